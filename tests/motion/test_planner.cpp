// Joint speeds, the whole window, the cost of planning, and random operators on random paths.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "path_rig.hpp"
#include "seeded.hpp"

namespace cnclab::motion {
namespace {

struct JointRow {
  const char* name;
  geometry::Point first, second;  // directions
  double feed_before, feed_after;
  double expected_mm_per_s;
};

TEST(Planner, DEC21JointSpeeds) {
  const double half = std::sqrt(0.5);
  const std::vector<JointRow> rows{
      {"straight on", {1, 0, 0, 0}, {1, 0, 0, 0}, 3000, 3000, 50},
      {"straight on, slower behind", {1, 0, 0, 0}, {1, 0, 0, 0}, 3000, 600, 10},
      {"straight on, slower before", {0, 1, 0, 0}, {0, 1, 0, 0}, 600, 3000, 10},
      {"90° along the axes: each steps by v", {1, 0, 0, 0}, {0, 1, 0, 0}, 3000, 3000, 5},
      {"90° across the axes: X steps by √2·v", {half, half, 0, 0}, {-half, half, 0, 0}, 3000, 3000, 5 / (2 * half)},
      {"back again: 2·v", {0, 0, 1, 0}, {0, 0, -1, 0}, 3000, 3000, 2.5},
      {"slower than the joint", {1, 0, 0, 0}, {0, 1, 0, 0}, 120, 3000, 2},
      {"fourth axis", {1, 0, 0, 0}, {0, 0, 0, 1}, 3000, 3000, 5},
  };
  const Limits limits;
  for (const auto& row : rows) {
    const auto& d = row.first;
    const auto& e = row.second;
    const auto before = make_segment(line({-d.x, -d.y, -d.z, -d.u}, {}, row.feed_before), 1, limits);
    const auto after = make_segment(line({}, {e.x, e.y, e.z, e.u}, row.feed_after), 1, limits);
    EXPECT_NEAR(joint_speed(before, after, limits), row.expected_mm_per_s, 1e-9) << row.name;
  }
}

TEST(Planner, WindowFullChangesNothing) {
  SegmentQueue queue;
  Planner planner(queue, {});
  geometry::Point at;
  for (std::size_t i = 0; i < SegmentQueue::kWindow; ++i) {
    const geometry::Point to{at.x + 0.01, 0, 0, 0};
    ASSERT_EQ(planner.append(line(at, to, 1000)), i + 1);
    at = to;
  }
  planner.plan();
  const auto refused = planner.append(line(at, {at.x + 1, 0, 0, 0}, 1000));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), AppendError::window_full);
  EXPECT_EQ(queue.waiting(), 65'536U);
  EXPECT_EQ(queue.exit_speed(65'535), 0);
}

TEST(Planner, LooksAheadOverTheWholeWindow) {
  // 65 535 ways of 2 µm are 131 mm; with RAMPE 1 the braking way from F MAX is longer than that.
  Limits limits;
  limits.acceleration_mm_per_s2 = 100.0 / 60;  // RAMPE 1
  SegmentQueue queue;
  Planner planner(queue, limits);
  for (std::size_t i = 0; i + 1 < SegmentQueue::kWindow; ++i) {
    ASSERT_TRUE(planner.append(
        line({static_cast<double>(i) * 0.002, 0, 0, 0}, {static_cast<double>(i + 1) * 0.002, 0, 0, 0}, 3000)));
  }
  ASSERT_TRUE(planner.append(item_of(geometry::End{})));
  planner.plan();
  for (const std::size_t i : {0UL, 1000UL, 30'000UL, 65'000UL, 65'533UL}) {
    const double rest = static_cast<double>(65'534 - i) * 0.002;
    EXPECT_NEAR(queue.exit_speed(i), std::min(50.0, std::sqrt(25 + 2 * limits.acceleration_mm_per_s2 * rest)), 1e-6)
        << i;
  }
}

TEST(Planner, UnknownEndIsApproachedAsIfTheNextJointWereAtRest) {
  const Limits limits;
  SegmentQueue queue;
  Planner planner(queue, limits);
  ASSERT_TRUE(planner.append(line({}, {1, 0, 0, 0}, 3000)));
  ASSERT_TRUE(planner.append(line({1, 0, 0, 0}, {1.01, 0, 0, 0}, 3000)));
  planner.plan();
  const double ramp = 2 * limits.acceleration_mm_per_s2;
  EXPECT_NEAR(queue.exit_speed(0), std::sqrt(ramp * 0.01), 1e-9) << "whatever follows can still be met on the ramp";
  ASSERT_TRUE(planner.append(line({1.01, 0, 0, 0}, {0, 0, 0, 0}, 3000)));
  planner.plan();
  EXPECT_NEAR(queue.exit_speed(1), 2.5, 1e-9) << "straight back: half of F START/STOP";
  EXPECT_NEAR(queue.exit_speed(0), std::sqrt(2.5 * 2.5 + ramp * 0.01), 1e-9);
  ASSERT_TRUE(planner.append(item_of(geometry::Dwell{1})));
  planner.plan();
  EXPECT_EQ(queue.exit_speed(2), 0);
  EXPECT_NEAR(queue.exit_speed(1), 2.5, 1e-9);
}

TEST(Planner, FullStopIsReachedWithUpToStartStopOnceItIsKnown) {
  const Limits limits;
  for (const bool at_once : {true, false}) {
    SegmentQueue queue;
    Planner planner(queue, limits);
    ASSERT_TRUE(planner.append(line({}, {1, 0, 0, 0}, 3000)));
    ASSERT_TRUE(planner.append(line({1, 0, 0, 0}, {1.01, 0, 0, 0}, 3000)));
    if (!at_once) planner.plan();
    ASSERT_TRUE(planner.append(item_of(geometry::End{})));
    planner.plan();
    EXPECT_NEAR(queue.exit_speed(0), std::sqrt(25 + 2 * limits.acceleration_mm_per_s2 * 0.01), 1e-9) << at_once;
  }
}

TEST(Planner, RevisesEachSegmentAtMostTwiceOnAverageInBatches) {
  SegmentQueue queue;
  Planner planner(queue, {});
  geometry::Point at;
  for (int i = 0; i < 60'000; ++i) {
    const geometry::Point to{at.x + 0.05, 0, 0, 0};
    ASSERT_TRUE(planner.append(line(at, to, 3000)));
    at = to;
    if (i % 500 == 499) planner.plan();
  }
  EXPECT_LE(planner.revised(), 2 * 60'000U);
}

TEST(Planner, LongRowsOfEventsGetAFullStop) {
  PathRig rig;
  std::vector<geometry::PathItem> items{line({}, {10, 0, 0, 0}, 1200)};
  for (int i = 0; i < 500; ++i) items.push_back(item_of(geometry::Mark{}));
  items.push_back(line({10, 0, 0, 0}, {20, 0, 0, 0}, 1200));
  rig.append(items);
  EXPECT_EQ(rig.queue().exit_speed(0), 0);
}

// --- random operators on random paths --------------------------------------------------------------------------------

struct RandomPath {
  std::vector<geometry::PathItem> items;
  geometry::Point end;
};

RandomPath random_path(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  RandomPath path;
  double heading = between(0, 6.28);
  for (int i = 0; i < count; ++i) {
    const int kind = std::uniform_int_distribution<>(0, 9)(random);
    heading += kind < 6 ? between(-0.2, 0.2) : between(-3.1, 3.1);
    const double length = std::pow(10, between(-1.5, 1.3));
    const double feed = between(200, 3000);
    const geometry::Point from = path.end;
    geometry::Point to{from.x + length * std::cos(heading), from.y + length * std::sin(heading), from.z, 0};
    if (kind == 9) {
      path.items.push_back(rapid(from, to));
    } else if (kind >= 7) {
      const geometry::Point center{from.x - length * std::sin(heading), from.y + length * std::cos(heading), 0, 0};
      const double turn = between(0.2, 5);
      const double start = heading - std::numbers::pi / 2;
      to = {center.x + length * std::cos(start + turn), center.y + length * std::sin(start + turn), from.z, 0};
      heading += turn;
      path.items.push_back(
          item_of(geometry::Arc{from, to, center, geometry::Turn::counterclockwise, geometry::Plane::xy, feed}));
    } else {
      path.items.push_back(line(from, to, feed));
    }
    path.end = to;
  }
  return path;
}

RC_GTEST_PROP(Planner, AnyPathUnderAnyOperatorKeepsEveryRuleAndEndsOnItsEnd, ()) {
  RC_PRE(kSeeded);
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  RandomPath path = random_path(seed, *rc::gen::inRange(2, 60));
  std::mt19937 random(seed ^ 0x5A5A5A5AU);
  const auto chance = [&](double p) { return std::uniform_real_distribution<>(0, 1)(random) < p; };
  std::uint64_t sequence = 0;
  for (auto& item : path.items) {
    item.ends_block = chance(0.7);
    item.sequence = ++sequence;
    item.exact_stop = chance(0.1);
    item.override_off = chance(0.1);
  }
  Limits limits;
  limits.acceleration_mm_per_s2 = std::uniform_real_distribution<>(2, 900)(random);
  limits.stop_deceleration_mm_per_s2 = limits.acceleration_mm_per_s2 / std::uniform_real_distribution<>(1, 10)(random);
  limits.start_stop_mm_per_s = std::uniform_real_distribution<>(0.5, 20)(random);
  PathRig rig(limits);
  Demand demand;
  std::size_t next = 0;
  for (int tick = 0; tick < 2'000'000; ++tick) {
    while (next < path.items.size() && chance(0.2)) rig.append_unplanned(path.items[next++]);
    if (chance(0.1) || next == path.items.size()) rig.planner().plan();
    if (chance(0.002)) demand.override_ratio = chance(0.2) ? 0 : std::uniform_real_distribution<>(0.05, 1)(random);
    if (demand.override_ratio == 0 && chance(0.01)) demand.override_ratio = 1;
    if (chance(demand.stop ? 0.02 : 0.001)) demand.stop = !demand.stop;
    if (chance(0.001)) demand.single_block = !demand.single_block;
    rig.tick(demand);
    if (next == path.items.size() && rig.is_done()) break;
  }
  RC_ASSERT(rig.is_done());
  RC_ASSERT(rig.follower().position() == path.end);
  const std::string broken = broken_rule(rig, {});
  RC_LOG() << broken;
  RC_ASSERT(broken.empty());
}

}  // namespace
}  // namespace cnclab::motion
