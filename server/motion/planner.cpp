// Joint speeds and the backward pass.
#include "motion/planner.hpp"

#include <algorithm>
#include <cmath>

namespace cnclab::motion {

namespace {

/// Passing more events than this on the fly would make a tick long; a longer row of them gets a full stop.
constexpr int kMostEventsInMotion = 64;

geometry::Point direction(const Segment& segment, double way) {
  if (const auto* line = std::get_if<geometry::Line>(&segment.item.what)) {
    return geometry::direction_at(*line, segment.length_mm);
  }
  return geometry::direction_at(std::get<geometry::Arc>(segment.item.what), segment.arc, way);
}

bool is_rapid(const Segment& segment) {
  const auto* line = std::get_if<geometry::Line>(&segment.item.what);
  return line != nullptr && line->is_rapid;
}

}  // namespace

double joint_speed(const Segment& before, const Segment& after, const Limits& limits) {
  const geometry::Point in = direction(before, before.length_mm);
  const geometry::Point out = direction(after, 0);
  const double largest_step =
      std::max({std::abs(out.x - in.x), std::abs(out.y - in.y), std::abs(out.z - in.z), std::abs(out.u - in.u)});
  const double slower = std::min(before.speed_mm_per_s, after.speed_mm_per_s);
  if (slower * largest_step <= limits.start_stop_mm_per_s) return slower;
  return limits.start_stop_mm_per_s / largest_step;
}

Planner::Planner(SegmentQueue& queue, const Limits& limits) : queue_(queue), limits_(limits) {
  first_of_run_ = unplanned_from_ = queue_.pushed();
}

void Planner::restart() {
  ++run_;
  newest_motion_.reset();
  stop_between_ = true;
  is_due_ = false;
  events_in_row_ = 0;
  first_of_run_ = unplanned_from_ = queue_.pushed();
  queue_.trim();
}

void Planner::restart(const Limits& limits) {
  limits_ = limits;
  restart();
}

/// The newest motion ends in a full stop, whatever is appended from here on.
void Planner::note_full_stop() {
  stop_between_ = true;
  if (!newest_motion_ || *newest_motion_ < queue_.popped() || queue_.is_full_stop_noted(*newest_motion_)) return;
  queue_.note_full_stop(*newest_motion_);
  is_due_ = true;
}

/// Works out the joint between the newest motion and segment `number`, and what is due behind it.
void Planner::join(std::uint64_t number) {
  const Segment& segment = queue_.at(number);
  if (!segment.is_motion) {
    if (segment.stops_before || ++events_in_row_ > kMostEventsInMotion) note_full_stop();
    return;
  }
  if (is_rapid(segment)) note_full_stop();
  if (newest_motion_ && *newest_motion_ >= queue_.popped() && !stop_between_) {
    queue_.note_joint_speed(*newest_motion_, joint_speed(queue_.at(*newest_motion_), segment, limits_));
  }
  newest_motion_ = number;
  events_in_row_ = 0;
  stop_between_ = false;
  is_due_ = true;
  if (is_rapid(segment) || segment.item.exact_stop) note_full_stop();
}

std::expected<std::size_t, AppendError> Planner::append(const geometry::PathItem& item) {
  if (queue_.is_full()) return std::unexpected(AppendError::window_full);
  const std::uint64_t number = queue_.pushed();
  queue_.push(make_segment(item, run_, limits_));
  join(number);
  return queue_.waiting();
}

/// Square of the greatest speed with which a segment may be entered that is left with `exit_speed` (0: full stop).
double Planner::entry_speed_sq(std::uint64_t number, double exit_speed) const {
  const Segment& segment = queue_.at(number);
  const double ramp = 2 * limits_.acceleration_mm_per_s2;
  const bool may_jump = exit_speed <= 0 && queue_.is_full_stop_noted(number);
  const double end = may_jump ? limits_.start_stop_mm_per_s : exit_speed;
  const double entry_sq = end * end + ramp * segment.length_mm;
  if (segment.creep_from_mm >= segment.length_mm) return entry_sq;
  const double creep = limits_.start_stop_mm_per_s / 2;
  return std::min(entry_sq, creep * creep + ramp * segment.creep_from_mm);
}

void Planner::plan() {
  queue_.trim();
  if (!is_due_ || !newest_motion_) return;
  is_due_ = false;
  const std::uint64_t first = std::max(first_of_run_, queue_.popped());
  double next_entry_sq = -1;  // of the motion behind the one looked at; -1: there is none
  for (std::uint64_t number = *newest_motion_ + 1; number-- > first;) {
    const Segment& segment = queue_.at(number);
    ++revised_;
    if (!segment.is_motion) continue;
    const double before = queue_.exit_speed(number);
    double exit = 0;
    if (next_entry_sq >= 0) exit = std::min(queue_.noted_joint_speed(number), std::sqrt(next_entry_sq));
    if (exit > before) queue_.raise_exit_speed(number, exit);
    const bool was_planned = number < unplanned_from_ && number != joint_behind_;
    if (exit <= before && was_planned) break;
    next_entry_sq = entry_speed_sq(number, std::max(exit, before));
  }
  unplanned_from_ = *newest_motion_ + 1;
  joint_behind_ = *newest_motion_;
}

}  // namespace cnclab::motion
