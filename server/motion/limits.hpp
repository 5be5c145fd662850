// What the machine may do, in the units of motion: mm and seconds.
#pragma once

#include <array>

namespace cnclab::motion {

/// Derived from machine data by `machine::motion_limits` (DEC-20).
struct Limits {
  double f_max_mm_per_s = 50;                              ///< MD 06
  double start_stop_mm_per_s = 5;                          ///< MD 10: speed that needs no ramp from and to rest
  double acceleration_mm_per_s2 = 166.7;                   ///< MD 12: RAMPE per 10 ms
  double stop_deceleration_mm_per_s2 = 138.9;              ///< MD 09: STOP's own, gentler ramp
  double creep_way_mm = 0.5;                               ///< MD 11
  std::array<double, 4> steps_per_mm{200, 200, 200, 200};  ///< MD 14..17: X Y Z U
};

}  // namespace cnclab::motion
