// Runs on a channel: steps, events, STOP and START, single block, limit switches.
#include <gtest/gtest.h>

#include <functional>

#include "channel_rig.hpp"

namespace cnclab::machine {
namespace {

TEST(ChannelRun, D105StepsAreTheRoundedEndPositionHoweverManyBlocks) {
  ChannelRig rig;
  Items items;
  for (int i = 1; i <= 10; ++i) items.line_to({i * 10.003, 0, 0, 0}, 3000);  // EX-130, rests exact (DEC-05)
  items.add(geometry::End{});
  rig.run(items);
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.machine.sum[0], 20006);  // 100.030 mm × 200
  const Snapshot end = rig.channel.snapshot();
  EXPECT_EQ(end.steps[0], 20006);
  EXPECT_NEAR(end.istwert_mm[0], 100.03, 1e-9);
  EXPECT_EQ(end.cause, StopCause::program_end);
  EXPECT_FALSE(end.started);
  EXPECT_FALSE(end.run_active);
  EXPECT_EQ(end.finished_sequence, 11U);
}

TEST(ChannelRun, StepsStayWithinHalfAStepOfThePath) {
  ChannelRig rig;
  Items items;
  items.line_to({33.333, 17.1, -4.7, 0}, 2000);
  rig.run(items);
  for (int i = 0; i < 1500; ++i) {
    const Snapshot now = rig.tick();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_LE(std::abs(static_cast<double>(now.steps[axis]) - now.path_mm[axis] * 200), 0.5 + 1e-9) << i;
    }
    const double t = now.path_mm[0] / 33.333;
    ASSERT_NEAR(now.path_mm[1], 17.1 * t, 1e-9);
    ASSERT_NEAR(now.path_mm[2], -4.7 * t, 1e-9);
  }
}

TEST(ChannelRun, NothingMovesBeforeGo) {
  ChannelRig rig;
  Items items;
  items.line_to({10, 0, 0, 0});
  rig.begin(items);
  const Snapshot now = rig.tick(500);
  EXPECT_EQ(rig.machine.moving_ticks, 0);
  EXPECT_TRUE(now.run_active);
  EXPECT_FALSE(now.started);
  EXPECT_EQ(now.run, rig.channel.planner().run());
}

TEST(ChannelRun, EX021StopInMidMoveThenStartRunsTheRest) {
  ChannelRig rig;
  Items items;
  items.line_to({10, 0, 0, 0}).add(geometry::End{});
  rig.run(items);
  rig.tick(200);
  rig.channel.stop(StopCause::operator_stop);
  EXPECT_EQ(rig.tick().state, MotionState::stopping);
  EXPECT_TRUE(rig.channel.snapshot().started) << "START state lasts until standstill";
  ASSERT_TRUE(rig.tick_to_rest());
  const Snapshot rest = rig.channel.snapshot();
  EXPECT_FALSE(rest.started);
  EXPECT_TRUE(rest.run_active);
  EXPECT_EQ(rest.cause, StopCause::operator_stop);
  EXPECT_GT(rest.steps[0], 0);
  EXPECT_LT(rest.steps[0], 2000);
  rig.tick(100);
  EXPECT_EQ(rig.channel.snapshot().steps[0], rest.steps[0]);
  rig.go();
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().steps[0], 2000);
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::program_end);
}

TEST(ChannelRun, EX022AbandonForgetsTheRestAndKeepsThePosition) {
  ChannelRig rig;
  Items items;
  items.line_to({10, 0, 0, 0});
  rig.run(items);
  rig.tick(200);
  rig.channel.stop(StopCause::operator_stop);
  ASSERT_TRUE(rig.tick_to_rest());
  const auto rest = rig.channel.snapshot().steps;
  ASSERT_TRUE(rig.channel.command(Abandon{}));
  rig.go();
  rig.tick(500);
  EXPECT_EQ(rig.channel.snapshot().steps, rest);
  EXPECT_FALSE(rig.channel.snapshot().run_active);
  EXPECT_EQ(rig.channel.snapshot().dropped, 1U);
}

