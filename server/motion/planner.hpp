// Look-ahead: how fast each segment may be left, so that the machine is always able to stop at the end of what it knows.
#pragma once

#include <cstddef>
#include <expected>

#include "motion/limits.hpp"
#include "motion/segment_queue.hpp"

namespace cnclab::motion {

enum class AppendError { window_full };

/// The speed with which the joint between two segments may be passed, mm/s: no axis' velocity steps by more than
/// F START/STOP, and not above the slower of both (DEC-21).
[[nodiscard]] double joint_speed(const Segment& before, const Segment& after, const Limits& limits);

/// Plans for one queue. Lab thread only.
class Planner {
 public:
  Planner(SegmentQueue& queue, const Limits& limits);

  /// Appends one item. errors: window_full, nothing changed.
  [[nodiscard]] std::expected<std::size_t, AppendError> append(const geometry::PathItem& item);

  /// Revises exit speeds from the newest segment back to the first that cannot become faster. Call it after each batch:
  /// each segment is then revised at most twice on average.
  void plan();

  /// Begins a new path: the next segment starts from rest.
  void restart();

 private:
  SegmentQueue& queue_;
  Limits limits_;
};

}  // namespace cnclab::motion
