// Each rule as a function of one tick; positions are doubles, so tolerances are those of rounding.
#include "limits_checker.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cnclab::machine {

namespace {

constexpr double kRelative = 1 + 1e-6;
constexpr double kTiny = 1e-7;  ///< mm, mm/s

double speed_of(const Snapshot& snapshot) { return snapshot.speed_mm_per_min / 60; }

bool is_at_switch(const Snapshot& snapshot) {
  return std::ranges::any_of(snapshot.limit, [](bool active) { return active; });
}

bool is_backing_off(const Snapshot& snapshot) {
  return snapshot.state == MotionState::stopping && !snapshot.started && snapshot.limit_axis < 4;
}

std::array<double, 4> by_axis(const geometry::Point& p) { return {p.x, p.y, p.z, p.u}; }

}  // namespace

void LimitsChecker::begin_run(const std::array<std::int64_t, 4>& steps, const geometry::Point& start) {
  start_ = start;
  place_ = {path_.size(), 0, 0};
  const auto mm = by_axis(start);
  for (std::size_t i = 0; i < 4; ++i) origin_[i] = steps[i] - std::llround(mm[i] * limits_.steps_per_mm[i]);
}

void LimitsChecker::anchor(const std::array<std::int64_t, 4>& steps, std::size_t index) {
  const auto mm = by_axis(path_.end(index));
  for (std::size_t i = 0; i < 4; ++i) origin_[i] = steps[i] - std::llround(mm[i] * limits_.steps_per_mm[i]);
}

std::string LimitsChecker::broken_rule(const Tick& tick) {
  std::string broken = rest_rule(tick);
  if (broken.empty()) broken = authority_rule(tick);
  if (broken.empty()) broken = stop_rule(tick);
  if (broken.empty()) broken = due_rule(tick);
  if (broken.empty() && tick.doing == Doing::run) broken = run_rule(tick);
  if (broken.empty() && (tick.doing == Doing::hand || tick.doing == Doing::reference)) broken = manual_rule(tick);
  ratio_before_ = tick.ratio;
  return broken;
}

/// Nothing moves but what was started, or is backing off a switch at F START/STOP.
std::string LimitsChecker::rest_rule(const Tick& tick) const {
  for (std::size_t i = 0; i < 4; ++i) {
    if (tick.sent.steps[i] != tick.now.steps[i] - tick.before.steps[i]) return "steps sent are not those counted";
    if (tick.sent.steps[i] == 0 || tick.doing != Doing::nothing) continue;
    if (!is_backing_off(tick.before)) return fmt::format("axis {} moves though nothing was started", i);
    const double most = limits_.start_stop_mm_per_s * tick_s_ * limits_.steps_per_mm[i] * kRelative + 1;
    if (std::abs(tick.sent.steps[i]) > most) return fmt::format("axis {} backs off too fast", i);
  }
  if (!tick.sent.drives_on && tick.sent.steps != motion::AxisSteps{}) return "steps without current";
  return {};
}

std::string LimitsChecker::authority_rule(const Tick& tick) const {
  if (tick.has_lease) return {};
  if (tick.now.spindle != geometry::SpindleTurn::off || tick.now.coolant) return "tools on without a lease";
  if (tick.now.lease_valid) return "lease reported valid";
  return {};
}

std::string LimitsChecker::stop_rule(const Tick& tick) const {
  if (!tick.must_rest || tick.doing == Doing::nothing) return {};
  const double before = speed_of(tick.before), now = speed_of(tick.now);
  if (now <= 0) return {};
  if (tick.doing == Doing::reference) {
    return now > before * kRelative ? fmt::format("{} after {} mm/s in spite of a stop", now, before) : "";
  }
  const double gentle = std::min(limits_.stop_deceleration_mm_per_s2, limits_.acceleration_mm_per_s2);
  if (now <= before - gentle * tick_s_ * (1 - 1e-6) + kTiny) return {};
  return fmt::format("{} after {} mm/s in spite of a stop", now, before);
}

std::string LimitsChecker::due_rule(const Tick& tick) {
  constexpr int kAnswer = 2;
  if (!tick.must_rest || tick.doing == Doing::nothing || !tick.now.started) {
    ticks_to_rest_.reset();
    return {};
  }
  const double gentle = std::min(limits_.stop_deceleration_mm_per_s2, limits_.acceleration_mm_per_s2);
  // In a reference run each of up to three axes brakes by itself, with its share of the ramp.
  const double share = tick.doing == Doing::reference ? 1 / std::sqrt(3.0) : 1;
  if (!ticks_to_rest_)
    ticks_to_rest_ = static_cast<int>(std::ceil(speed_of(tick.before) / (gentle * share * tick_s_))) + kAnswer;
  return (*ticks_to_rest_)-- > 0 ? "" : "does not rest within its braking time";
}