TEST(ChannelRun, AbandonInMotionBrakesFirst) {
  ChannelRig rig;
  Items items;
  items.line_to({100, 0, 0, 0}, 3000);
  rig.run(items);
  rig.tick(1000);
  ASSERT_TRUE(rig.channel.command(Abandon{}));
  double before = rig.tick().speed_mm_per_min;
  while (rig.channel.snapshot().state != MotionState::standstill) {
    const double now = rig.tick().speed_mm_per_min;
    ASSERT_TRUE(before - now <= 60 * 138.9 * kTick_s + 1e-6 || (now == 0 && before <= 300 + 9)) << before << ' ' << now;
    before = now;
  }
  EXPECT_FALSE(rig.channel.snapshot().run_active);
}

TEST(ChannelRun, G040DwellTakesItsTimeAndIsKeptThroughStop) {
  ChannelRig rig;
  Items items;
  items.add(geometry::Dwell{1.0}).add(geometry::End{});
  rig.run(items);
  rig.tick(400);
  rig.channel.stop(StopCause::operator_stop);
  EXPECT_EQ(rig.tick().state, MotionState::standstill);
  rig.tick(5000);
  rig.go();
  int ticks = 0;
  while (rig.tick().started) ++ticks;
  EXPECT_NEAR(ticks, 600, 3);
}

TEST(ChannelRun, KEY045EinzelsatzPressedInADwellRestsBehindIt) {
  ChannelRig rig;
  Items items;
  items.add(geometry::Dwell{1.0}).add(geometry::Dwell{1.0}).add(geometry::End{});
  rig.run(items);
  rig.tick(400);
  rig.channel.set_single_block(true);
  int ticks = 0;
  while (rig.tick().started) ++ticks;
  EXPECT_NEAR(ticks, 600, 3);
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::single_block);
}

struct EventRow {
  const char* name;
  std::vector<geometry::PathItem> items;
  std::function<bool(const Snapshot&)> holds;
};

TEST(ChannelRun, EventsDoWhatTheySay) {
  using namespace geometry;
  const std::vector<EventRow> rows{
      {"M-003 spindle clockwise", Items().add(Spindle{SpindleTurn::clockwise, 1500}),
       [](const Snapshot& s) { return s.spindle == SpindleTurn::clockwise && s.spindle_rpm == 1500; }},
      {"M-004 spindle counterclockwise", Items().add(Spindle{SpindleTurn::counterclockwise, 900}),
       [](const Snapshot& s) { return s.spindle == SpindleTurn::counterclockwise && s.spindle_rpm == 900; }},
      {"M-005 spindle off", Items().add(Spindle{SpindleTurn::clockwise, 900}).add(Spindle{}),
       [](const Snapshot& s) { return s.spindle == SpindleTurn::off; }},
      {"M-009 coolant off", Items().add(Coolant{true}).add(Coolant{false}),
       [](const Snapshot& s) { return !s.coolant; }},
      {"M-080 all outputs of card 2 off", Items().add(Output{2, 5, true}).add(Output{2, 0, false}),
       [](const Snapshot& s) { return s.outputs[1] == 0; }},
      {"M-008 coolant on", Items().add(Coolant{true}), [](const Snapshot& s) { return s.coolant; }},
      {"M-043 output 3 of card 1", Items().add(Output{1, 3, true}),
       [](const Snapshot& s) { return s.outputs[0] == 4; }},
      {"M-070 all outputs of card 2", Items().add(Output{2, 0, true}),
       [](const Snapshot& s) { return s.outputs[1] == 0xFF; }},
      {"M-083 output 3 off", Items().add(Output{2, 0, true}).add(Output{2, 3, false}),
       [](const Snapshot& s) { return s.outputs[1] == 0xFB; }},
      {"M-015 signal", Items().add(Signal{}), [](const Snapshot& s) { return s.signals == 1; }},
      {"G-680 Istwert by G68", Items().add(SetActual{{true, false, true}, {5, 9, -2.5}}),
       [](const Snapshot& s) { return s.istwert_mm[0] == 5 && s.istwert_mm[1] == 0 && s.istwert_mm[2] == -2.5; }},
  };
  for (const auto& row : rows) {
    ChannelRig rig;
    rig.run(row.items);
    EXPECT_TRUE(row.holds(rig.tick(5))) << row.name;
    EXPECT_EQ(rig.machine.moving_ticks, 0) << row.name;
  }
}

