// Lengths, points and directions of path elements against the manual's examples and closed formulas.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/path_math.hpp"

namespace {

using namespace cnclab::geometry;
using std::numbers::pi;

constexpr double kDegrees = 180 / pi;

double distance(const Point& a, const Point& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z) +
                   (a.u - b.u) * (a.u - b.u));
}

double size(const Point& vector) { return distance(vector, {}); }

struct ArcRow {
  std::string name;
  Arc arc;
  double length_mm;
  double sweep_degrees;  ///< > 0 counterclockwise
  double tolerance_mm;   ///< of the printed length
};

Arc arc(Plane plane, Turn turn, Point from, Point to, Point center) {
  return {.from = from, .to = to, .center = center, .turn = turn, .plane = plane, .feed_mm_per_min = 1000};
}

std::vector<ArcRow> arc_rows() {
  constexpr auto kCw = Turn::clockwise;
  constexpr auto kCcw = Turn::counterclockwise;
  return {
      {"EX-014 half circle", arc(Plane::xy, kCw, {75, 60, 54}, {85, 60, 54}, {80, 60, 54}), 15.707963, -180, 5e-7},
      {"EX-042 nearly full circle", arc(Plane::xy, kCw, {0, 0}, {0.005, -0.005}, {20, 0}), 125.6430, -359.98567, 5e-5},
      {"EX-105 arc of P0001", arc(Plane::xy, kCw, {20, 20}, {20.005, 19.995}, {30, 30}), 88.850593, -359.97135, 5e-7},
      {"EX-101 mirrored in X", arc(Plane::xy, kCcw, {-20, 20}, {-20.005, 19.995}, {-30, 30}), 88.850593, 359.97135,
       5e-7},
      {"EX-102 mirrored in Y", arc(Plane::xy, kCcw, {20, -20}, {20.005, -19.995}, {30, -30}), 88.850593, 359.97135,
       5e-7},
      {"EX-103 mirrored in both", arc(Plane::xy, kCw, {-20, -20}, {-20.005, -19.995}, {-30, -30}), 88.850593,
       -359.97135, 5e-7},
      {"EX-108 wrong sense after one mirror", arc(Plane::xy, kCw, {-20, 20}, {-20.005, 19.995}, {-30, 30}), 0.007071,
       -0.02865, 5e-7},
      {"DEC-04 full circle cw", arc(Plane::xy, kCw, {0, 0}, {0, 0}, {20, 0}), 40 * pi, -360, 1e-9},
      {"DEC-04 full circle ccw", arc(Plane::yz, kCcw, {1, 2, 3}, {1, 2, 3}, {1, 2, 13}), 20 * pi, 360, 1e-9},
      {"G-070 helix, one turn", arc(Plane::xy, kCcw, {10, 0, 0}, {10, 0, -4}, {0, 0, 0}), std::hypot(20 * pi, 4), 360,
       1e-9},
      {"D-128 G17 quarter ccw from +Z: X to Y", arc(Plane::xy, kCcw, {10, 0, 0}, {0, 10, 0}, {}), 5 * pi, 90, 1e-9},
      {"D-128 G18 quarter ccw from +Y: Z to X", arc(Plane::xz, kCcw, {0, 0, 10}, {10, 0, 0}, {}), 5 * pi, 90, 1e-9},
      {"D-128 G18 quarter cw from +Y: X to Z", arc(Plane::xz, kCw, {10, 0, 0}, {0, 0, 10}, {}), 5 * pi, -90, 1e-9},
      {"D-128 G19 quarter ccw from +X: Y to Z", arc(Plane::yz, kCcw, {0, 10, 0}, {0, 0, 10}, {}), 5 * pi, 90, 1e-9},
  };
}

