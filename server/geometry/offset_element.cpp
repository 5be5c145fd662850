// Normal offsets and their joints (COMP-004, COMP-008, COMP-009, COMP-011; D-71).
//
//   outer corner: round it            inner corner: cut both             tangent: nothing
//
//          ╭──────▶                     │  ╱                              ─────▶╮
//        ╭ ┊R                     ──────P──── ─ ─                         ═════╗│
//        │ ┌══════▶                  ═══│═══╗                                  ║▼
//        │ ║                            ▼   ║
//
// Rules, with d the signed offset and a bend > 0 to the left:
//   1. The ends of both ways agree within a nanometre: tangent.
//   2. d × bend < 0: outer. A contour that turns back upon itself is outer where its two sides leave the tool room.
//   3. Else inner. Every point P at the distance d from both elements, seen from the corner C as w = P - C, obeys
//        w·nA = d + kA·m/2     w·nB = d + kB·m/2     |w|² = d² + m
//      for lines (curvature k = 0) and arcs alike, n being the left normals at C. With T and N along and across the
//      bisector, h half the bend and m = u·sin²h it follows:
//        u  = 2·d² / ((a + b)/2 - sin²h + cos h·√(a·b - sin²h)),   a = 1 - d·kA, b = 1 - d·kB
//        wT = (kA - kB)/4·u·sin h      wN = (d + (kA + kB)/4·u·sin²h) / cos h, of the sign of d
//      Nothing in it cancels when the bend goes to zero. Of two such points this is the one next to the corner.
//   4. Where a radius changes along the arc (D-55) P belongs to the circles at the corner: its distance from a spiral
//      is off by the change as far as P lies from the corner. Where that is more than a trifle, Newton's steps lead to
//      the point on both spirals. Ways that almost touch have none, or one far away: P stands then. It is off by no
//      more than the two radii of the arc are apart, so by no more than the arc tolerance.
//   5. A seat's way is the one point at its centre. The ways beside its neighbours end and begin there if they come
//      within the arc tolerance of it; else an outer corner is rounded, and an inner one has no room for the tool.
#include "geometry/offset_element.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace cnclab::geometry {