std::string LimitsChecker::ramp_rule(const Tick& tick) const {
  const double before = speed_of(tick.before), now = speed_of(tick.now);
  const double ramp = limits_.acceleration_mm_per_s2 * tick_s_ * kRelative + kTiny;
  const double jump = limits_.start_stop_mm_per_s * kRelative;
  if (now <= 0) {
    const bool may_fall = tick.is_cut || is_at_switch(tick.before) || before <= jump + ramp;
    return may_fall ? "" : fmt::format("stops from {} mm/s without ramp", before);
  }
  if (before <= 0) return now > jump + ramp ? fmt::format("starts with {} mm/s", now) : "";
  if (std::abs(now - before) > ramp) return fmt::format("goes from {} to {} mm/s in a tick", before, now);
  return {};
}

/// By hand and to the switches: speed within the potentiometer's share of F MAX, steps that fit the speed.
std::string LimitsChecker::manual_rule(const Tick& tick) {
  const double now = speed_of(tick.now), before = speed_of(tick.before);
  double slowest = 0, rounding_sq = 0, way_sq = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double step = 1 / limits_.steps_per_mm[i];
    slowest = std::max(slowest, 5 * step * 3);  // DEC-40: single steps on up to three axes at potentiometer 0
    rounding_sq += step * step;
    way_sq += tick.sent.steps[i] * step * tick.sent.steps[i] * step;
  }
  // Some axes back off from their switches (D-11) while the others still search or brake.
  const double backing_off = tick.doing == Doing::reference ? limits_.start_stop_mm_per_s : 0;
  const double allowed = std::max(tick.ratio * limits_.f_max_mm_per_s, slowest);
  const auto most_with = [&](double braking) {
    const double together = std::hypot(std::max(allowed, braking), backing_off);
    return std::min(limits_.f_max_mm_per_s, together) * kRelative + kTiny;
  };
  if (tick.ratio < ratio_before_) ceiling_ = std::max(ceiling_, before);
  const double most = most_with(ceiling_);
  lower_ceiling(tick);
  if (now > most_with(ceiling_)) return fmt::format("{} mm/s by hand", now);
  if (std::sqrt(way_sq) > most * tick_s_ + std::sqrt(rounding_sq)) return "moved further than its speed allows";
  if (tick.doing == Doing::hand) return ramp_rule(tick);
  const double ramp = limits_.acceleration_mm_per_s2 * tick_s_ * kRelative + kTiny;
  if (now > before + limits_.start_stop_mm_per_s * kRelative + ramp) return "reference run jumps";
  return {};
}

std::string LimitsChecker::run_rule(const Tick& tick) {
  std::string broken = half_step_rule(tick);
  Place place;
  if (broken.empty()) broken = locate(tick, place);
  if (broken.empty()) broken = ramp_rule(tick);
  if (broken.empty()) broken = speed_rule(tick, place);
  if (broken.empty()) broken = joint_rule(tick, place);
  if (broken.empty()) broken = honesty_rule(tick, place);
  place_ = place;
  return broken;
}

std::string LimitsChecker::half_step_rule(const Tick& tick) const {
  for (std::size_t i = 0; i < 4; ++i) {
    const double exact = tick.now.path_mm[i] * limits_.steps_per_mm[i];
    const double off = static_cast<double>(tick.now.steps[i] - origin_[i]) - exact;
    if (std::abs(off) > 0.5 + kTiny) return fmt::format("axis {} is {} steps off", i, off);
  }
  return {};
}

std::string LimitsChecker::locate(const Tick& tick, Place& place) const {
  const geometry::Point at{tick.now.path_mm[0], tick.now.path_mm[1], tick.now.path_mm[2], tick.now.path_mm[3]};
  place = {path_.size(), 0, 0};
  if (tick.now.sequence > path_.size()) return "a block that there is not";
  for (std::size_t i = tick.now.sequence; i-- > 0;) {
    if (!path_.is_motion(i)) continue;
    place.index = i;
    break;
  }
  const bool had_begun = place_.index < path_.size();
  if (place.index == path_.size()) {
    if (had_begun) return "went back to the beginning";
    return at == start_ ? "" : "left the start before the first motion";
  }
  if (had_begun && place.index < place_.index) return "went back to an earlier block";
  const bool same = place.index == place_.index;
  const auto found = path_.place(place.index, at, same ? place_.way_mm : 0);
  if (found.distance_mm > kTiny)
    return fmt::format("{} mm off the path in block {}", found.distance_mm, place.index + 1);
  place.way_mm = found.way_mm;
  place.total_mm = path_.way_before_mm(place.index) + found.way_mm;
  if (place.total_mm < place_.total_mm - kTiny) return "went backwards";
  const bool in_event = !path_.is_motion(tick.now.sequence - 1);
  if (in_event && at != path_.end(place.index)) return "an event in the middle of a way";
  return {};
}

