// The tick: pieces of the speed profile along the queue's segments.
#include "motion/follower.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cnclab::motion {

namespace {

/// More pieces than any sensible path has in a tick; a bound on the tick's time all the same.
constexpr int kMostPieces = 2000;
constexpr int kMostDropped = 4096;
/// Segments looked at in one tick for a block end.
constexpr int kSearchPerTick = 256;
/// Segments looked at ahead for feeds that the potentiometer makes slower than the plan.
constexpr int kOverrideLookAhead = 32;
/// No more events than this lie between two ways that are joined in motion (the planner's own bound).
constexpr int kMostEventsAtJoint = 65;
/// Rounding allowed at a joint, relative.
constexpr double kJointTolerance = 1e-6;

double ratio_of(const Segment& segment, double ratio) { return segment.item.override_off ? 1.0 : ratio; }

double cap_of(const Segment& segment, double ratio) {
  return std::min(segment.speed_mm_per_s, ratio_of(segment, ratio) * segment.feed_mm_per_s);
}

geometry::Point end_of(const Segment& segment) {
  if (const auto* line = std::get_if<geometry::Line>(&segment.item.what)) return line->to;
  return std::get_if<geometry::Arc>(&segment.item.what)->to;
}

geometry::Point point_on(const Segment& segment, double way) {
  if (const auto* line = std::get_if<geometry::Line>(&segment.item.what)) {
    return geometry::point_at(*line, segment.length_mm, way);
  }
  return geometry::point_at(*std::get_if<geometry::Arc>(&segment.item.what), segment.arc, way);
}

/// A line or an arc that is too short to be travelled is passed at once.
bool is_event(const Segment& segment) {
  return !segment.is_motion && !std::holds_alternative<geometry::Line>(segment.item.what) &&
         !std::holds_alternative<geometry::Arc>(segment.item.what);
}

}  // namespace

Follower::Follower(SegmentQueue& queue, const Limits& limits) : queue_(queue), limits_(limits) {}

const Segment* Follower::of_this_run(std::uint64_t number) const noexcept {
  const Segment* segment = queue_.ahead(number);
  return segment != nullptr && run_ != 0 && segment->run == run_ ? segment : nullptr;
}

void Follower::begin(std::uint64_t run, const geometry::Point& position, const Limits& limits) noexcept {
  abandoned_run_ = std::max(abandoned_run_, run - 1);
  run_ = run;
  limits_ = limits;
  position_ = position;
  speed_ = way_ = odometer_ = 0;
  sequence_ = finished_sequence_ = 0;
  rest_due_ = false;  // every run begins alike, whatever ended the one before: it can be replayed
  free_row_ = {};
  forget_hold();
  drop_old_runs();
}

void Follower::halt_now() noexcept { rest(); }

void Follower::abandon() noexcept {
  abandoned_run_ = std::max(abandoned_run_, run_);
  run_ = 0;
  rest();
  way_ = 0;
  free_row_ = {};
  forget_hold();
  drop_old_runs();
}

void Follower::drop_old_runs() noexcept {
  for (int i = 0; i < kMostDropped; ++i) {
    const Segment* segment = queue_.front();
    if (segment == nullptr || segment->run > abandoned_run_) return;
    queue_.pop();
  }
}

void Follower::rest() noexcept {
  rest_due_ = rest_due_ || speed_ > 0;
  speed_ = 0;
  search_ = {};
}

void Follower::forget_hold() noexcept {
  hold_ = {};
  search_ = {};
}

/// Looks for the first end of a block that the ramp can reach, some segments per tick, and keeps to it once found.
void Follower::seek_hold() noexcept {
  const std::uint64_t front = queue_.popped_number();
  if (!search_.has_begun || search_.next < front) search_ = {true, false, front, 0, odometer_ - way_};
  for (int i = 0; i < kSearchPerTick; ++i, ++search_.next) {
    const Segment* segment = of_this_run(search_.next);
    if (segment == nullptr) {
      search_ = {};
      return;
    }
    if (segment->is_motion) {
      search_.at_mm += segment->length_mm;
      search_.motion = search_.next;
      search_.has_motion = true;
    }
    const bool is_rest = segment->item.ends_block && !segment->item.passes_single_block;
    if (is_rest && can_rest_at(search_)) {
      hold_ = {true, search_.next, search_.has_motion ? search_.motion : UINT64_MAX, search_.at_mm};
      return;
    }
  }
}

