// One piece of a speed profile: constant acceleration until something changes or the time is up.
//
//   v²  │      cap ────────╲            In the plane of way and v² all ramps are straight lines of slope ±2a, so every
//       │     ╱             ╲           limit ahead (exit speed at a way, stop at a way) is one number here:
//       │   ╱                 ╲ envelope      envelope_sq = v_limit² + 2·a·way_to_it        (the smallest one binds)
//       └──────────────────────── way   and the speed may be anything below cap² and envelope_sq − 2·a·s.
//
// The profile is followed in continuous time, not in steps of a tick: a tick only cuts pieces where it ends. So the
// speed never changes faster than the ramp, whatever falls into a tick, and times agree with closed formulas.
#pragma once

#include "motion/limits.hpp"

namespace cnclab::motion {

/// What bounds the speed from here to the next change.
struct Course {
  double cap_mm_per_s = 0;  ///< cruising speed; 0: stand still (potentiometer at 0)
  double envelope_sq = 0;   ///< (mm/s)², see above; infinity where nothing lies ahead
  double way_mm = 0;        ///< to the next change of these bounds, > 0
};

/// What was done.
struct Piece {
  double way_mm = 0;
  double time_s = 0;
  double speed_mm_per_s = 0;  ///< at its end
  bool rests = false;         ///< braked to F START/STOP because of STOP or potentiometer 0, and stands from now on
};

/// The next piece from `speed` on, at most `time_s` long. Starting from rest jumps to at most F START/STOP (DEC-20).
/// stop   brake with STOPVERZÖGERUNG, where the envelope demands it with RAMPE. Must not be called at rest with `stop`
///        or a cap of 0: there is nothing to do then.
[[nodiscard]] Piece next_piece(double speed_mm_per_s, const Course& course, bool stop, const Limits& limits,
                               double time_s) noexcept;

/// `time_s` of motion with nothing ahead but the cap: manual motion, reference search. At rest with `stop`: nothing.
[[nodiscard]] Piece run_free(double speed_mm_per_s, double cap_mm_per_s, bool stop, const Limits& limits,
                             double time_s) noexcept;

}  // namespace cnclab::motion
