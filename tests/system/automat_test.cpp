// Programs on the student's own training machine, in real time (AU, KEY, MOD; training is everybody's own).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

const std::string kShort = "P0001\nN001G01X+10000F3000\nN002G01Y+5000\nN003G01Z+2500\n";
const std::string kLong = "P0001\nN001G01X+300000F3000\n";
const std::string kEndless = "P0001\nN001G01X+20000F3000\nN002G01X-20000\nN003G20P0001N001\n";

void open_automat(StationProcess& station) { station.key("AUTOMAT ENTER ENTER"); }

/// X of the screen in mm.
double x_of(StationProcess& station) {
  for (const auto& row : station.screen()) {
    const auto at = row.find("X  ");
    if (at != std::string::npos) return std::stod(row.substr(at + 3));
  }
  throw std::runtime_error("no X on the screen:\n" + station.text());
}

class Automat : public testing::Test {
 protected:
  StationProcess seat_with(const std::string& tape) {
    room_.add_student("anna", {tape});
    return room_.seat(1, "anna");
  }
  bool is_running() { return room_.instructor().station(1)["running"]; }
  Classroom room_;
};

TEST_F(Automat, MOD_052_the_blocks_and_the_modal_state_are_shown_before_START) {
  StationProcess anna = seat_with(kShort);
  open_automat(anna);
  const auto rows = anna.screen();
  EXPECT_THAT(monitor_row(rows, 1), testing::HasSubstr("AUTOMAT"));
  EXPECT_THAT(anna.text(), testing::HasSubstr("G17 G40 G45 G74 G91 F0000 S0000 T00 M12"));
  EXPECT_THAT(anna.text(), testing::HasSubstr("N001 G01 X+..10.000 Y.....,... Z.....,... F3000 S.... T.. M.."));
  EXPECT_THAT(anna.text(), testing::HasSubstr("N003 G01"));
}

TEST_F(Automat, MOD_053_a_program_runs_to_its_end_and_stops_by_itself) {
  StationProcess anna = seat_with(kShort);
  open_automat(anna);
  anna.key("START");
  anna.wait_for("Z  +0002.500", 10s);
  anna.wait_for("X  +0010.000");
  anna.wait_for("Y  +0005.000");
  EXPECT_TRUE(eventually(5s, [&] { return !is_running(); }));
}

TEST_F(Automat, KEY_030_STOP_brakes_and_START_runs_the_rest) {
  StationProcess anna = seat_with("P0001\nN001G01X+60000F3000\n");
  open_automat(anna);
  anna.key("START");
  ASSERT_TRUE(eventually(5s, [&] { return x_of(anna) > 5; }));
  anna.key("STOP");
  ASSERT_TRUE(eventually(5s, [&] { return !is_running(); }));
  const double stopped_mm = x_of(anna);
  EXPECT_GT(stopped_mm, 5);
  EXPECT_LT(stopped_mm, 60);
  anna.key("START");
  anna.wait_for("X  +0060.000", 10s);
}

TEST_F(Automat, KEY_043_MENU_after_STOP_abandons_the_rest) {
  StationProcess anna = seat_with(kLong);
  open_automat(anna);
  anna.key("START");
  ASSERT_TRUE(eventually(5s, [&] { return x_of(anna) > 5; }));
  anna.key("STOP");
  ASSERT_TRUE(eventually(5s, [&] { return !is_running(); }));
  const double stopped_mm = x_of(anna);
  anna.key("MENU AUTOMAT");
  EXPECT_DOUBLE_EQ(x_of(anna), stopped_mm);
}

TEST_F(Automat, MOD_054_EINZELSATZ_stops_after_each_block) {
  StationProcess anna = seat_with(kShort);
  open_automat(anna);
  anna.key("EINZELSATZ START");
  anna.wait_for("X  +0010.000", 5s);
  ASSERT_TRUE(eventually(5s, [&] { return !is_running(); }));
  EXPECT_TRUE(anna.shows("Y  +0000.000"));
  anna.key("START");
  anna.wait_for("Y  +0005.000", 5s);
  ASSERT_TRUE(eventually(5s, [&] { return !is_running(); }));
  EXPECT_TRUE(anna.shows("Z  +0000.000"));
}

TEST_F(Automat, MOD_058_the_potentiometer_at_0_is_standstill_and_raised_again_goes_on) {
  StationProcess anna = seat_with(kEndless);
  open_automat(anna);
  anna.key("START");
  ASSERT_TRUE(eventually(5s, [&] { return x_of(anna) > 1; }));
  anna.expect_ok("pot 0");
  double before_mm = x_of(anna);
  ASSERT_TRUE(eventually(5s, [&] { return before_mm == std::exchange(before_mm, x_of(anna)); })) << "standstill";
  EXPECT_TRUE(is_running());
  anna.expect_ok("pot 100");
  EXPECT_TRUE(eventually(5s, [&] { return x_of(anna) != before_mm; }));
}

TEST_F(Automat, EX_010_an_endless_program_runs_until_STOP) {
  StationProcess anna = seat_with(kEndless);
  open_automat(anna);
  anna.key("START");
  double highest_mm = 0;
  const auto has_come_back = [&] {
    const double x_mm = x_of(anna);
    highest_mm = std::max(highest_mm, x_mm);
    return highest_mm > 15 && x_mm < 5;
  };
  ASSERT_TRUE(eventually(10s, has_come_back)) << "first pass";
  highest_mm = 0;
  ASSERT_TRUE(eventually(10s, has_come_back)) << "second pass";
  anna.key("STOP");
  EXPECT_TRUE(eventually(5s, [&] { return !is_running(); }));
}

TEST_F(Automat, everybody_practises_at_once_and_nobody_moves_the_labs_machine) {
  StationProcess anna = seat_with(kEndless);
  room_.add_student("otto", {kShort});
  StationProcess otto = room_.seat(2, "otto");
  open_automat(anna);
  open_automat(otto);
  anna.key("START");
  otto.key("START");
  otto.wait_for("Z  +0002.500", 10s);
  EXPECT_TRUE(is_running());
  const auto machine = room_.instructor().status()["machine"];
  EXPECT_EQ(machine["x"], 0);
  EXPECT_EQ(machine["state"], "standstill");
}

TEST_F(Automat, DEC_50_a_missing_program_is_named_and_starts_nothing) {
  StationProcess anna = seat_with(kShort);
  anna.key("AUTOMAT CLEAR");
  anna.type("4711");
  anna.key("ENTER");
  anna.wait_for("Programm fehlt");
}

}  // namespace
}  // namespace cnclab::harness
