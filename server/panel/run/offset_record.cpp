// The place nearest to where the axes stand, and what the offset is there.
#include "panel/run/offset_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/path_math.hpp"

namespace cnclab::panel {

namespace {

using geometry::Arc;
using geometry::Line;
using geometry::Point;
using Offset = std::array<double, 3>;

/// A place on a way: its share of the way, 0..1, and how far from it the axes are.
struct PlaceOnWay {
  double share = 0;
  double distance_mm = 0;
};

double distance(const Point& a, const Point& b) { return geometry::length_of(Line{.from = a, .to = b}); }

PlaceOnWay nearest_on(const Line& line, const Point& point) {
  const double length = geometry::length_of(line);
  if (length == 0) return {.share = 1, .distance_mm = distance(point, line.to)};
  const Point direction = geometry::direction_at(line, length);
  const double way = (point.x - line.from.x) * direction.x + (point.y - line.from.y) * direction.y +
                     (point.z - line.from.z) * direction.z;
  const double share = std::clamp(way / length, 0.0, 1.0);
  return {.share = share, .distance_mm = distance(point, geometry::point_at(line, length, share * length))};
}

/// By its angle about the centre; before the beginning and behind the end the nearer of them counts.
PlaceOnWay nearest_on(const Arc& arc, const Point& point) {
  const geometry::PlaneAxes& axes = geometry::axes_of(arc.plane);
  const geometry::ArcShape shape = geometry::shape_of(arc);
  const double angle =
      std::atan2(point.*axes.second - arc.center.*axes.second, point.*axes.first - arc.center.*axes.first);
  const double turned = std::remainder(angle - shape.start_angle - shape.sweep / 2, 2 * std::numbers::pi);
  const double share = std::clamp(turned / shape.sweep + 0.5, 0.0, 1.0);
  return {.share = share, .distance_mm = distance(point, geometry::point_at(arc, shape, share * shape.length))};
}

Offset evenly(const Offset& from, const Offset& to, double share) {
  return {std::lerp(from[0], to[0], share), std::lerp(from[1], to[1], share), std::lerp(from[2], to[2], share)};
}

Offset turned(const Offset& offset, const geometry::PlaneAxes& axes, double angle) {
  const Point point{offset[0], offset[1], offset[2]};
  Point result = point;
  result.*axes.first = point.*axes.first * std::cos(angle) - point.*axes.second * std::sin(angle);
  result.*axes.second = point.*axes.first * std::sin(angle) + point.*axes.second * std::cos(angle);
  return {result.x, result.y, result.z};
}

Offset offset_at(const Line&, const Offset& from, const Offset& to, double share) { return evenly(from, to, share); }

Offset offset_at(const Arc& arc, const Offset& from, const Offset& to, double share) {
  const geometry::PlaneAxes& axes = geometry::axes_of(arc.plane);
  const double sweep = geometry::shape_of(arc).sweep;
  // What lies beside the arc's end is seen as it lies beside its beginning, and turned to the place between.
  return turned(evenly(from, turned(to, axes, -sweep), share), axes, share * sweep);
}

std::optional<geometry::PathElement> way_of(const geometry::PathItem& item) {
  if (const auto* line = std::get_if<Line>(&item.what)) return *line;
  if (const auto* arc = std::get_if<Arc>(&item.what)) return *arc;
  return std::nullopt;
}

}  // namespace

void OffsetRecord::take(const std::vector<geometry::PathItem>& items) {
  constexpr Offset kNone{};
  for (const geometry::PathItem& item : items) {
    const std::optional<geometry::PathElement> way = way_of(item);
    if (!way) continue;
    if (newest_mm_ != kNone || item.shift_mm != kNone)
      ways_.push_back({item.sequence, *way, newest_mm_, item.shift_mm});
    newest_mm_ = item.shift_mm;
  }
}

void OffsetRecord::forget_before(std::uint64_t sequence) {
  for (; !ways_.empty() && ways_.front().sequence < sequence; ways_.pop_front()) before_mm_ = ways_.front().to_mm;
}

Offset OffsetRecord::behind(std::uint64_t sequence) const {
  const auto next = std::ranges::upper_bound(ways_, sequence, {}, &Way::sequence);
  return next == ways_.begin() ? before_mm_ : std::prev(next)->to_mm;
}

Offset OffsetRecord::within(std::uint64_t sequence, const std::array<double, 4>& path_mm) const {
  const Point point{path_mm[0], path_mm[1], path_mm[2], path_mm[3]};
  Offset offset = behind(sequence);
  double least_mm = std::numeric_limits<double>::infinity();
  for (const Way& way : std::ranges::equal_range(ways_, sequence, {}, &Way::sequence)) {
    std::visit(
        [&](const auto& element) {
          const PlaceOnWay place = nearest_on(element, point);
          if (place.distance_mm >= least_mm) return;
          least_mm = place.distance_mm;
          offset = offset_at(element, way.from_mm, way.to_mm, place.share);
        },
        way.element);
  }
  return offset;
}

}  // namespace cnclab::panel