TEST(PathMath, ArcsOfTheManualHaveTheirLengthAndSweep) {
  for (const ArcRow& row : arc_rows()) {
    const ArcShape shape = shape_of(row.arc);
    EXPECT_NEAR(shape.length, row.length_mm, row.tolerance_mm) << row.name;
    EXPECT_NEAR(length_of(row.arc), row.length_mm, row.tolerance_mm) << row.name;
    EXPECT_NEAR(shape.sweep * kDegrees, row.sweep_degrees, 5e-6) << row.name;
    EXPECT_EQ(point_at(row.arc, shape, 0), row.arc.from) << row.name;
    EXPECT_EQ(point_at(row.arc, shape, shape.length), row.arc.to) << row.name;
  }
}

TEST(PathMath, EX014HalfCirclePassesItsTopPoint) {
  const Arc half = arc(Plane::xy, Turn::clockwise, {75, 60, 54}, {85, 60, 54}, {80, 60, 54});
  const ArcShape shape = shape_of(half);
  EXPECT_LT(distance(point_at(half, shape, shape.length / 2), {80, 65, 54}), 1e-12);
  EXPECT_LT(distance(direction_at(half, shape, 0), {0, 1}), 1e-12);
  EXPECT_LT(distance(direction_at(half, shape, shape.length / 2), {1, 0}), 1e-12);
  EXPECT_LT(distance(direction_at(half, shape, shape.length), {0, -1}), 1e-12);
}

TEST(PathMath, EX041RadiusErrorIsSpreadOverTheAngle_D55) {
  const Arc circle = arc(Plane::xy, Turn::clockwise, {0, 0}, {0.005, -0.005}, {20, 0});
  const ArcShape shape = shape_of(circle);
  EXPECT_NEAR(shape.start_radius, 20, 1e-12);
  EXPECT_NEAR(shape.end_radius, 19.995001, 5e-7);
  const double middle = distance(point_at(circle, shape, shape.length / 2), {20, 0});
  EXPECT_NEAR(middle, (shape.start_radius + shape.end_radius) / 2, 1e-9);
}

TEST(PathMath, HelixClimbsEvenly_G070) {
  const Arc helix = arc(Plane::xy, Turn::counterclockwise, {10, 0, 0}, {-10, 0, 3}, {0, 0, 0});
  const ArcShape shape = shape_of(helix);
  EXPECT_NEAR(shape.length, std::hypot(10 * pi, 3), 1e-12);
  EXPECT_LT(distance(point_at(helix, shape, shape.length / 2), {0, 10, 1.5}), 1e-12);
  EXPECT_NEAR(direction_at(helix, shape, 1).z, 3 / std::hypot(10 * pi, 3), 1e-12);
}

TEST(PathMath, LinesRunStraight_EX011_EX030) {
  const Line diagonal{.from = {}, .to = {50, 50, 50}, .feed_mm_per_min = 3000, .is_rapid = true};
  EXPECT_NEAR(length_of(diagonal), 86.602540, 5e-7);
  const Line feed{.from = {}, .to = {100, 100}, .feed_mm_per_min = 1000};
  const double length = length_of(feed);
  EXPECT_NEAR(length, 141.421356, 5e-7);
  EXPECT_NEAR(direction_at(feed, length).x * 1000, 707.107, 5e-4);  // axis speed, FST-002
  EXPECT_EQ(point_at(feed, length, length), feed.to);
  EXPECT_LT(distance(point_at(feed, length, length / 4), {25, 25}), 1e-12);
}

TEST(PathMath, AWayOfNoLengthHasNoDirection) {
  const Line still{.from = {1, 2, 3}, .to = {1, 2, 3}, .feed_mm_per_min = 100};
  EXPECT_EQ(direction_at(still, length_of(still)), Point{});
  EXPECT_EQ(point_at(still, 0, 0), still.to);
}

