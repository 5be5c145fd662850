// Steps: different steps/mm per axis, sums over whole programs, what ISTWERT counts, and how regular the stream is.
#include <gtest/gtest.h>

#include <cmath>

#include "channel_rig.hpp"
#include "geometry/step_grid.hpp"

namespace cnclab::machine {
namespace {

struct StepsRow {
  const char* name;
  std::array<int, 4> per_mm;
  geometry::Point end;
};

/// Lines, arcs, a helix and the fourth axis, to `end` at last.
std::vector<geometry::PathItem> program_to(const geometry::Point& end) {
  Items items;
  items.line_to({3.3333, -1.2345, 0.777, 0}, 2000);
  items.add(geometry::Arc{{3.3333, -1.2345, 0.777, 0},
                          {5.3333, 0.7655, 0.777, 0},
                          {3.3333, 0.7655, 0, 0},
                          geometry::Turn::counterclockwise,
                          geometry::Plane::xy,
                          900});
  items.add(geometry::Arc{{5.3333, 0.7655, 0.777, 0},
                          {5.3333, 0.7655, 2.001, 0},
                          {4.3333, 0.7655, 0, 0},
                          geometry::Turn::clockwise,
                          geometry::Plane::xy,
                          900});
  items.add(geometry::Line{{5.3333, 0.7655, 2.001, 0}, {5.3333, 0.7655, 2.001, end.u}, 700, false});
  items.add(geometry::Line{{5.3333, 0.7655, 2.001, end.u}, end, 1500, false}).add(geometry::End{});
  return items;
}

TEST(Steps, MD114SumIsTheRoundedEndPositionOnEveryAxis) {
  const std::vector<StepsRow> rows{{"equal", {200, 200, 200, 200}, {7.0013, -2.5, 1.111, 4}},
                                   {"different", {200, 400, 125, 80}, {7.0013, -2.5071, 1.1119, 4.321}},
                                   {"coarse and fine", {1, 3, 9999, 7}, {7.5001, -2.5, 1.11119, -0.5}},
                                   {"primes", {193, 211, 227, 233}, {-3.14159, 2.71828, -1.41421, 0.57721}}};
  for (const auto& row : rows) {
    MachineData data;
    for (int axis = 0; axis < 4; ++axis) ASSERT_TRUE(data.set(14 + axis, row.per_mm[static_cast<std::size_t>(axis)]));
    ChannelRig rig(data);
    rig.run(program_to(row.end));
    ASSERT_TRUE(rig.tick_to_rest()) << row.name;
    const Snapshot end = rig.channel.snapshot();
    ASSERT_EQ(end.cause, StopCause::program_end) << row.name;
    const std::array<double, 4> mm{row.end.x, row.end.y, row.end.z, row.end.u};
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const std::int64_t expected = std::llround(mm[axis] * row.per_mm[axis]);
      EXPECT_EQ(rig.machine.sum[axis], expected) << row.name << ' ' << axis;
      EXPECT_EQ(rig.machine.simulated.position_steps()[axis], expected) << row.name << ' ' << axis;
      EXPECT_NEAR(end.istwert_mm[axis], static_cast<double>(expected) / row.per_mm[axis], 1e-9)
          << row.name << ": ISTWERT counts steps, axis " << axis;
    }
  }
}

TEST(Steps, MD131SmallestWayIsOneStep) {
  ChannelRig rig;
  Items items;
  items.line_to({0.005, 0.0024, 0.0026, 0}, 100).add(geometry::End{});
  rig.run(items);
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.machine.sum, (std::array<std::int64_t, 4>{1, 0, 1, 0}));
}

TEST(Steps, EX130RoundedIncrementsShowTheOriginalsRests) {
  ChannelRig rig;
  Items items;
  // `[control] rests = "original"`: each increment of 10.003 mm is rounded to 2001 steps before it is added (D-115).
  const double rounded = static_cast<double>(std::llround(10.003 * 200)) / 200;
  for (int i = 1; i <= 10; ++i) items.line_to({i * rounded, 0, 0, 0}, 3000);
  items.add(geometry::End{});
  rig.run(items);
  ASSERT_TRUE(rig.tick_to_rest());
  EXPECT_EQ(rig.machine.sum[0], 20010);
  EXPECT_NEAR(rig.channel.snapshot().istwert_mm[0], 100.050, 1e-9);
}

TEST(Steps, G031EllipseClosesAndIsTwiceAsWideAsHigh) {
  ChannelRig rig(data_with({{14, 200}, {15, 400}}));
  geometry::PathItem circle;
  circle.what = geometry::Arc{{}, {}, {-5, 0, 0, 0}, geometry::Turn::counterclockwise, geometry::Plane::xy, 900};
  circle.sequence = 1;
  std::vector<geometry::PathItem> items;
  geometry::append_in_step_grid(circle, {200, 400, 200, 200}, items);
  rig.run(items);
  std::array<std::int64_t, 2> low{}, high{};
  ASSERT_TRUE(rig.tick_until([&](const Snapshot& now) {
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], now.steps[i]);
      high[i] = std::max(high[i], now.steps[i]);
    }
    return rig.channel.queue().waiting() == 0 && now.speed_mm_per_min == 0;
  }));
  EXPECT_EQ(rig.machine.sum, (std::array<std::int64_t, 4>{}));
  EXPECT_NEAR(static_cast<double>(high[0] - low[0]), 2000, 1) << "10 mm wide";
  EXPECT_NEAR(static_cast<double>(high[1] - low[1]), 2000, 1) << "as many steps high, which are 5 mm";
}

TEST(Steps, ERR045StreamIsRegular) {
  ChannelRig rig;
  Items items;
  items.line_to({2, 0, 0, 0}, 90);  // 300 steps/s, below F START/STOP: no ramp
  rig.run(items);
  int last = -1, shortest = 1000, longest = 0;
  for (int tick = 0; tick < 1200; ++tick) {
    rig.tick();
    if (rig.machine.last.steps[0] == 0) continue;
    ASSERT_EQ(rig.machine.last.steps[0], 1);
    if (last >= 0) {
      shortest = std::min(shortest, tick - last);
      longest = std::max(longest, tick - last);
    }
    last = tick;
  }
  EXPECT_EQ(shortest, 3);
  EXPECT_EQ(longest, 4) << "3⅓ ticks each";
}

}  // namespace
}  // namespace cnclab::machine
