// The workpiece of a test run: a grid of heights from which a turning cutter takes material.
//
// The cutter is an end mill: a cylinder with a flat end, upright along Z (the CNC 3300's spindle). Over each cell the
// material keeps the lowest height that the cutter's end has had there; along a slope that is where the cutter stood
// over the cell at its lower end, worked out exactly and not in steps.
#pragma once

#include <vector>

#include "drawing/relief.hpp"

namespace cnclab::testrun {

class Stock final : public drawing::Relief {
 public:
  /// So many cells at most: a large workpiece gets larger ones (1.6 MB).
  static constexpr double kMostCells = 400'000;

  /// block     low below high on each axis, else there is nothing to cut
  /// cell_mm   > 0
  Stock(const drawing::Box& block, double cell_mm);

  /// The cutter goes straight from `from` to `to`, its tip at these points.
  /// returns   whether it met material with more than the edge of a cell
  bool cut(const geometry::Point& from, const geometry::Point& to, double radius_mm);

  [[nodiscard]] drawing::Box block() const override { return block_; }
  [[nodiscard]] double height_mm(double x_mm, double y_mm) const override;
  [[nodiscard]] double removed_mm3() const;
  [[nodiscard]] double cell_mm() const { return cell_mm_; }

 private:
  drawing::Box block_;
  double cell_mm_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<float> heights_;  ///< mm; row by row from low Y
};

}  // namespace cnclab::testrun
