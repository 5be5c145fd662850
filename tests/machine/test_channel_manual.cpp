// Hand motion, reference runs, Istwert.
#include <gtest/gtest.h>

#include "channel_rig.hpp"

namespace cnclab::machine {
namespace {

TEST(ChannelManual, MOD005HandMovesAtPotentiometerTimesFMax) {
  ChannelRig rig;
  rig.channel.set_override(0.5);
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {1, -1, 0}}));
  rig.tick(500);
  const auto before = rig.channel.snapshot().steps;
  const Snapshot now = rig.tick(1000);
  EXPECT_NEAR(now.speed_mm_per_min, 1500, 1e-6);
  EXPECT_NEAR(static_cast<double>(now.steps[0] - before[0]) / 200, 25 / std::sqrt(2), 0.01);
  EXPECT_NEAR(static_cast<double>(now.steps[1] - before[1]) / 200, -25 / std::sqrt(2), 0.01);
  EXPECT_TRUE(now.started);
  rig.channel.stop(StopCause::operator_stop);
  ASSERT_TRUE(rig.tick_to_rest(1000));
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::operator_stop);
  rig.go();
  EXPECT_EQ(rig.tick(50).dropped, 1U) << "MOD-008: nothing is chosen any more";
}

TEST(ChannelManual, DEC40PotentiometerZeroMovesInSlowSingleSteps) {
  ChannelRig rig;
  rig.channel.set_override(0);
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {0, 0, 1}}));
  rig.tick(2000);
  EXPECT_NEAR(static_cast<double>(rig.machine.sum[2]), 10, 1);
  EXPECT_NEAR(rig.machine.moving_ticks, 10, 1);
}

TEST(ChannelManual, ERR021SwitchStopsTheHandAndOnlyAwayIsPossible) {
  ChannelRig rig(data_with({{5, 20'000}}));
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {0, 0, 1}}));
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.limit[2]; }));
  const Snapshot stopped = rig.tick();
  EXPECT_EQ(stopped.state, MotionState::standstill);
  EXPECT_EQ(stopped.cause, StopCause::limit_switch);
  EXPECT_EQ(stopped.limit_axis, 2);
  EXPECT_NE(stopped.istwert_mm[2], 0) << "D-117: no zeroing by hand";
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {0, 0, 1}}));
  EXPECT_EQ(rig.tick(50).steps, stopped.steps);
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {0, 0, -1}}));
  EXPECT_LT(rig.tick(50).steps[2], stopped.steps[2]);
}

TEST(ChannelManual, D11ReferenceRunEndsOneMillimetreFromTheSwitchesAtZero) {
  ChannelRig rig(data_with({{3, 40'000}, {4, 60'000}, {5, 30'000}}));
  ASSERT_TRUE(rig.channel.command(RunReference{kLease, {1, -1, 1}}));
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  const Snapshot end = rig.channel.snapshot();
  EXPECT_NEAR(static_cast<double>(end.steps[0]), (20.0 - 1) * 200, 2);
  EXPECT_NEAR(static_cast<double>(end.steps[1]), -(30.0 - 1) * 200, 2);
  EXPECT_NEAR(static_cast<double>(end.steps[2]), (15.0 - 1) * 200, 2);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(end.istwert_mm[i], 0) << i;
  EXPECT_TRUE(end.is_referenced);
  EXPECT_EQ(end.limit_axis, 0xFF) << "D-117: no message in a reference run";
  EXPECT_EQ(end.cause, StopCause::program_end);
}

TEST(ChannelManual, D11ReferencePlaceDoesNotDependOnSpeed) {
  std::array<std::int64_t, 3> places{};
  int i = 0;
  for (const double ratio : {0.1, 0.55, 1.0}) {
    ChannelRig rig(data_with({{3, 40'000}}));
    rig.channel.set_override(ratio);
    ASSERT_TRUE(rig.channel.command(RunReference{kLease, {-1, 0, 0}}));
    rig.tick();
    ASSERT_TRUE(rig.tick_to_rest());
    places[static_cast<std::size_t>(i++)] = rig.channel.snapshot().steps[0];
  }
  EXPECT_NEAR(static_cast<double>(places[0] - places[1]), 0, 1);
  EXPECT_NEAR(static_cast<double>(places[0] - places[2]), 0, 1);
}

TEST(ChannelManual, MOD013StopEndsAReferenceRun) {
  ChannelRig rig;
  ASSERT_TRUE(rig.channel.command(RunReference{kLease, {1, 0, 0}}));
  rig.tick(300);
  rig.channel.stop(StopCause::operator_stop);
  ASSERT_TRUE(rig.tick_to_rest(1000));
  EXPECT_FALSE(rig.channel.snapshot().is_referenced);
  EXPECT_FALSE(rig.channel.snapshot().started);
}

TEST(ChannelManual, DEC23FastRamplessStopLosesTheReferenceASlowOneDoesNot) {
  for (const bool fast : {true, false}) {
    ChannelRig rig(data_with({{3, 10'000}, {4, 10'000}, {5, 10'000}}));
    ASSERT_TRUE(rig.channel.command(RunReference{kLease, {1, 1, 1}}));
    rig.tick();
    ASSERT_TRUE(rig.tick_to_rest());
    ASSERT_TRUE(rig.channel.snapshot().is_referenced);
    rig.channel.set_override(fast ? 1 : 0.05);  // 150 mm/min is below F START/STOP 300
    ASSERT_TRUE(rig.channel.command(Jog{kLease, {-1, 0, 0}}));
    ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.cause == StopCause::limit_switch; }));
    EXPECT_EQ(rig.channel.snapshot().is_referenced, !fast) << fast;
  }
}

TEST(ChannelManual, MOD010IstwertRenamesAndMovesNothing) {
  ChannelRig rig;
  ASSERT_TRUE(rig.channel.command(SetIstwert{kLease, {true, false, true}, {12.345, 9, -7}}));
  const Snapshot now = rig.tick(10);
  EXPECT_NEAR(now.istwert_mm[0], 12.345, 1e-12);
  EXPECT_EQ(now.istwert_mm[1], 0);
  EXPECT_EQ(now.istwert_mm[2], -7);
  EXPECT_EQ(rig.machine.moving_ticks, 0);
}

}  // namespace
}  // namespace cnclab::machine