bool Follower::can_rest_at(const Search& place) const noexcept {
  if (speed_ <= 0) return true;
  if (!place.has_motion) return false;
  const double rest_from = limits_.start_stop_mm_per_s;
  const double way = place.at_mm - odometer_;
  const double reachable_sq = rest_from * rest_from + 2 * limits_.acceleration_mm_per_s2 * way;
  return speed_ * speed_ <= reachable_sq * (1 + kJointTolerance);
}

/// Looks further along the row of ways under M23, some per tick, so that it costs each of them once.
void Follower::extend_free_row() noexcept {
  const std::uint64_t front = queue_.popped_number();
  if (!free_row_.has_begun || free_row_.next < front) free_row_ = {true, front, front, odometer_ - way_};
  for (int i = 0; i < kSearchPerTick; ++i, ++free_row_.next) {
    const Segment* segment = of_this_run(free_row_.next);
    if (segment == nullptr || (segment->is_motion && !segment->item.override_off)) return;
    if (!segment->is_motion) continue;
    free_row_.motion = free_row_.next;
    free_row_.ends_mm += segment->length_mm;
  }
}

/// Slower segments ahead under the potentiometer: what the exit speeds, made for 100 %, do not know.
///
/// Beyond the segments looked at the planned profile scaled by the ratio is kept, which is slower than needed but can
/// always be kept: scaled, every ramp in it only becomes flatter. Ways under M23 are passed over first.
double Follower::override_envelope_sq(const Segment& segment, double ratio, double time_s) const noexcept {
  const double ramp = 2 * limits_.acceleration_mm_per_s2;
  const double rest_from = limits_.start_stop_mm_per_s;
  const double cap = cap_of(segment, ratio);
  const double horizon = cap * cap / ramp + cap * time_s;  // nothing behind it can bind in this tick
  double way = segment.length_mm - way_;
  double envelope_sq = std::numeric_limits<double>::infinity();
  std::uint64_t number = queue_.popped_number();
  std::uint64_t motion = number;
  if (segment.item.override_off && free_row_.next > number) {
    way = std::max(way, free_row_.ends_mm - odometer_);
    number = free_row_.next - 1;
    motion = free_row_.motion;
  }
  for (int i = 0; i < kOverrideLookAhead; ++i) {
    if (way > horizon) return envelope_sq;
    const Segment* next = of_this_run(++number);
    if (next == nullptr) return envelope_sq;
    if (!next->is_motion) continue;
    if (queue_.exit_speed(motion) <= 0) return envelope_sq;
    const double next_cap = cap_of(*next, ratio);
    const double entry = next_cap > 0 ? next_cap : rest_from;
    envelope_sq = std::min(envelope_sq, entry * entry + ramp * way);
    way += next->length_mm;
    motion = number;
  }
  const double planned = queue_.exit_speed(motion);
  const double beyond = ratio * (planned > 0 ? planned : rest_from);
  return std::min(envelope_sq, beyond * beyond + ramp * way);
}

Course Follower::course_ahead(const Segment& segment, const Demand& demand, double time_s) const noexcept {
  const double ramp = 2 * limits_.acceleration_mm_per_s2;
  const double rest_from = limits_.start_stop_mm_per_s;
  const std::uint64_t number = queue_.popped_number();
  const double rest = segment.length_mm - way_;
  const double exit = queue_.exit_speed(number);
  const bool holds_here = hold_.is_chosen && hold_.motion == number;
  const double end = exit > 0 && !holds_here ? exit : rest_from;
  Course course{cap_of(segment, demand.override_ratio), end * end + ramp * rest, rest};
  if (hold_.is_chosen && !holds_here) {
    const double way = std::max(0.0, hold_.at_mm - odometer_);
    course.envelope_sq = std::min(course.envelope_sq, rest_from * rest_from + ramp * way);
  }
  if (segment.creep_from_mm < segment.length_mm) {
    const double creep = rest_from / 2;
    if (way_ >= segment.creep_from_mm) {
      course.cap_mm_per_s = std::min(course.cap_mm_per_s, creep);
    } else {
      course.way_mm = segment.creep_from_mm - way_;
      course.envelope_sq = std::min(course.envelope_sq, creep * creep + ramp * course.way_mm);
    }
  }
  if (demand.override_ratio < 1 && course.cap_mm_per_s > 0) {
    course.envelope_sq = std::min(course.envelope_sq, override_envelope_sq(segment, demand.override_ratio, time_s));
  }
  return course;
}

