// Lines by projection, arcs by their angle.
#include "path_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cnclab::machine {

namespace {

using geometry::Arc;
using geometry::Line;
using geometry::Point;

constexpr double kFull = 2 * std::numbers::pi;

struct PlaneAxes {
  double Point::*first, Point::*second, Point::*normal;
};

PlaneAxes plane_axes(geometry::Plane plane) {
  switch (plane) {
    case geometry::Plane::xy:
      return {&Point::x, &Point::y, &Point::z};
    case geometry::Plane::xz:
      return {&Point::z, &Point::x, &Point::y};
    case geometry::Plane::yz:
      return {&Point::y, &Point::z, &Point::x};
  }
  return {};
}

Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z, a.u - b.u}; }
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.u * b.u; }
double size_of(const Point& a) { return std::sqrt(dot(a, a)); }

double turned(double angle) { return angle - kFull * std::floor(angle / kFull); }

}  // namespace

PathOracle::PathOracle(std::vector<geometry::PathItem> items, const Point& start) : items_(std::move(items)) {
  Point at = start;
  double way = 0;
  for (const auto& item : items_) {
    Shape shape;
    shape.way_before = way;
    if (const auto* line = std::get_if<Line>(&item.what)) {
      shape.length = size_of(minus(line->to, line->from));
      at = line->to;
    } else if (const auto* arc = std::get_if<Arc>(&item.what)) {
      const PlaneAxes axes = plane_axes(arc->plane);
      const double a = arc->from.*axes.first - arc->center.*axes.first;
      const double b = arc->from.*axes.second - arc->center.*axes.second;
      const double c = arc->to.*axes.first - arc->center.*axes.first;
      const double d = arc->to.*axes.second - arc->center.*axes.second;
      shape.sense = arc->turn == geometry::Turn::counterclockwise ? 1 : -1;
      shape.radius = std::hypot(a, b);
      shape.growth = std::hypot(c, d) - shape.radius;
      shape.begin_angle = std::atan2(b, a);
      const bool is_full = a == c && b == d;
      shape.sweep = is_full ? kFull : turned(shape.sense * (std::atan2(d, c) - shape.begin_angle));
      shape.rise = arc->to.*axes.normal - arc->from.*axes.normal;
      shape.length = std::hypot((shape.radius + shape.growth / 2) * shape.sweep, shape.rise);
      at = arc->to;
    }
    shape.end = at;
    way += shape.length;
    shapes_.push_back(shape);
  }
}

double PathOracle::feed_mm_per_min(std::size_t index) const {
  if (const auto* line = std::get_if<Line>(&items_[index].what)) return line->feed_mm_per_min;
  if (const auto* arc = std::get_if<Arc>(&items_[index].what)) return arc->feed_mm_per_min;
  return 0;
}

double PathOracle::radius_mm(std::size_t index) const {
  const Shape& shape = shapes_[index];
  return std::min(shape.radius, shape.radius + shape.growth);
}

PathOracle::Placement PathOracle::place(std::size_t index, const Point& point, double from_mm) const {
  const Shape& shape = shapes_[index];
  if (const auto* line = std::get_if<Line>(&items_[index].what)) {
    const Point along = minus(line->to, line->from), here = minus(point, line->from);
    const double way = shape.length > 0 ? std::clamp(dot(here, along) / shape.length, 0.0, shape.length) : 0;
    const double part = shape.length > 0 ? way / shape.length : 0;
    const Point foot{along.x * part, along.y * part, along.z * part, along.u * part};
    return {way, size_of(minus(here, foot))};
  }
  const auto& arc = std::get<Arc>(items_[index].what);
  const PlaneAxes axes = plane_axes(arc.plane);
  const double a = point.*axes.first - arc.center.*axes.first, b = point.*axes.second - arc.center.*axes.second;
  const double angle = turned(shape.sense * (std::atan2(b, a) - shape.begin_angle));
  constexpr double kRounding = 1e-9;
  double part = std::clamp(from_mm / shape.length, 0.0, 1.0);
  for (const double candidate : {angle - kFull, angle, angle + kFull}) {
    const double there = candidate / shape.sweep;
    if (there < part - kRounding || there > 1 + kRounding) continue;
    part = std::clamp(there, 0.0, 1.0);
    break;
  }
  const double now = shape.begin_angle + shape.sense * part * shape.sweep;
  const double off_plane = point.*axes.normal - arc.from.*axes.normal - part * shape.rise;
  const double radius = shape.radius + part * shape.growth;
  const double off_circle = std::hypot(a - radius * std::cos(now), b - radius * std::sin(now));
  return {part * shape.length, std::hypot(off_plane, off_circle)};
}

Point PathOracle::heading(std::size_t index, double way_mm) const {
  const Shape& shape = shapes_[index];
  if (const auto* line = std::get_if<Line>(&items_[index].what)) {
    const Point way = minus(line->to, line->from);
    return {way.x / shape.length, way.y / shape.length, way.z / shape.length, way.u / shape.length};
  }
  const auto& arc = std::get<Arc>(items_[index].what);
  const PlaneAxes axes = plane_axes(arc.plane);
  const double part = way_mm / shape.length, angle = shape.begin_angle + shape.sense * part * shape.sweep;
  const double around = shape.sense * (shape.radius + part * shape.growth) * shape.sweep;
  const double size = std::hypot(around, shape.growth, shape.rise);
  Point heading;
  heading.*axes.first = (shape.growth * std::cos(angle) - around * std::sin(angle)) / size;
  heading.*axes.second = (shape.growth * std::sin(angle) + around * std::cos(angle)) / size;
  heading.*axes.normal = shape.rise / size;
  return heading;
}

}  // namespace cnclab::machine
