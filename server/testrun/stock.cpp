// Cutting: which cells a way sweeps over, and how deep.
#include "testrun/stock.hpp"

#include <algorithm>
#include <cmath>

namespace cnclab::testrun {

namespace {

using geometry::Point;

/// Material thinner than this is no cut: the same way passed twice, or the chord of an arc beside it.
constexpr double kThinnest_mm = 0.02;

/// What the cutter's disc sweeps over on a straight way, seen from above.
class Sweep {
 public:
  Sweep(const Point& from, const Point& to, double radius)
      : from_(from),
        to_(to),
        radius_(radius),
        dx_(to.x - from.x),
        dy_(to.y - from.y),
        length_sq_(dx_ * dx_ + dy_ * dy_) {}

  struct Interval {
    double low = 0, high = -1;
  };
  /// Where a line of this Y meets it; it is convex, so that is one piece.
  [[nodiscard]] Interval at(double y) const {
    Interval row{.low = std::numeric_limits<double>::infinity(), .high = -std::numeric_limits<double>::infinity()};
    for (const Point* end : {&from_, &to_}) {
      const double half_sq = radius_ * radius_ - (y - end->y) * (y - end->y);
      if (half_sq < 0) continue;
      row.low = std::min(row.low, end->x - std::sqrt(half_sq));
      row.high = std::max(row.high, end->x + std::sqrt(half_sq));
    }
    if (dy_ == 0) return row;
    const double length = std::sqrt(length_sq_);
    for (const double side : {-1.0, 1.0}) {  // the two edges beside the way
      const double share = (y - from_.y - side * radius_ * dx_ / length) / dy_;
      if (share < 0 || share > 1) continue;
      const double x = from_.x - side * radius_ * dy_ / length + share * dx_;
      row.low = std::min(row.low, x);
      row.high = std::max(row.high, x);
    }
    return row;
  }

  struct Depth {
    bool is_swept = false;
    bool is_core = false;  ///< by more than the cutter's rim
    double z = 0;
  };
  /// The lowest height of the cutter's end over this place.
  [[nodiscard]] Depth over(double x, double y, double rim) const {
    const double rx = x - from_.x, ry = y - from_.y;
    const double core = std::max(radius_ - rim, 0.0);
    if (length_sq_ == 0) {
      const double distance_sq = rx * rx + ry * ry;
      return {distance_sq <= radius_ * radius_, distance_sq <= core * core, std::min(from_.z, to_.z)};
    }
    const double along = (rx * dx_ + ry * dy_) / length_sq_;
    const double beside_sq = rx * rx + ry * ry - along * along * length_sq_;
    if (beside_sq > radius_ * radius_) return {};
    const double reach = std::sqrt((radius_ * radius_ - beside_sq) / length_sq_);
    const double first = std::max(along - reach, 0.0), last = std::min(along + reach, 1.0);
    if (first > last) return {};
    const double climb = to_.z - from_.z;
    return {true, beside_sq <= core * core, from_.z + climb * (climb < 0 ? last : first)};
  }

 private:
  Point from_, to_;
  double radius_, dx_, dy_, length_sq_;
};

}  // namespace

Stock::Stock(const drawing::Box& block, double cell_mm) : block_(block), cell_mm_(cell_mm) {
  const double width = std::max(block.high.x - block.low.x, 0.0), depth = std::max(block.high.y - block.low.y, 0.0);
  cell_mm_ = std::max(cell_mm_, std::sqrt(width * depth / kMostCells));
  columns_ = static_cast<int>(width / cell_mm_);
  rows_ = static_cast<int>(depth / cell_mm_);
  heights_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                  static_cast<float>(block.high.z));
}

bool Stock::cut(const Point& from, const Point& to, double radius_mm) {
  const double lowest = std::min(from.z, to.z);
  if (lowest >= block_.high.z || heights_.empty()) return false;
  const Sweep sweep(from, to, radius_mm);
  const auto row_of = [&](double y) { return std::clamp((y - block_.low.y) / cell_mm_, -1.0, rows_ + 1.0); };
  const int first_row = std::max(0, static_cast<int>(std::floor(row_of(std::min(from.y, to.y) - radius_mm))));
  const int last_row = std::min(rows_ - 1, static_cast<int>(std::floor(row_of(std::max(from.y, to.y) + radius_mm))));
  bool has_met = false;
  for (int row = first_row; row <= last_row; ++row) {
    const double y = block_.low.y + (row + 0.5) * cell_mm_;
    const Sweep::Interval interval = sweep.at(y);
    if (interval.low > interval.high) continue;
    const double left = (interval.low - block_.low.x) / cell_mm_, right = (interval.high - block_.low.x) / cell_mm_;
    const int first = static_cast<int>(std::clamp(std::floor(left), 0.0, static_cast<double>(columns_)));
    const int last = static_cast<int>(std::clamp(std::floor(right), -1.0, columns_ - 1.0));
    for (int column = first; column <= last; ++column) {
      float& height = heights_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                               static_cast<std::size_t>(column)];
      if (lowest >= static_cast<double>(height)) continue;
      Sweep::Depth depth = sweep.over(block_.low.x + (column + 0.5) * cell_mm_, y, cell_mm_);
      depth.z = std::max(depth.z, block_.low.z);
      if (!depth.is_swept || depth.z >= static_cast<double>(height)) continue;
      has_met = has_met || (depth.is_core && static_cast<double>(height) - depth.z > kThinnest_mm);
      height = static_cast<float>(depth.z);
    }
  }
  return has_met;
}

double Stock::height_mm(double x_mm, double y_mm) const {
  if (heights_.empty()) return block_.high.z;
  const auto index = [&](double place, double low, int count) {
    return static_cast<std::size_t>(std::clamp(std::floor((place - low) / cell_mm_), 0.0, count - 1.0));
  };
  const std::size_t row = index(y_mm, block_.low.y, rows_), column = index(x_mm, block_.low.x, columns_);
  return static_cast<double>(heights_[row * static_cast<std::size_t>(columns_) + column]);
}

double Stock::removed_mm3() const {
  double sum = 0;
  for (const float height : heights_) sum += block_.high.z - static_cast<double>(height);
  return sum * cell_mm_ * cell_mm_;
}

}  // namespace cnclab::testrun
