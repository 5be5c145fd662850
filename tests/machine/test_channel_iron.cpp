// Runs that meet the iron: limit switches, G69, paths that jump, traces, changed machine data.
#include <gtest/gtest.h>

#include "channel_rig.hpp"

namespace cnclab::machine {
namespace {

TEST(ChannelIron, ERR020LimitSwitchStopsAtOnceFreesTheAxisAndZeroesIt) {
  const MachineData data = data_with({{3, 40'000}});  // switches at ±20 mm
  ChannelRig rig(data);
  Items items;
  items.line_to({100, 3, 0, 0}, 3000);
  rig.run(items);
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.limit[0]; }));
  const double speed_before = rig.channel.snapshot().speed_mm_per_min;
  EXPECT_GT(speed_before, 2000);
  const Snapshot stopped = rig.tick();
  EXPECT_EQ(stopped.cause, StopCause::limit_switch);
  EXPECT_EQ(stopped.limit_axis, 0);
  EXPECT_EQ(stopped.state, MotionState::stopping);
  EXPECT_EQ(rig.machine.last.steps, motion::AxisSteps{});
  EXPECT_FALSE(stopped.run_active);
  const auto y = stopped.steps[1];
  ASSERT_TRUE(rig.tick_to_rest(1000));
  const Snapshot freed = rig.channel.snapshot();
  EXPECT_NEAR(static_cast<double>(freed.steps[0]), (20.0 - 1.0) * 200, 2);  // 1 mm before the switch
  EXPECT_EQ(freed.steps[1], y);
  EXPECT_EQ(freed.istwert_mm[0], 0);
  EXPECT_NE(freed.istwert_mm[1], 0);
  EXPECT_FALSE(freed.limit[0]);
  EXPECT_FALSE(freed.is_referenced);
  rig.go();
  EXPECT_EQ(rig.tick(200).steps, freed.steps) << "AUTH-009: the run is abandoned";
}

TEST(ChannelIron, ERR020BackOffKeepsToStartStopSpeed) {
  ChannelRig rig(data_with({{4, 20'000}}));
  Items items;
  items.line_to({0, -50, 0, 0}, 3000);
  rig.run(items);
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.limit[1]; }));
  EXPECT_EQ(rig.tick().limit_axis, 1);
  int ticks = 0;
  while (rig.tick().state == MotionState::stopping) {
    ASSERT_LE(std::abs(rig.machine.last.steps[1]), 1);  // 5 mm/s are one step of 0.005 mm per tick
    ASSERT_GE(rig.machine.last.steps[1], 0);
    ++ticks;
  }
  EXPECT_NEAR(ticks, 200, 15);
}

TEST(ChannelIron, G690ReferenceInAProgramGoesOnFromTheSwitch) {
  ChannelRig rig(data_with({{3, 40'000}}));
  Items items;
  items.line_to({2, 0, 0, 0}).add(geometry::Reference{{true, false, false}, {-1, 0, 0}}).line_to({7, 0, 0, 0});
  items.add(geometry::End{});
  rig.run(items);
  ASSERT_TRUE(rig.tick_to_rest());
  const Snapshot end = rig.channel.snapshot();
  EXPECT_EQ(end.cause, StopCause::program_end);
  EXPECT_NEAR(static_cast<double>(end.steps[0]), (-20.0 + 1.0 + 5.0) * 200, 2);
  EXPECT_NEAR(end.istwert_mm[0], -1 + 5, 1e-9);  // G-691
  EXPECT_EQ(end.limit_axis, 0xFF) << "D-117: no ENDSCHALTER in G69";
}

TEST(ChannelIron, G690StopInTheSearchKeepsTheRest) {
  ChannelRig rig(data_with({{3, 40'000}}));
  Items items;
  items.add(geometry::Reference{{true, false, false}, {1, 0, 0}}).add(geometry::End{});
  rig.run(items);
  rig.tick(200);
  rig.channel.stop(StopCause::operator_stop);
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_TRUE(rig.channel.snapshot().run_active);
  rig.go();
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::program_end);
  EXPECT_EQ(rig.channel.snapshot().istwert_mm[0], 1);
}

TEST(ChannelIron, PathThatJumpsIsRefusedNotCommanded) {
  ChannelRig rig;
  Items items;
  items.line_to({1, 0, 0, 0});
  items.add(geometry::Line{{50, 0, 0, 0}, {51, 0, 0, 0}, 1000, false});
  rig.run(items);
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::error);
  EXPECT_LE(rig.channel.snapshot().steps[0], 201);
}

TEST(ChannelIron, TraceHasEveryTickOfTheRunAndCountsLostOnes) {
  ChannelRig rig;
  rig.channel.record_trace(true);
  Items items;
  items.line_to({10, 0, 0, 0}).add(geometry::End{});
  rig.run(items, {5, 0, 0, 0});
  std::vector<TracePoint> points;
  std::uint64_t lost = 0;
  while (rig.tick().started) lost += rig.channel.drain_trace(points);
  lost += rig.channel.drain_trace(points);
  EXPECT_EQ(lost, 0U);
  for (std::size_t i = 1; i < points.size(); ++i) ASSERT_EQ(points[i].tick, points[i - 1].tick + 1);
  EXPECT_EQ(points.back().steps[0], 2000);
  EXPECT_EQ(points[points.size() / 2].source, (geometry::SourceBlock{1, 1}));
  Items slow;
  slow.add(geometry::Dwell{20});
  rig.run(slow);
  rig.tick(10'000);
  points.clear();
  lost = rig.channel.drain_trace(points);
  EXPECT_GE(points.size(), 8192U);
  EXPECT_EQ(points.size() + lost, 10'001U);
}

TEST(ChannelIron, DEC28MachineDataActFromTheNextRun) {
  ChannelRig rig;
  Items items;
  items.line_to({10, 0, 0, 0}, 3000).add(geometry::End{});
  rig.run(items);
  rig.tick(10);
  EXPECT_FALSE(rig.channel.set_data(data_with({{6, 600}}))) << "not while started";
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_TRUE(rig.channel.set_data(data_with({{6, 600}})));
  rig.run(items);
  double fastest = 0;
  while (rig.channel.snapshot().started) fastest = std::max(fastest, rig.tick().speed_mm_per_min);
  EXPECT_NEAR(fastest, 600, 1e-6);
}

}  // namespace
}  // namespace cnclab::machine
