// Look-ahead: how fast each segment may be left, so that the machine is always able to stop at the end of what it
// knows.
//
// Exit speeds are found backwards: the newest segment ends in a stop; each one before it may be left with the smaller
// of its joint's speed and the speed from which the ramp still reaches what follows. Where a joint's own limit is
// already reached nothing before it can become faster, and the pass ends. The follower accelerates as it goes, so there
// is no forward pass.
//
// Speeds once published only ever rise, so what is not known must be taken as slow as it may turn out: the end of what
// is known might become a joint slower than F START/STOP, and is approached as if it had to be reached with speed 0.
// Once a full stop is known to follow (rapid, exact stop, dwell, end …) it may be reached with up to F START/STOP.
//
// Not supported: a tick in which more than some hundred segments end (each below 0.1 µm at full speed) is cut short.
#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>

#include "motion/limits.hpp"
#include "motion/segment_queue.hpp"

namespace cnclab::motion {

enum class AppendError { window_full };

/// The speed with which the joint between two segments may be passed, mm/s: no axis' velocity steps by more than
/// F START/STOP, and not above the slower of both (DEC-21).
[[nodiscard]] double joint_speed(const Segment& before, const Segment& after, const Limits& limits);

/// Everything that motion must know of an item: length, speed limits, whether it needs standstill.
[[nodiscard]] Segment make_segment(const geometry::PathItem& item, std::uint64_t run, const Limits& limits);

/// Plans for one queue. Lab thread only.
class Planner {
 public:
  Planner(SegmentQueue& queue, const Limits& limits);

  /// Appends one item.
  /// returns  segments now waiting (1..kWindow)
  /// errors   window_full, nothing changed
  [[nodiscard]] std::expected<std::size_t, AppendError> append(const geometry::PathItem& item);

  /// Revises exit speeds from the newest segment back to the first that cannot become faster. Call it after each batch:
  /// each segment is then revised at most twice on average. What was not planned yet ends in a stop.
  void plan();

  /// Begins a new path: the next segment starts from rest. Earlier segments that still wait belong to the former run.
  /// Users of a `machine::Channel` call its `begin_run` instead.
  void restart();
  void restart(const Limits& limits);

  /// Number of the run that segments are appended to, from 1.
  [[nodiscard]] std::uint64_t run() const { return run_; }
  /// Segments looked at by `plan` so far, for tests and benchmarks of its cost.
  [[nodiscard]] std::uint64_t revised() const { return revised_; }

 private:
  void join(std::uint64_t number);
  void note_full_stop();
  [[nodiscard]] double entry_speed_sq(std::uint64_t number, double exit_speed) const;

  SegmentQueue& queue_;
  Limits limits_;
  std::uint64_t run_ = 1;
  std::optional<std::uint64_t> newest_motion_;  ///< of this run
  bool stop_between_ = true;                    ///< a full stop is due before the next motion
  bool is_due_ = false;                         ///< something was appended that may make exit speeds rise
  int events_in_row_ = 0;
  std::uint64_t unplanned_from_ = 0;         ///< segments from here on were never looked at by `plan`
  std::uint64_t joint_behind_ = UINT64_MAX;  ///< newest motion of the last pass: its joint was not known then
  std::uint64_t first_of_run_ = 0;
  std::uint64_t revised_ = 0;
};

}  // namespace cnclab::motion
