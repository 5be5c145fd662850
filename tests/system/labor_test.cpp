// Key LABOR at a real station: versions come back, language and password change, messages, log out (interfaces.md 3,
// STO-005, STO-006, SEAT-002).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

class Labor : public testing::Test {
 protected:
  Labor() { room_.add_student("anna"); }

  /// G90 as N001 of P0001, at the station's keyboard.
  static void store_g90(StationProcess& seat) {
    seat.key("EINGABE ENTER ENTER");
    seat.type("90");
    seat.key("ENTER EINGABE");
    seat.wait_for("002");
  }

  Classroom room_;
};

TEST_F(Labor, STO_005_ADeletedProgramComesBackByItsVersion) {
  StationProcess anna = room_.seat(1, "anna");
  store_g90(anna);
  anna.key("MENU SPEICHER_LOESCHEN");
  anna.type("1");
  anna.key("ENTER");
  anna.wait_for("PROGRAMM GELOESCHT");
  anna.key("MENU LABOR");
  EXPECT_THAT(anna.screen()[18], HasSubstr("Was möchten Sie tun?"));
  anna.key("1 1 1 ENTER");
  anna.wait_for("Versionen: P0001, Seite 1 von 1");
  EXPECT_THAT(anna.screen()[19], HasSubstr("gelöscht"));
  EXPECT_THAT(anna.screen()[20], HasSubstr("Satz N001 gespeichert"));
  EXPECT_THAT(anna.screen()[20], HasSubstr("anna, Platz 1"));
  anna.key("2");
  anna.wait_for("P0001: soll Version 1 wieder gelten?");
  anna.key("ENTER");
  anna.wait_for("P0001: Version 1 gilt wieder.");
  anna.key("EINGABE ENTER");
  anna.wait_for("N001 G90");
}

TEST_F(Labor, STO_005_ToolTableAndMachineDataComeBackToo) {
  StationProcess anna = room_.seat(1, "anna");
  anna.expect_ok("hold 50 ENTER+RESET");
  for (int i = 0; i < 5; ++i) anna.key("ENTER");
  anna.type("1500");
  anna.key("ENTER");
  anna.wait_for("NR 07");
  anna.key("LABOR 1 3");
  anna.wait_for("Versionen: Maschinendaten, Seite 1 von 1");
  EXPECT_THAT(anna.screen()[20], HasSubstr("wie geliefert"));
  anna.key("2 ENTER");
  anna.wait_for("Maschinendaten: Version 0 gilt wieder.");
  anna.key("RESET");
  anna.expect_ok("hold 50 ENTER+RESET");
  for (int i = 0; i < 5; ++i) anna.key("ENTER");
  EXPECT_THAT(monitor_row(anna.screen(), 5), HasSubstr("3000")) << "F MAX as delivered";
  anna.key("RESET LABOR 1 2");
  anna.wait_for("Versionen: Werkzeugtabelle P0000");
  EXPECT_THAT(anna.screen()[19], HasSubstr("noch nichts gespeichert"));
}

TEST_F(Labor, TheLanguageHoldsAtOnceAndAtTheNextLogin) {
  {
    StationProcess anna = room_.seat(1, "anna");
    anna.key("LABOR 3 2");
    anna.wait_for("The texts are English now.");
    anna.wait_for("? all keys");
    anna.quit();
  }
  StationProcess anna = room_.seat(2, "anna");
  anna.key("LABOR");
  EXPECT_THAT(anna.screen()[18], HasSubstr("What would you like to do?"));
}

TEST_F(Labor, SEC_002_ThePasswordChangesOnlyWithTheOldOne) {
  StationOptions options = room_.station_options(1, "anna");
  const StationOptions before = options;
  options.new_password_file = room_.passwords().set("anna.new", "ein neues Passwort");
  {
    StationProcess anna(options);
    anna.key("LABOR 2");
    anna.wait_for("Das Passwort ist geändert.");
    anna.quit();
  }
  StationProcess refused(before);
  EXPECT_EQ(refused.wait(10s), 4) << "the old one holds no more";
  StationOptions after = options;
  after.password_file = options.new_password_file;
  after.new_password_file.clear();
  StationProcess anna(after);
  anna.key("MENU");
  anna.quit();
}

TEST_F(Labor, SEC_003_AtATerminalTheDialogRefusesAWrongOldPasswordAndTakesTheRightOne) {
  Terminal terminal = room_.terminal(1, "anna", 24, 80);
  terminal.wait_for("? alle Tasten");
  terminal.type("o2");
  terminal.wait_for("Altes Passwort");
  terminal.type("falsches Wort\reins zwei drei\reins zwei drei\r");
  terminal.wait_for("Das alte Passwort ist falsch.");
  EXPECT_EQ(terminal.text().find("falsches Wort"), std::string::npos) << "no letter is shown";
  terminal.type(room_.passwords().password_of("anna") + "\reins zwei drei\reins zwei vier\r");
  terminal.wait_for("Die neuen Passwörter sind verschieden");
  terminal.type(room_.passwords().password_of("anna") + "\reins zwei drei\reins zwei drei\r");
  terminal.wait_for("Das Passwort ist geändert.");
  terminal.type("qq");
  EXPECT_EQ(terminal.wait(5s), 0);
  room_.passwords().set("anna", "eins zwei drei");
  StationProcess anna = room_.seat(1, "anna");
  anna.quit();
}

TEST_F(Labor, MessagesCanBeReadAgainAndLogOutEndsTheStation) {
  StationProcess anna = room_.seat(1, "anna");
  room_.instructor().must({"message", "all", "Pause bis zehn Uhr"});
  anna.wait_for("lehrer: Pause bis zehn Uhr");
  anna.key("MENU");
  anna.wait_gone("Pause");
  anna.key("LABOR 6");
  anna.wait_for("Nachrichten der Lehrkraft, Seite 1 von 1");
  EXPECT_THAT(anna.screen()[19], HasSubstr("lehrer: Pause bis zehn Uhr"));
  anna.key("LABOR LABOR");
  static_cast<void>(anna.send("key 7"));
  EXPECT_EQ(anna.wait(5s), 0);
}

TEST_F(Labor, INS_002_NothingOfAMessageIsLost) {
  StationProcess anna = room_.seat(1, "anna");
  const std::string longest = "Bitte alle " + std::string(58, 'x') + " bis Ende.";
  ASSERT_EQ(longest.size(), 79U);
  room_.instructor().must({"message", "1", longest + "!"});
  anna.wait_for("Ende.!");
  EXPECT_TRUE(anna.shows(std::string(58, 'x'))) << anna.text();
  anna.key("MENU LABOR 6");
  anna.wait_for("Nachrichten der Lehrkraft");
  EXPECT_TRUE(anna.shows("Ende.!")) << anna.text();
  const OneShot too_long = room_.instructor().run({"message", "all", longest + "!!"});
  EXPECT_EQ(too_long.exit_code, 1);
  EXPECT_THAT(too_long.errors, HasSubstr("80"));
  for (const char* empty : {"", " "}) EXPECT_EQ(room_.instructor().run({"message", "1", empty}).exit_code, 1);
}

TEST_F(Labor, AUTH_005_AnOfferIsSeenAndAcceptedWithTheMenuOpen) {
  StationProcess anna = room_.seat(1, "anna");
  anna.key("LABOR");
  room_.instructor().must({"select", "1"});
  anna.wait_for("START nimmt an");
  anna.key("START");
  anna.wait_gone("TRAINING");
  anna.key("2");
  anna.wait_for("wenn die Maschine abgegeben ist");
}

}  // namespace
}  // namespace cnclab::harness
