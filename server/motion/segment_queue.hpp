// The planned path between two threads: one side plans and appends, the other follows it tick by tick.
//
//   planner (lab thread)  ── append, raise exit speeds ──▶  [ segment | segment | … ]  ── front, pop ──▶  follower
//   (tick)
//
// Rules
//  1. One producer, one consumer, no locks. Slots live in chunks that the producer makes when they are first needed and
//     takes back when the follower has left them, so memory follows what is waiting, up to kWindow segments.
//  2. A slot's exit speed is the only thing that changes after it was published, and it only ever rises: an old value
//     read by the follower is slower, never unsafe. The follower that sees a new value of segment i also sees those of
//     the segments behind it that made it possible (release/acquire, planner writes from the end to the front).
//  3. Every segment carries the number of its run. The follower drops what belongs to a run that was abandoned, so the
//     producer may go on pushing in the same moment without harm.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/path_item.hpp"
#include "geometry/path_math.hpp"

namespace cnclab::motion {

/// A path item with everything the tick needs worked out beforehand.
struct Segment {
  geometry::PathItem item;
  geometry::ArcShape arc;     ///< for arcs
  std::uint64_t run = 0;      ///< number of the run it belongs to, from 1
  double length_mm = 0;       ///< 0 for events
  double feed_mm_per_s = 0;   ///< programmed, within F MAX: what the potentiometer scales
  double speed_mm_per_s = 0;  ///< feed, within the arc's centripetal limit
  double creep_from_mm = 0;   ///< exact stop: way at which creeping begins; length_mm where there is none
  bool is_motion = false;     ///< false also for ways too short to be travelled
  bool stops_before = false;  ///< events that need standstill: dwell, waits, halts, end, reference
};

class SegmentQueue {
 public:
  static constexpr std::size_t kWindow = 65'536;

  SegmentQueue();
  ~SegmentQueue();
  SegmentQueue(const SegmentQueue&) = delete;
  SegmentQueue& operator=(const SegmentQueue&) = delete;

  // Producer side.
  [[nodiscard]] bool is_full() const { return waiting() >= kWindow; }
  /// Appends; the exit speed is 0, that of a full stop. Must not be full. May allocate.
  void push(const Segment& segment);
  [[nodiscard]] std::size_t waiting() const { return static_cast<std::size_t>(pushed() - popped()); }
  [[nodiscard]] std::uint64_t pushed() const { return head_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t popped() const { return tail_.load(std::memory_order_acquire); }
  [[nodiscard]] const Segment& at(std::uint64_t number) const;  ///< popped() <= number < pushed()
  /// The greatest exit speed that the joint behind the segment allows; the producer's own note, 0 until it is known.
  void note_joint_speed(std::uint64_t number, double mm_per_s);
  [[nodiscard]] double noted_joint_speed(std::uint64_t number) const;
  /// What follows needs standstill: the segment ends in a full stop for good. Also the producer's own note.
  void note_full_stop(std::uint64_t number);
  [[nodiscard]] bool is_full_stop_noted(std::uint64_t number) const;
  void raise_exit_speed(std::uint64_t number, double mm_per_s);
  /// Gives back the chunks that the consumer has left.
  void trim();
  /// Chunks in memory now, the spare one included.
  [[nodiscard]] std::size_t chunks_held() const;

  // Both sides.
  /// Speed with which the segment may be left in motion; 0 = it ends in a full stop (reached with up to F START/STOP).
  [[nodiscard]] double exit_speed(std::uint64_t number) const;

  // Consumer side.
  [[nodiscard]] const Segment* front() const noexcept { return ahead(popped_number()); }  ///< nullptr when empty
  [[nodiscard]] std::uint64_t popped_number() const noexcept { return tail_.load(std::memory_order_relaxed); }
  /// A waiting segment by its number, popped_number() or greater; nullptr where there is none yet.
  [[nodiscard]] const Segment* ahead(std::uint64_t number) const noexcept;
  void pop() noexcept { tail_.store(popped_number() + 1, std::memory_order_release); }
  /// Forgets everything that waits now, whatever its run.
  void clear() noexcept { tail_.store(head_.load(std::memory_order_acquire), std::memory_order_release); }

 private:
  struct Slot {
    Segment segment;
    double joint_speed = 0;     ///< producer only
    bool is_full_stop = false;  ///< producer only
    std::atomic<double> exit_speed{0};
  };
  static constexpr std::size_t kChunk = 128;
  static constexpr std::size_t kChunks = kWindow / kChunk + 2;
  using Chunk = std::array<Slot, kChunk>;

  [[nodiscard]] Slot& slot(std::uint64_t number) const;
  void open_chunk(std::uint64_t chunk);

  std::vector<std::unique_ptr<Chunk>> chunks_;  ///< ring by chunk number; fixed size, entries come and go
  std::unique_ptr<Chunk> spare_;
  std::uint64_t oldest_chunk_ = 0;  ///< the first that is still held
  alignas(64) std::atomic<std::uint64_t> head_{0};
  alignas(64) std::atomic<std::uint64_t> tail_{0};
};

}  // namespace cnclab::motion
