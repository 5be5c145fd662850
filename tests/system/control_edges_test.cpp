// What of a control needs the whole lab to be seen: damaged machine data at the login (ERR-014), RESET and the lease
// (DEC-39), and the recorder's → as two presses of a terminal's key (interfaces.md 3).
#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

class ControlEdges : public testing::Test {
 protected:
  ControlEdges() { room_.add_student("anna", {"P0001N001G91\nN002G01X+20000F1000\n%\n"}); }

  /// F MAX 1500 instead of 3000.
  static void store_f_max(StationProcess& seat) {
    seat.expect_ok("hold 50 ENTER+RESET");
    for (int i = 0; i < 5; ++i) seat.key("ENTER");
    seat.type("1500");
    seat.key("ENTER");
    seat.wait_for("NR 07");
  }

  Classroom room_;
};

TEST_F(ControlEdges, ERR_014_DamagedMachineDataAreReplacedByTheRomsAtTheLogin) {
  {
    StationProcess anna = room_.seat(1, "anna");
    store_f_max(anna);
    anna.key("RESET");
    anna.quit();
  }
  {
    SQLite::Database raw((room_.data() / "cnclab.db").string(), SQLite::OPEN_READWRITE, 5000);
    ASSERT_EQ(raw.exec("UPDATE machine_datum SET check_code = check_code + 1 WHERE number = 6 AND person_id > 0"), 1);
  }
  {
    StationProcess anna = room_.seat(1, "anna");
    EXPECT_THAT(anna.text(), HasSubstr("CHECKSUM FEHLER"));
    EXPECT_THAT(anna.screen()[18],
                HasSubstr("Die Maschinendaten waren beschädigt: jetzt gelten die Daten aus dem ROM."));
    anna.expect_ok("hold 50 ENTER+RESET");
    for (int i = 0; i < 5; ++i) anna.key("ENTER");
    EXPECT_THAT(monitor_row(anna.screen(), 5), HasSubstr("3000"));
    anna.key("RESET");
    anna.quit();
  }
  StationProcess anna = room_.seat(1, "anna");
  EXPECT_THAT(anna.text(), Not(HasSubstr("CHECKSUM FEHLER"))) << "said once: the database is whole again";
}

TEST_F(ControlEdges, DEC_39_RESET_StopsTheMachineAndEndsTheLease) {
  StationProcess anna = room_.seat(1, "anna");
  room_.give_machine(1, anna);
  anna.key("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(eventually(5s, [&] { return room_.instructor().status().at("machine").at("state") == "moving"; }));
  anna.key("RESET");
  anna.wait_for("TRAINING");
  ASSERT_TRUE(eventually(5s, [&] {
    const auto status = room_.instructor().status();
    return status.at("selected") == 0 && status.at("machine").at("state") == "standstill";
  })) << room_.instructor().status();
  EXPECT_LT(room_.instructor().status().at("machine").at("x").get<double>(), 20.0) << "stopped on the way";
}

// Over 5 s: the tape's leader takes its time, five counts of it before it can be written on.
TEST_F(ControlEdges, EXT_012_AtATerminalEnterStartsTheRecorderAndTheSecondOneReleases) {
  Terminal terminal = room_.terminal(1, "anna", 24, 80);
  terminal.wait_for("? alle Tasten");
  terminal.type("o5\t");  // LABOR, cassettes, EINGABE: a new one
  terminal.wait_for("K01");
  terminal.type("1");
  terminal.wait_for("in den Rekorder einlegen");
  terminal.type("1");
  terminal.wait_for("auswerfen");
  terminal.type("o");
  terminal.wait_for("? alle Tasten");
  terminal.type("d2");
  terminal.wait_for("AUF KASSETTE SCHREIBEN");
  terminal.type("1\r");
  terminal.wait_for("MOTOR ●");
  terminal.wait_for("REKORDER 006  MOTOR ●  AUFNAHME ○", 20s);
  terminal.type("\r");
  terminal.wait_for("AUFNAHME ●");
  terminal.wait_for("MOTOR ○", 20s);
  EXPECT_EQ(terminal.text().find("falsch"), std::string::npos) << terminal.text();
}

}  // namespace
}  // namespace cnclab::harness
