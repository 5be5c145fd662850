// Lines and circles of a drawing against values worked out by hand and printed in the manual.
#include "drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>

#include "parts.hpp"

namespace cnclab::lesson {
namespace {

constexpr double kPi = std::numbers::pi;

struct ArcRow {
  const char* name;
  Point from;
  Arc arc;
  double length;
  Point middle;
};
void PrintTo(const ArcRow& row, std::ostream* out) { *out << row.name; }

class DrawnArc : public testing::TestWithParam<ArcRow> {};

TEST_P(DrawnArc, HasTheLengthAndMiddleOfTheFormula) {
  const Element element(GetParam().from, GetParam().arc);
  EXPECT_NEAR(element.length_mm(), GetParam().length, 1e-4);
  EXPECT_LT(distance(element.at(element.length_mm() / 2), GetParam().middle), 1e-2);
  EXPECT_LT(distance(element.at(element.length_mm()), GetParam().arc.to), 1e-9);
  EXPECT_LT(distance(element.at(0), GetParam().from), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, DrawnArc,
    testing::Values(
        ArcRow{"EX-014 half circle clockwise: top point",
               {75, 60, 54},
               {Plane::xy, Turn::cw, {80, 60, 54}, {85, 60, 54}},
               15.707963,
               {80, 65, 54}},
        ArcRow{"EX-042 manual's circle in two blocks",
               {0, 0, 0},
               {Plane::xy, Turn::cw, {20, 0, 0}, {0.005, -0.005, 0}},
               125.6430,
               {40, 0, 0}},
        ArcRow{"EX-105 circle of the appendix",
               {20, 20, 0},
               {Plane::xy, Turn::cw, {30, 30, 0}, {20.005, 19.995, 0}},
               88.850593,
               {40, 40, 0}},
        ArcRow{"DEC-04 full circle", {15, 0, 0}, {Plane::xy, Turn::ccw, {0, 0, 0}, {15, 0, 0}}, 30 * kPi, {-15, 0, 0}},
        ArcRow{"D-128 XZ counterclockwise: Z turns towards X",
               {0, 0, 10},
               {Plane::xz, Turn::ccw, {0, 0, 0}, {10, 0, 0}},
               5 * kPi,
               {10 / std::numbers::sqrt2, 0, 10 / std::numbers::sqrt2}},
        ArcRow{"D-128 XZ clockwise the long way",
               {0, 0, 10},
               {Plane::xz, Turn::cw, {0, 0, 0}, {10, 0, 0}},
               15 * kPi,
               {-10 / std::numbers::sqrt2, 0, -10 / std::numbers::sqrt2}},
        ArcRow{"YZ counterclockwise: Y turns towards Z",
               {0, 10, 0},
               {Plane::yz, Turn::ccw, {0, 0, 0}, {0, 0, 10}},
               5 * kPi,
               {0, 10 / std::numbers::sqrt2, 10 / std::numbers::sqrt2}}),
    [](const auto& row) { return "row" + std::to_string(row.index); });

TEST(Drawing, NearestPointOfALineIsTheFootOfThePerpendicularWithinLimits) {
  const Element line({0, 0, 0}, Line{{10, 0, 0}});
  EXPECT_DOUBLE_EQ(line.nearest({4, 3, 1}, 0, 10), 4);
  EXPECT_DOUBLE_EQ(line.nearest({4, 3, 1}, 5, 10), 5);
  EXPECT_DOUBLE_EQ(line.nearest({14, 3, 1}, 0, 10), 10);
}

TEST(Drawing, NearestPointOfAnArcIsOnTheRayFromTheCentre) {
  const Element arc({10, 0, 0}, Arc{Plane::xy, Turn::ccw, {0, 0, 0}, {0, 10, 0}});
  EXPECT_NEAR(arc.nearest({3, 3, 0}, 0, 100), 2.5 * kPi, 1e-9);
  EXPECT_NEAR(arc.nearest({3, 3, 0}, 0, 2), 2, 1e-9);
}

// The closed formulas: sides of the drawing added up by hand.
TEST(Parts, HaveTheLengthsOfTheDrawingAndEndWhereTheyBegan) {
  const std::vector<double> lengths = {
      100,
      3 * 40.0,
      145.426207,  // EX-105
      125.6501,    // EX-043
      30 + 30 * kPi,
      60 + 20 * kPi,
      10 + 10 * kPi + 15 + 10 * kPi + std::sqrt(325.0),
      52 + 16 * kPi,
      3 * 18 + 30,
      6 * 4 * kPi + 48,
      4 * 10 + 2 * 2 + std::sqrt(24.0 * 24 + 16 * 16 + 4 * 4),
      5 * 24 * std::sin(72 * kPi / 180),
      28 * kPi + 8,
      std::sqrt(500.0) + std::sqrt(250.0) + 15 + std::sqrt(35.0 * 35 + 25 * 25 + 5 * 5),
      72,
  };
  const auto all = parts();
  ASSERT_EQ(all.size(), 15U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(all[i].student + ": " + all[i].title);
    const Drawing drawing(all[i].curves);
    EXPECT_NEAR(drawing.length_mm(), lengths[i], 2e-3);
    EXPECT_LT(distance(drawing.end(), {0, 0, 0}), 1e-9);
  }
}

}  // namespace
}  // namespace cnclab::lesson