namespace {

/// Below this sine a bend is none, or a turn back.
constexpr double kStraight = 1e-9;
/// Below this cosine of half the bend a corner is a cusp.
constexpr double kSharp = 0.1;

/// The bend from the end of one element to the start of the next.
struct Bend {
  double sine = 0, cosine = 1;
};

Bend bend_between(const OffsetElement& before, const OffsetElement& after) {
  Bend bend{.sine = cross(before.end_direction, after.start_direction),
            .cosine = dot(before.end_direction, after.start_direction)};
  if (bend.cosine > 0 || std::abs(bend.sine) > kStraight) return bend;
  // A turn back (rule 2): the element behind lies left of the one before if the curvatures say so; a way back along
  // itself goes round the end.
  const double opening = before.end_curvature() + after.start_curvature();
  if (std::abs(opening) > kStraight)
    bend.sine = opening > 0 ? -kStraight : kStraight;
  else
    bend.sine = before.offset > 0 ? -kStraight : kStraight;
  return bend;
}

/// Rule 3: the point next to the corner at the distance of the offset from both, as seen from the corner.
std::optional<PlaneVector> meeting_point(const OffsetElement& before, const OffsetElement& after, double sine) {
  const PlaneVector along = before.end_direction + after.start_direction;
  const PlaneVector across = after.start_direction - before.end_direction;
  const double cos_half = size(along) / 2;
  const double sin_half = std::copysign(size(across) / 2, sine);
  const double sin_sq = sin_half * sin_half;
  const double d = before.offset, curvature = before.end_curvature(), next_curvature = after.start_curvature();
  const double a = 1 - d * curvature, b = 1 - d * next_curvature;
  if (a * b < sin_sq) return std::nullopt;

  const double u = 2 * d * d / ((a + b) / 2 - sin_sq + cos_half * std::sqrt(a * b - sin_sq));
  const double along_bisector = (curvature - next_curvature) / 4 * u * sin_half;
  if (cos_half > kSharp) {
    const PlaneVector bisector = along * (1 / (2 * cos_half));
    const double across_bisector = (d + (curvature + next_curvature) / 4 * u * sin_sq) / cos_half;
    return bisector * along_bisector + left_of(bisector) * across_bisector;
  }
  // Almost a turn back: the bisector is known by its normal, and wN by |w|.
  const PlaneVector normal = across * (1 / (2 * sin_half));
  const double across_sq = d * d + u * sin_sq - along_bisector * along_bisector;
  return right_of(normal) * along_bisector + normal * std::copysign(std::sqrt(std::max(across_sq, 0.0)), d);
}

/// How far behind an element's end (`sign` -1) or start (+1) a point beside it lies, `w` being seen from there.
double trim_to(PlaneVector w, PlaneVector direction, double curvature, double offset, double sign) {
  if (curvature == 0) return sign * dot(w, direction);
  const double radius = 1 / curvature - offset;  // signed, of the tool centre's way
  const double turned = std::atan2(dot(w, direction) / radius, (1 / curvature - dot(w, left_of(direction))) / radius);
  return sign * std::copysign(1.0, radius) * turned;
}

struct PlaceAndSlope {
  PlaneVector place, slope;
};

/// The tool centre's way after `extent` from the start, and its derivative by extent.
PlaceAndSlope way_at(const OffsetElement& element, double extent) {
  if (!element.is_arc()) return {element.start + element.start_direction * extent, element.start_direction};
  const double growth = (element.end_radius - element.start_radius) / element.extent;
  const double radius = element.start_radius - element.turn * element.offset + growth * extent;
  const double angle = element.start_angle + element.turn * extent;
  const PlaneVector outward{std::cos(angle), std::sin(angle)};
  return {element.center + outward * radius, outward * growth + left_of(outward) * (element.turn * radius)};
}

/// Rule 4: how far the joint is from the way beside a spiral, mm.
double error_beside(const OffsetElement& element, double trim) {
  return std::abs(element.end_radius - element.start_radius) * trim / element.extent;
}

/// Behind the end of one or ahead of the start of the other there is no way to meet on.
bool is_beside_both(const OffsetElement& before, const OffsetElement& after, const Joint& joint) {
  return joint.trim_before * before.way_per_extent() > -kSamePoint_mm &&
         joint.trim_after * after.way_per_extent() > -kSamePoint_mm;
}

/// Rule 4. false: the ways do not meet near the starting point.
bool refine(const OffsetElement& before, const OffsetElement& after, Joint& joint) {
  constexpr int kMostSteps = 12;          // quadratic: four are enough unless the ways nearly touch
  constexpr double kSamePlace_mm = 1e-9;  // the ways' own arithmetic
  double along_before = before.extent - joint.trim_before, along_after = joint.trim_after;
  for (int step = 0; step < kMostSteps; ++step) {
    const PlaceAndSlope a = way_at(before, along_before), b = way_at(after, along_after);
    const PlaneVector gap = b.place - a.place;
    if (size(gap) < kSamePlace_mm) {
      joint.point = a.place;
      joint.trim_before = before.extent - along_before;
      joint.trim_after = along_after;
      return true;
    }
    const double determinant = cross(a.slope, b.slope);
    if (determinant == 0) return false;
    along_before += cross(gap, b.slope) / determinant;
    along_after += cross(gap, a.slope) / determinant;
  }
  return false;
}

/// Rule 3 for two lines, in its shortest form.
Joint joint_of_lines(const OffsetElement& before, const OffsetElement& after, const Bend& bend) {
  const double trim = before.offset * bend.sine / (1 + bend.cosine);
  const PlaneVector normals = left_of(before.end_direction + after.start_direction);
  return {.kind = Joint::Kind::inner,
          .point = after.from + normals * (before.offset / (1 + bend.cosine)),
          .trim_before = trim,
          .trim_after = trim};
}

Joint outer_joint(const OffsetElement& before, const Bend& bend) {
  return {.kind = Joint::Kind::outer,
          .point = before.end,
          .turn = bend.sine > 0 ? Turn::counterclockwise : Turn::clockwise};
}

/// Rule 5.
std::expected<Joint, StageFault::Kind> joint_at_seat(const OffsetElement& before, const OffsetElement& after,
                                                     const Bend& bend) {
  const bool is_reached = bend.cosine > 0 && size(after.start - before.end) <= kArcTolerance_mm;
  if (!is_reached) {
    if (bend.sine * before.offset < 0) return outer_joint(before, bend);
    return std::unexpected(StageFault::Kind::no_intersection);
  }
  Joint joint{.kind = Joint::Kind::tangent, .point = before.is_seat ? before.center : after.center};
  const PlaneVector w = joint.point - after.from;
  if (!before.is_seat) joint.trim_before = trim_to(w, before.end_direction, before.end_curvature(), before.offset, -1);
  if (!after.is_seat) joint.trim_after = trim_to(w, after.start_direction, after.start_curvature(), after.offset, 1);
  return joint;
}

/// An inside arc whose radii are the tool's, but for rounding.
void seat_tool(OffsetElement& element) {
  const double tool_radius = element.turn * element.offset;  // < 0: the tool is outside
  const auto [smaller, larger] = std::minmax(element.start_radius, element.end_radius);
  element.is_seat = smaller - kRounded_mm <= tool_radius && tool_radius <= larger + kRounded_mm;
  if (!element.is_seat) return;
  element.start_radius = element.end_radius = tool_radius;
  element.start = element.end = element.center;
}

}  // namespace

