// Motion without a path: by hand in a direction, and to the limit switches and 1 mm back (D-11, D-63, D-117).
#pragma once

#include <array>
#include <cstdint>

#include "machine/axis_counters.hpp"
#include "machine/machine.hpp"
#include "motion/limits.hpp"

namespace cnclab::machine {

/// Sign of motion of X, Y, Z, U; 0 = the axis does not take part.
using Directions = std::array<std::int8_t, 4>;

/// DEC-40: with the potentiometer at 0 the hand still moves the axes in single steps that can be heard.
inline constexpr double kSlowSteps_per_s = 5;

/// A straight motion without end: ramps up to override × F MAX, ends by `stop`.
class HandDrive {
 public:
  void start(const Directions& directions, const motion::Limits& limits, const AxisCounters& counters) noexcept;
  /// One tick; writes the new position. Path speed afterwards, mm/s.
  void advance(double tick_s, double override_ratio, bool stop, AxisCounters& counters) noexcept;
  [[nodiscard]] double speed_mm_per_s() const { return speed_; }
  void halt_now() noexcept { speed_ = 0; }

 private:
  motion::Limits limits_;
  std::array<double, 4> unit_{};
  std::array<std::int64_t, 4> base_{};
  double slowest_mm_per_s_ = 0;
  double way_mm_ = 0;
  double speed_ = 0;
};

/// Each axis by itself: search its switch, stop at once, back off until 1 mm lies between axis and switch.
///
/// The axes share the path speed, so that all together keep to F MAX and F START/STOP.
class SwitchDrive {
 public:
  static constexpr double kBackOff_mm = 1;
  /// Over-travel and some more: a switch that is still active then is broken.
  static constexpr double kFarthest_mm = 30;

  /// directions   towards the switches
  void search(const Directions& directions, const motion::Limits& limits, const AxisCounters& counters) noexcept;
  /// directions   towards the switches that are active
  void back_off(const Directions& directions, const motion::Limits& limits, const AxisCounters& counters) noexcept;
  void advance(double tick_s, double override_ratio, bool stop, const Inputs& inputs, AxisCounters& counters) noexcept;
  void cancel() noexcept;

  [[nodiscard]] bool is_done() const;
  [[nodiscard]] bool has_failed() const;
  [[nodiscard]] double speed_mm_per_s() const;
  /// Takes part in the present or last motion.
  [[nodiscard]] bool has_axis(std::size_t axis) const { return axes_[axis].direction != 0; }

 private:
  enum class Stage : std::uint8_t { done, search, turn, back_off, failed };
  struct Axis {
    Stage stage = Stage::done;
    std::int8_t direction = 0;
    double speed = 0;
    double way_mm = 0;   ///< from base, in the direction of the switch
    double free_mm = 0;  ///< backed off since the switch was seen free
    std::int64_t base = 0;
  };

  void begin(const Directions& directions, Stage stage, const motion::Limits& limits,
             const AxisCounters& counters) noexcept;
  void search_tick(Axis& axis, double tick_s, double cap, bool stop, bool at_switch) const noexcept;
  void back_off_tick(Axis& axis, double tick_s, bool stop, bool at_switch) const noexcept;

  motion::Limits share_;  ///< what one axis may do
  std::array<Axis, 4> axes_{};
};

}  // namespace cnclab::machine
