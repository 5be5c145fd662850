// Which constant acceleration holds now, and for how long.
#include "motion/ramp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cnclab::motion {

namespace {

/// Relative width within which a speed counts as "on" its limit; ten thousand times the rounding of a double.
constexpr double kTight = 1e-12;
constexpr double kTightSquare = 1e-10;

struct Phase {
  double acceleration = 0;
  double way = 0;        ///< after which another phase begins
  double end_speed = 0;  ///< when all of the way is done
};

Phase ramp_to(double speed, double target, double acceleration) {
  return {acceleration, (target * target - speed * speed) / (2 * acceleration), target};
}

bool is_on_envelope(double speed, const Course& course) {
  return speed * speed >= course.envelope_sq * (1 - kTightSquare);
}

/// Along the envelope: RAMPE down to the next change.
Phase along_envelope(double speed, double way, double ramp) {
  return {-ramp, way, std::sqrt(std::max(0.0, speed * speed - 2 * ramp * way))};
}

Phase braking_to_rest(double speed, const Course& course, bool stop, const Limits& limits) {
  const double ramp = limits.acceleration_mm_per_s2;
  const double rest_from = limits.start_stop_mm_per_s;
  if (!stop) return ramp_to(speed, rest_from, -ramp);
  if (speed > course.cap_mm_per_s * (1 + kTight))
    return ramp_to(speed, std::max(course.cap_mm_per_s, rest_from), -ramp);
  const double gentle = limits.stop_deceleration_mm_per_s2;
  const double below_envelope = course.envelope_sq - speed * speed;
  if (gentle >= ramp || is_on_envelope(speed, course)) return ramp_to(speed, rest_from, -ramp);
  const Phase phase = ramp_to(speed, rest_from, -gentle);
  const double meets_envelope = below_envelope / (2 * (ramp - gentle));
  if (meets_envelope >= phase.way) return phase;
  return {-gentle, meets_envelope, std::sqrt(speed * speed - 2 * gentle * meets_envelope)};
}

Phase travelling(double speed, const Course& course, double ramp) {
  const double cap = course.cap_mm_per_s;
  if (speed > cap * (1 + kTight)) return ramp_to(speed, cap, -ramp);
  const double below_envelope = course.envelope_sq - speed * speed;
  if (is_on_envelope(speed, course)) return along_envelope(speed, course.way_mm, ramp);
  if (speed >= cap * (1 - kTight)) return {0, below_envelope / (2 * ramp), speed};
  const Phase to_cap = ramp_to(speed, cap, ramp);
  const double to_envelope = below_envelope / (4 * ramp);
  if (to_cap.way <= to_envelope) return to_cap;
  return {ramp, to_envelope, std::sqrt(speed * speed + 2 * ramp * to_envelope)};
}

}  // namespace

Piece next_piece(double speed, const Course& course, bool stop, const Limits& limits, double time_s) noexcept {
  const bool to_rest = stop || course.cap_mm_per_s <= 0;
  if (to_rest && speed <= limits.start_stop_mm_per_s * (1 + kTight)) return {0, 0, 0, true};
  if (speed <= 0) {
    speed = std::min({limits.start_stop_mm_per_s, course.cap_mm_per_s, std::sqrt(course.envelope_sq)});
  }
  Phase phase =
      to_rest ? braking_to_rest(speed, course, stop, limits) : travelling(speed, course, limits.acceleration_mm_per_s2);
  if (phase.way > course.way_mm) {
    phase.way = course.way_mm;
    phase.end_speed = std::sqrt(std::max(0.0, speed * speed + 2 * phase.acceleration * phase.way));
  }
  const double whole_time = phase.way <= 0 ? 0 : 2 * phase.way / (speed + phase.end_speed);
  if (whole_time > time_s) {
    const double way = (speed + phase.acceleration * time_s / 2) * time_s;
    return {std::clamp(way, 0.0, phase.way), time_s, std::max(0.0, speed + phase.acceleration * time_s), false};
  }
  const bool rests = to_rest && phase.end_speed <= limits.start_stop_mm_per_s * (1 + kTight);
  return {std::max(0.0, phase.way), whole_time, phase.end_speed, rests};
}

Piece run_free(double speed, double cap, bool stop, const Limits& limits, double time_s) noexcept {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  constexpr int kMostPieces = 8;  // accelerate, cruise, brake, rest: more cannot fall into a tick
  Piece sum{0, 0, speed, false};
  for (int i = 0; i < kMostPieces && sum.time_s < time_s; ++i) {
    if (sum.speed_mm_per_s <= 0 && (stop || cap <= 0)) return sum;
    const Piece piece = next_piece(sum.speed_mm_per_s, {cap, kFar, kFar}, stop, limits, time_s - sum.time_s);
    sum = {sum.way_mm + piece.way_mm, sum.time_s + piece.time_s, piece.rests ? 0 : piece.speed_mm_per_s, piece.rests};
    if (piece.rests) return sum;
  }
  return sum;
}

}  // namespace cnclab::motion
