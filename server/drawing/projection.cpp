// Views and scale of a drawing.
#include "drawing/projection.hpp"

#include <cmath>
#include <numbers>

namespace cnclab::drawing {

std::array<geometry::Point, 8> corners_of(const Box& box) {
  std::array<geometry::Point, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {(i & 1U) != 0 ? box.high.x : box.low.x, (i & 2U) != 0 ? box.high.y : box.low.y,
                  (i & 4U) != 0 ? box.high.z : box.low.z};
  return corners;
}

Flat project(const geometry::Point& point, View view) {
  constexpr double kCosine30 = std::numbers::sqrt3 / 2;
  switch (view) {
    case View::xy:
      return {point.x, point.y};
    case View::xz:
      return {point.x, point.z};
    case View::yz:
      return {point.y, point.z};
    case View::iso:
      return {(point.x - point.y) * kCosine30, (point.x + point.y) / 2 + point.z};
  }
  return {};
}

Sheet::Sheet(Bounds bounds) : bounds_(bounds) {
  if (bounds_.is_empty()) bounds_.take({});
  constexpr double kLeast_mm = 1;  // a point or an axis-parallel line still gets a field
  const double margin = std::max({bounds_.right - bounds_.left, bounds_.high - bounds_.low, kLeast_mm}) * 0.05;
  bounds_.left -= margin;
  bounds_.right += margin;
  bounds_.low -= margin;
  bounds_.high += margin;
  scale_ = std::min((kWidth_px - kLeft_px - kRight_px) / (bounds_.right - bounds_.left),
                    (kHeight_px - kTop_px - kBottom_px) / (bounds_.high - bounds_.low));
}

double Sheet::tick_mm() const {
  constexpr double kLeast_px = 60;
  const double least = kLeast_px / scale_;
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (decade * factor >= least) return decade * factor;
  return decade * 10;
}

}  // namespace cnclab::drawing
