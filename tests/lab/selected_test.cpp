// The station that has just got the machine, with time in our hands: what its next START is worth (AUTH-007, AUTH-008).
#include <gtest/gtest.h>

#include "language/tape.hpp"
#include "small_lab.hpp"

namespace cnclab::lab {
namespace {

class Selected : public testing::Test, protected SmallLab {
 protected:
  Selected() {
    with_database([](db::Database& database) {
      const std::string block = "N001G04H9999";
      const db::StoredBlock dwell{1, block, language::check_code(1, block)};
      database.put_block(database.person("eva")->id, 1, dwell, {.name = "eva", .station = kSeat, .time_ms = 1});
    });
    log_in(console_, "lehrer", 0);
  }

  /// The time passes as in a busy server, whose polls come a little late; eva and the console see what comes.
  void pass_ms(std::int64_t milliseconds) {
    constexpr std::int64_t kPoll_ms = 11;
    for (std::int64_t passed = 0; passed < milliseconds; passed += kPoll_ms) {
      advance_ms(kPoll_ms);
      poll();
      look(eva_);
      look(console_);
    }
  }
  void select() {
    v1::InstructorRequest request;
    request.mutable_select()->set_station(kSeat);
    ASSERT_TRUE(ask(console_, request).error().empty());
  }
  std::string row_18() const { return desk().view.screen.text(18); }
  const Desk& desk() const { return *eva_.visit->desk; }

  Caller console_ = call(v1::CLIENT_KIND_INSTRUCTOR);
  Caller eva_ = call();
};

// A beat comes once a second to those without the machine: whenever in that second the machine is given, the first
// START in view of the new situation counts.
TEST_F(Selected, AUTH_008_a_START_right_after_the_grant_counts_at_every_phase_of_the_beats) {
  log_in(eva_, "eva", kSeat);
  constexpr std::int64_t kStep_ms = 10, kLongest_ms = 1100;
  pass_ms(500);
  for (std::int64_t phase_ms = 0; phase_ms <= kLongest_ms; phase_ms += kStep_ms) {
    pass_ms(kLongest_ms + kStep_ms);
    select();
    poll();
    look(eva_);
    strike(eva_, Key::START);
    ASSERT_TRUE(desk().on_lab_machine) << row_18();
    for (const Key key : {Key::AUTOMAT, Key::ENTER, Key::ENTER, Key::START}) strike(eva_, key);
    ASSERT_EQ(row_18().find("START kam zu spät"), std::string::npos) << "phase " << phase_ms << " ms";
    strike(eva_, Key::STOP);
    v1::InstructorRequest release;
    release.mutable_release()->set_force(true);
    ASSERT_TRUE(ask(console_, release).error().empty());
    while (desk().on_lab_machine) pass_ms(10);
    while (desk().switching) poll();  // the beat that heeds the STOP is a real one
  }
}

TEST_F(Selected, AUTH_008_a_START_right_after_the_log_in_counts) {
  poll();  // a beat has just begun, the next one is 50 ms away
  log_in(eva_, "eva", kSeat);
  select();
  poll();
  look(eva_);
  for (const Key key : {Key::START, Key::AUTOMAT, Key::ENTER, Key::ENTER, Key::START}) strike(eva_, key);
  ASSERT_TRUE(desk().on_lab_machine);
  EXPECT_EQ(row_18().find("START kam zu spät"), std::string::npos);
}

TEST_F(Selected, AUTH_008_a_START_of_a_beat_older_than_a_second_does_not_count) {
  log_in(eva_, "eva", kSeat);
  select();
  poll();
  look(eva_);
  for (const Key key : {Key::START, Key::AUTOMAT, Key::ENTER, Key::ENTER}) strike(eva_, key);
  const std::uint64_t seen = eva_.beat;
  pass_ms(1060);
  eva_.beat = seen;
  strike(eva_, Key::START);
  EXPECT_NE(row_18().find("START kam zu spät"), std::string::npos) << row_18();
}

TEST_F(Selected, AUTH_007_when_the_computers_clock_jumps_the_lease_and_the_run_go_on) {
  log_in(eva_, "eva", kSeat);
  select();
  poll();
  look(eva_);
  for (const Key key : {Key::START, Key::AUTOMAT, Key::ENTER, Key::ENTER, Key::START}) strike(eva_, key);
  for (const std::int64_t jump_ms : {86'400'000LL, -2 * 86'400'000LL, 3'600'000LL}) {
    unix_ms_ += jump_ms;
    pass_ms(1500);
    ASSERT_TRUE(desk().on_lab_machine) << "a jump of " << jump_ms << " ms";
    ASSERT_TRUE(desk().control.is_running()) << "a jump of " << jump_ms << " ms";
  }
}

TEST_F(Selected, AUTH_007_a_wall_clock_that_stands_still_keeps_no_lease_alive) {
  log_in(eva_, "eva", kSeat);
  select();
  poll();
  look(eva_);
  for (const Key key : {Key::START, Key::AUTOMAT, Key::ENTER, Key::ENTER, Key::START}) strike(eva_, key);
  for (int silent_ms = 0; silent_ms <= 1100; silent_ms += 10) {
    advance_ms(10);
    poll();
  }
  while (desk().on_lab_machine) pass_ms(10);
  EXPECT_FALSE(desk().control.is_running());
}

}  // namespace
}  // namespace cnclab::lab