/// A random arc within the tolerance of D-55, in any plane, with any normal way.
Arc random_arc() {
  const auto plane = *rc::gen::element(Plane::xy, Plane::xz, Plane::yz);
  const auto turn = *rc::gen::element(Turn::clockwise, Turn::counterclockwise);
  const double radius = *rc::gen::inRange(1, 500'000) / 1000.0;
  const double begin = *rc::gen::inRange(0, 360'000) / 1000.0 / kDegrees;
  const double sweep = *rc::gen::inRange(1, 359'999) / 1000.0 / kDegrees;
  const double error = *rc::gen::inRange(-20, 21) / 1000.0 * std::min(1.0, radius);
  const PlaneAxes& axes = axes_of(plane);
  Arc made{.from = {}, .to = {}, .center = {}, .turn = turn, .plane = plane, .feed_mm_per_min = 100};
  const double end = turn == Turn::counterclockwise ? begin + sweep : begin - sweep;
  made.center.*axes.first = *rc::gen::inRange(-500'000, 500'000) / 1000.0;
  made.center.*axes.second = *rc::gen::inRange(-500'000, 500'000) / 1000.0;
  made.from.*axes.first = made.center.*axes.first + radius * std::cos(begin);
  made.from.*axes.second = made.center.*axes.second + radius * std::sin(begin);
  made.to.*axes.first = made.center.*axes.first + (radius + error) * std::cos(end);
  made.to.*axes.second = made.center.*axes.second + (radius + error) * std::sin(end);
  made.to.*axes.normal = *rc::gen::inRange(-10'000, 10'000) / 1000.0;
  return made;
}

RC_GTEST_PROP(PathMathProperty, ArcStaysBetweenItsRadii, ()) {
  const Arc made = random_arc();
  const ArcShape shape = shape_of(made);
  const PlaneAxes& axes = axes_of(made.plane);
  const double way = shape.length * *rc::gen::inRange(0, 1001) / 1000.0;
  const Point point = point_at(made, shape, way);
  const double radius =
      std::hypot(point.*axes.first - made.center.*axes.first, point.*axes.second - made.center.*axes.second);
  RC_ASSERT(radius >= std::min(shape.start_radius, shape.end_radius) - 1e-9);
  RC_ASSERT(radius <= std::max(shape.start_radius, shape.end_radius) + 1e-9);
}

RC_GTEST_PROP(PathMathProperty, EndsAreExactAndDirectionsHaveLengthOne, ()) {
  const Arc made = random_arc();
  const ArcShape shape = shape_of(made);
  RC_ASSERT(point_at(made, shape, 0) == made.from);
  RC_ASSERT(point_at(made, shape, shape.length) == made.to);
  const double way = shape.length * *rc::gen::inRange(0, 1001) / 1000.0;
  RC_ASSERT(std::abs(size(direction_at(made, shape, way)) - 1) < 1e-12);
}

RC_GTEST_PROP(PathMathProperty, DirectionIsTheSlopeOfTheWay, ()) {
  const Arc made = random_arc();
  const ArcShape shape = shape_of(made);
  RC_PRE(shape.length > 0.1);
  const double step = shape.length * 1e-6;
  const double way = shape.length * *rc::gen::inRange(1, 1000) / 1000.0;
  const Point a = point_at(made, shape, way - step), b = point_at(made, shape, way + step);
  const Point direction = direction_at(made, shape, way);
  const double chord = distance(a, b);
  const Point slope{(b.x - a.x) / chord, (b.y - a.y) / chord, (b.z - a.z) / chord, 0};
  RC_ASSERT(distance(slope, direction) < 1e-3);
}

RC_GTEST_PROP(PathMathProperty, ChordsAddUpToTheLength, ()) {
  const Arc made = random_arc();
  const ArcShape shape = shape_of(made);
  constexpr int kParts = 2000;
  double sum = 0;
  Point last = made.from;
  for (int part = 1; part <= kParts; ++part) {
    const Point next = point_at(made, shape, shape.length * part / kParts);
    sum += distance(last, next);
    last = next;
  }
  // A radius error makes the true way a little longer than mean radius × sweep: at most by the error itself.
  const double error = std::abs(shape.end_radius - shape.start_radius);
  RC_ASSERT(std::abs(sum - shape.length) <= error + shape.length * 1e-5);
}

}  // namespace
