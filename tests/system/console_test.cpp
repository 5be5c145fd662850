// The instructor's console in a real terminal (INS-001, INS-002, SEC-002, SEAT-005).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"

namespace cnclab::harness {
namespace {

constexpr int kHeadings = 1;

class ConsoleInTerminal : public testing::Test {
 protected:
  ConsoleInTerminal() { room_.add_student("anna"); }

  Terminal console(const std::string& server, const std::filesystem::path& password_file, int columns = 80) {
    return Terminal({.program = programs_folder() / "cnclab-instructor",
                     .arguments = {"--server", server, "--user", "lehrer", "--password-file", password_file.string(),
                                   "--fingerprint", room_.server().fingerprint()},
                     .environment = {},
                     .rows = 24,
                     .columns = columns});
  }
  Terminal console() { return console(room_.server().address(), room_.passwords().file_of("lehrer")); }
  /// Screen row of a seat.
  static int row_of(int seat) { return kHeadings + seat; }

  Classroom room_;
};

TEST_F(ConsoleInTerminal, INS_001_shows_who_sits_where_as_they_come_and_work) {
  Terminal terminal = console();
  terminal.wait_for("q Ende");  // drawn last
  EXPECT_THAT(terminal.row(row_of(7)), testing::HasSubstr(" 7"));
  StationProcess anna = room_.seat(7, "anna");
  terminal.wait_for("anna");
  EXPECT_THAT(terminal.row(row_of(7)), testing::HasSubstr("anna"));
  anna.key("EINGABE");
  terminal.wait_for("EINGABEMODUS");
}

TEST_F(ConsoleInTerminal, INS_002_a_station_is_watched_typed_at_locked_and_shown_by_keys) {
  StationProcess anna = room_.seat(7, "anna");
  Terminal terminal = console();
  terminal.wait_for("anna");
  terminal.type("7w");
  terminal.wait_for("jede andere Taste");
  anna.key("EINGABE");
  terminal.wait_for("EINGABEMODUS");
  terminal.type("t");
  terminal.wait_for("F8 gibt sie zur");
  anna.wait_for("lehrer hat diese Tastatur");
  terminal.type("\x1b[19~");  // F8
  terminal.wait_for("LEHRKRAFT");
  anna.wait_gone("lehrer hat diese Tastatur");
  terminal.type("l");
  anna.wait_for("gesperrt");
  terminal.wait_for("gesperrt");
  terminal.type("l");
  anna.wait_gone("gesperrt");
  terminal.type("mGuten Morgen\r");
  anna.wait_for("lehrer: Guten Morgen");
}

TEST_F(ConsoleInTerminal, INS_002_after_watching_the_table_is_back_and_every_key_works) {
  StationProcess anna = room_.seat(7, "anna");
  Terminal terminal = console();
  terminal.wait_for("anna");
  for (const char* key : {"q", " ", "7"}) {
    terminal.type("7w");
    terminal.wait_for("jede andere Taste");
    terminal.type(key);
    terminal.wait_gone("jede andere Taste");
    anna.key("EINGABE");  // the answer to the end of watching has come when the table shows what was done after it
    terminal.wait_for("EINGABEMODUS");
    EXPECT_THAT(terminal.text(), testing::HasSubstr("LEHRKRAFT"));
    anna.key("MENU");
    terminal.wait_gone("EINGABEMODUS");
  }
  terminal.type("h");
  terminal.wait_for("HALT: lehrer");
  terminal.type("c");
  terminal.wait_gone("HALT: lehrer");
  terminal.type("7w");
  terminal.wait_for("jede andere Taste");
  terminal.type("h");
  EXPECT_TRUE(eventually(kLimit, [&] { return room_.instructor().status()["halted_by"] == "lehrer"; }))
      << "also while a screen is watched";
  terminal.type("q");
  terminal.wait_for("HALT: lehrer");
  terminal.type("q");
  EXPECT_EQ(terminal.wait(kLimit), 0);
}

TEST_F(ConsoleInTerminal, INS_001_last_key_and_errors_stand_beside_the_name) {
  StationProcess anna = room_.seat(7, "anna");
  Terminal terminal = console();
  terminal.wait_for("anna");
  anna.key("EINGABE ENTER ENTER ENTER EINGABE");  // an incomplete block
  terminal.wait_for("EINGABE ");
  EXPECT_TRUE(eventually(kLimit, [&] {
    terminal.update();
    return terminal.row(row_of(7)).find("  1") != std::string::npos;
  })) << terminal.row(row_of(7));
}

TEST_F(ConsoleInTerminal, INS_002_in_a_wide_terminal_the_watched_screen_stands_beside_the_seats) {
  StationProcess anna = room_.seat(7, "anna");
  constexpr int kWide = 161;
  Terminal terminal = console(room_.server().address(), room_.passwords().file_of("lehrer"), kWide);
  terminal.wait_for("anna");
  terminal.type("7w");
  terminal.wait_for("jede andere Taste");
  anna.key("EINGABE");
  terminal.wait_for("EINGABEMODUS");
  EXPECT_THAT(terminal.text(), testing::HasSubstr("LEHRKRAFT"));
  EXPECT_THAT(terminal.text(), testing::HasSubstr("CNC 3300"));
}

TEST_F(ConsoleInTerminal, INS_005_every_command_can_be_typed_and_its_answer_read) {
  Terminal terminal = console();
  terminal.wait_for("verbunden");
  terminal.type(":student add berta\r");
  terminal.wait_for("\"password\"");
  terminal.type("q");
  terminal.wait_gone("\"password\"");
  terminal.type(":students\r");
  terminal.wait_for("\"role\"");
  terminal.type("q");
  terminal.wait_gone("\"role\"");
  const TemporaryFolder folder;
  std::string tape = "P0007\n";
  for (int block = 1; block <= 300; ++block)
    tape += "N" + std::to_string(1000 + block).substr(1) + "G01X+1000Y-1000\n";  // longer than one piece
  terminal.type(":program send " + folder.write("tape", tape).string() + " berta\r");
  EXPECT_TRUE(eventually(kLimit, [&] {
    return room_.instructor().run({"program", "show", "berta", "P0007"}).output == tape + "%\n";
  })) << terminal.text();
  const auto copy = folder.path() / "copy.db";
  terminal.type(":backup " + copy.string() + "\r");
  EXPECT_TRUE(eventually(kLimit, [&] { return std::filesystem::exists(copy); })) << terminal.text();
}

TEST_F(ConsoleInTerminal, INS_002_select_halt_clear_and_release_by_keys) {
  StationProcess anna = room_.seat(7, "anna");
  Terminal terminal = console();
  terminal.wait_for("anna");
  terminal.type("7s");
  anna.wait_for("START nimmt an");
  terminal.wait_for("gefragt");
  anna.key("START");
  terminal.wait_for("►");
  EXPECT_THAT(terminal.row(row_of(7)), testing::HasSubstr("►"));
  terminal.type("h");
  terminal.wait_for("HALT: lehrer");
  terminal.type("c");
  terminal.wait_gone("HALT: lehrer");
  terminal.type("r");
  EXPECT_TRUE(eventually(kLimit, [&] { return room_.instructor().status()["selected"] == 0; }));
}

TEST_F(ConsoleInTerminal, AUTH_006_F12_halts) {
  Terminal terminal = console();
  terminal.wait_for("verbunden");
  terminal.type("\x1b[24~");
  EXPECT_TRUE(eventually(kLimit, [&] { return room_.instructor().status()["halted_by"] == "lehrer"; }));
}

TEST_F(ConsoleInTerminal, INS_002_a_click_and_the_arrows_choose_a_seat) {
  Terminal terminal = console();
  terminal.wait_for("verbunden");
  terminal.click(row_of(12), 20);
  EXPECT_TRUE(eventually(kLimit, [&] {
    terminal.update();
    return terminal.is_inverse(row_of(12), 20);
  }));
  terminal.type("\x1bOB");
  EXPECT_TRUE(eventually(kLimit, [&] {
    terminal.update();
    return terminal.is_inverse(row_of(13), 20);
  })) << terminal.text();
}

TEST_F(ConsoleInTerminal, a_window_too_small_says_so_and_nothing_but_a_halt_acts) {
  Terminal terminal = console();
  terminal.wait_for("verbunden");
  terminal.resize(20, 70);
  terminal.wait_for("Fenster zu klein: 80×24");
  terminal.type("q");
  terminal.type("h");
  EXPECT_TRUE(eventually(kLimit, [&] { return room_.instructor().status()["halted_by"] == "lehrer"; }));
  terminal.resize(24, 80);
  terminal.wait_for("HALT: lehrer");
}

TEST_F(ConsoleInTerminal, a_terminal_without_a_movable_cursor_is_refused_with_a_sentence) {
  for (const char* const program : {"cnclab-instructor", "cnclab-station"}) {
    Terminal terminal({.program = programs_folder() / program,
                       .arguments = {"--server", room_.server().address()},
                       .environment = {{"TERM", "dumb"}, {"LC_ALL", "C.UTF-8"}},
                       .rows = 24,
                       .columns = 80});
    terminal.wait_for("kein Bild zeichnen");
    EXPECT_EQ(terminal.wait(kLimit), 2) << program;
  }
}

TEST_F(ConsoleInTerminal, a_refusal_stands_on_the_message_line) {
  Terminal terminal = console();
  terminal.wait_for("verbunden");
  terminal.type("3s");
  terminal.wait_for("An Platz 3 ist niemand angemeldet");
}

TEST_F(ConsoleInTerminal, q_asks_only_while_somebody_has_control) {
  StationProcess anna = room_.seat(7, "anna");
  room_.give_machine(7, anna);
  Terminal terminal = console();
  terminal.wait_for("►");
  terminal.type("q");
  terminal.wait_for("Platz 7 hat die Steuerung");
  terminal.type("n");
  terminal.wait_gone("Platz 7 hat die Steuerung");
  room_.instructor().must({"release"});
  terminal.wait_gone("►");
  terminal.type("q");
  EXPECT_EQ(terminal.wait(kLimit), 0);
}

TEST_F(ConsoleInTerminal, SEAT_005_a_lost_line_is_shown_and_comes_back_by_itself) {
  TcpProxy line(room_.server().port());
  Terminal terminal = console(line.address(), room_.passwords().file_of("lehrer"));
  terminal.wait_for("verbunden");
  line.cut();
  terminal.wait_for("VERBINDUNG VERLOREN");
  line.mend();
  terminal.wait_for("verbunden", 10s);
}

TEST_F(ConsoleInTerminal, SEC_002_a_one_time_password_leads_to_a_dialogue_for_a_new_one) {
  const OneShot added = room_.instructor().must({"student", "add", "vertretung", "--role", "instructor"});
  const auto file = room_.passwords().set("vertretung", added.objects.at(0)["password"]);
  Terminal terminal({.program = programs_folder() / "cnclab-instructor",
                     .arguments = {"--server", room_.server().address(), "--user", "vertretung", "--password-file",
                                   file.string(), "--fingerprint", room_.server().fingerprint()},
                     .environment = {},
                     .rows = 24,
                     .columns = 80});
  terminal.wait_for("Neues Passwort");
  terminal.type("kurz\r");
  terminal.wait_for("Noch einmal");
  terminal.type("anders\r");
  terminal.wait_for("verschieden");
  terminal.type("lang genug 1\r");
  terminal.type("lang genug 1\r");
  terminal.wait_for("verbunden");
}

}  // namespace
}  // namespace cnclab::harness
