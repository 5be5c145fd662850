// A beat that stalls takes the current from the machine (AUTH-007, AUTH-009, AUTH-010).
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "channel_rig.hpp"
#include "comes_true.hpp"
#include "machine/watchdog.hpp"

namespace cnclab::machine {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

TEST(StallDetector, TellsOncePerStall) {
  StallDetector detector(std::chrono::milliseconds(100));
  EXPECT_FALSE(detector.look(0, 0));
  EXPECT_FALSE(detector.look(0, 99 * kMillisecond));
  EXPECT_TRUE(detector.look(0, 100 * kMillisecond));
  EXPECT_FALSE(detector.look(0, 300 * kMillisecond)) << "still the same stall";
  EXPECT_FALSE(detector.look(1, 301 * kMillisecond));
  EXPECT_FALSE(detector.look(1, 400 * kMillisecond));
  EXPECT_TRUE(detector.look(1, 401 * kMillisecond));
}

TEST(StallDetector, ABeatThatGoesOnIsNeverAStall) {
  StallDetector detector(std::chrono::milliseconds(100));
  for (std::uint64_t tick = 0; tick < 1000; ++tick) {
    EXPECT_FALSE(detector.look(tick, static_cast<std::int64_t>(tick) * 99 * kMillisecond));
  }
}

TEST(SimulatedMachine, CutTakesTheCurrentUntilThePowerOffWasSeen) {
  SimulatedMachine machine({});
  Outputs outputs;
  outputs.steps = {5, 0, 0, 0};
  (void)machine.exchange(outputs);
  machine.cut();
  (void)machine.exchange(outputs);
  EXPECT_EQ(machine.position_steps()[0], 5);
  (void)machine.exchange({.drives_on = false});
  (void)machine.exchange(outputs);
  EXPECT_EQ(machine.position_steps()[0], 10);
}

TEST(ChannelCut, StopsWithoutRampSwitchesOffAndNeedsPowerOn) {
  ChannelRig rig;
  Items items;
  items.add(geometry::Spindle{geometry::SpindleTurn::clockwise, 500}).line_to({50, 0, 0, 0}, 3000);
  rig.run(items);
  rig.tick(500);
  rig.channel.cut();
  const Snapshot off = rig.tick();
  EXPECT_EQ(off.state, MotionState::off);
  EXPECT_EQ(off.cause, StopCause::power_off);
  EXPECT_EQ(off.spindle, geometry::SpindleTurn::off);
  EXPECT_FALSE(off.run_active);
  EXPECT_EQ(rig.machine.last.steps, motion::AxisSteps{});
  rig.go();
  EXPECT_EQ(rig.tick(50).steps, off.steps);
}

/// A driver that hangs in its tick until it is let go.
class HangingMachine final : public Machine {
 public:
  Inputs exchange(const Outputs& outputs) noexcept override {
    drives_on = outputs.drives_on;
    while (hangs.load()) std::this_thread::yield();
    return {};
  }
  void cut() noexcept override { cuts.fetch_add(1); }

  std::atomic<bool> hangs{false}, drives_on{true};
  std::atomic<int> cuts{0};
};

TEST(Watchdog, AHangingDriverIsCutFromOutsideTheTick) {
  HangingMachine machine;
  const auto channel = std::make_shared<Channel>(machine, MachineData{});
  TickThread beat;
  Watchdog watchdog(beat);
  ASSERT_TRUE(beat.add(channel));
  watchdog.guard(channel);
  ASSERT_TRUE(comes_true([&] { return channel->snapshot().tick > 5; }));
  const int before = machine.cuts;
  machine.hangs = true;
  EXPECT_TRUE(comes_true([&] { return machine.cuts > before; }));
  EXPECT_GE(watchdog.stalls(), 1U);
  machine.hangs = false;
  EXPECT_TRUE(comes_true([&] { return channel->snapshot().state == MotionState::off; }))
      << "and so says the tick later";
  EXPECT_TRUE(comes_true([&] { return !machine.drives_on; }));
  beat.remove(channel);
}

}  // namespace
}  // namespace cnclab::machine
