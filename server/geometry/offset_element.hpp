// One element of a contour with the way of the tool's centre beside it, and the joint between two such ways.
#pragma once

#include <cstdint>
#include <expected>

#include "geometry/path_stages.hpp"
#include "geometry/plane_vector.hpp"
#include "geometry/tolerances.hpp"

namespace cnclab::geometry {

/// A line or arc of the contour in its plane, and its ends shifted along their normals.
///
/// Offsets are signed: > 0 to the left of the direction of travel, < 0 to the right. Curvatures too: > 0 turns left.
struct OffsetElement {
  PlaneVector from{}, to{};                        ///< programmed
  PlaneVector start{}, end{};                      ///< on the normal offset of `from` and `to`
  PlaneVector start_direction{}, end_direction{};  ///< of length 1; of arcs: across the radius
  double extent = 0;                               ///< a line's length in mm, an arc's sweep in radians, > 0
  double start_radius = 0, end_radius = 0;         ///< programmed, mm; 0 of a line
  double turn = 0;                                 ///< +1 left (counterclockwise), -1 right, 0 a line
  PlaneVector center{};                            ///< of an arc
  double start_angle = 0;                          ///< of an arc, radians
  double offset = 0;                               ///< mm
  bool is_seat = false;  ///< an inside arc of the tool's radius: the tool's centre rests on the arc's, its radii are R

  [[nodiscard]] bool is_arc() const { return turn != 0; }
  [[nodiscard]] double start_curvature() const { return is_arc() ? turn / start_radius : 0; }
  [[nodiscard]] double end_curvature() const { return is_arc() ? turn / end_radius : 0; }
  /// Radius of the tool centre's way; 0 of a seat.
  [[nodiscard]] double smallest_offset_radius() const { return std::min(start_radius, end_radius) - turn * offset; }
  /// Does the tool fit into it?
  [[nodiscard]] bool has_room() const { return !is_arc() || smallest_offset_radius() >= 0; }
  /// mm of the tool centre's way for one unit of `extent`
  [[nodiscard]] double way_per_extent() const { return is_arc() ? (start_radius + end_radius) / 2 - turn * offset : 1; }
};

/// `line` must move in the plane. A spiral (D-55) keeps its two radii, each shifted along the radius. Where the tool's
/// radius lies between them, by less than `kRounded_mm` outside, the arc is a seat.
[[nodiscard]] OffsetElement offset_of(const Line& line, const PlaneAxes& axes, double offset);
[[nodiscard]] OffsetElement offset_of(const Arc& arc, double offset);

/// How the way beside one element goes over into the way beside the next.
struct Joint {
  enum class Kind : std::uint8_t { tangent, outer, inner };
  Kind kind = Kind::tangent;
  PlaneVector point{};          ///< where the way beside the element before ends
  double trim_before = 0;       ///< inner, seats: extent cut off the end of the element before
  double trim_after = 0;        ///< inner, seats: extent cut off the start of the element behind
  Turn turn = Turn::clockwise;  ///< outer: sense of the arc about the corner
};

/// The joint of two elements of one offset, `before.to` == `after.from`.
///
/// errors   no_intersection
[[nodiscard]] std::expected<Joint, StageFault::Kind> joint_of(const OffsetElement& before, const OffsetElement& after);

}  // namespace cnclab::geometry
