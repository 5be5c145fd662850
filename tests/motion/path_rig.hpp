// A planner and a follower on one queue, run in virtual time, every tick recorded.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/path_item.hpp"
#include "motion/follower.hpp"
#include "motion/planner.hpp"
#include "motion/segment_queue.hpp"

namespace cnclab::motion {

/// What could be seen from outside in one tick.
struct Sample {
  geometry::Point position;
  double speed = 0;                ///< at the end of the tick, mm/s
  std::uint64_t front = 0;         ///< queue number of the segment in work at the end of the tick
  std::uint64_t front_before = 0;  ///< … at its beginning
  Demand demand;
  bool held = false;
  bool event_done = false;
};

inline geometry::PathItem item_of(auto what, std::uint64_t sequence = 0) {
  geometry::PathItem item;
  item.what = what;
  item.sequence = sequence;
  item.ends_block = sequence != 0;
  item.source.block = static_cast<std::uint16_t>(sequence);
  return item;
}

inline geometry::PathItem line(geometry::Point from, geometry::Point to, double feed, std::uint64_t sequence = 0) {
  return item_of(geometry::Line{from, to, feed, false}, sequence);
}

inline geometry::PathItem rapid(geometry::Point from, geometry::Point to, std::uint64_t sequence = 0) {
  return item_of(geometry::Line{from, to, 3000, true}, sequence);
}

class PathRig {
 public:
  explicit PathRig(const Limits& limits = {}, double tick_s = 1e-3)
      : limits_(limits), tick_s_(tick_s), planner_(queue_, limits), follower_(queue_, limits) {
    follower_.begin(planner_.run(), {}, limits);
  }

  /// Appends all and plans once.
  void append(const std::vector<geometry::PathItem>& items) {
    for (const auto& item : items) append_unplanned(item);
    planner_.plan();
  }
  void append_unplanned(const geometry::PathItem& item) {
    segments_.push_back(make_segment(item, planner_.run(), limits_));
    if (!planner_.append(item)) throw std::runtime_error("window full");
  }

  /// One tick; events are done at once when they are reached.
  const Sample& tick(const Demand& demand = {}) {
    Sample sample;
    sample.front_before = queue_.popped();
    sample.demand = demand;
    double left_s = tick_s_;
    for (;;) {
      const Advance done = follower_.advance(left_s, demand);
      sample.held = sample.held || done.held;
      if (!done.event_reached || (demand.stop && !done.moving)) break;
      left_s = done.left_s;
      sample.event_done = true;
      if (follower_.pass_event()) {
        sample.held = true;
        break;
      }
    }
    sample.position = follower_.position();
    sample.speed = follower_.speed_mm_per_s();
    sample.front = queue_.popped();
    samples_.push_back(sample);
    return samples_.back();
  }

  /// Ticks until the queue is empty and the path rests. False after `most` ticks.
  bool run_out(const Demand& demand = {}, int most = 5'000'000) {
    for (int i = 0; i < most; ++i) {
      if (is_done()) return true;
      tick(demand);
    }
    return false;
  }

  [[nodiscard]] bool is_done() const { return queue_.waiting() == 0 && follower_.speed_mm_per_s() == 0; }
  [[nodiscard]] double time_s() const { return static_cast<double>(samples_.size()) * tick_s_; }
  [[nodiscard]] double tick_s() const { return tick_s_; }
  [[nodiscard]] const Limits& limits() const { return limits_; }
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }
  [[nodiscard]] SegmentQueue& queue() { return queue_; }
  [[nodiscard]] Planner& planner() { return planner_; }
  [[nodiscard]] Follower& follower() { return follower_; }

 private:
  Limits limits_;
  double tick_s_;
  SegmentQueue queue_;
  Planner planner_;
  Follower follower_;
  std::vector<Segment> segments_;
  std::vector<Sample> samples_;
};

/// The first rule that a recorded motion breaks, in words; empty where it keeps to all of them.
[[nodiscard]] std::string broken_rule(const PathRig& rig, geometry::Point start);

/// DEC-21 in other words than the planner's: the speed at a joint of directions `in` and `out`.
[[nodiscard]] double allowed_at_joint(const Segment& before, const Segment& after, const Limits& limits);

}  // namespace cnclab::motion
