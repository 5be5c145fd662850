// The workpiece of a test run as pictures see it: the machine's height field (machine/workpiece.hpp) as a relief.
#pragma once

#include <optional>

#include "drawing/relief.hpp"
#include "machine/workpiece.hpp"

namespace cnclab::testrun {

class Stock final : public drawing::Relief {
 public:
  /// block     low below high on each axis, else there is nothing to cut
  /// cell_mm   > 0; a large workpiece gets larger ones (machine::fitted)
  Stock(const drawing::Box& block, double cell_mm);

  /// The cutter goes straight from `from` to `to`, its tip at these points.
  /// returns   whether it met material with more than the edge of a cell
  bool cut(const geometry::Point& from, const geometry::Point& to, double radius_mm);

  [[nodiscard]] drawing::Box block() const override { return block_; }
  [[nodiscard]] double height_mm(double x_mm, double y_mm) const override;
  [[nodiscard]] double removed_mm3() const { return piece_ ? piece_->removed_mm3() : 0; }
  [[nodiscard]] double cell_mm() const { return piece_ ? piece_->cell_mm() : 0; }

 private:
  drawing::Box block_;
  std::optional<machine::Workpiece> piece_;
};

}  // namespace cnclab::testrun
