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
  EXPECT_EQ(status()["machine"]["state"], "halted") << "only who pressed it releases it";
  otto_->key("MASCHINE_HALT");
  EXPECT_TRUE(comes_to("standstill"));
}

TEST_F(Halt, AUTH_006_the_controlling_stations_STOP_always_stops) {
  anna_->key("STOP");
  EXPECT_TRUE(comes_to("standstill"));
  EXPECT_EQ(status()["selected"], 1) << "STOP keeps the lease";
  anna_->key("START");
  EXPECT_TRUE(comes_to("moving")) << "the rest of the way";
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
