// From space to paper: which way the axes point in a view, and how millimetres become pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "drawing/picture.hpp"
#include "geometry/path_item.hpp"

namespace cnclab::drawing {

/// From where the part is seen: against Z, Y or X (D-128), or from above at an angle with all three axes.
enum class View : std::uint8_t { xy, xz, yz, iso };

/// A workpiece in path coordinates, mm.
struct Box {
  geometry::Point low, high;
};

/// Corner i has the high X where bit 0 is set, the high Y where bit 1 is, the high Z where bit 2 is.
[[nodiscard]] std::array<geometry::Point, 8> corners_of(const Box& box);

/// mm to the right and up.
[[nodiscard]] Flat project(const geometry::Point& point, View view);
/// The smallest rectangle around points.
struct Bounds {
  double left = std::numeric_limits<double>::infinity(), right = -std::numeric_limits<double>::infinity();
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void take(const Flat& point) {
    left = std::min(left, point.right);
    right = std::max(right, point.right);
    low = std::min(low, point.up);
    high = std::max(high, point.up);
  }
  [[nodiscard]] bool is_empty() const { return left > right; }
};

/// Fits the drawing into the sheet, equal scale both ways.
class Sheet {
 public:
  static constexpr double kWidth_px = 960, kHeight_px = 720;
  static constexpr double kLeft_px = 80, kRight_px = 40, kTop_px = 80, kBottom_px = 70;

  explicit Sheet(Bounds bounds);

  [[nodiscard]] double x(double right_mm) const { return kLeft_px + (right_mm - bounds_.left) * scale_; }
  [[nodiscard]] double y(double up_mm) const { return kHeight_px - kBottom_px - (up_mm - bounds_.low) * scale_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  /// Distance of axis marks: 1, 2 or 5 times a power of ten, at least 60 pixels.
  [[nodiscard]] double tick_mm() const;

 private:
  Bounds bounds_;
  double scale_ = 1;  ///< pixels per mm
};

}  // namespace cnclab::drawing
