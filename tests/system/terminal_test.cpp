// The station in a real terminal: the same screen as headless, keyboard on the screen, mouse (DEC-01, interfaces.md 3).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

ScreenRows first_rows(Terminal& terminal) {
  ScreenRows rows;
  for (int row = 0; row < kScreenRows; ++row) rows.push_back(terminal.row(row));
  return rows;
}

class StationInTerminal : public testing::Test {
 protected:
  StationInTerminal() { room_.add_student("anna", {"P0001\nN001G00X+50000Y+50000Z+50000\nN002G04H0010\n"}); }
  Classroom room_;
};

TEST_F(StationInTerminal, DEC_01_shows_the_same_24_by_80_cells_as_headless) {
  ScreenRows expected;
  {
    StationProcess headless = room_.seat(1, "anna");
    headless.key("EINGABE ENTER");
    headless.wait_for("N002 G04");
    expected = without_clock(headless.screen());
    headless.quit();
  }
  Terminal terminal = room_.terminal(1, "anna", kScreenRows, kScreenColumns);
  terminal.wait_for("N002 G04");
  static_cast<void>(eventually(5s, [&] {  // the last rows may still be on their way
    terminal.update();
    return without_clock(first_rows(terminal)) == expected;
  }));
  EXPECT_EQ(without_clock(first_rows(terminal)), expected);
}

TEST_F(StationInTerminal, SEAT_003_who_looks_on_is_told_so_and_asked_before_the_end) {
  StationProcess seated = room_.seat(1, "anna");
  StationOptions options = room_.station_options(2, "anna");
  options.more = {"--look-on"};
  Terminal terminal({.program = programs_folder() / "cnclab-station",
                     .arguments = station_arguments(options),
                     .environment = {{"XDG_STATE_HOME", (room_.folder().path() / "state").string()}},
                     .rows = kScreenRows,
                     .columns = kScreenColumns});
  terminal.wait_for("Nur zusehen: Platz 1");
  terminal.wait_for("Tasten wirken hier nicht");
  seated.key("EINGABE");
  terminal.wait_for("EINGABEMODUS");
  terminal.type("m");  // no key acts
  terminal.type("q");
  terminal.wait_for("Zusehen beenden?");
  EXPECT_NE(terminal.text().find("EINGABEMODUS"), std::string::npos);
  terminal.type("q");
  EXPECT_EQ(terminal.wait(kLimit), 0);
}

TEST_F(StationInTerminal, the_keyboard_is_shown_from_36_rows_and_a_click_presses_its_key) {
  Terminal terminal = room_.terminal(1, "anna", 40, kScreenColumns);
  terminal.wait_for("CNC 3300");
  std::pair<int, int> key{};
  ASSERT_TRUE(eventually(5s, [&] {
    terminal.update();
    const auto found = terminal.find_below(" EINGABE", kScreenRows);
    key = found.value_or(key);
    return found.has_value();
  })) << terminal.text();
  terminal.click(key.first, key.second + 2);
  terminal.wait_for("EINGABEMODUS");
}

TEST_F(StationInTerminal, below_36_rows_there_is_no_keyboard_but_every_key_of_the_plain_one) {
  Terminal terminal = room_.terminal(1, "anna", kScreenRows, kScreenColumns);
  terminal.wait_for("CNC 3300");
  terminal.type("?");
  terminal.wait_for("EINGABE");
  terminal.wait_for("SATZ SUCHEN");
}

TEST_F(StationInTerminal, a_resized_terminal_shows_the_keyboard_as_soon_as_there_is_room) {
  Terminal terminal = room_.terminal(1, "anna", kScreenRows, kScreenColumns);
  terminal.wait_for("CNC 3300");
  terminal.resize(44, 100);
  ASSERT_TRUE(eventually(5s, [&] {
    terminal.update();
    return terminal.find_below("TEACH", kScreenRows).has_value();
  })) << terminal.text();
}

TEST_F(StationInTerminal, SEAT_005_a_lost_server_is_shown_and_the_station_comes_back_by_itself) {
  TcpProxy line(room_.server().port());
  StationOptions options = room_.station_options(1, "anna");
  options.server = line.address();
  Terminal terminal({.program = programs_folder() / "cnclab-station",
                     .arguments = station_arguments(options),
                     .environment = {},
                     .rows = kScreenRows,
                     .columns = kScreenColumns});
  terminal.wait_for("CNC 3300");
  line.cut();
  terminal.wait_for("VERBINDUNG VERLOREN");
  line.mend();
  terminal.wait_gone("VERBINDUNG VERLOREN", 10s);
}

// A password that was typed in the form does for the way back as one from a file does.
TEST_F(StationInTerminal, SEAT_005_after_a_crash_of_the_server_the_station_comes_back_without_a_new_log_in) {
  StationOptions options = room_.station_options(1, "anna");
  options.password_file.clear();
  Terminal terminal({.program = programs_folder() / "cnclab-station",
                     .arguments = station_arguments(options),
                     .environment = {},
                     .rows = kScreenRows,
                     .columns = kScreenColumns});
  terminal.wait_for("Passwort");
  terminal.type(room_.passwords().password_of("anna") + "\r");
  terminal.wait_for("TRAINING");
  room_.crash_and_restart();
  ASSERT_TRUE(eventually(15s, [&] {
    terminal.update();
    return room_.instructor().status()["stations"].size() == 1;
  })) << terminal.text();
  terminal.wait_for("TRAINING");
}

}  // namespace
}  // namespace cnclab::harness
