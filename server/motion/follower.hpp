// Follows the planned path in ticks: speed by ramps, potentiometer, stop and single block; position exactly on the path.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/path_item.hpp"
#include "motion/limits.hpp"
#include "motion/segment_queue.hpp"

namespace cnclab::motion {

/// Integer steps of X, Y, Z, U in one tick.
using AxisSteps = std::array<std::int32_t, 4>;

/// What the operator wants right now; read anew in each tick.
struct Demand {
  double override_ratio = 1;   ///< potentiometer 0..1
  bool stop = false;           ///< brake with STOPVERZÖGERUNG and rest on the path
  bool single_block = false;   ///< rest at the next end of a block that can be reached by the ramp
};

/// What the follower did in a tick.
struct Advance {
  bool moving = false;              ///< path speed > 0 at the end of the tick
  bool event_reached = false;       ///< the front of the queue is an event, and it may be done now
  bool block_ended = false;         ///< an item with ends_block was finished (motion only)
  bool starved = false;             ///< rest, nothing queued
};

/// Tick side of one path. Allocates nothing, waits for nothing.
class Follower {
 public:
  Follower(SegmentQueue& queue, const Limits& limits);

  /// Moves on by `tick_s`. Events are not passed: the machine executes the front event and calls `pass_event`.
  Advance advance(double tick_s, const Demand& demand);
  void pass_event();

  /// Stands still at once, without ramp (limit switch, power-off).
  void halt_now();
  /// Forgets the queued path; the position stays.
  void abandon();

  [[nodiscard]] const geometry::Point& position() const { return position_; }  ///< mm, path coordinates
  [[nodiscard]] double speed_mm_per_s() const { return speed_; }
  [[nodiscard]] const Segment* current() const { return queue_.front(); }
  /// Takes over a position while at rest (start of a run, SetActual, reference run).
  void set_position(const geometry::Point& position);

 private:
  SegmentQueue& queue_;
  Limits limits_;
  geometry::Point position_;
  double speed_ = 0;
  double way_ = 0;  ///< mm done of the front segment
};

}  // namespace cnclab::motion
