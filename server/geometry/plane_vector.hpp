// Two-dimensional vectors in the axes of a plane: where compensation and rounding think.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/path_math.hpp"

namespace cnclab::geometry {

/// A point, way or direction in a plane, mm: along its first and its second axis (`PlaneAxes`).
struct PlaneVector {
  double first = 0, second = 0;
  friend bool operator==(const PlaneVector&, const PlaneVector&) = default;
};

[[nodiscard]] inline PlaneVector operator+(PlaneVector a, PlaneVector b) {
  return {a.first + b.first, a.second + b.second};
}
[[nodiscard]] inline PlaneVector operator-(PlaneVector a, PlaneVector b) {
  return {a.first - b.first, a.second - b.second};
}
[[nodiscard]] inline PlaneVector operator*(PlaneVector v, double factor) {
  return {v.first * factor, v.second * factor};
}
[[nodiscard]] inline double dot(PlaneVector a, PlaneVector b) { return a.first * b.first + a.second * b.second; }
/// > 0: b points to the left of a.
[[nodiscard]] inline double cross(PlaneVector a, PlaneVector b) { return a.first * b.second - a.second * b.first; }
[[nodiscard]] inline double size(PlaneVector v) { return std::sqrt(dot(v, v)); }
/// The vector turned to its left, and to its right, by a quarter.
[[nodiscard]] inline PlaneVector left_of(PlaneVector v) { return {-v.second, v.first}; }
[[nodiscard]] inline PlaneVector right_of(PlaneVector v) { return {v.second, -v.first}; }

/// Position along an axis-parallel or slanted way at 0 <= t <= 1.
[[nodiscard]] inline PlaneVector between(PlaneVector a, PlaneVector b, double t) {
  return {std::lerp(a.first, b.first, t), std::lerp(a.second, b.second, t)};
}

[[nodiscard]] inline PlaneVector in_plane(const Point& point, const PlaneAxes& axes) {
  return {point.*axes.first, point.*axes.second};
}
inline void set_in_plane(Point& point, const PlaneAxes& axes, PlaneVector place) {
  point.*axes.first = place.first;
  point.*axes.second = place.second;
}

/// Does the line lead to another place of the plane? The fourth axis never does.
[[nodiscard]] inline bool moves_in_plane(const Line& line, const PlaneAxes& axes) {
  return line.from.*axes.first != line.to.*axes.first || line.from.*axes.second != line.to.*axes.second;
}

}  // namespace cnclab::geometry
