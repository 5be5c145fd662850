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
  events_in_row_ = 0;
  first_of_run_ = unplanned_from_ = queue_.pushed();
  queue_.trim();
}

void Planner::restart(const Limits& limits) {
  limits_ = limits;
  restart();
}

/// Works out the joint between the newest motion and `segment`, and what is due behind `segment`.
void Planner::join_to(std::uint64_t number, const Segment& segment) {
  if (!segment.is_motion) {
    stop_between_ = stop_between_ || segment.stops_before || ++events_in_row_ > kMostEventsInMotion;
    return;
  }
  const bool full_stop = stop_between_ || is_rapid(segment);
  if (newest_motion_ && *newest_motion_ >= queue_.popped() && !full_stop) {
    queue_.note_joint_speed(*newest_motion_, joint_speed(queue_.at(*newest_motion_), segment, limits_));
  }
  newest_motion_ = number;
  events_in_row_ = 0;
  stop_between_ = is_rapid(segment) || segment.item.exact_stop;
}

std::expected<std::size_t, AppendError> Planner::append(const geometry::PathItem& item) {
  if (queue_.is_full()) return std::unexpected(AppendError::window_full);
  const Segment segment = make_segment(item, run_, limits_);
  join_to(queue_.pushed(), segment);
  queue_.push(segment);
  return queue_.waiting();
}

/// Square of the greatest speed with which a segment may be entered that is left with `exit_speed` (0: full stop).
double Planner::entry_speed_sq(const Segment& segment, double exit_speed) const {
  const double ramp = 2 * limits_.acceleration_mm_per_s2;
  const double end = exit_speed > 0 ? exit_speed : limits_.start_stop_mm_per_s;
  const double entry_sq = end * end + ramp * segment.length_mm;
  if (segment.creep_from_mm >= segment.length_mm) return entry_sq;
  const double creep = limits_.start_stop_mm_per_s / 2;
  return std::min(entry_sq, creep * creep + ramp * segment.creep_from_mm);
}

void Planner::plan() {
  queue_.trim();
  if (!newest_motion_ || *newest_motion_ < unplanned_from_) return;
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
    next_entry_sq = entry_speed_sq(segment, std::max(exit, before));
  }
  unplanned_from_ = *newest_motion_ + 1;
  joint_behind_ = *newest_motion_;
}

}  // namespace cnclab::motion
