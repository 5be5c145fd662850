// The planned path between two threads: one side plans and appends, the other follows it tick by tick.
//
//   planner (lab thread)  ── append, raise exit speeds ──▶  [ segment | segment | … ]  ── front, pop ──▶  follower (tick)
//
// Rules
//  1. One producer, one consumer, no locks. Slots live in chunks that are made when they are first needed and used
//     again when the follower has left them, so memory follows what is waiting, up to kWindow segments.
//  2. A slot's exit speed is the only thing that changes after it was published, and it only ever rises: an old value
//     read by the follower is slower, never unsafe.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "geometry/path_item.hpp"
#include "geometry/path_math.hpp"

namespace cnclab::motion {

/// A path item with everything the tick needs worked out beforehand.
struct Segment {
  geometry::PathItem item;
  geometry::ArcShape arc;         ///< for arcs
  double length_mm = 0;           ///< 0 for events
  double speed_mm_per_s = 0;      ///< programmed, within F MAX and the arc's centripetal limit
  double to_block_end_mm = 0;     ///< way from this segment's end to the end of its block (EINZELSATZ)
  bool is_motion = false;
  bool stops_before = false;      ///< events that need standstill: dwell, waits, halts, end, reference
};

class SegmentQueue {
 public:
  static constexpr std::size_t kWindow = 65'536;

  SegmentQueue();
  ~SegmentQueue();
  SegmentQueue(const SegmentQueue&) = delete;
  SegmentQueue& operator=(const SegmentQueue&) = delete;

  // Producer side.
  [[nodiscard]] bool is_full() const;
  /// Appends; the exit speed of the last segment is that of a stop. Must not be full.
  void push(const Segment& segment);
  /// The producer's own view, index 0 = oldest still waiting at the time of `waiting()`.
  [[nodiscard]] std::size_t waiting() const;
  [[nodiscard]] std::uint64_t pushed() const { return head_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t popped() const { return tail_.load(std::memory_order_acquire); }
  [[nodiscard]] const Segment& at(std::uint64_t number) const;  ///< popped() <= number < pushed()
  void raise_exit_speed(std::uint64_t number, double mm_per_s);
  [[nodiscard]] double exit_speed(std::uint64_t number) const;

  // Consumer side.
  [[nodiscard]] const Segment* front() const;  ///< nullptr when empty
  void pop();
  /// Forgets everything that waits (a run was abandoned). Consumer side; the producer must have stopped pushing.
  void clear();

 private:
  struct Chunk;
  static constexpr std::size_t kChunk = 256;
  std::array<std::unique_ptr<Chunk>, kWindow / kChunk + 1> chunks_;
  std::atomic<std::uint64_t> head_{0}, tail_{0};
};

}  // namespace cnclab::motion
