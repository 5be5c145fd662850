// Ramps of manual motion, reference search and back-off.
#include "machine/manual_drives.hpp"

#include <algorithm>
#include <cmath>

#include "motion/ramp.hpp"

namespace cnclab::machine {

namespace {

double axes_in(const Directions& directions) {
  return static_cast<double>(std::ranges::count_if(directions, [](std::int8_t d) { return d != 0; }));
}

}  // namespace

void HandDrive::start(const Directions& directions, const motion::Limits& limits,
                      const AxisCounters& counters) noexcept {
  limits_ = limits;
  base_ = counters.steps();
  way_mm_ = speed_ = 0;
  const double length = std::sqrt(std::max(1.0, axes_in(directions)));
  double finest = 0;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    unit_[axis] = directions[axis] / length;
    if (directions[axis] != 0) finest = std::max(finest, counters.per_mm(axis));
  }
  slowest_mm_per_s_ = finest > 0 ? std::min(kSlowSteps_per_s / finest * length, limits.f_max_mm_per_s) : 0;
}

void HandDrive::advance(double tick_s, double override_ratio, bool stop, AxisCounters& counters) noexcept {
  const double cap = std::max(override_ratio * limits_.f_max_mm_per_s, slowest_mm_per_s_);
  const motion::Piece piece = motion::run_free(speed_, cap, stop, limits_, tick_s);
  speed_ = piece.speed_mm_per_s;
  way_mm_ += piece.way_mm;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    counters.step_to(axis, base_[axis] + std::llround(unit_[axis] * way_mm_ * counters.per_mm(axis)));
  }
}

void SwitchDrive::begin(const Directions& directions, Stage stage, const motion::Limits& limits,
                        const AxisCounters& counters) noexcept {
  const double part = 1 / std::sqrt(std::max(1.0, axes_in(directions)));
  share_ = limits;
  share_.f_max_mm_per_s *= part;
  share_.start_stop_mm_per_s *= part;
  share_.acceleration_mm_per_s2 *= part;
  share_.stop_deceleration_mm_per_s2 *= part;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool takes_part = directions[i] != 0;
    axes_[i] = {takes_part ? stage : Stage::done, directions[i], 0, 0, 0, counters.steps()[i]};
  }
}

void SwitchDrive::search(const Directions& directions, const motion::Limits& limits,
                         const AxisCounters& counters) noexcept {
  begin(directions, Stage::search, limits, counters);
}

void SwitchDrive::back_off(const Directions& directions, const motion::Limits& limits,
                           const AxisCounters& counters) noexcept {
  begin(directions, Stage::turn, limits, counters);
}

void SwitchDrive::search_tick(Axis& axis, double tick_s, double cap, bool stop, bool at_switch) const noexcept {
  if (at_switch) {  // no ramp at the switch (DEC-23)
    axis.speed = 0;
    axis.stage = Stage::turn;
    return;
  }
  const motion::Piece piece = motion::run_free(axis.speed, cap, stop, share_, tick_s);
  axis.speed = piece.speed_mm_per_s;
  axis.way_mm += piece.way_mm;
}

void SwitchDrive::back_off_tick(Axis& axis, double tick_s, bool stop, bool at_switch) const noexcept {
  axis.speed = stop ? 0 : share_.start_stop_mm_per_s;
  double way = axis.speed * tick_s;
  if (at_switch) {
    axis.free_mm = 0;
  } else {
    way = std::min(way, kBackOff_mm - axis.free_mm);
    axis.free_mm += way;
  }
  axis.way_mm -= way;
  const bool arrived = axis.free_mm >= kBackOff_mm;
  if (arrived) axis.stage = Stage::done;
  if (axis.way_mm < -kFarthest_mm) axis.stage = Stage::failed;
  if (axis.stage != Stage::back_off) axis.speed = 0;
}

void SwitchDrive::advance(double tick_s, double override_ratio, bool stop, const Inputs& inputs,
                          AxisCounters& counters) noexcept {
  for (std::size_t i = 0; i < 4; ++i) {
    Axis& axis = axes_[i];
    const bool at_switch = axis.direction > 0 ? inputs.limit_plus[i] : inputs.limit_minus[i];
    const double cap = std::max(override_ratio * share_.f_max_mm_per_s,
                                std::min(kSlowSteps_per_s / counters.per_mm(i), share_.f_max_mm_per_s));
    switch (axis.stage) {
      case Stage::done:
      case Stage::failed:
        continue;
      case Stage::search:
        search_tick(axis, tick_s, cap, stop, at_switch);
        break;
      case Stage::turn:  // a whole tick at rest before the axis turns round
        axis.base = counters.steps()[i];
        axis.way_mm = axis.free_mm = 0;
        axis.stage = Stage::back_off;
        continue;
      case Stage::back_off:
        back_off_tick(axis, tick_s, stop, at_switch);
        break;
    }
    counters.step_to(i, axis.base + std::llround(axis.direction * axis.way_mm * counters.per_mm(i)));
  }
}

void SwitchDrive::cancel() noexcept {
  for (Axis& axis : axes_) {
    axis.stage = Stage::done;
    axis.speed = 0;
  }
}

bool SwitchDrive::is_done() const {
  return std::ranges::all_of(axes_, [](const Axis& a) { return a.stage == Stage::done || a.stage == Stage::failed; });
}

bool SwitchDrive::has_failed() const {
  return std::ranges::any_of(axes_, [](const Axis& a) { return a.stage == Stage::failed; });
}

double SwitchDrive::speed_mm_per_s() const {
  double sum_sq = 0;
  for (const Axis& axis : axes_) sum_sq += axis.speed * axis.speed;
  return std::sqrt(sum_sq);
}

}  // namespace cnclab::machine
