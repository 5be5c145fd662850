// Shading: each view looks at the surface in its own way.
#include "drawing/relief.hpp"

#include <algorithm>
#include <cmath>

namespace cnclab::drawing {

namespace {

constexpr int kSamples = 160;  // along a line of sight, and across the block in the view at an angle

struct Place {
  double right = 0, up = 0;
};

Place center_of(const Raster& raster, int column, int row) {
  const Bounds& field = raster.field;
  return {field.left + (column + 0.5) * (field.right - field.left) / raster.columns,
          field.high - (row + 0.5) * (field.high - field.low) / raster.rows};
}

bool is_within(double value, double low, double high) { return value >= low && value <= high; }

float depth_at(const Relief& relief, const Box& block, double x, double y) {
  const double thickness = block.high.z - block.low.z;
  if (thickness <= 0) return 0;
  return static_cast<float>(std::clamp((block.high.z - relief.height_mm(x, y)) / thickness, 0.0, 1.0));
}

std::vector<float> from_above(const Relief& relief, const Raster& raster) {
  const Box block = relief.block();
  std::vector<float> shades;
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column) {
      const Place place = center_of(raster, column, row);
      const bool is_inside =
          is_within(place.right, block.low.x, block.high.x) && is_within(place.up, block.low.y, block.high.y);
      shades.push_back(is_inside ? depth_at(relief, block, place.right, place.up) : 0.0F);
    }
  return shades;
}

/// Heights along the line of sight that meets the picture at `right`.
std::vector<double> heights_along(const Relief& relief, View view, double right) {
  const Box block = relief.block();
  const bool looks_along_y = view == View::xz;
  const double low = looks_along_y ? block.low.y : block.low.x, high = looks_along_y ? block.high.y : block.high.x;
  std::vector<double> heights;
  for (int sample = 0; sample < kSamples; ++sample) {
    const double along = low + (sample + 0.5) * (high - low) / kSamples;
    heights.push_back(looks_along_y ? relief.height_mm(right, along) : relief.height_mm(along, right));
  }
  return heights;
}

std::vector<float> from_the_side(const Relief& relief, View view, const Raster& raster) {
  const Box block = relief.block();
  const double low = view == View::xz ? block.low.x : block.low.y,
               high = view == View::xz ? block.high.x : block.high.y;
  std::vector<float> shades(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  for (int column = 0; column < raster.columns; ++column) {
    const double right = center_of(raster, column, 0).right;
    if (!is_within(right, low, high)) continue;
    const std::vector<double> heights = heights_along(relief, view, right);
    for (int row = 0; row < raster.rows; ++row) {
      const double up = center_of(raster, column, row).up;
      if (!is_within(up, block.low.z, block.high.z)) continue;
      const auto gone = std::ranges::count_if(heights, [&](double height) { return height < up; });
      shades[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
             static_cast<std::size_t>(column)] = static_cast<float>(gone) / kSamples;
    }
  }
  return shades;
}

/// The painter's way: columns of material from the farthest (high X + Y) to the nearest, each over those behind it.
class AngleView {
 public:
  AngleView(const Relief& relief, const Raster& raster)
      : relief_(relief),
        raster_(raster),
        block_(relief.block()),
        shades_(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows)) {}

  std::vector<float> paint() {
    for (int sum = 2 * (kSamples - 1); sum >= 0; --sum)
      for (int i = std::max(0, sum - kSamples + 1); i <= std::min(sum, kSamples - 1); ++i) paint_column(i, sum - i);
    return std::move(shades_);
  }

 private:
  void paint_column(int i, int j) {
    const double x = block_.low.x + (i + 0.5) * (block_.high.x - block_.low.x) / kSamples;
    const double y = block_.low.y + (j + 0.5) * (block_.high.y - block_.low.y) / kSamples;
    const double height = relief_.height_mm(x, y);
    const Flat foot = project({.x = x, .y = y, .z = block_.low.z}, View::iso);
    const int column = static_cast<int>(std::floor((foot.right - raster_.field.left) * per_mm_right()));
    if (column < 0 || column >= raster_.columns) return;
    const int bottom = row_at(foot.up), top = row_at(foot.up + height - block_.low.z);
    constexpr float kWall = 0.5F;
    const bool is_outside = i == 0 || j == 0;  // the block's own faces; all others are seen where material is gone
    for (int row = std::max(top, 0); row <= std::min(bottom, raster_.rows - 1); ++row)
      at(column, row) = is_outside ? 0.0F : kWall;
    if (top >= 0 && top < raster_.rows) at(column, top) = depth_at(relief_, block_, x, y);
  }

  [[nodiscard]] double per_mm_right() const { return raster_.columns / (raster_.field.right - raster_.field.left); }
  [[nodiscard]] int row_at(double up) const {
    return static_cast<int>(
        std::floor((raster_.field.high - up) * raster_.rows / (raster_.field.high - raster_.field.low)));
  }
  float& at(int column, int row) {
    return shades_[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster_.columns) +
                   static_cast<std::size_t>(column)];
  }

  const Relief& relief_;
  const Raster& raster_;
  Box block_;
  std::vector<float> shades_;
};

}  // namespace

std::vector<float> shades_of(const Relief& relief, View view, const Raster& raster) {
  switch (view) {
    case View::xy:
      return from_above(relief, raster);
    case View::xz:
    case View::yz:
      return from_the_side(relief, view, raster);
    case View::iso:
      return AngleView(relief, raster).paint();
  }
  return {};
}

}  // namespace cnclab::drawing
