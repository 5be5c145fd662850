// From space to paper: which way the axes point in a view, and how millimetres become pixels.
#pragma once

#include <algorithm>
#include <limits>

#include "drawing/path_svg.hpp"

namespace cnclab::drawing {

/// A point on paper: mm to the right and up, or pixels to the right and down.
struct Flat {
  double right = 0, up = 0;
};

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
