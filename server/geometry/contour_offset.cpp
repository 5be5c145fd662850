// Entry, elements, corners and exit of a compensated contour (COMP-001 to COMP-011; D-70, D-71, D-75, DEC-09).
//
//   1. The first line of the plane behind G41/G42 is the entry: from where the tool stands to the normal offset of the
//      START of the element behind it (D-70).
//   2. Each further line or arc of the plane is an element of the contour. Its joint with the one held back is worked
//      out; then that one leaves, everything behind it leaves, and the new one is held back.
//   3. What does not move in the plane (events, ways along the normal, the fourth axis) keeps its place behind the
//      element before it: at the corner, ahead of the corner arc.
//   4. A corner arc belongs to the block of the element behind it and leaves directly before that.
//   5. G40 (or the end of the stream) ends the contour at the normal offset of the last element's own end; the next
//      line of the plane leaves to its programmed end. A line that names an axis of the plane but finds the program
//      there already (G90) leaves too.
//   6. Another side or radius while one is on ends the contour as G40 does; the next line is an entry again, from where
//      the tool stands. Repeating what is on changes nothing. Radius 0 is off (COMP-003).
//   7. The manual's full circle is an arc ending one increment beside its start and a line back to it (G-024). Where
//      the tool runs inside that corner, no joint would fit the tiny line; inside the circle it would swing round the
//      line's ends into the wall: the arc takes the line over and closes by itself.
#include "geometry/contour_offset.hpp"

#include <cmath>
#include <numbers>

#include "geometry/contour_check.hpp"