double LimitsChecker::cap(std::size_t index, double ratio) const {
  const double feed = std::min(path_.feed_mm_per_min(index) / 60, limits_.f_max_mm_per_s);
  return path_.item(index).override_off ? feed : feed * ratio;
}

/// The speed of one who has braked with all of RAMPE ever since the potentiometer was turned back.
void LimitsChecker::lower_ceiling(const Tick& tick) {
  // In a reference run each axis brakes by itself while others back off: all that is sure is that nothing gets faster.
  const double share = tick.doing == Doing::reference ? 0 : 1;
  ceiling_ = std::min(std::max(0.0, ceiling_ - share * limits_.acceleration_mm_per_s2 * tick_s_ / kRelative),
                      speed_of(tick.now));
}

std::string LimitsChecker::speed_rule(const Tick& tick, const Place& place) {
  const double before = speed_of(tick.before), now = speed_of(tick.now);
  if (tick.ratio < ratio_before_) ceiling_ = std::max(ceiling_, before);
  if (place.index == path_.size()) return now > 0 ? "moves without a path" : "";
  const bool had_begun = place_.index < path_.size();
  const std::size_t first = had_begun ? place_.index : 0;
  double fastest = cap(place.index, tick.ratio);
  for (std::size_t i = first; i < place.index; ++i) {
    const bool is_left = i == place_.index && place_.way_mm >= path_.length_mm(i);
    if (path_.is_motion(i) && !is_left) fastest = std::max(fastest, cap(i, tick.ratio));
  }
  const double travelled = (place.total_mm - place_.total_mm) / tick_s_;
  const double most = std::max(fastest, ceiling_) * kRelative + kTiny / tick_s_ * 1e-2;
  if (travelled > most) return fmt::format("travels {} mm/s where {} are allowed", travelled, most);
  const double cap_now = cap(place.index, tick.ratio);
  const double braked = ceiling_ - limits_.acceleration_mm_per_s2 * tick_s_ / kRelative;
  const double most_now = std::max(cap_now, braked) * kRelative + kTiny;
  if (now > most_now) return fmt::format("{} mm/s where {} are allowed", now, most_now);
  lower_ceiling(tick);
  const double radius = path_.radius_mm(place.index);
  if (radius > 0 && now * now / radius > limits_.acceleration_mm_per_s2 * kRelative) {
    return fmt::format("{} mm/s on a radius of {} mm", now, radius);
  }
  return {};
}

/// The speed at a joint passed in this tick is at least what both ends of the tick and the ramp leave possible.
std::string LimitsChecker::joint_rule(const Tick& tick, const Place& place) const {
  const double before = speed_of(tick.before), now = speed_of(tick.now);
  if (before <= 0 || now <= 0 || place_.index >= path_.size() || place_.index == place.index) return {};
  const double at_joint = (before + now - limits_.acceleration_mm_per_s2 * tick_s_) / 2;
  std::size_t last = place_.index;
  for (std::size_t i = place_.index + 1; i <= place.index; ++i) {
    if (!path_.is_motion(i)) continue;
    const auto in = by_axis(path_.heading(last, path_.length_mm(last))), out = by_axis(path_.heading(i, 0));
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const double step = at_joint * std::abs(out[axis] - in[axis]);
      if (step > limits_.start_stop_mm_per_s * kRelative + kTiny) {
        return fmt::format("axis {} steps by {} mm/s between blocks {} and {}", axis, step, last + 1, i + 1);
      }
    }
    last = i;
  }
  return {};
}

/// Way travelled = integral of the reported speed: within a tick it can differ from the mean by a quarter of the ramp.
std::string LimitsChecker::honesty_rule(const Tick& tick, const Place& place) const {
  const double before = speed_of(tick.before), now = speed_of(tick.now);
  const double travelled = (place.total_mm - place_.total_mm) / tick_s_;
  const double ramp = limits_.acceleration_mm_per_s2 * tick_s_;
  if (before > 0 && now > 0) {
    const bool is_far = std::abs(travelled - (before + now) / 2) > ramp / 4 * kRelative + 1e-4;
    return is_far ? fmt::format("travels {} mm/s, reports {} to {}", travelled, before, now) : "";
  }
  const double most = std::max({before, now, std::min(limits_.start_stop_mm_per_s, limits_.f_max_mm_per_s)}) + ramp;
  return travelled > most * kRelative + 1e-4 ? fmt::format("travels {} mm/s from or to rest", travelled) : "";
}

}  // namespace cnclab::machine
