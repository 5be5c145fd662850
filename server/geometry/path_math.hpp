// What every stage needs to know of a path element: its length and time, where it is at a way, and its direction there.
#pragma once

#include "geometry/path_item.hpp"

namespace cnclab::geometry {

/// The two axes of a plane in the order in which a turn from the first to the second is counterclockwise (D-128).
struct PlaneAxes {
  double Point::* first;
  double Point::* second;
  double Point::* normal;
};

[[nodiscard]] const PlaneAxes& axes_of(Plane plane);

/// An arc worked out once, so that points on it cost one sine and one cosine.
struct ArcShape {
  double start_angle = 0;   ///< radians, in the plane's own sense
  double sweep = 0;         ///< radians, > 0 counterclockwise, never 0; ±2π for a full circle
  double start_radius = 0;  ///< mm, at `from`
  double end_radius = 0;    ///< mm, at `to`
  double normal_way = 0;    ///< mm along the third axis (helix), else 0
  double length = 0;        ///< mm: mean radius × sweep, with the normal way by Pythagoras
};

[[nodiscard]] ArcShape shape_of(const Arc& arc);

[[nodiscard]] double length_of(const Line& line);  ///< mm, all four axes
[[nodiscard]] double length_of(const Arc& arc);    ///< mm
/// mm, of lines and arcs, those of the fourth axis too; 0 of everything else.
[[nodiscard]] double length_of(const PathItem& item);
/// Seconds that a way takes at its feed, without ramps, and a dwell; 0 of everything else.
[[nodiscard]] double seconds_at_feed(const PathItem& item);

/// The point of the element after `way` mm, 0 <= way <= length; exact at both ends.
[[nodiscard]] Point point_at(const Line& line, double length, double way);
[[nodiscard]] Point point_at(const Arc& arc, const ArcShape& shape, double way);

/// Unit direction of travel in x, y, z, u after `way` mm.
[[nodiscard]] Point direction_at(const Line& line, double length);
[[nodiscard]] Point direction_at(const Arc& arc, const ArcShape& shape, double way);

}  // namespace cnclab::geometry
