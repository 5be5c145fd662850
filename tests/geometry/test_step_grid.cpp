// Arcs of stepping drives with unequal steps/mm (G-031, MD-130).
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/step_grid.hpp"

namespace cnclab::geometry {
namespace {

PathItem circle(Plane plane, Point at, Point to, Point center, Turn turn = Turn::counterclockwise) {
  PathItem item;
  item.what = Arc{at, to, center, turn, plane, 600};
  item.sequence = 7;
  item.ends_block = true;
  item.exact_stop = true;
  return item;
}

std::vector<PathItem> in_grid(const PathItem& item, const std::array<double, 4>& steps_per_mm) {
  std::vector<PathItem> out;
  append_in_step_grid(item, steps_per_mm, out);
  return out;
}

TEST(StepGrid, EqualStepsLeaveTheArcAlone) {
  const PathItem item = circle(Plane::xy, {10, 0, 0, 0}, {0, 10, 0, 0}, {});
  const auto out = in_grid(item, {200, 200, 77, 5});
  ASSERT_EQ(out.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<Arc>(out[0].what)) << "Z and U do not matter in the plane X Y";
}

TEST(StepGrid, OtherItemsPass) {
  PathItem item;
  item.what = Line{{}, {1, 2, 3, 0}, 100, false};
  EXPECT_EQ(in_grid(item, {200, 400, 100, 1}).size(), 1U);
}

struct EllipseRow {
  const char* name;
  Plane plane;
  Point from;
  std::array<double, 4> steps_per_mm;
  double half_x, half_y, half_z;  ///< of the ellipse, 0 for the third axis
};

TEST(StepGrid, G031AFullCircleBecomesTheEllipseOfEqualSteps) {
  const std::vector<EllipseRow> rows{
      {"X 200 Y 400 from +X: half as high", Plane::xy, {10, 0, 0, 0}, {200, 400, 200, 1}, 10, 5, 0},
      {"X 200 Y 400 from +Y: twice as wide", Plane::xy, {0, 10, 0, 0}, {200, 400, 200, 1}, 20, 10, 0},
      {"X 300 Z 100 from +X", Plane::xz, {10, 0, 0, 0}, {300, 1, 100, 1}, 10, 0, 30},
      {"Y 150 Z 200 from +Z", Plane::yz, {0, 0, 6, 0}, {1, 150, 200, 1}, 0, 8, 6}};
  for (const auto& row : rows) {
    const auto out = in_grid(circle(row.plane, row.from, row.from, {}), row.steps_per_mm);
    ASSERT_GT(out.size(), 50U) << row.name;
    Point most, at = row.from;
    for (const auto& item : out) {
      const auto& line = std::get<Line>(item.what);
      EXPECT_EQ(line.from, at) << row.name << ": joined";
      at = line.to;
      most = {std::max(most.x, at.x), std::max(most.y, at.y), std::max(most.z, at.z), 0};
      double sum = 0;  // of the squares in the ellipse's equation
      for (const auto& [value, half] : {std::pair{at.x, row.half_x}, {at.y, row.half_y}, {at.z, row.half_z}}) {
        if (half > 0) sum += value * value / (half * half);
      }
      EXPECT_NEAR(sum, 1, 1e-9) << row.name;
    }
    EXPECT_EQ(at, row.from) << row.name;
    EXPECT_NEAR(most.x, row.half_x, 0.01) << row.name;
    EXPECT_NEAR(most.y, row.half_y, 0.01) << row.name;
    EXPECT_NEAR(most.z, row.half_z, 0.01) << row.name;
  }
}

TEST(StepGrid, ChordsStayWithinAQuarterOfAStep) {
  const std::array<double, 4> steps_per_mm{200, 400, 100, 1};
  for (const auto& item : in_grid(circle(Plane::xy, {10, 0, 0, 0}, {10, 0, 0, 0}, {}), steps_per_mm)) {
    const auto& line = std::get<Line>(item.what);
    const double x = (line.from.x + line.to.x) / 2 * 200, y = (line.from.y + line.to.y) / 2 * 400;
    EXPECT_NEAR(std::hypot(x, y), 2000, 0.25 + 1e-9);
  }
}

TEST(StepGrid, AQuarterEndsExactlyOnItsEndWithItsFlags) {
  const auto out = in_grid(circle(Plane::xy, {10, 0, 1, 0}, {0, 10, 3, 0}, {}), {200, 300, 200, 1});
  ASSERT_GT(out.size(), 10U);
  EXPECT_EQ(std::get<Line>(out.back().what).to, (Point{0, 10, 3, 0}));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool is_last = i + 1 == out.size();
    EXPECT_EQ(out[i].ends_block, is_last);
    EXPECT_EQ(out[i].exact_stop, is_last);
    EXPECT_EQ(out[i].sequence, 7U);
    EXPECT_EQ(std::get<Line>(out[i].what).feed_mm_per_min, 600);
  }
}

TEST(StepGrid, ClockwiseGoesTheOtherWay) {
  const auto out = in_grid(circle(Plane::xy, {10, 0, 0, 0}, {10, 0, 0, 0}, {}, Turn::clockwise), {200, 400, 200, 1});
  EXPECT_LT(std::get<Line>(out.front().what).to.y, 0);
}

}  // namespace
}  // namespace cnclab::geometry
