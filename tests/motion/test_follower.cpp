// Profiles with closed formulas, stops, potentiometer, rapids, exact stop, single block.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "path_rig.hpp"

namespace cnclab::motion {
namespace {

constexpr double kAcceleration = 500.0 / 3;  // RAMPE 100 → 100/60 mm/s in 10 ms (DEC-20)
constexpr double kStartStop = 5;             // F START/STOP 300 mm/min

Limits standard() {
  Limits limits;
  limits.acceleration_mm_per_s2 = kAcceleration;
  limits.stop_deceleration_mm_per_s2 = kAcceleration / 1.2;
  return limits;
}

/// Time for a straight way from and to F START/STOP with ramps (trapezoid or triangle).
double trapezoid_s(double way, double feed_mm_per_s, double a = kAcceleration, double jump = kStartStop) {
  const double start = std::min(jump, feed_mm_per_s);
  const double ramps = (feed_mm_per_s * feed_mm_per_s - start * start) / a;
  if (ramps <= way) return 2 * (feed_mm_per_s - start) / a + (way - ramps) / feed_mm_per_s;
  const double peak = std::sqrt(start * start + a * way);
  return 2 * (peak - start) / a;
}

struct ProfileRow {
  const char* name;
  geometry::Point to;
  double feed_mm_per_min;
  double way_mm;
};

class Profile : public testing::TestWithParam<ProfileRow> {};

TEST_P(Profile, TakesTheTimeOfTheTrapezoid) {
  const ProfileRow& row = GetParam();
  PathRig rig(standard());
  rig.append({line({}, row.to, row.feed_mm_per_min)});
  EXPECT_NEAR(rig.segments()[0].length_mm, row.way_mm, 1e-6);
  ASSERT_TRUE(rig.run_out());
  EXPECT_NEAR(rig.time_s(), trapezoid_s(row.way_mm, row.feed_mm_per_min / 60), 1.01e-3);
  EXPECT_EQ(rig.follower().position(), row.to);
  EXPECT_EQ(broken_rule(rig, {}), "");
}

INSTANTIATE_TEST_SUITE_P(Dec20, Profile,
                         testing::Values(ProfileRow{"EX-030 X100 Y100 F1000", {100, 100, 0, 0}, 1000, 141.421356},
                                         ProfileRow{"F MAX over 200 mm", {200, 0, 0, 0}, 3000, 200},
                                         ProfileRow{"triangle: too short for the feed", {0, 5, 0, 0}, 3000, 5},
                                         ProfileRow{"slower than F START/STOP: no ramp", {0, 0, 3, 0}, 120, 3},
                                         ProfileRow{"one step", {0.005, 0, 0, 0}, 1000, 0.005},
                                         ProfileRow{"fourth axis", {0, 0, 0, 20}, 600, 20}),
                         [](const auto& row) {
                           std::string name = row.param.name;
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
                           return name;
                         });

TEST(Follower, EX030SteadySpeedIs1000AndEachAxis707) {
  PathRig rig(standard());
  rig.append({line({}, {100, 100, 0, 0}, 1000)});
  for (int i = 0; i < 4000; ++i) rig.tick();
  const auto& a = rig.samples()[2000];
  const auto& b = rig.samples()[3000];
  EXPECT_NEAR(b.speed * 60, 1000, 1e-6);
  EXPECT_NEAR((b.position.x - a.position.x) * 60, 707.107, 1e-3);  // one second
  EXPECT_NEAR((b.position.y - a.position.y) * 60, 707.107, 1e-3);
}

TEST(Follower, DEC22RapidStopsFullyBeforeAndAfter) {
  PathRig rig(standard());
  rig.append(
      {line({}, {10, 0, 0, 0}, 1000), rapid({10, 0, 0, 0}, {20, 0, 0, 0}), line({20, 0, 0, 0}, {30, 0, 0, 0}, 1000)});
  ASSERT_TRUE(rig.run_out());
  int rests = 0;
  for (std::size_t i = 1; i + 1 < rig.samples().size(); ++i) {
    const auto& sample = rig.samples()[i];
    const bool at_joint = sample.position.x == 10 || sample.position.x == 20;
    if (sample.speed != 0 || rig.samples()[i - 1].speed == 0 || !at_joint) continue;
    ++rests;
    EXPECT_EQ(rig.samples()[i + 1].position, sample.position) << "a full stop lasts a whole tick";
  }
  EXPECT_EQ(rests, 2);
  EXPECT_NEAR(rig.time_s(), 2 * trapezoid_s(10, 1000.0 / 60) + trapezoid_s(10, 50), 6e-3);
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, DEC21CollinearBlocksAreOneMotion) {
  PathRig rig(standard());
  std::vector<geometry::PathItem> items;
  for (int i = 0; i < 1000; ++i) items.push_back(line({i * 0.1, 0, 0, 0}, {(i + 1) * 0.1, 0, 0, 0}, 2000));
  items.push_back(item_of(geometry::End{}));
  rig.append(items);
  ASSERT_TRUE(rig.run_out());
  EXPECT_NEAR(rig.time_s(), trapezoid_s(100, 2000.0 / 60), 2e-3);
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, DEC21SquareCornerIsPassedWithStartStop) {
  PathRig rig(standard(), 1e-5);
  rig.append({line({}, {10, 0, 0, 0}, 1000), line({10, 0, 0, 0}, {10, 10, 0, 0}, 1000)});
  EXPECT_NEAR(rig.queue().exit_speed(0), kStartStop, 1e-12);
  ASSERT_TRUE(rig.run_out());
  double slowest = 1e9;
  for (const auto& sample : rig.samples()) {
    if (sample.position.x > 9.9 && sample.position.y < 0.1) slowest = std::min(slowest, sample.speed);
  }
  EXPECT_NEAR(slowest, kStartStop, 0.01);
}

TEST(Follower, DEC21SlowerBlockIsEnteredAtItsSpeed) {
  PathRig rig(standard(), 1e-4);
  rig.append({line({}, {20, 0, 0, 0}, 2400), line({20, 0, 0, 0}, {30, 0, 0, 0}, 600)});
  EXPECT_NEAR(rig.queue().exit_speed(0), 10, 1e-12);
  ASSERT_TRUE(rig.run_out());
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, ArcSpeedKeepsCentripetalWithinRamp) {
  PathRig rig(standard());
  geometry::Arc circle{{1, 0, 0, 0},        {1, 0, 0, 0}, {0, 0, 0, 0}, geometry::Turn::counterclockwise,
                       geometry::Plane::xy, 3000};
  rig.append({item_of(circle)});
  ASSERT_TRUE(rig.run_out());
  double fastest = 0;
  for (const auto& sample : rig.samples()) fastest = std::max(fastest, sample.speed);
  const double limit = std::sqrt(kAcceleration * 1);  // 12.9 mm/s, far below F 3000
  EXPECT_NEAR(fastest, limit, 1e-9);
  EXPECT_NEAR(rig.time_s(), trapezoid_s(2 * std::numbers::pi, limit), 1.01e-3);
  EXPECT_EQ(rig.follower().position(), circle.to);
  EXPECT_EQ(broken_rule(rig, {1, 0, 0, 0}), "");
}

TEST(Follower, G610ExactStopCreepsOverSchleichwegAtHalfStartStop) {
  PathRig rig(standard());
  auto exact = line({}, {20, 0, 0, 0}, 1000);
  exact.exact_stop = true;
  rig.append({exact, line({20, 0, 0, 0}, {30, 0, 0, 0}, 1000)});
  ASSERT_TRUE(rig.run_out());
  int creeping = 0;
  bool rested = false;
  for (const auto& sample : rig.samples()) {
    if (sample.position.x > 19.5 && sample.position.x < 20) {
      EXPECT_LE(sample.speed, kStartStop / 2 + 1e-9);
      ++creeping;
    }
    rested = rested || (sample.position.x == 20 && sample.speed == 0);
  }
  EXPECT_NEAR(creeping, 200, 2);  // 0.5 mm at 2.5 mm/s
  EXPECT_TRUE(rested);
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, D39StopBrakesOnItsOwnRampAndGoesOnExactlyThere) {
  PathRig rig(standard());
  rig.append({line({}, {50, 0, 0, 0}, 3000)});
  while (rig.follower().position().x < 25) rig.tick();
  const double from = rig.follower().position().x;
  int braking = 0;
  while (rig.tick({.stop = true}).speed > 0) ++braking;
  const double decel = kAcceleration / 1.2;
  EXPECT_NEAR(rig.follower().position().x - from, (2500 - 25) / (2 * decel), 0.06);
  EXPECT_NEAR(braking, 45 / decel * 1000, 2);
  const double rest = rig.follower().position().x;
  for (int i = 0; i < 50; ++i) rig.tick({.stop = true});
  EXPECT_EQ(rig.follower().position().x, rest);
  ASSERT_TRUE(rig.run_out());
  EXPECT_EQ(rig.follower().position().x, 50);
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, StopNearACornerKeepsTheCornersSpeed) {
  for (const double at : {16.0, 17.0, 18.0, 18.5, 19.0, 19.5, 19.9}) {
    PathRig rig(standard());
    rig.append({line({}, {20, 0, 0, 0}, 3000), line({20, 0, 0, 0}, {0, 0.5, 0, 0}, 3000)});
    while (rig.follower().position().x < at && rig.queue().popped() == 0) rig.tick();
    while (rig.tick({.stop = true}).speed > 0) {
    }
    ASSERT_TRUE(rig.run_out());
    EXPECT_EQ(broken_rule(rig, {}), "") << at;
  }
}

struct OverrideRow {
  double ratio;
};

TEST(Follower, DEC40PotentiometerScalesTheSpeed) {
  for (const double ratio : {0.1, 0.5, 0.99}) {
    PathRig rig(standard());
    rig.append({line({}, {50, 0, 0, 0}, 1200)});
    ASSERT_TRUE(rig.run_out({.override_ratio = ratio}));
    EXPECT_NEAR(rig.time_s(), trapezoid_s(50, 20 * ratio), 1.01e-3) << ratio;
    EXPECT_EQ(broken_rule(rig, {}), "") << ratio;
  }
}

TEST(Follower, DEC40PotentiometerZeroStandsStillAndChangesActInTheNextTick) {
  PathRig rig(standard());
  rig.append({line({}, {50, 0, 0, 0}, 1200)});
  for (int i = 0; i < 500; ++i) rig.tick();
  EXPECT_NEAR(rig.follower().speed_mm_per_s(), 20, 1e-9);
  EXPECT_NEAR(rig.tick({.override_ratio = 0}).speed, 20 - kAcceleration * 1e-3, 1e-9);
  for (int i = 0; i < 100; ++i) rig.tick({.override_ratio = 0});
  const double rest = rig.follower().position().x;
  EXPECT_EQ(rig.follower().speed_mm_per_s(), 0);
  for (int i = 0; i < 100; ++i) rig.tick({.override_ratio = 0});
  EXPECT_EQ(rig.follower().position().x, rest);
  ASSERT_TRUE(rig.run_out());
  EXPECT_EQ(rig.follower().position().x, 50);
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, M023OverrideOffIgnoresThePotentiometer) {
  PathRig rig(standard());
  auto item = line({}, {30, 0, 0, 0}, 1200);
  item.override_off = true;
  rig.append({item});
  ASSERT_TRUE(rig.run_out({.override_ratio = 0}));
  EXPECT_NEAR(rig.time_s(), trapezoid_s(30, 20), 1.01e-3);
}

TEST(Follower, M023RowOfShortWaysRunsAtFullFeedWhateverThePotentiometerSays) {
  for (const double ratio : {0.0, 0.05, 0.6}) {
    PathRig rig(standard());
    std::vector<geometry::PathItem> items;
    for (int i = 0; i < 3000; ++i) {
      items.push_back(line({i * 0.01, 0, 0, 0}, {(i + 1) * 0.01, 0, 0, 0}, 3000));
      items.back().override_off = true;
      if (i % 7 == 0) items.push_back(item_of(geometry::Mark{}));
    }
    items.push_back(item_of(geometry::End{}));
    rig.append(items);
    ASSERT_TRUE(rig.run_out({.override_ratio = ratio}));
    EXPECT_NEAR(rig.time_s(), trapezoid_s(30, 50), 2.1e-3) << ratio;
    EXPECT_EQ(broken_rule(rig, {}), "") << ratio;
  }
}

TEST(Follower, M023RowIsLeftAtThePotentiometersSpeed) {
  PathRig rig(standard());
  std::vector<geometry::PathItem> items;
  for (int i = 0; i < 4000; ++i) {
    items.push_back(line({i * 0.01, 0, 0, 0}, {(i + 1) * 0.01, 0, 0, 0}, 3000));
    items.back().override_off = i < 2000;
  }
  items.push_back(item_of(geometry::End{}));
  rig.append(items);
  double fastest = 0;
  while (rig.follower().position().x < 20) fastest = std::max(fastest, rig.tick({.override_ratio = 0.2}).speed);
  EXPECT_GT(fastest, 49) << "20 mm are enough for F MAX and back";
  EXPECT_NEAR(rig.follower().speed_mm_per_s(), 10, 0.2);
  ASSERT_TRUE(rig.run_out({.override_ratio = 0.2}));
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, DEC40SlowerBlockAheadIsMetAtItsScaledSpeed) {
  PathRig rig(standard());
  rig.append({line({}, {20, 0, 0, 0}, 3000), line({20, 0, 0, 0}, {40, 0, 0, 0}, 900)});
  ASSERT_TRUE(rig.run_out({.override_ratio = 0.5}));
  EXPECT_EQ(broken_rule(rig, {}), "");  // includes: never above 7.5 mm/s on the second
}

TEST(Follower, EventsWithoutStandstillArePassedInMotion) {
  PathRig rig(standard());
  rig.append({line({}, {10, 0, 0, 0}, 1200), item_of(geometry::Spindle{geometry::SpindleTurn::clockwise, 1000}),
              item_of(geometry::Mark{}), line({10, 0, 0, 0}, {20, 0, 0, 0}, 1200)});
  ASSERT_TRUE(rig.run_out());
  EXPECT_NEAR(rig.time_s(), trapezoid_s(20, 20), 1.01e-3);
}

struct StandstillRow {
  const char* name;
  geometry::PathItem item;
};

TEST(Follower, EventsThatNeedStandstillGetIt) {
  const std::vector<StandstillRow> rows{{"G-040 dwell", item_of(geometry::Dwell{0.1})},
                                        {"M-016 wait", item_of(geometry::Wait{})},
                                        {"M-000 halt", item_of(geometry::Halt{})},
                                        {"G-690 reference", item_of(geometry::Reference{})},
                                        {"M-002 end", item_of(geometry::End{})}};
  for (const auto& row : rows) {
    PathRig rig(standard());
    rig.append({line({}, {10, 0, 0, 0}, 1200), row.item, line({10, 0, 0, 0}, {20, 0, 0, 0}, 1200)});
    while (!rig.tick().event_done) ASSERT_LT(rig.samples().size(), 5000U);
    const auto& reached = rig.samples()[rig.samples().size() - 2];
    EXPECT_EQ(reached.speed, 0) << row.name;
    EXPECT_EQ(reached.position.x, 10) << row.name;
  }
}

TEST(Follower, EinzelsatzFromRestDoesExactlyOneBlock) {
  PathRig rig(standard());
  std::vector<geometry::PathItem> items;
  for (int i = 0; i < 5; ++i) {
    items.push_back(line({i * 2.0, 0, 0, 0}, {i * 2.0 + 1, 0, 0, 0}, 1200));  // a block of two ways and a mark
    items.push_back(line({i * 2.0 + 1, 0, 0, 0}, {i * 2.0 + 2, 0, 0, 0}, 1200));
    items.push_back(item_of(geometry::Mark{}, static_cast<std::uint64_t>(i) + 1));
  }
  rig.append(items);
  for (int block = 1; block <= 5; ++block) {
    while (!rig.tick({.single_block = true}).held) ASSERT_LT(rig.samples().size(), 20'000U);
    EXPECT_EQ(rig.follower().position().x, block * 2.0);
    EXPECT_EQ(rig.follower().speed_mm_per_s(), 0);
    EXPECT_EQ(rig.follower().finished_sequence(), static_cast<std::uint64_t>(block));
  }
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, EinzelsatzInMotionRestsAtTheFirstEndThatTheRampReaches) {
  PathRig rig(standard());
  std::vector<geometry::PathItem> items;
  for (int i = 0; i < 100; ++i) {
    items.push_back(line({i * 1.0, 0, 0, 0}, {i + 1.0, 0, 0, 0}, 3000, static_cast<std::uint64_t>(i) + 1));
  }
  rig.append(items);
  while (rig.follower().position().x < 30.5) rig.tick();
  const double braking_way = (2500.0 - 25) / (2 * kAcceleration);  // 7.425 mm
  const double first = std::ceil(rig.follower().position().x + braking_way);
  while (!rig.tick({.single_block = true}).held) ASSERT_LT(rig.samples().size(), 20'000U);
  EXPECT_EQ(rig.follower().position().x, first);
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, WindowThatRunsEmptyHasBrakedToRest) {
  PathRig rig(standard());
  rig.append({line({}, {30, 0, 0, 0}, 3000)});
  ASSERT_TRUE(rig.run_out());
  EXPECT_EQ(rig.follower().position().x, 30);
  rig.append({line({30, 0, 0, 0}, {60, 0, 0, 0}, 3000)});
  ASSERT_TRUE(rig.run_out());
  EXPECT_EQ(rig.follower().position().x, 60);
  EXPECT_EQ(broken_rule(rig, {}), "");
}

TEST(Follower, AbandonedRunIsDroppedAlsoWhatIsPushedLater) {
  PathRig rig(standard());
  rig.append({line({}, {30, 0, 0, 0}, 3000)});
  for (int i = 0; i < 100; ++i) rig.tick();
  rig.follower().abandon();
  const double rest = rig.follower().position().x;
  rig.append({line({30, 0, 0, 0}, {60, 0, 0, 0}, 3000)});  // the lab thread did not know yet
  for (int i = 0; i < 100; ++i) {
    rig.follower().drop_old_runs();
    rig.tick();
  }
  EXPECT_EQ(rig.follower().position().x, rest);
  EXPECT_EQ(rig.queue().waiting(), 0U);
  rig.planner().restart();
  rig.append({line({rest, 0, 0, 0}, {rest + 1, 0, 0, 0}, 3000)});
  for (int i = 0; i < 10; ++i) rig.tick();
  EXPECT_EQ(rig.follower().position().x, rest) << "a run that has not begun must wait";
  rig.follower().begin(rig.planner().run(), {rest, 0, 0, 0}, standard());
  for (int i = 0; i < 1000; ++i) rig.tick();
  EXPECT_EQ(rig.follower().position().x, rest + 1);
}

}  // namespace
}  // namespace cnclab::motion
