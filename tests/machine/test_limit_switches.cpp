// Limit switches on every axis, U included, on machines that do not behave (ERR-020 to ERR-022, D-117, HW-009).
#include <gtest/gtest.h>

#include <functional>

#include "channel_rig.hpp"

namespace cnclab::machine {
namespace {

/// A machine whose switches are a function of its position in mm and of the tick.
class SwitchMachine final : public Machine {
 public:
  using Switches = std::function<void(const std::array<double, 4>& mm, int tick, Inputs& inputs)>;
  explicit SwitchMachine(Switches switches) : switches_(std::move(switches)) {}

  Inputs exchange(const Outputs& outputs) noexcept override {
    for (std::size_t i = 0; i < 4; ++i) {
      mm[i] += outputs.steps[i] / 200.0;
    }
    last = outputs;
    Inputs inputs;
    switches_(mm, ++tick, inputs);
    return inputs;
  }

  std::array<double, 4> mm{};
  Outputs last;
  int tick = 0;

 private:
  Switches switches_;
};

class SwitchRig {
 public:
  explicit SwitchRig(SwitchMachine::Switches switches) : machine(std::move(switches)), channel(machine, {}) {
    channel.grant(kLease, kNeverExpires);
    tick();
  }
  Snapshot tick(int count = 1) {
    for (int i = 0; i < count; ++i) channel.tick(now_ns += kTick_ns, kTick_s);
    return channel.snapshot();
  }
  void run(const std::vector<geometry::PathItem>& items) {
    motion::Planner* planner = channel.begin_run(kLease, {});
    for (const auto& item : items) ASSERT_TRUE(planner->append(item));
    planner->plan();
    ASSERT_TRUE(channel.command(Go{kLease}));
  }
  bool rests(int most = 100'000) {
    for (int i = 0; i < most; ++i) {
      if (tick().state == MotionState::standstill) return true;
    }
    return false;
  }

