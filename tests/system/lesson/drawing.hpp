// The drawing of a part: ideal curves by closed formulas, worked out without any of the control's own code.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace cnclab::lesson {

/// X, Y, Z in mm.
using Point = std::array<double, 3>;

[[nodiscard]] double distance(const Point& a, const Point& b);

/// A straight line to an end point.
struct Line {
  Point to{};
};

/// The plane of an arc. Angles count from the first axis towards the second, as seen against the third: XY from +Z,
/// XZ from +Y (so Z turns towards X, D-128), YZ from +X.
enum class Plane { xy, xz, yz };
enum class Turn { cw, ccw };

/// An arc about a centre. Where start and end differ in radius by a step (the manual's full circle in two blocks,
/// EX-040), the radius changes linearly with the angle (D-55). End = start is a full circle (DEC-04).
struct Arc {
  Plane plane = Plane::xy;
  Turn turn = Turn::ccw;
  Point centre{};
  Point to{};
};

using Curve = std::variant<Line, Arc>;

/// One curve with everything needed to walk along it.
class Element {
 public:
  Element(const Point& from, const Curve& curve);

  [[nodiscard]] double length_mm() const { return length_; }
  /// The point after `way_mm` (0 … length), by the closed formula of the line or circle.
  [[nodiscard]] Point at(double way_mm) const;
  /// The way at which the element comes nearest to `p`, limited to [low, high].
  [[nodiscard]] double nearest(const Point& p, double low, double high) const;

 private:
  struct Round {
    int first = 0, second = 1;  ///< axes of the plane, in the order in which angles count
    Point centre{};
    double radius_from = 0, radius_to = 0, angle_from = 0, sweep = 0;  ///< rad, sweep < 0 clockwise
  };
  void make_round(const Arc& arc);
  [[nodiscard]] double nearest_on_arc(const Point& p, double low, double high) const;

  Point from_{}, to_{};
  double length_ = 0;
  std::variant<std::monostate, Round> round_;
};

/// A whole drawing: curves one after the other, from (0, 0, 0) where the tool stands at the start.
class Drawing {
 public:
  explicit Drawing(const std::vector<Curve>& curves);

  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }
  [[nodiscard]] double length_mm() const { return length_; }
  [[nodiscard]] const Point& end() const { return end_; }
  /// Which axes move at all, for the limit √n/2 steps.
  [[nodiscard]] int moving_axes() const { return moving_axes_; }

 private:
  std::vector<Element> elements_;
  double length_ = 0;
  Point end_{};
  int moving_axes_ = 0;
};

}  // namespace cnclab::lesson
