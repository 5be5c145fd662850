// A recorded run fed back: same trajectory tick by tick, divergences named, damaged recordings refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "channel_rig.hpp"
#include "machine/recorder.hpp"

namespace cnclab::machine {
namespace {

std::vector<geometry::PathItem> program(double way_mm) {
  Items items;
  items.line_to({way_mm, 3, -1, 0}, 1800).add(geometry::Spindle{geometry::SpindleTurn::counterclockwise, 1234});
  items.add(geometry::Wait{1, 5}).add(geometry::Output{2, 3, true}).add(geometry::SpindleDigits{-7});
  items.add(geometry::Arc{
      {way_mm, 3, -1, 0}, {way_mm, 3, -1, 0}, {0, 3, 0, 0}, geometry::Turn::clockwise, geometry::Plane::xy, 900});
  items.add(geometry::Reference{{false, true, false}, {0, 1, 0}}).add(geometry::Signal{});
  items.add(geometry::Line{{way_mm, 1, -1, 0}, {99, 1, -1, 0}, 3000, false});  // onto the switch
  return items;
}

/// A run with an operator, on any machine; the trajectory of every tick.
std::vector<std::array<std::int64_t, 4>> trajectory(Machine& machine, double way_mm, SimulatedMachine* simulated) {
  Channel channel(machine, data_with({{3, 60'000}, {4, 30'000}}));
  std::vector<std::array<std::int64_t, 4>> steps;
  channel.grant(kLease, kNeverExpires);
  std::int64_t now_ns = 0;
  for (int tick = 0; tick < 12'000; ++tick) {
    if (tick == 1) {
      motion::Planner* planner = channel.begin_run(kLease, {});
      for (const auto& item : program(way_mm)) EXPECT_TRUE(planner->append(item));
      planner->plan();
      EXPECT_TRUE(channel.command(Go{kLease}));
    }
    if (tick == 150) channel.stop(StopCause::operator_stop);
    if (tick == 400 && !channel.command(Go{kLease})) ADD_FAILURE();
    if (tick == 700) channel.set_override(0.6);
    if (tick == 1500 && simulated != nullptr) simulated->set_input(1, 5, true);
    channel.tick(now_ns += kTick_ns, kTick_s);
    steps.push_back(channel.snapshot().steps);
  }
  EXPECT_EQ(channel.snapshot().cause, StopCause::limit_switch);
  return steps;
}

MachineData recorded_data() { return data_with({{3, 60'000}, {4, 30'000}}); }

TEST(Recorder, ReplayGivesTheSameTrajectoryTickByTick) {
  SimulatedMachine simulated(recorded_data());
  MachineRecorder recorder(simulated);
  const auto first = trajectory(recorder, 6, &simulated);
  EXPECT_EQ(recorder.ticks_lost(), 0U);
  const auto bytes = recorder.bytes();
  EXPECT_LT(bytes.size(), 12'000U * 5) << "some bytes per tick";
  ReplayMachine replay(bytes);
  EXPECT_EQ(trajectory(replay, 6, nullptr), first);
  EXPECT_EQ(replay.report().ticks, 12'000U);
  EXPECT_EQ(replay.report().diverging, 0U);
  EXPECT_EQ(replay.report().beyond, 0U);
  EXPECT_TRUE(replay.report().fault.empty());
}

TEST(Recorder, DivergenceNamesItsFirstTickAndBothSides) {
  SimulatedMachine simulated(recorded_data());
  MachineRecorder recorder(simulated);
  const auto first = trajectory(recorder, 6, &simulated);
  const auto bytes = recorder.bytes();
  ReplayMachine replay(bytes);
  const auto other = trajectory(replay, 5, nullptr);
  ASSERT_TRUE(replay.report().first);
  const auto [a, b] = std::ranges::mismatch(first, other);
  const Divergence& divergence = *replay.report().first;
  EXPECT_EQ(divergence.tick, static_cast<std::uint64_t>(a - first.begin()) + 1);
  EXPECT_NE(divergence.recorded.outputs.steps, divergence.replayed.outputs.steps);
  EXPECT_EQ(divergence.recorded.inputs, divergence.replayed.inputs) << "the machine answers as it did";
}

TEST(Recorder, PlayedIntoAnEqualMachineItAnswersTheSame) {
  SimulatedMachine simulated(recorded_data());
  MachineRecorder recorder(simulated);
  (void)trajectory(recorder, 6, &simulated);
  SimulatedMachine again(recorded_data());
  const ReplayReport report = play(recorder.bytes(), again);
  EXPECT_EQ(report.ticks, 12'000U);
  EXPECT_EQ(again.position_steps(), simulated.position_steps());
  ASSERT_TRUE(report.first) << "nobody set the input of card 1";
  EXPECT_EQ(report.first->tick, 1501U);
  EXPECT_EQ(report.first->recorded.inputs.cards[0], 0x10);
  EXPECT_EQ(report.first->replayed.inputs.cards[0], 0);
}

TEST(Recorder, MemoryIsBoundedAndLostTicksAreCounted) {
  SimulatedMachine simulated({});
  MachineRecorder recorder(simulated, 105);
  for (int i = 0; i < 1000; ++i) (void)recorder.exchange({});
  EXPECT_EQ(recorder.bytes().size(), 105U);
  EXPECT_EQ(recorder.ticks_lost(), 900U);
}

TEST(Recorder, BehindTheEndTheLastInputsStand) {
  SimulatedMachine simulated({});
  simulated.set_input(0, 0, true);
  MachineRecorder recorder(simulated);
  for (int i = 0; i < 3; ++i) (void)recorder.exchange({});
  const auto bytes = recorder.bytes();
  ReplayMachine replay(bytes);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(replay.exchange({}).input_1);
  EXPECT_EQ(replay.report().ticks, 3U);
  EXPECT_EQ(replay.report().beyond, 2U);
}

TEST(Recording, TheFormatIsTheDocumentedOne) {
  std::array<std::uint8_t, 64> memory{};
  RecordingWriter writer(memory);
  RecordedTick tick;
  tick.outputs.steps = {3, 0, -1, 0};
  ASSERT_TRUE(writer.write(tick));
  tick.outputs.steps = {0, 0, 0, 300};
  tick.outputs.spindle = geometry::SpindleTurn::counterclockwise;
  tick.outputs.spindle_rpm = 2000;
  tick.inputs.limit_minus[1] = true;
  tick.inputs.cards[1] = 0x80;
  ASSERT_TRUE(writer.write(tick));
  const std::vector<std::uint8_t> expected{'C',  'N',  'C',  'R', 1,     // header
                                           0x05, 6,    1,                // 3 of X, −1 of Z
                                           0x38, 0xD8, 0x04,             // 300 of U, both changed
                                           0x21, 0xA0, 0x1F, 0,   0, 0,  // drives, left, 2000
                                           0x20, 0,    0,    0x80};      // −Y, card 2 line 8
  EXPECT_EQ(std::vector(memory.begin(), memory.begin() + static_cast<std::ptrdiff_t>(writer.size())), expected);
}

TEST(Recording, ExtremeValuesComeBack) {
  std::array<std::uint8_t, 256> memory{};
  RecordingWriter writer(memory);
  RecordedTick tick;
  tick.outputs.steps = {INT32_MAX, INT32_MIN, -1, 1};
  tick.outputs.spindle_rpm = INT32_MAX;
  tick.outputs.s_digits = INT32_MIN;
  tick.outputs.spindle = geometry::SpindleTurn::clockwise;
  tick.outputs.cards = {0xFF, 0xA5};
  tick.inputs.limit_plus = {true, true, true, true};
  tick.inputs.fault = true;
  ASSERT_TRUE(writer.write(tick));
  ASSERT_LE(writer.size(), kRecordingHeader + kLongestTick);
  RecordingReader reader{std::span(memory).first(writer.size())};
  const auto read = reader.next();
  ASSERT_TRUE(read && *read);
  EXPECT_EQ(**read, tick);
  const auto end = reader.next();
  EXPECT_TRUE(end && !*end);
}

TEST(Recording, EveryCutAndEveryChangedByteIsReadOrRefusedButNeverMore) {
  SimulatedMachine simulated(data_with({{3, 4000}}));
  MachineRecorder recorder(simulated);
  Outputs outputs;
  for (int i = 0; i < 60; ++i) {
    outputs.steps = {i * 37 % 90, -i, 0, i % 7 == 0 ? 100'000 : 0};
    outputs.coolant = i % 11 == 0;
    (void)recorder.exchange(outputs);
  }
  const auto whole = recorder.bytes();
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    RecordingReader reader{std::span(whole).first(cut)};
    int ticks = 0;
    for (auto tick = reader.next(); tick && *tick; tick = reader.next()) ++ticks;
    EXPECT_LE(ticks, 60);
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const std::uint8_t value : std::array<std::uint8_t, 4>{0x00, 0x3F, 0x80, 0xFF}) {
      auto damaged = whole;
      damaged[at] = value;
      RecordingReader reader(damaged);
      std::size_t ticks = 0;
      for (auto tick = reader.next(); tick && *tick; tick = reader.next()) ++ticks;
      EXPECT_LE(ticks, whole.size());
    }
  }
  EXPECT_FALSE(RecordingReader({}).next());
}

}  // namespace
}  // namespace cnclab::machine