  SwitchMachine machine;
  Channel channel;
  std::int64_t now_ns = 0;
};

std::vector<geometry::PathItem> way(const geometry::Point& to, bool rapid = false) {
  return Items().add(geometry::Line{{}, to, 3000, rapid}).add(geometry::End{});
}

struct AxisRow {
  const char* name;
  std::size_t axis;
  geometry::Point to;
  double switch_mm;  ///< signed
};

TEST(LimitSwitches, ERR020EveryAxisInBothDirectionsIsFreedByOneMillimetreAndZeroed) {
  const std::vector<AxisRow> rows{{"+X", 0, {90, 4, 0, 0}, 30},   {"-X", 0, {-90, 4, 0, 0}, -30},
                                  {"+Y", 1, {0, 90, 0, 3}, 25},   {"-Y", 1, {2, -90, 0, 0}, -25},
                                  {"+Z", 2, {0, 0, 90, 0}, 20},   {"-Z", 2, {0, 9, -90, 0}, -20},
                                  {"+U", 3, {0, 0, 0, 90}, 15.5}, {"-U", 3, {0, 0, 0, -90}, -15.5}};
  for (const auto& row : rows) {
    for (const bool rapid : {false, true}) {
      SwitchRig rig([&row](const auto& mm, int, Inputs& inputs) {
        inputs.limit_plus[row.axis] = row.switch_mm > 0 && mm[row.axis] >= row.switch_mm;
        inputs.limit_minus[row.axis] = row.switch_mm < 0 && mm[row.axis] <= row.switch_mm;
      });
      rig.run(way(row.to, rapid));
      ASSERT_TRUE(rig.rests()) << row.name;
      const Snapshot end = rig.channel.snapshot();
      EXPECT_EQ(end.cause, StopCause::limit_switch) << row.name;
      EXPECT_EQ(end.limit_axis, row.axis) << row.name << ": ERR-022 shows it by its place";
      EXPECT_NEAR(rig.machine.mm[row.axis], row.switch_mm - std::copysign(1.0, row.switch_mm), 0.011) << row.name;
      EXPECT_EQ(end.istwert_mm[row.axis], 0) << row.name;
      for (std::size_t i = 0; i < 4; ++i) {
        if (i == row.axis) continue;
        EXPECT_NEAR(end.istwert_mm[i], rig.machine.mm[i], 1e-9) << row.name << ' ' << i;
      }
      EXPECT_FALSE(end.run_active) << row.name;
    }
  }
}

TEST(LimitSwitches, ERR020TwoAxesAtOnceAreBothFreed) {
  SwitchRig rig([](const auto& mm, int, Inputs& inputs) {
    inputs.limit_plus[0] = mm[0] >= 20;
    inputs.limit_minus[1] = mm[1] <= -20;
  });
  rig.run(way({50, -50, 0, 0}));
  ASSERT_TRUE(rig.rests());
  const Snapshot end = rig.channel.snapshot();
  EXPECT_EQ(end.limit_axis, 0) << "the first of them is named";
  EXPECT_NEAR(rig.machine.mm[0], 19, 0.011);
  EXPECT_NEAR(rig.machine.mm[1], -19, 0.011);
  EXPECT_EQ(end.istwert_mm[0], 0);
  EXPECT_EQ(end.istwert_mm[1], 0);
}

TEST(LimitSwitches, BouncingSwitchIsLeftByAWholeMillimetreAfterItsLastBounce) {
  SwitchRig rig([](const auto& mm, int tick, Inputs& inputs) {
    const bool bounces = mm[0] >= 19.7 && mm[0] < 20 && tick % 3 == 0;
    inputs.limit_plus[0] = mm[0] >= 20 || bounces;
  });
  rig.run(way({50, 0, 0, 0}));
  ASSERT_TRUE(rig.rests());
  EXPECT_LT(rig.machine.mm[0], 18.75);
  EXPECT_GT(rig.machine.mm[0], 18.5);
}

TEST(LimitSwitches, SwitchThatNeverOpensEndsTheBackOffAndTheReference) {
  SwitchRig rig([](const auto& mm, int tick, Inputs& inputs) { inputs.limit_plus[0] = tick > 300 || mm[0] > 400; });
  rig.run(way({100, 0, 0, 0}));
  ASSERT_TRUE(rig.rests());
  EXPECT_GT(rig.machine.mm[0], -31) << "30 mm at most, then the switch counts as broken";
  EXPECT_FALSE(rig.channel.snapshot().is_referenced);
  rig.tick();
  EXPECT_EQ(rig.machine.last.steps, motion::AxisSteps{});
}

TEST(LimitSwitches, D117AxisThatStandsOnASwitchMayLeaveItByProgram) {
  SwitchRig rig([](const auto& mm, int, Inputs& inputs) { inputs.limit_plus[0] = mm[0] >= -0.5; });
  rig.run(way({-10, 0, 0, 0}));
  ASSERT_TRUE(rig.rests());
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::program_end);
  EXPECT_NEAR(rig.machine.mm[0], -10, 1e-9);
}

TEST(LimitSwitches, D117AxisOnASwitchIsNotDrivenFurtherInByProgram) {
  SwitchRig rig([](const auto& mm, int, Inputs& inputs) { inputs.limit_plus[0] = mm[0] >= -0.5; });
  rig.run(way({10, 0, 0, 0}));
  rig.tick(3);
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::limit_switch);
  EXPECT_LE(rig.machine.mm[0], 0.011) << "one tick at F START/STOP";
  ASSERT_TRUE(rig.rests());
  EXPECT_NEAR(rig.machine.mm[0], -1.5, 0.02);
}

TEST(LimitSwitches, SwitchInTheRampOfAStopIsHeededToo) {
  SwitchRig rig([](const auto& mm, int, Inputs& inputs) { inputs.limit_plus[0] = mm[0] >= 40; });
  rig.run(way({100, 0, 0, 0}));
  while (rig.machine.mm[0] < 38) rig.tick();
  rig.channel.stop(StopCause::operator_stop);
  ASSERT_TRUE(rig.rests());
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::limit_switch) << "more than a STOP, which would keep the rest";
  EXPECT_FALSE(rig.channel.snapshot().run_active);
  EXPECT_NEAR(rig.machine.mm[0], 39, 0.011);
}

