// MASCHINE HALT and power: they act at once, latch, and start nothing when they are lifted (AUTH-006, AUTH-010).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "programs.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

/// Station 1 (anna) runs an endless program on the lab's machine; station 2 (otto) looks on.
class Halt : public testing::Test {
 protected:
  Halt() {
    room_.add_student("anna", {kEndless});
    room_.add_student("otto");
    anna_.emplace(room_.seat(1, "anna"));
    otto_.emplace(room_.seat(2, "otto"));
    room_.give_machine(1, *anna_);
    start();
  }

  nlohmann::json status() { return room_.instructor().status(); }
  void start() {
    anna_->key("MENU AUTOMAT ENTER ENTER START");
    if (!eventually(kLimit, [&] { return status()["machine"]["state"] == "moving"; })) {
      throw std::runtime_error("the machine does not move:\n" + anna_->text());
    }
  }
  bool comes_to(const std::string& state) {
    return eventually(kLimit, [&] { return status()["machine"]["state"] == state; });
  }
  /// A START before the screen has shown that the machine stands does not count (AUTH-008): pressed again, as one does.
  [[nodiscard]] bool goes_on() {
    return eventually(kLimit, [&] {
      anna_->key("START");
      return status()["machine"]["state"] == "moving";
    });
  }
  void expect_still() {
    const auto before = status()["machine"];
    constexpr int kLooks = 10;
    for (int look = 0; look < kLooks; ++look) ASSERT_EQ(status()["machine"]["x"], before["x"]);
  }
  /// The program again from its beginning, with a new lease where the halt has ended the old one.
  void run_again() {
    if (status()["selected"] != 1) room_.give_machine(1, *anna_);
    start();
  }

  Classroom room_;
  std::optional<StationProcess> anna_, otto_;
};

TEST_F(Halt, AUTH_006_the_instructors_halt_stops_latches_and_is_named_on_every_screen) {
  room_.instructor().must({"halt"});
  ASSERT_TRUE(comes_to("halted"));
  EXPECT_EQ(status()["halted_by"], "lehrer");
  anna_->wait_for("lehrer");
  otto_->wait_for("lehrer");
  anna_->key("START");
  expect_still();
  EXPECT_EQ(status()["machine"]["state"], "halted");
}

TEST_F(Halt, AUTH_006_clear_halt_starts_nothing_and_a_new_START_runs_again) {
  room_.instructor().must({"halt"});
  ASSERT_TRUE(comes_to("halted"));
  room_.instructor().must({"clear-halt"});
  ASSERT_TRUE(comes_to("standstill"));
  EXPECT_EQ(status()["halted_by"], "");
  expect_still();
  run_again();
}

TEST_F(Halt, AUTH_006_any_station_stops_the_machine_and_the_same_key_releases_it) {
  otto_->key("MASCHINE_HALT");
  ASSERT_TRUE(comes_to("halted"));
  EXPECT_THAT(status()["halted_by"].get<std::string>(), HasSubstr("otto"));
  anna_->key("MASCHINE_HALT");
  EXPECT_EQ(status()["machine"]["state"], "halted") << "only who pressed it releases it; she has pressed too now";
  anna_->key("MASCHINE_HALT");
  EXPECT_EQ(status()["machine"]["state"], "halted");
  otto_->key("MASCHINE_HALT");
  EXPECT_TRUE(comes_to("standstill"));
}

TEST_F(Halt, AUTH_006_each_of_those_who_have_pressed_holds_the_halt) {
  otto_->key("MASCHINE_HALT");
  room_.instructor().must({"halt"});
  anna_->key("MASCHINE_HALT");
  EXPECT_EQ(status()["halted_by"], "Platz 2, otto; lehrer; Platz 1, anna");
  otto_->key("MASCHINE_HALT");
  EXPECT_EQ(status()["halted_by"], "lehrer; Platz 1, anna");
  anna_->key("MASCHINE_HALT");
  EXPECT_EQ(status()["halted_by"], "lehrer");
  EXPECT_EQ(status()["machine"]["state"], "halted");
  room_.instructor().must({"clear-halt"});
  EXPECT_TRUE(comes_to("standstill"));
}

TEST_F(Halt, AUTH_006_who_has_moved_to_another_seat_releases_the_own_press) {
  otto_->key("MASCHINE_HALT");
  otto_->quit();
  otto_.emplace(room_.seat(3, "otto"));
  otto_->key("MASCHINE_HALT");
  EXPECT_EQ(status()["halted_by"], "");
}

TEST_F(Halt, AUTH_006_STOP_and_MASCHINE_HALT_act_whatever_is_held_with_them) {
  for (const char* keys : {"STOP+5", "5+STOP"}) {
    anna_->key(keys);
    ASSERT_TRUE(comes_to("standstill")) << keys;
    anna_->key("START");
    ASSERT_TRUE(comes_to("moving")) << keys;
  }
  otto_->key("5+MASCHINE_HALT");
  EXPECT_TRUE(comes_to("halted"));
}

// interfaces.md section 3: `ok` says that the next `screen` contains it.
TEST_F(Halt, STOP_stands_in_the_next_screen) {
  constexpr int kRounds = 10;
  for (int round = 0; round < kRounds; ++round) {
    anna_->key("STOP");
    EXPECT_FALSE(anna_->shows("Programm läuft")) << "round " << round;
    ASSERT_TRUE(comes_to("standstill"));
    ASSERT_TRUE(goes_on());
  }
}

TEST_F(Halt, DEC_39_RESET_stops_while_the_menu_of_LABOR_is_open) {
  anna_->key("LABOR RESET");
  ASSERT_TRUE(comes_to("standstill"));
  EXPECT_EQ(status()["selected"], 0);
}

TEST_F(Halt, AUTH_006_the_controlling_stations_STOP_always_stops) {
  anna_->key("STOP");
  EXPECT_TRUE(comes_to("standstill"));
  EXPECT_EQ(status()["selected"], 1) << "STOP keeps the lease";
  EXPECT_TRUE(goes_on()) << "the rest of the way";
}

TEST_F(Halt, AUTH_010_power_off_stops_at_once_and_power_on_starts_nothing) {
  room_.instructor().must({"power-off"});
  ASSERT_TRUE(comes_to("off"));
  expect_still();
  EXPECT_EQ(status()["machine"]["referenced"], false) << "DEC-23";
  anna_->key("START");
  expect_still();
  room_.instructor().must({"power-on"});
  ASSERT_TRUE(comes_to("standstill"));
  expect_still();
}

}  // namespace
}  // namespace cnclab::harness
