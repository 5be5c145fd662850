// Length, points and directions of lines and arcs (G-020, G-030, G-070; D-55, D-128, DEC-04).
#include "geometry/path_math.hpp"

#include <cmath>
#include <numbers>

namespace cnclab::geometry {

namespace {

constexpr double kFullTurn_rad = 2 * std::numbers::pi;

// One constant decides the view of all planes (D-128): G17 from +Z, G18 from +Y (so Z turns towards X), G19 from +X.
constexpr PlaneAxes kXy{.first = &Point::x, .second = &Point::y, .normal = &Point::z};
constexpr PlaneAxes kXz{.first = &Point::z, .second = &Point::x, .normal = &Point::y};
constexpr PlaneAxes kYz{.first = &Point::y, .second = &Point::z, .normal = &Point::x};

/// The angle from `start` to `end` in the sense of `turn`: (0, 2π] counterclockwise, [-2π, 0) clockwise.
double sweep_between(double start_angle, double end_angle, Turn turn) {
  double sweep = end_angle - start_angle;
  if (turn == Turn::counterclockwise) {
    while (sweep <= 0) sweep += kFullTurn_rad;
  } else {
    while (sweep >= 0) sweep -= kFullTurn_rad;
  }
  return sweep;
}

/// A vector of length 1; a zero vector stays zero.
Point unit(Point vector) {
  const double length =
      std::sqrt(vector.x * vector.x + vector.y * vector.y + vector.z * vector.z + vector.u * vector.u);
  if (length == 0) return vector;
  return {vector.x / length, vector.y / length, vector.z / length, vector.u / length};
}

}  // namespace

const PlaneAxes& axes_of(Plane plane) {
  switch (plane) {
    case Plane::xy:
      return kXy;
    case Plane::xz:
      return kXz;
    case Plane::yz:
      return kYz;
  }
  return kXy;
}

ArcShape shape_of(const Arc& arc) {
  const PlaneAxes& axes = axes_of(arc.plane);
  const double center_first = arc.center.*axes.first, center_second = arc.center.*axes.second;
  const double start_first = arc.from.*axes.first - center_first, start_second = arc.from.*axes.second - center_second;
  const double end_first = arc.to.*axes.first - center_first, end_second = arc.to.*axes.second - center_second;

  ArcShape shape;
  shape.start_angle = std::atan2(start_second, start_first);
  shape.start_radius = std::hypot(start_first, start_second);
  shape.end_radius = std::hypot(end_first, end_second);
  shape.normal_way = arc.to.*axes.normal - arc.from.*axes.normal;
  const bool is_full_circle = start_first == end_first && start_second == end_second;
  shape.sweep = is_full_circle ? (arc.turn == Turn::counterclockwise ? kFullTurn_rad : -kFullTurn_rad)
                               : sweep_between(shape.start_angle, std::atan2(end_second, end_first), arc.turn);
  const double mean_radius = (shape.start_radius + shape.end_radius) / 2;
  shape.length = std::hypot(mean_radius * shape.sweep, shape.normal_way);
  return shape;
}

double length_of(const Line& line) {
  const double x = line.to.x - line.from.x, y = line.to.y - line.from.y;
  const double z = line.to.z - line.from.z, u = line.to.u - line.from.u;
  return std::sqrt(x * x + y * y + z * z + u * u);
}

double length_of(const Arc& arc) { return shape_of(arc).length; }

double length_of(const PathItem& item) {
  if (const auto* line = std::get_if<Line>(&item.what)) return length_of(*line);
  if (const auto* arc = std::get_if<Arc>(&item.what)) return length_of(*arc);
  return 0;
}

double seconds_at_feed(const PathItem& item) {
  constexpr double kSecondsPerMinute = 60;
  if (const auto* line = std::get_if<Line>(&item.what))
    return length_of(*line) / line->feed_mm_per_min * kSecondsPerMinute;
  if (const auto* arc = std::get_if<Arc>(&item.what)) return length_of(*arc) / arc->feed_mm_per_min * kSecondsPerMinute;
  if (const auto* dwell = std::get_if<Dwell>(&item.what)) return dwell->seconds;
  return 0;
}

Point point_at(const Line& line, double length, double way) {
  if (way <= 0) return line.from;
  if (way >= length) return line.to;
  const double t = way / length;
  return {std::lerp(line.from.x, line.to.x, t), std::lerp(line.from.y, line.to.y, t),
          std::lerp(line.from.z, line.to.z, t), std::lerp(line.from.u, line.to.u, t)};
}

Point point_at(const Arc& arc, const ArcShape& shape, double way) {
  if (way <= 0) return arc.from;
  if (way >= shape.length) return arc.to;
  const PlaneAxes& axes = axes_of(arc.plane);
  const double t = way / shape.length;
  const double angle = shape.start_angle + shape.sweep * t;
  const double radius = std::lerp(shape.start_radius, shape.end_radius, t);
  Point point;
  point.*axes.first = arc.center.*axes.first + radius * std::cos(angle);
  point.*axes.second = arc.center.*axes.second + radius * std::sin(angle);
  point.*axes.normal = arc.from.*axes.normal + shape.normal_way * t;
  point.u = std::lerp(arc.from.u, arc.to.u, t);
  return point;
}

Point direction_at(const Line& line, double length) {
  if (length <= 0) return {};
  return unit({line.to.x - line.from.x, line.to.y - line.from.y, line.to.z - line.from.z, line.to.u - line.from.u});
}

Point direction_at(const Arc& arc, const ArcShape& shape, double way) {
  if (shape.length <= 0) return {};
  const PlaneAxes& axes = axes_of(arc.plane);
  const double t = way <= 0 ? 0 : (way >= shape.length ? 1 : way / shape.length);
  const double angle = shape.start_angle + shape.sweep * t;
  const double radius = std::lerp(shape.start_radius, shape.end_radius, t);
  const double radius_change = shape.end_radius - shape.start_radius;  // per whole sweep, D-55
  const double sine = std::sin(angle), cosine = std::cos(angle);
  Point direction;
  direction.*axes.first = radius_change * cosine - radius * sine * shape.sweep;
  direction.*axes.second = radius_change * sine + radius * cosine * shape.sweep;
  direction.*axes.normal = shape.normal_way;
  return unit(direction);
}

}  // namespace cnclab::geometry