TEST(ChannelRun, G680RenamesWithoutJumping) {
  ChannelRig rig;
  Items items;
  items.line_to({10, 0, 0, 0}).add(geometry::SetActual{{true, false, false}, {100, 0, 0}}).line_to({12, 0, 0, 0});
  items.add(geometry::End{});
  rig.run(items);
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().steps[0], 2400);
  EXPECT_NEAR(rig.channel.snapshot().istwert_mm[0], 102, 1e-9);
  EXPECT_NEAR(rig.channel.snapshot().path_mm[0], 12, 1e-9);
}

TEST(ChannelRun, M000HaltWaitsForGo) {
  ChannelRig rig;
  Items items;
  items.line_to({1, 0, 0, 0}).add(geometry::Halt{true}).line_to({2, 0, 0, 0}).add(geometry::End{});
  rig.run(items);
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.state == MotionState::halted; }));
  const Snapshot halted = rig.tick(300);
  EXPECT_EQ(halted.state, MotionState::halted);
  EXPECT_EQ(halted.cause, StopCause::programmed_halt);
  EXPECT_TRUE(halted.started);
  EXPECT_EQ(halted.signals, 1U);
  EXPECT_EQ(halted.steps[0], 200);
  rig.go();
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().steps[0], 400);
}

TEST(ChannelRun, M000StopThenStartGoesOnBehindTheHalt) {
  ChannelRig rig;
  Items items;
  items.add(geometry::Halt{}).line_to({2, 0, 0, 0}).add(geometry::End{});
  rig.run(items);
  rig.tick(10);
  rig.channel.stop(StopCause::operator_stop);
  EXPECT_EQ(rig.tick().state, MotionState::standstill);
  rig.go();
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().steps[0], 400);
}

struct WaitRow {
  const char* name;
  geometry::Wait wait;
  std::vector<std::pair<int, int>> lines;  ///< card and line that have to become active, the last one decides
};

TEST(ChannelRun, WaitsForInputs) {
  std::vector<std::pair<int, int>> all, all_of_2;
  for (int i = 1; i <= 8; ++i) all.emplace_back(1, i);
  for (int i = 8; i >= 1; --i) all_of_2.emplace_back(2, i);
  const std::vector<WaitRow> rows{{"M-016 Input 1", {0, 0}, {{0, 0}}},
                                  {"M-063 card 1 line 3", {1, 3}, {{1, 3}}},
                                  {"M-098 card 2 line 8", {2, 8}, {{2, 8}}},
                                  {"M-060 all of card 1", {1, 0}, all},
                                  {"M-090 all of card 2", {2, 0}, all_of_2}};
  for (const auto& row : rows) {
    ChannelRig rig;
    Items items;
    items.add(row.wait).line_to({1, 0, 0, 0}).add(geometry::End{});
    rig.run(items);
    for (const auto& [card, line] : row.lines) {
      const Snapshot waits = rig.tick(20);
      EXPECT_EQ(waits.state, MotionState::halted) << row.name;
      EXPECT_EQ(waits.cause, StopCause::waiting_for_input) << row.name;
      rig.machine.simulated.set_input(card, line, true);
    }
    ASSERT_TRUE(rig.tick_to_rest()) << row.name;
    EXPECT_EQ(rig.channel.snapshot().steps[0], 200) << row.name;
  }
}

