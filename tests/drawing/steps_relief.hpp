// A workpiece whose surface a test describes.
#pragma once

#include <functional>

#include "drawing/relief.hpp"

namespace cnclab::drawing {

class ShapedRelief final : public Relief {
 public:
  ShapedRelief(Box block, std::function<double(double, double)> height) : block_(block), height_(std::move(height)) {}
  [[nodiscard]] Box block() const override { return block_; }
  [[nodiscard]] double height_mm(double x, double y) const override { return height_(x, y); }

 private:
  Box block_;
  std::function<double(double, double)> height_;
};

/// 120 × 80 × 30 about the origin, its top at 0.
inline constexpr Box kBlock{.low = {-60, -40, -30, 0}, .high = {60, 40, 0, 0}};

/// With a round pocket of radius 20 in the middle, 15 deep.
inline ShapedRelief pocket() {
  return {kBlock, [](double x, double y) { return x * x + y * y < 400 ? -15.0 : 0.0; }};
}

}  // namespace cnclab::drawing
