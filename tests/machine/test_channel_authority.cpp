// Who may move: epochs, expiry, stops of every cause, power.
#include <gtest/gtest.h>

#include "channel_rig.hpp"

namespace cnclab::machine {
namespace {

std::vector<geometry::PathItem> long_way() {
  Items items;
  items.add(geometry::Spindle{geometry::SpindleTurn::clockwise, 1000}).add(geometry::Coolant{true});
  items.line_to({100, 0, 0, 0}, 3000);
  return items;
}

TEST(ChannelAuthority, AUTH012NothingMovesWithoutALease) {
  ChannelRig rig({}, false);
  rig.run(long_way());
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {1, 0, 0}}));
  ASSERT_TRUE(rig.channel.command(SwitchSpindle{kLease, {geometry::SpindleTurn::clockwise, 100}}));
  const Snapshot now = rig.tick(100);
  EXPECT_EQ(rig.machine.moving_ticks, 0);
  EXPECT_EQ(now.refused, 4U);
  EXPECT_EQ(now.spindle, geometry::SpindleTurn::off);
  EXPECT_FALSE(now.is_referenced);
}

struct StaleRow {
  const char* name;
  Command command;
};

TEST(ChannelAuthority, AUTH002EveryCommandWithAnOldEpochIsRefused) {
  const Epoch old{6};
  const std::vector<StaleRow> rows{{"Go", Go{old}},
                                   {"Go of nobody", Go{Epoch{0}}},
                                   {"Go of the future", Go{Epoch{8}}},
                                   {"SwitchSpindle", SwitchSpindle{old, {geometry::SpindleTurn::clockwise, 100}}},
                                   {"SwitchCoolant", SwitchCoolant{old, true}},
                                   {"SetIstwert", SetIstwert{old, {true, false, false}, {5, 0, 0}}},
                                   {"Jog", Jog{old, {1, 0, 0}}},
                                   {"RunReference", RunReference{old, {1, 0, 0}}}};
  for (const auto& row : rows) {
    ChannelRig rig;
    rig.channel.grant(old, kNeverExpires);  // epochs never go back
    rig.begin(long_way());
    rig.tick();
    ASSERT_TRUE(rig.channel.command(row.command));
    const Snapshot now = rig.tick(50);
    EXPECT_EQ(now.refused, 1U) << row.name;
    EXPECT_EQ(rig.machine.moving_ticks, 0) << row.name;
    EXPECT_EQ(now.istwert_mm[0], 0) << row.name;
    EXPECT_EQ(now.spindle, geometry::SpindleTurn::off) << row.name;
    EXPECT_FALSE(now.coolant) << row.name;
  }
}

TEST(ChannelAuthority, AUTH007ExpiredLeaseStopsOnTheRampByItself) {
  ChannelRig rig({}, false);
  rig.channel.grant(kLease, rig.now_ns + 1000 * kTick_ns);
  rig.run(long_way());
  rig.tick(900);
  EXPECT_GT(rig.channel.snapshot().speed_mm_per_min, 2900);
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.state == MotionState::stopping; }, 110));
  EXPECT_EQ(rig.channel.snapshot().spindle, geometry::SpindleTurn::off);
  EXPECT_FALSE(rig.channel.snapshot().coolant);
  EXPECT_GT(rig.channel.snapshot().speed_mm_per_min, 2800) << "on the ramp, not at once";
  ASSERT_TRUE(rig.tick_to_rest(1000));
  const Snapshot rest = rig.channel.snapshot();
  EXPECT_EQ(rest.cause, StopCause::lease_expired);
  EXPECT_FALSE(rest.run_active);
  EXPECT_FALSE(rest.lease_valid);
  rig.channel.grant(kLease, kNeverExpires);  // a dead lease does not come back
  rig.go();
  const Snapshot after = rig.tick(100);
  EXPECT_EQ(after.steps, rest.steps);
  EXPECT_EQ(after.refused, 1U);
}

TEST(ChannelAuthority, AUTH007RenewedLeaseGoesOn) {
  ChannelRig rig({}, false);
  rig.channel.grant(kLease, rig.now_ns + 300 * kTick_ns);
  rig.run(long_way());
  for (int i = 0; i < 20; ++i) {
    rig.channel.grant(kLease, rig.now_ns + 300 * kTick_ns);
    EXPECT_EQ(rig.tick(50).state, MotionState::moving) << i;
  }
}