void Follower::work_on(const geometry::PathItem& item) noexcept {
  source_ = item.source;
  sequence_ = item.sequence;
  const auto* line = std::get_if<geometry::Line>(&item.what);
  is_rapid_ = line != nullptr && line->is_rapid;
}

void Follower::finish_item(const geometry::PathItem& item, Advance& done) noexcept {
  work_on(item);
  if (item.ends_block) {
    finished_sequence_ = item.sequence;
    done.block_ended = true;
  }
  if (hold_.is_chosen && hold_.item == queue_.popped_number()) {
    done.held = true;
    forget_hold();
  }
  queue_.pop();
}

/// A joint that was planned only when it was near: a full stop was expected there, so nobody braked to what the
/// potentiometer leaves of the next feed. The full stop that was expected is still possible.
bool Follower::is_too_fast_behind(std::uint64_t number, double ratio) const noexcept {
  const double jump = limits_.start_stop_mm_per_s * (1 + kJointTolerance);
  if (ratio >= 1 || speed_ > jump) return false;
  for (int i = 0; i < kMostEventsAtJoint; ++i) {
    const Segment* next = of_this_run(++number);
    if (next == nullptr) return false;
    if (next->is_motion) return speed_ > cap_of(*next, ratio) * (1 + kJointTolerance);
  }
  return false;
}

void Follower::finish_motion(const Segment& segment, double ratio, Advance& done) noexcept {
  const std::uint64_t number = queue_.popped_number();
  const double exit = queue_.exit_speed(number);
  const bool holds_here = hold_.is_chosen && hold_.motion == number;
  position_ = end_of(segment);
  way_ = 0;
  if (holds_here || speed_ > exit * (1 + kJointTolerance) || is_too_fast_behind(number, ratio)) {
    rest();
    done.left_s = 0;
  } else {
    speed_ = std::min(speed_, exit);
  }
  finish_item(segment.item, done);
}

/// One piece along the front segment.
void Follower::move(const Segment& segment, const Demand& demand, Advance& done) noexcept {
  const Course course = course_ahead(segment, demand, done.left_s);
  const Piece piece = next_piece(speed_, course, demand.stop, limits_, done.left_s);
  const bool to_creep = way_ < segment.creep_from_mm && segment.creep_from_mm < segment.length_mm;
  const bool to_change = piece.way_mm >= course.way_mm;
  work_on(segment.item);
  speed_ = piece.speed_mm_per_s;
  odometer_ += piece.way_mm;
  way_ = !to_change ? way_ + piece.way_mm : to_creep ? segment.creep_from_mm : segment.length_mm;
  done.left_s = std::max(0.0, done.left_s - piece.time_s);
  if (to_change && !to_creep) finish_motion(segment, demand.override_ratio, done);
  if (piece.rests) {
    rest_due_ = true;
    rest();
    done.left_s = 0;
  }
}

void Follower::place_on_path() noexcept {
  const Segment* segment = current();
  if (way_ > 0 && segment != nullptr) position_ = point_on(*segment, way_);
}

void Follower::choose_rest(bool single_block) noexcept {
  if (!single_block) forget_hold();
  if (single_block && !hold_.is_chosen) seek_hold();
}

Advance Follower::advance(double time_s, const Demand& demand) noexcept {
  Advance done;
  done.left_s = time_s;
  choose_rest(demand.single_block);
  if (demand.override_ratio < 1) extend_free_row();
  for (int pieces = 0; pieces < kMostPieces && done.left_s > 0 && !done.held; ++pieces) {
    const Segment* segment = current();
    done.starved = segment == nullptr;
    if (segment == nullptr) break;
    if (is_event(*segment)) {
      done.event_reached = true;
      break;
    }
    if (!segment->is_motion) {
      finish_item(segment->item, done);
      continue;
    }
    const bool may_go = !demand.stop && cap_of(*segment, demand.override_ratio) > 0;
    if (speed_ <= 0 && (rest_due_ || !may_go)) {
      rest_due_ = false;
      done.left_s = 0;
      break;
    }
    move(*segment, demand, done);
  }
  if (!done.event_reached && !done.held) done.left_s = 0;
  place_on_path();
  done.moving = speed_ > 0;
  return done;
}

bool Follower::pass_event() noexcept {
  const Segment* segment = current();
  if (segment == nullptr) return false;
  Advance done;
  finish_item(segment->item, done);
  return done.held;
}

}  // namespace cnclab::motion