TEST(ChannelRun, D15StartCancelsAWait) {
  ChannelRig rig;
  Items items;
  items.add(geometry::Wait{0, 0}).line_to({1, 0, 0, 0}).add(geometry::End{});
  rig.run(items);
  rig.tick(20);
  rig.go();
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().steps[0], 200);
}

TEST(ChannelRun, MOD054EinzelsatzDoesExactlyOneBlockPerGo) {
  ChannelRig rig;
  Items items;
  items.add(geometry::Mark{}).line_to({1, 0, 0, 0}).add(geometry::Spindle{geometry::SpindleTurn::clockwise, 100});
  items.line_to({2, 0, 0, 0}).add(geometry::Dwell{0.05}).line_to({3, 0, 0, 0}).add(geometry::Halt{});
  items.line_to({4, 0, 0, 0}).add(geometry::End{});
  rig.channel.set_single_block(true);
  rig.begin(items);
  for (std::uint64_t block = 1; block <= 6; ++block) {
    rig.go();
    rig.tick();
    ASSERT_TRUE(rig.tick_to_rest()) << block;
    EXPECT_EQ(rig.channel.snapshot().finished_sequence, block);
    EXPECT_EQ(rig.channel.snapshot().cause, StopCause::single_block);
    rig.tick(50);
    EXPECT_EQ(rig.channel.snapshot().finished_sequence, block);
  }
  rig.go();
  EXPECT_EQ(rig.tick(3).state, MotionState::halted) << "M00 is a block too; its halt is its rest";
  rig.go();
  rig.tick();
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.channel.snapshot().finished_sequence, 8U);
  EXPECT_EQ(rig.channel.snapshot().steps[0], 800);
}

TEST(ChannelRun, AUTH006StopIsNotUndoneByAnOlderGo) {
  ChannelRig rig;
  Items items;
  items.line_to({10, 0, 0, 0});
  rig.begin(items);
  rig.tick();
  rig.go();
  rig.channel.stop(StopCause::operator_stop);
  rig.tick(200);
  EXPECT_EQ(rig.machine.moving_ticks, 0);
  EXPECT_EQ(rig.channel.snapshot().dropped, 1U);
  rig.go();
  rig.tick(200);
  EXPECT_GT(rig.machine.moving_ticks, 0);
}

TEST(ChannelRun, FullCommandRingIsToldToTheCaller) {
  ChannelRig rig;
  for (int i = 0; i < 64; ++i) ASSERT_TRUE(rig.channel.command(Abandon{})) << i;
  EXPECT_FALSE(rig.channel.command(Abandon{}));
  EXPECT_EQ(rig.channel.begin_run(kLease, {}), nullptr);
  EXPECT_FALSE(rig.channel.is_settled());
  rig.tick();
  EXPECT_TRUE(rig.channel.is_settled());
  EXPECT_TRUE(rig.channel.command(Abandon{}));
}

TEST(ChannelRun, SegmentsPushedAfterAnAbandonmentNeverMove) {
  ChannelRig rig;
  Items items;
  items.line_to({10, 0, 0, 0});
  rig.run(items);
  rig.tick(100);
  rig.channel.stop(StopCause::machine_halt);
  ASSERT_TRUE(rig.tick_to_rest());
  const auto rest = rig.channel.snapshot().steps;
  motion::Planner& planner = rig.channel.planner();  // the lab thread has not looked yet
  Items late;
  late.line_to({20, 0, 0, 0});
  for (const auto& item : static_cast<const std::vector<geometry::PathItem>&>(late)) ASSERT_TRUE(planner.append(item));
  planner.plan();
  rig.go();
  rig.tick(500);
  EXPECT_EQ(rig.channel.snapshot().steps, rest);
  EXPECT_EQ(rig.channel.queue().waiting(), 0U);
}

}  // namespace
}  // namespace cnclab::machine