namespace cnclab::geometry {

namespace {

bool is_on(const RadiusOffset& order) {
  return (order.side == OffsetSide::left || order.side == OffsetSide::right) && order.radius_mm > 0;
}

bool same(const RadiusOffset& a, const RadiusOffset& b) {
  return a.side == b.side && a.radius_mm == b.radius_mm && a.plane == b.plane;
}

/// The bits of `named_axes` of the plane's two axes.
unsigned axes_bits(Plane plane) {
  switch (plane) {
    case Plane::xy:
      return 1U | 2U;
    case Plane::xz:
      return 1U | 4U;
    case Plane::yz:
      return 2U | 4U;
  }
  return 0;
}

Point sum(const Point& point, const Point& shift) {
  return {point.x + shift.x, point.y + shift.y, point.z + shift.z, point.u};
}

std::array<double, 3> numbers_of(const Point& point) { return {point.x, point.y, point.z}; }

const Point& from_of(const PathItem& item) {
  if (const auto* line = std::get_if<Line>(&item.what)) return line->from;
  return std::get<Arc>(item.what).from;
}

const Point& to_of(const PathItem& item) {
  if (const auto* line = std::get_if<Line>(&item.what)) return line->to;
  return std::get<Arc>(item.what).to;
}

PathElement element_of(const PathItem& item) {
  if (const auto* line = std::get_if<Line>(&item.what)) return *line;
  return std::get<Arc>(item.what);
}

double feed_of(const PathItem& item) {
  if (const auto* line = std::get_if<Line>(&item.what)) return line->feed_mm_per_min;
  return std::get<Arc>(item.what).feed_mm_per_min;
}

OffsetElement offset_of(const PathItem& item, const PlaneAxes& axes, double offset) {
  if (const auto* line = std::get_if<Line>(&item.what)) return offset_of(*line, axes, offset);
  return offset_of(std::get<Arc>(item.what), offset);
}

/// Where an arc's ends all but meet, has rounding made a whole circle of a tiny arc, or a tiny arc of a circle?
bool has_flipped(const Arc& arc, const PlaneAxes& axes, double intended_sweep) {
  constexpr double kWidest_mm = 2 * kArcTolerance_mm;  // a seat moves either end by no more than the arc tolerance
  const PlaneVector gap = in_plane(arc.to, axes) - in_plane(arc.from, axes);
  return dot(gap, gap) <= kWidest_mm * kWidest_mm &&
         std::abs(std::abs(shape_of(arc).sweep) - intended_sweep) > std::numbers::pi;
}

struct Ends {
  PlaneVector from, to;
};

/// Lets a line or arc run from there to there. false: an arc of which nothing is left.
bool set_ends(PathItem& way, const PlaneAxes& axes, const Ends& ends, double intended_extent) {
  if (auto* line = std::get_if<Line>(&way.what)) {
    set_in_plane(line->from, axes, ends.from);
    set_in_plane(line->to, axes, ends.to);
    return true;
  }
  auto& arc = std::get<Arc>(way.what);
  set_in_plane(arc.from, axes, ends.from);
  set_in_plane(arc.to, axes, ends.to);
  if (!has_flipped(arc, axes, intended_extent)) return true;
  set_in_plane(arc.to, axes, ends.from);
  return intended_extent > std::numbers::pi;
}

}  // namespace

std::expected<void, StageFault> ContourOffset::push(const PathItem& item, std::vector<PathItem>& out,
                                                    ContourCheck* check) {
  if (std::holds_alternative<RadiusOffset>(item.what)) return take_order(item, out, check);
  const auto* line = std::get_if<Line>(&item.what);
  const bool is_way = line != nullptr ? !item.is_fourth_axis && moves_in_plane(*line, axes_of(order_.plane))
                                      : std::holds_alternative<Arc>(item.what);
  if (is_way && !is_idle()) return take_way(item, out, check);
  if (holds()) {
    behind_.push_back(item);
    return {};
  }
  const bool is_exit_without_way = state_ == State::off && is_shifted_ && line != nullptr && !item.is_fourth_axis &&
                                   (item.named_axes & axes_bits(order_.plane)) != 0;
  if (is_exit_without_way) return take_way(item, out, check);
  leave(item, out);
  return {};
}

std::expected<void, StageFault> ContourOffset::flush(std::vector<PathItem>& out, ContourCheck* check) {
  finish(out, check);
  return {};
}

std::expected<void, StageFault> ContourOffset::take_order(const PathItem& item, std::vector<PathItem>& out,
                                                          ContourCheck* check) {
  const auto& order = std::get<RadiusOffset>(item.what);
  if (is_on(order) && state_ != State::off && same(order, order_)) {
    if (holds())
      behind_.push_back(item);
    else
      out.push_back(item);
    return {};
  }
  finish(out, check);
  out.push_back(item);
  const bool keeps_plane = !is_on(order) && is_shifted_;  // the exit is still due in the old plane
  const Plane plane = keeps_plane ? order_.plane : order.plane;
  order_ = order;
  order_.plane = plane;
  state_ = is_on(order) ? State::awaits_entry : State::off;
  offset_ = order.side == OffsetSide::left ? order.radius_mm : -order.radius_mm;
  return {};
}

std::expected<void, StageFault> ContourOffset::take_way(const PathItem& item, std::vector<PathItem>& out,
                                                        ContourCheck* check) {
  const bool is_line = std::holds_alternative<Line>(item.what);
  switch (state_) {
    case State::off:
      if (!is_line) return fault_at(StageFault::Kind::arc_at_entry_or_exit, item);
      leave_contour(item, out, check);
      return {};
    case State::awaits_entry:
      if (!is_line) return fault_at(StageFault::Kind::arc_at_entry_or_exit, item);
      held_ = item;
      state_ = State::entry_held;
      return {};
    case State::entry_held:
      return begin_contour(item, out, check);
    case State::element_held:
      return join(item, out, check);
  }
  return {};
}

std::expected<OffsetElement, StageFault> ContourOffset::offset_beside(const PathItem& item) const {
  const auto* arc = std::get_if<Arc>(&item.what);
  if (arc != nullptr && arc->plane != order_.plane) return fault_at(StageFault::Kind::no_intersection, item);
  const OffsetElement element = offset_of(item, axes_of(order_.plane), offset_);
  if (!element.has_room())
    return fault_at(StageFault::Kind::inside_arc_too_small, item, std::min(element.start_radius, element.end_radius),
                    order_.radius_mm);
  return element;
}

/// Rule 1.
std::expected<void, StageFault> ContourOffset::begin_contour(const PathItem& item, std::vector<PathItem>& out,
                                                             ContourCheck* check) {
  const std::expected<OffsetElement, StageFault> found = offset_beside(item);
  if (!found) return std::unexpected(found.error());
  const OffsetElement& element = *found;
  emit_entry(element.start, out, check);
  hold(item, element, {.kind = Joint::Kind::tangent, .point = element.start});
  return {};
}

/// Rule 2.
std::expected<void, StageFault> ContourOffset::join(const PathItem& item, std::vector<PathItem>& out,
                                                    ContourCheck* check) {
  if (closes_circle(item)) {
    close_circle(item);
    return {};
  }
  const std::expected<OffsetElement, StageFault> found = offset_beside(item);
  if (!found) return std::unexpected(found.error());
  const OffsetElement& element = *found;
  const auto joint = joint_of(element_, element);
  if (!joint) return fault_at(joint.error(), item);
  const auto backwards = [](const OffsetElement& shape, double trims) {
    return !((shape.extent - trims) * shape.way_per_extent() >= -kSamePoint_mm);
  };
  const double trims = start_.trim_after + joint->trim_before;
  if (backwards(element_, trims))
    return fault_at(StageFault::Kind::runs_backwards, held_, element_.extent * element_.way_per_extent(),
                    trims * element_.way_per_extent());
  if (backwards(element, joint->trim_after))
    return fault_at(StageFault::Kind::runs_backwards, item, element.extent * element.way_per_extent(),
                    joint->trim_after * element.way_per_extent());
  emit_element(*joint, out, check);
  hold(item, element, *joint);
  return {};
}

/// Rule 7.
bool ContourOffset::closes_circle(const PathItem& item) const {
  const auto* line = std::get_if<Line>(&item.what);
  if (line == nullptr || !element_.is_arc()) return false;
  const PlaneAxes& axes = axes_of(order_.plane);
  const PlaneVector way = in_plane(line->to, axes) - in_plane(line->from, axes);
  if (dot(way, way) > kArcTolerance_mm * kArcTolerance_mm) return false;
  if (size(in_plane(line->to, axes) - element_.from) > kSamePoint_mm) return false;
  const bool is_inside_corner = cross(element_.end_direction, way) * offset_ > 0;
  const bool is_inside_circle = element_.turn * offset_ > 0;
  return (is_inside_corner || is_inside_circle) && element_.extent > std::numbers::pi;
}

void ContourOffset::close_circle(const PathItem& item) {
  const PlaneAxes& axes = axes_of(order_.plane);
  auto& arc = std::get<Arc>(held_.what);
  set_in_plane(arc.to, axes, element_.from);
  element_ = offset_of(arc, offset_);
  PathItem rest = item;
  set_in_plane(std::get<Line>(rest.what).from, axes, element_.to);
  set_in_plane(std::get<Line>(rest.what).to, axes, element_.to);
  behind_.push_back(rest);
}

void ContourOffset::hold(const PathItem& item, const OffsetElement& element, const Joint& joint) {
  held_ = item;
  element_ = element;
  start_ = joint;
  state_ = State::element_held;
}

/// Rule 5: nothing follows, so what is held ends at the normal offset of its own end.
void ContourOffset::finish(std::vector<PathItem>& out, ContourCheck* check) {
  switch (state_) {
    case State::off:
    case State::awaits_entry:
      return;
    case State::entry_held:
      emit_entry(offset_of(held_, axes_of(order_.plane), offset_).end, out, check);
      if (check != nullptr) check->end();
      break;
    case State::element_held:
      emit_element({.kind = Joint::Kind::tangent, .point = element_.end}, out, check);
      if (check != nullptr) check->end();
      break;
  }
  state_ = State::awaits_entry;
}

/// Rule 5: the exit.
void ContourOffset::leave_contour(const PathItem& item, std::vector<PathItem>& out, ContourCheck* check) {
  out.push_back(item);
  auto& line = std::get<Line>(out.back().what);
  line.from = sum(line.from, shift_);
  shift_ = {};
  is_shifted_ = false;
  if (check != nullptr) check->add_exit(item.source, line);
}

/// Lets an item pass that does not move in the plane, or comes while nothing is on.
void ContourOffset::leave(const PathItem& item, std::vector<PathItem>& out) {
  out.push_back(item);
  if (!is_shifted_) return;
  out.back().shift_mm = numbers_of(shift_);
  if (auto* line = std::get_if<Line>(&out.back().what)) {
    line->from = sum(line->from, shift_);
    line->to = sum(line->to, shift_);
  }
}

void ContourOffset::emit_entry(PlaneVector end, std::vector<PathItem>& out, ContourCheck* check) {
  const PlaneAxes& axes = axes_of(order_.plane);
  out.push_back(held_);
  auto& line = std::get<Line>(out.back().what);
  line.from = sum(line.from, shift_);
  set_in_plane(line.to, axes, end);
  if (check != nullptr) check->begin(order_.plane, order_.radius_mm, held_.source, line);
  at_ = end;
  shift_ = {};
  set_shift(at_, to_of(held_));
  out.back().shift_mm = numbers_of(shift_);
  emit_behind(out);
}

void ContourOffset::emit_element(const Joint& joint, std::vector<PathItem>& out, ContourCheck* check) {
  // What is shorter than the ends' own uncertainty is skipped: its direction would be noise.
  constexpr double kSpent_mm = 2 * kSamePoint_mm;
  const PlaneAxes& axes = axes_of(order_.plane);
  if (check != nullptr) check->add_contour(held_.source, element_of(held_));
  if (start_.kind == Joint::Kind::outer) emit_corner(out, check);
  out.push_back(held_);
  PathItem& way = out.back();
  const double left = element_.extent - start_.trim_after - joint.trim_before;
  if (left * element_.way_per_extent() > kSpent_mm && set_ends(way, axes, {at_, joint.point}, left)) {
    at_ = in_plane(to_of(way), axes);
    if (check != nullptr) check->add_path(held_.source, element_of(way));
  } else {
    Line still{.from = from_of(held_), .to = to_of(held_), .feed_mm_per_min = feed_of(held_)};
    set_in_plane(still.from, axes, at_);
    set_in_plane(still.to, axes, at_);
    way.what = still;
  }
  set_shift(at_, to_of(held_));
  way.shift_mm = numbers_of(shift_);
  emit_behind(out);
}

/// Rule 4. The arc stops for nothing: what the block asks for happens at its own end.
void ContourOffset::emit_corner(std::vector<PathItem>& out, ContourCheck* check) {
  const PlaneAxes& axes = axes_of(order_.plane);
  PathItem corner = held_;
  corner.ends_block = false;
  corner.exact_stop = false;
  corner.named_axes = 0;
  const Point& programmed = from_of(held_);
  Arc arc{.from = programmed, .to = programmed, .center = programmed, .turn = start_.turn, .plane = order_.plane};
  arc.feed_mm_per_min = feed_of(held_);
  set_in_plane(arc.from, axes, at_);
  set_in_plane(arc.to, axes, element_.start);
  corner.what = arc;
  at_ = element_.start;
  set_shift(at_, programmed);
  corner.shift_mm = numbers_of(shift_);
  out.push_back(corner);
  if (check != nullptr) check->add_corner(held_.source, arc);
}

/// Rule 3.
void ContourOffset::emit_behind(std::vector<PathItem>& out) {
  for (const PathItem& item : behind_) leave(item, out);
  behind_.clear();
}

void ContourOffset::set_shift(PlaneVector place, const Point& programmed) {
  const PlaneAxes& axes = axes_of(order_.plane);
  set_in_plane(shift_, axes, place - in_plane(programmed, axes));
  is_shifted_ = true;
}

}  // namespace cnclab::geometry
