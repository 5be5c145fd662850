// Where the axes are in whole steps, and what the operator calls that place (G68, ISTWERT).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace cnclab::machine {

/// Steps are the truth; the Istwert is a name for them: steps - zero, in mm.
class AxisCounters {
 public:
  explicit AxisCounters(const std::array<double, 4>& steps_per_mm) : per_mm_(steps_per_mm) {}

  [[nodiscard]] const std::array<std::int64_t, 4>& steps() const { return steps_; }
  [[nodiscard]] double per_mm(std::size_t axis) const { return per_mm_[axis]; }
  [[nodiscard]] double istwert_mm(std::size_t axis) const {
    return (static_cast<double>(steps_[axis]) - zero_steps_[axis]) / per_mm_[axis];
  }

  void step_to(std::size_t axis, std::int64_t steps) { steps_[axis] = steps; }
  void set_istwert(std::size_t axis, double mm) {
    zero_steps_[axis] = static_cast<double>(steps_[axis]) - mm * per_mm_[axis];
  }
  /// New machine data: the operator reads the same Istwert as before.
  void set_steps_per_mm(const std::array<double, 4>& steps_per_mm) {
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const double shown = istwert_mm(axis);
      per_mm_[axis] = steps_per_mm[axis];
      set_istwert(axis, shown);
    }
  }

 private:
  std::array<double, 4> per_mm_;
  std::array<std::int64_t, 4> steps_{};
  std::array<double, 4> zero_steps_{};
};

}  // namespace cnclab::machine