OffsetElement offset_of(const Line& line, const PlaneAxes& axes, double offset) {
  OffsetElement element{.from = in_plane(line.from, axes), .to = in_plane(line.to, axes), .offset = offset};
  const PlaneVector way = element.to - element.from;
  element.extent = size(way);
  element.start_direction = element.end_direction = way * (1 / element.extent);
  const PlaneVector shift = left_of(element.start_direction) * offset;
  element.start = element.from + shift;
  element.end = element.to + shift;
  return element;
}

OffsetElement offset_of(const Arc& arc, double offset) {
  const PlaneAxes& axes = axes_of(arc.plane);
  const ArcShape shape = shape_of(arc);
  OffsetElement element{.from = in_plane(arc.from, axes),
                        .to = in_plane(arc.to, axes),
                        .extent = std::abs(shape.sweep),
                        .start_radius = shape.start_radius,
                        .end_radius = shape.end_radius,
                        .turn = shape.sweep > 0 ? 1.0 : -1.0,
                        .center = in_plane(arc.center, axes),
                        .start_angle = shape.start_angle,
                        .offset = offset};
  const PlaneVector start_normal = (element.center - element.from) * (element.turn / element.start_radius);
  const PlaneVector end_normal = (element.center - element.to) * (element.turn / element.end_radius);
  element.start_direction = right_of(start_normal);
  element.end_direction = right_of(end_normal);
  element.start = element.from + start_normal * offset;
  element.end = element.to + end_normal * offset;
  seat_tool(element);
  return element;
}

std::expected<Joint, StageFault::Kind> joint_of(const OffsetElement& before, const OffsetElement& after) {
  const Bend bend = bend_between(before, after);
  const PlaneVector gap = after.start - before.end;
  if (bend.cosine > 0 && dot(gap, gap) <= kSamePoint_mm * kSamePoint_mm)
    return Joint{.kind = Joint::Kind::tangent, .point = before.end};
  if (before.is_seat || after.is_seat) return joint_at_seat(before, after, bend);
  if (bend.sine * before.offset < 0) return outer_joint(before, bend);
  if (!before.is_arc() && !after.is_arc()) return joint_of_lines(before, after, bend);

  const auto w = meeting_point(before, after, bend.sine);
  if (!w) return std::unexpected(StageFault::Kind::no_intersection);
  Joint joint{
      .kind = Joint::Kind::inner,
      .point = after.from + *w,
      .trim_before = trim_to(*w, before.end_direction, before.end_curvature(), before.offset, -1),
      .trim_after = trim_to(*w, after.start_direction, after.start_curvature(), after.offset, 1),
  };
  if (!is_beside_both(before, after, joint)) return std::unexpected(StageFault::Kind::no_intersection);
  const double error = std::max(error_beside(before, joint.trim_before), error_beside(after, joint.trim_after));
  if (error <= kExactJoint_mm) return joint;
  Joint exact = joint;
  return refine(before, after, exact) && is_beside_both(before, after, exact) ? exact : joint;
}

}  // namespace cnclab::geometry