TEST(ChannelAuthority, AUTH004RevokedLeaseStopsAndItsEpochIsDead) {
  ChannelRig rig;
  rig.run(long_way());
  rig.tick(500);
  rig.channel.revoke(StopCause::lease_ended);
  rig.tick();
  EXPECT_EQ(rig.channel.snapshot().state, MotionState::stopping);
  ASSERT_TRUE(rig.tick_to_rest(1000));
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::lease_ended);
  EXPECT_EQ(rig.channel.snapshot().spindle, geometry::SpindleTurn::off);
  const auto rest = rig.channel.snapshot().steps;
  rig.channel.grant(kLease, kNeverExpires);
  rig.run(long_way());
  EXPECT_EQ(rig.tick(100).steps, rest);
  rig.channel.grant(Epoch{8}, kNeverExpires);
  rig.begin(long_way(), {}, Epoch{8});
  rig.go(Epoch{8});
  EXPECT_NE(rig.tick(100).steps, rest);
}

TEST(ChannelAuthority, AUTH002NewLeaseEndsTheRunOfTheOldOne) {
  ChannelRig rig;
  rig.run(long_way());
  rig.tick(500);
  rig.channel.grant(Epoch{8}, kNeverExpires);
  rig.go(Epoch{8});
  ASSERT_TRUE(rig.tick_to_rest(1000));
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::lease_ended);
  EXPECT_FALSE(rig.channel.snapshot().run_active);
}

TEST(ChannelAuthority, AUTH009EventsPassedWhileBrakingForGoodSwitchNothingOn) {
  ChannelRig rig;
  Items items;
  items.line_to({10, 0, 0, 0}, 3000).add(geometry::Spindle{geometry::SpindleTurn::clockwise, 1000});
  items.add(geometry::Coolant{true}).add(geometry::Output{1, 3, true}).add(geometry::Signal{});
  items.line_to({50, 0, 0, 0}, 3000);
  rig.run(items);
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.path_mm[0] > 9; }));
  rig.channel.revoke(StopCause::lease_ended);
  ASSERT_TRUE(rig.tick_to_rest(1000));
  const Snapshot rest = rig.channel.snapshot();
  EXPECT_GT(rest.path_mm[0], 10) << "the events were passed";
  EXPECT_EQ(rest.spindle, geometry::SpindleTurn::off);
  EXPECT_FALSE(rest.coolant);
  EXPECT_EQ(rest.outputs[0], 0);
  EXPECT_EQ(rest.signals, 0U);
}

struct CauseRow {
  const char* name;
  StopCause cause;
  bool keeps_rest;
};

TEST(ChannelAuthority, AUTH009OnlyTheOperatorsStopKeepsTheRest) {
  const std::vector<CauseRow> rows{{"D-39 STOP", StopCause::operator_stop, true},
                                   {"AUTH-006 MASCHINE HALT", StopCause::machine_halt, false},
                                   {"error", StopCause::error, false}};
  for (const auto& row : rows) {
    ChannelRig rig;
    rig.run(long_way());
    rig.tick(500);
    rig.channel.stop(row.cause);
    EXPECT_GT(rig.tick().speed_mm_per_min, 2800) << row.name;
    ASSERT_TRUE(rig.tick_to_rest(1000)) << row.name;
    const Snapshot rest = rig.channel.snapshot();
    EXPECT_EQ(rest.cause, row.cause) << row.name;
    EXPECT_EQ(rest.run_active, row.keeps_rest) << row.name;
    EXPECT_EQ(rest.spindle == geometry::SpindleTurn::off, !row.keeps_rest) << row.name;
    EXPECT_EQ(rest.coolant, row.keeps_rest) << row.name;
    rig.go();
    EXPECT_EQ(rig.tick(100).steps != rest.steps, row.keeps_rest) << row.name;
  }
}

TEST(ChannelAuthority, AUTH006HaltDuringStopsBrakingStillAbandons) {
  ChannelRig rig;
  rig.run(long_way());
  rig.tick(500);
  rig.channel.stop(StopCause::operator_stop);
  rig.tick(5);
  rig.channel.stop(StopCause::machine_halt);
  ASSERT_TRUE(rig.tick_to_rest(1000));
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::machine_halt);
  EXPECT_FALSE(rig.channel.snapshot().run_active);
}

TEST(ChannelAuthority, AUTH006HaltAtRestWithSpindleOn) {
  ChannelRig rig;
  ASSERT_TRUE(rig.channel.command(SwitchSpindle{kLease, {geometry::SpindleTurn::clockwise, 100}}));
  EXPECT_EQ(rig.tick().spindle, geometry::SpindleTurn::clockwise);
  rig.channel.stop(StopCause::machine_halt);
  EXPECT_EQ(rig.tick().spindle, geometry::SpindleTurn::off);
}