TEST(LimitSwitches, HaltDuringBackOffStopsItAndLosesTheReference) {
  SwitchRig rig([](const auto& mm, int, Inputs& inputs) { inputs.limit_plus[0] = mm[0] >= 20; });
  rig.run(way({100, 0, 0, 0}));
  while (rig.tick().cause != StopCause::limit_switch) ASSERT_LT(rig.machine.tick, 5000);
  rig.tick(30);
  rig.channel.stop(StopCause::machine_halt);
  rig.tick();
  const double rest = rig.machine.mm[0];
  EXPECT_EQ(rig.tick(300).state, MotionState::standstill);
  EXPECT_EQ(rig.machine.mm[0], rest);
}

TEST(LimitSwitches, MOD011ReferenceOfAnAxisThatStandsOnItsSwitchOnlyBacksOff) {
  SwitchRig rig([](const auto& mm, int, Inputs& inputs) { inputs.limit_minus[2] = mm[2] <= 0.25; });
  ASSERT_TRUE(rig.channel.command(RunReference{kLease, {0, 0, -1}}));
  rig.tick();
  ASSERT_TRUE(rig.rests());
  EXPECT_NEAR(rig.machine.mm[2], 1.25, 0.011);
  EXPECT_EQ(rig.channel.snapshot().istwert_mm[2], 0);
}

TEST(LimitSwitches, MOD011OnlyTheChosenAxesMoveInAReferenceRun) {
  SwitchRig rig([](const auto& mm, int, Inputs& inputs) { inputs.limit_plus[1] = mm[1] >= 30; });
  ASSERT_TRUE(rig.channel.command(RunReference{kLease, {0, 1, 0}}));
  rig.tick();
  ASSERT_TRUE(rig.rests());
  EXPECT_EQ(rig.machine.mm[0], 0);
  EXPECT_NEAR(rig.machine.mm[1], 29, 0.011) << "MOD-012";
  EXPECT_EQ(rig.machine.mm[2], 0);
  EXPECT_FALSE(rig.channel.snapshot().is_referenced) << "X and Z are not";
}

struct ReferenceRow {
  const char* name;
  double value;
  double switch_mm;
};

TEST(LimitSwitches, G690SignIsTheDirectionAndTheValueTheIstwert) {
  for (const auto& row : {ReferenceRow{"G-690 positive", 12.5, 20},
                          {"G-690 negative", -3, -20},
                          {"G-693 zero drives in positive direction", 0, 20}}) {
    SwitchRig rig([](const auto& mm, int, Inputs& inputs) {
      inputs.limit_plus[0] = mm[0] >= 20;
      inputs.limit_minus[0] = mm[0] <= -20;
    });
    Items items;
    items.line_to({2, 3, 0, 0}).add(geometry::Reference{{true, false, false}, {row.value, 0, 0}}).add(geometry::End{});
    rig.run(items);
    ASSERT_TRUE(rig.rests()) << row.name;
    EXPECT_EQ(rig.channel.snapshot().istwert_mm[0], row.value) << row.name;
    EXPECT_NEAR(rig.channel.snapshot().istwert_mm[1], 3, 1e-9) << row.name << ": G-692";
    EXPECT_NEAR(rig.machine.mm[0], row.switch_mm - std::copysign(1.0, row.switch_mm), 0.011) << row.name;
    EXPECT_EQ(rig.channel.snapshot().limit_axis, 0xFF) << row.name << ": D-117, no message";
  }
}

TEST(LimitSwitches, G694NegativeSwitchWithZeroedIstwert) {
  SwitchRig rig([](const auto& mm, int, Inputs& inputs) { inputs.limit_minus[0] = mm[0] <= -20; });
  Items items;
  items.add(geometry::Reference{{true, false, false}, {-1, 0, 0}});
  items.add(geometry::SetActual{{true, false, false}, {0, 0, 0}}).add(geometry::End{});
  rig.run(items);
  ASSERT_TRUE(rig.rests());
  EXPECT_EQ(rig.channel.snapshot().istwert_mm[0], 0);
  EXPECT_NEAR(rig.machine.mm[0], -19, 0.011);
}

}  // namespace
}  // namespace cnclab::machine
