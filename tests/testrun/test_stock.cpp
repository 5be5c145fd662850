// What a cutter takes away, against closed formulas and against a slow cutter that goes in tiny steps.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "testrun/stock.hpp"

namespace cnclab::testrun {
namespace {

using geometry::Point;

/// 120 × 80 × 30, its top at 0 (DEC-24).
constexpr drawing::Box kBlock{.low = {-60, -40, -30, 0}, .high = {60, 40, 0, 0}};

TEST(Stock, AHoleIsACylinder) {
  Stock stock(kBlock, 0.25);
  EXPECT_TRUE(stock.cut({0, 0, 5, 0}, {0, 0, -10, 0}, 5));
  EXPECT_NEAR(stock.removed_mm3(), std::numbers::pi * 25 * 10, std::numbers::pi * 25 * 10 * 0.01);
  EXPECT_NEAR(stock.height_mm(0, 0), -10, 1e-5);
  EXPECT_NEAR(stock.height_mm(4.8, 0), -10, 1e-5);
  EXPECT_NEAR(stock.height_mm(5.2, 0), 0, 1e-5);
}

TEST(Stock, ASlotHasRoundEnds) {
  Stock stock(kBlock, 0.25);
  EXPECT_TRUE(stock.cut({-20, 0, -2, 0}, {20, 0, -2, 0}, 4));
  const double expected = (40 * 8 + std::numbers::pi * 16) * 2;
  EXPECT_NEAR(stock.removed_mm3(), expected, expected * 0.01);
  EXPECT_NEAR(stock.height_mm(-23, 2), -2, 1e-5);  // in the rounding
  EXPECT_NEAR(stock.height_mm(-23.5, 2.5), 0, 1e-5);
}

TEST(Stock, ASlopeIsDeepestWhereTheCutterStoodLowest) {
  Stock stock(kBlock, 0.25);
  stock.cut({0, 0, 0, 0}, {40, 0, -10, 0}, 4);
  EXPECT_NEAR(stock.height_mm(20.125, 0.125), -5 - 1.03, 0.02);  // 4 mm further on it was 1 mm deeper
  EXPECT_NEAR(stock.height_mm(43, 0), -10, 1e-5);
  EXPECT_NEAR(stock.height_mm(-5, 0), 0, 1e-5);
}

TEST(Stock, MaterialEndsAtTheBottomAndAtTheSides) {
  Stock stock(kBlock, 1);
  stock.cut({-200, 0, -99, 0}, {200, 0, -99, 0}, 200);
  EXPECT_NEAR(stock.removed_mm3(), 120 * 80 * 30, 1);
  EXPECT_FALSE(stock.cut({-200, 0, -99, 0}, {200, 0, -99, 0}, 200));
}

struct MeetingRow {
  const char* name;
  Point from, to;
  bool meets;
};
class Meeting : public testing::TestWithParam<MeetingRow> {};
/// A slot 5 deep along X with a cutter of radius 4 is there already.
INSTANTIATE_TEST_SUITE_P(AfterASlot, Meeting,
                         testing::Values(MeetingRow{"above", {-60, 0, 2, 0}, {60, 0, 2, 0}, false},
                                         MeetingRow{"touching_the_top", {-60, 20, 0, 0}, {60, 20, 0, 0}, false},
                                         MeetingRow{"the_same_way_back", {20, 0, -5, 0}, {-20, 0, -5, 0}, false},
                                         MeetingRow{"out_of_it", {20, 0, -5, 0}, {20, 0, 50, 0}, false},
                                         MeetingRow{"a_hair_deeper", {20, 0, -5.01, 0}, {-20, 0, -5.01, 0}, false},
                                         MeetingRow{"deeper", {20, 0, -5.1, 0}, {-20, 0, -5.1, 0}, true},
                                         MeetingRow{"into_its_side", {0, 0, -5, 0}, {0, 1, -5, 0}, true},
                                         MeetingRow{"beside_the_workpiece", {0, 50, -5, 0}, {20, 50, -5, 0}, false},
                                         MeetingRow{"through_a_corner", {-70, 30, -1, 0}, {-50, 50, -1, 0}, true}),
                         [](const auto& row) { return row.param.name; });

TEST_P(Meeting, IsNoticed) {
  Stock stock(kBlock, 0.25);
  ASSERT_TRUE(stock.cut({-20, 0, -5, 0}, {20, 0, -5, 0}, 4));
  EXPECT_EQ(stock.cut(GetParam().from, GetParam().to, 4), GetParam().meets);
}

TEST(Stock, LargeWorkpiecesGetLargeCells) {
  const Stock stock({.low = {0, 0, -50, 0}, .high = {2000, 1000, 0, 0}}, 0.25);
  EXPECT_NEAR(stock.cell_mm(), std::sqrt(2000.0 * 1000.0 / machine::kUsualCells), 1e-9);
  Stock nothing({.low = {0, 0, 0, 0}, .high = {0, 0, 0, 0}}, 0.25);
  EXPECT_FALSE(nothing.cut({0, 0, -5, 0}, {1, 0, -5, 0}, 4));
  EXPECT_EQ(nothing.removed_mm3(), 0);
  EXPECT_EQ(nothing.height_mm(3, 3), 0);
}

/// Against a cutter that is set down at 2000 places along the way.
TEST(Stock, AnyWayCutsWhatSmallStepsCut) {
  setenv("RC_PARAMS", "seed=3300 max_success=100", 0);
  EXPECT_TRUE(rc::check([] {
    const auto place = [] {
      return Point{*rc::gen::inRange(-70, 70) + 0.1, *rc::gen::inRange(-50, 50) + 0.1, -*rc::gen::inRange(-5, 35) + 0.1,
                   0};
    };
    const Point from = place(), to = place();
    const double radius = *rc::gen::inRange(1, 15);
    Stock fast(kBlock, 1), slow(kBlock, 1);
    fast.cut(from, to, radius);
    constexpr int kSteps = 2000;
    for (int step = 0; step <= kSteps; ++step) {
      const double share = static_cast<double>(step) / kSteps;
      const Point at{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                     from.z + share * (to.z - from.z), 0};
      slow.cut(at, at, radius);
    }
    for (double x = -59.5; x < 60; ++x)
      for (double y = -39.5; y < 40; ++y) {
        const double difference = slow.height_mm(x, y) - fast.height_mm(x, y);
        // Steps of the slow one may jump over a cell at the rim; it never cuts where the fast one does not.
        RC_ASSERT(difference > -1e-4);
        const double step_mm = std::abs(to.z - from.z) / kSteps + 1e-4;
        if (difference > step_mm) RC_ASSERT(slow.height_mm(x, y) > -1e-6 || difference < 0.5);
      }
  }));
}

}  // namespace
}  // namespace cnclab::testrun