TEST(ChannelAuthority, AUTH006LatchedHaltDropsStartCommandsUntilReleased) {
  ChannelRig rig;
  rig.channel.latch(true);
  rig.tick();
  rig.begin(long_way());
  rig.go();
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {1, 0, 0}}));
  ASSERT_TRUE(rig.channel.command(SwitchSpindle{kLease, {geometry::SpindleTurn::clockwise, 100}}));
  rig.tick(100);
  EXPECT_EQ(rig.machine.moving_ticks, 0);
  EXPECT_EQ(rig.machine.last.spindle, geometry::SpindleTurn::off);
  rig.channel.latch(false);
  rig.tick(100);
  EXPECT_EQ(rig.machine.moving_ticks, 0) << "releasing starts nothing";
  rig.begin(long_way());
  rig.go();
  rig.tick(100);
  EXPECT_GT(rig.machine.moving_ticks, 0);
}

TEST(ChannelAuthority, AUTH010PowerOffStopsAtOnceAndPowerOnStartsNothing) {
  ChannelRig rig;
  rig.run(long_way());
  rig.tick(500);
  ASSERT_TRUE(rig.channel.command(PowerOff{}));
  const Snapshot off = rig.tick();
  EXPECT_EQ(off.state, MotionState::off);
  EXPECT_EQ(off.cause, StopCause::power_off);
  EXPECT_EQ(off.speed_mm_per_min, 0);
  EXPECT_EQ(rig.machine.last.steps, motion::AxisSteps{});
  EXPECT_FALSE(rig.machine.last.drives_on);
  EXPECT_EQ(off.spindle, geometry::SpindleTurn::off);
  rig.go();
  EXPECT_EQ(rig.tick(50).steps, off.steps);
  ASSERT_TRUE(rig.channel.command(PowerOn{}));
  EXPECT_EQ(rig.tick(50).steps, off.steps);
  EXPECT_EQ(rig.channel.snapshot().state, MotionState::standstill);
  EXPECT_FALSE(rig.channel.snapshot().run_active);
}

TEST(ChannelAuthority, AUTH003OutputsKeepTheirStateButForThoseThatGoOffWithThePower) {
  ChannelRig rig;
  rig.channel.set_outputs_off_at_power_off({0b0000'0101, 0b1000'0000});
  rig.run(Items().add(geometry::Output{1, 0, true}).add(geometry::Output{2, 0, true}));
  ASSERT_EQ(rig.tick(5).outputs, (std::array<std::uint8_t, 2>{0xFF, 0xFF}));
  rig.channel.stop(StopCause::machine_halt);
  ASSERT_EQ(rig.tick(5).outputs, (std::array<std::uint8_t, 2>{0xFF, 0xFF})) << "a stop leaves them";
  ASSERT_TRUE(rig.channel.command(PowerOff{}));
  EXPECT_EQ(rig.tick(5).outputs, (std::array<std::uint8_t, 2>{0b1111'1010, 0b0111'1111}));
  ASSERT_TRUE(rig.channel.command(PowerOn{}));
  EXPECT_EQ(rig.tick(5).outputs, (std::array<std::uint8_t, 2>{0b1111'1010, 0b0111'1111})) << "power on starts nothing";
}

TEST(ChannelAuthority, FaultOfTheDriveIsAPowerOff) {
  ChannelRig rig;
  rig.run(long_way());
  rig.tick(500);
  rig.machine.fault = true;
  rig.tick(2);
  EXPECT_EQ(rig.channel.snapshot().state, MotionState::off);
  ASSERT_TRUE(rig.channel.command(PowerOn{}));
  EXPECT_EQ(rig.tick().state, MotionState::off) << "not while the fault lasts";
}

TEST(ChannelAuthority, AUTH009BackOffIsFinishedWithoutALease) {
  ChannelRig rig(data_with({{3, 40'000}}));
  rig.run(long_way());
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.cause == StopCause::limit_switch; }));
  rig.tick(20);
  rig.channel.revoke(StopCause::lease_ended);
  EXPECT_EQ(rig.tick().state, MotionState::stopping);
  ASSERT_TRUE(rig.tick_to_rest(1000));
  EXPECT_NEAR(static_cast<double>(rig.channel.snapshot().steps[0]), 19 * 200, 2);
  EXPECT_EQ(rig.channel.snapshot().istwert_mm[0], 0);
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::limit_switch);
}

}  // namespace
}  // namespace cnclab::machine
