// Axis-parallel radius and length (COMP-010, COMP-014, COMP-015, COMP-016; D-72 (a), D-73, DEC-65).
//
//   G43, R 5, square of 30:              ┌───────────────┐ (35,35)
//   each side ends 5 further on     (-5,35)              │
//   in its own direction; the            │     30 × 30   │
//   other axis stays where it is         │               │
//                                 (0,0)──┼──────────────▶┘ (35,0)
//                                 (-5,-5)▼
//
//   1. Under G43 a line's end is shifted by R along each axis of the plane in the sense of its way there; under G44
//      against it. An axis without a way keeps its shift.
//      Where less than nothing would be left, the axis would run against its programmed direction: a way under G44
//      that is shorter than R, or than 2·R behind a way to the other side, cannot be followed (DEC-09).
//   2. G40 takes each axis' shift back with the next line that moves or names that axis.
//   3. What G41/G42 finds left over, or a run finds at its start, goes in both axes of the plane with the next line
//      that moves or names one of them: that line ends on the contour's offset, or on the programmed point.
//   4. G46: the axis perpendicular to the plane is shifted by L from the next line on that moves or names it; G45 takes
//      it back in the same way.
//   5. An arc cannot change its shape: where the radius shifts its plane, or is to, it is refused. The length shifts
//      arcs and helices as they are, whatever their plane.
#include "geometry/axis_offset.hpp"

#include <cmath>

#include "geometry/path_math.hpp"
#include "geometry/tolerances.hpp"

namespace cnclab::geometry {

namespace {

constexpr std::array<double Point::*, 3> kAxes{&Point::x, &Point::y, &Point::z};

constexpr std::size_t normal_of(Plane plane) {
  switch (plane) {
    case Plane::xy:
      return 2;
    case Plane::xz:
      return 1;
    case Plane::yz:
      return 0;
  }
  return 2;
}

void add(Point& point, const std::array<double, 3>& shift_mm) {
  point.x += shift_mm[0];
  point.y += shift_mm[1];
  point.z += shift_mm[2];
}

}  // namespace

std::expected<void, StageFault> AxisOffset::rewrite(PathItem& item) {
  if (auto* line = std::get_if<Line>(&item.what)) {
    if (const auto shifted = shift(item, *line); !shifted) return shifted;
    if (line->from == line->to) item.what = Mark{};
  } else if (auto* arc = std::get_if<Arc>(&item.what)) {
    if (refuses(*arc))
      return std::unexpected(
          StageFault{.kind = StageFault::Kind::arc_under_axis_offset, .block = item.source, .other = item.source});
    add(arc->from, shift_mm_);
    add(arc->to, shift_mm_);
    add(arc->center, shift_mm_);
  } else if (const auto* radius = std::get_if<RadiusOffset>(&item.what)) {
    take(*radius);
    item.what = Mark{};
  } else if (const auto* length = std::get_if<LengthOffset>(&item.what)) {
    take(*length);
    item.what = Mark{};
  }
  return {};
}

void AxisOffset::take(const RadiusOffset& order) {
  plane_ = order.plane;
  switch (order.side) {
    case OffsetSide::off:
      if (rule_ == Rule::follows_ways) rule_ = Rule::leaves_alone;
      return;
    case OffsetSide::left:
    case OffsetSide::right:
      rule_ = Rule::leaves_together;
      return;
    case OffsetSide::plus:
    case OffsetSide::minus:
      rule_ = Rule::follows_ways;
      radius_mm_ = order.side == OffsetSide::plus ? order.radius_mm : -order.radius_mm;
      return;
  }
}

void AxisOffset::take(const LengthOffset& order) {
  plane_ = order.plane;
  length_mm_ = order.length_mm;
}

std::expected<void, StageFault> AxisOffset::shift(const PathItem& item, Line& line) {
  std::array<double, 3> next_mm = shift_mm_;
  if (!item.is_fourth_axis) {
    const std::size_t normal = normal_of(plane_);
    bool moves_in_plane = false;
    const auto way = [&](std::size_t axis) { return line.to.*kAxes[axis] - line.from.*kAxes[axis]; };
    const auto is_named = [&](std::size_t axis) { return (item.named_axes >> axis & 1U) != 0; };
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
      moves_in_plane = moves_in_plane || (axis != normal && (way(axis) != 0 || is_named(axis)));
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      next_mm[axis] = next_shift(axis, way(axis), is_named(axis), moves_in_plane);
      const double change = next_mm[axis] - shift_mm_[axis];
      if (axis != normal && runs_backwards(way(axis), change))
        return std::unexpected(StageFault{.kind = StageFault::Kind::runs_backwards,
                                          .block = item.source,
                                          .other = item.source,
                                          .found_mm = std::abs(way(axis)),
                                          .needed_mm = std::abs(change)});
    }
  }
  add(line.from, shift_mm_);
  add(line.to, next_mm);
  shift_mm_ = next_mm;
  return {};
}

/// Rule 1: does the change of an axis' shift more than undo its way?
bool AxisOffset::runs_backwards(double way, double change) const {
  return rule_ == Rule::follows_ways && way != 0 && std::copysign(1.0, way) * (way + change) < -kSamePoint_mm;
}

double AxisOffset::next_shift(std::size_t axis, double way, bool is_named, bool moves_in_plane) const {
  const double now = shift_mm_[axis];
  const bool moves = way != 0 || is_named;
  if (axis == normal_of(plane_)) return moves ? length_mm_ : now;
  switch (rule_) {
    case Rule::leaves_together:
      return moves_in_plane ? 0 : now;
    case Rule::leaves_alone:
      return moves ? 0 : now;
    case Rule::follows_ways:
      if (way == 0) return now;
      return way > 0 ? radius_mm_ : -radius_mm_;
  }
  return now;
}

bool AxisOffset::refuses(const Arc& arc) const {
  const bool is_shifting = rule_ == Rule::follows_ways && radius_mm_ != 0;
  const std::size_t arc_normal = normal_of(arc.plane), normal = normal_of(plane_);
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
    if (axis != arc_normal && axis != normal && (is_shifting || shift_mm_[axis] != 0)) return true;
  return false;
}

}  // namespace cnclab::geometry
