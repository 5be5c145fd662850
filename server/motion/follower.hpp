// Follows the planned path in ticks: speed by ramps, potentiometer, stop and single block; position exactly on the
// path.
//
// What holds in every tick
//  1. speed <= feed × potentiometer, the arc's limit, F MAX; a lowered potentiometer is met on the ramp (DEC-40).
//  2. The speed never exceeds what the exit speeds ahead allow, so a joint is never passed too fast; the path may end
//  or
//     a stop may come at any moment.
//  3. Rest is entered from, and left to, at most F START/STOP (DEC-20), and lasts at least one whole tick, so that no
//     axis reverses within a tick.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/path_item.hpp"
#include "motion/limits.hpp"
#include "motion/ramp.hpp"
#include "motion/segment_queue.hpp"

namespace cnclab::motion {

/// Integer steps of X, Y, Z, U in one tick.
using AxisSteps = std::array<std::int32_t, 4>;

/// What the operator wants right now; read anew in each tick.
struct Demand {
  double override_ratio = 1;  ///< potentiometer 0..1
  bool stop = false;          ///< brake with STOPVERZÖGERUNG and rest on the path
  bool single_block = false;  ///< rest at the next end of a block that can be reached by the ramp
};

/// What the follower did in (a part of) a tick.
struct Advance {
  double left_s = 0;           ///< not used yet: an event was reached before the tick was over
  bool moving = false;         ///< path speed > 0 at the end
  bool event_reached = false;  ///< the front of the queue is an event, and it may be done now
  bool block_ended = false;    ///< an item with ends_block was finished (motion only)
  bool held = false;           ///< rest at the end of a block because of `single_block` (motion only)
  bool starved = false;        ///< rest, nothing queued
};

/// Tick side of one path. Allocates nothing, waits for nothing.
class Follower {
 public:
  Follower(SegmentQueue& queue, const Limits& limits);

  /// Moves on by `time_s`: the whole tick, or what an event left of it. Events are not passed: the machine executes the
  /// front event, calls `pass_event` and then this again with `left_s`.
  Advance advance(double time_s, const Demand& demand) noexcept;
  /// Single block was switched on or off, maybe while an event lasts: where does it rest? `advance` asks by itself.
  void choose_rest(bool single_block) noexcept;
  /// The front event was done. True when single block rests behind it.
  bool pass_event() noexcept;

  /// Begins run `run` (Segment::run) at rest at `position`; earlier runs' segments are dropped, later ones wait.
  void begin(std::uint64_t run, const geometry::Point& position, const Limits& limits) noexcept;
  /// Stands still at once, without ramp (limit switch, power-off).
  void halt_now() noexcept;
  /// Forgets the queued path of this run and whatever still comes for it; the position stays.
  void abandon() noexcept;
  /// Drops at most some thousand segments of runs that are over; to be called in each tick.
  void drop_old_runs() noexcept;

  [[nodiscard]] const geometry::Point& position() const { return position_; }  ///< mm, path coordinates
  [[nodiscard]] double speed_mm_per_s() const { return speed_; }
  [[nodiscard]] const Limits& limits() const { return limits_; }
  /// The front segment of this run, nullptr when there is none.
  [[nodiscard]] const Segment* current() const noexcept { return of_this_run(queue_.popped_number()); }
  /// The item worked on last: its block and sequence.
  [[nodiscard]] geometry::SourceBlock source() const { return source_; }
  [[nodiscard]] std::uint64_t sequence() const { return sequence_; }
  [[nodiscard]] bool is_rapid() const { return is_rapid_; }                             ///< it is a G00
  [[nodiscard]] std::uint64_t finished_sequence() const { return finished_sequence_; }  ///< PathItem::sequence, 0 none
  /// Takes over a position while at rest (start of a run, reference run).
  void set_position(const geometry::Point& position) noexcept { position_ = position; }

 private:
  /// The end of a block at which single block will rest.
  struct Hold {
    bool is_chosen = false;
    std::uint64_t item = 0;    ///< the item that ends the block
    std::uint64_t motion = 0;  ///< the last motion up to there
    double at_mm = 0;          ///< on the odometer
  };
  /// How far the search for a block end has come.
  struct Search {
    bool has_begun = false, has_motion = false;
    std::uint64_t next = 0;
    std::uint64_t motion = 0;
    double at_mm = 0;
  };

  /// The row of ways from the front on at which the potentiometer does not act (M23), as far as it was looked at.
  struct FreeRow {
    bool has_begun = false;
    std::uint64_t next = 0;    ///< the first segment behind it
    std::uint64_t motion = 0;  ///< the last motion in it
    double ends_mm = 0;        ///< on the odometer
  };

  [[nodiscard]] const Segment* of_this_run(std::uint64_t number) const noexcept;
  [[nodiscard]] Course course_ahead(const Segment& segment, const Demand& demand, double time_s) const noexcept;
  [[nodiscard]] double override_envelope_sq(const Segment& segment, double ratio, double time_s) const noexcept;
  void extend_free_row() noexcept;
  [[nodiscard]] bool can_rest_at(const Search& place) const noexcept;
  void seek_hold() noexcept;
  void forget_hold() noexcept;
  void rest() noexcept;
  void work_on(const geometry::PathItem& item) noexcept;
  void finish_item(const geometry::PathItem& item, Advance& done) noexcept;
  [[nodiscard]] bool is_too_fast_behind(std::uint64_t number, double ratio) const noexcept;
  void finish_motion(const Segment& segment, double ratio, Advance& done) noexcept;
  void move(const Segment& segment, const Demand& demand, Advance& done) noexcept;
  void place_on_path() noexcept;

  SegmentQueue& queue_;
  Limits limits_;
  geometry::Point position_;
  std::uint64_t run_ = 0;            ///< 0: none, everything that waits is for later runs
  std::uint64_t abandoned_run_ = 0;  ///< this one and all before it are dropped
  double speed_ = 0;
  double way_ = 0;         ///< mm done of the front segment
  double odometer_ = 0;    ///< mm done in this run
  bool rest_due_ = false;  ///< this tick is to be spent at rest
  Hold hold_;
  Search search_;
  FreeRow free_row_;
  geometry::SourceBlock source_;
  std::uint64_t sequence_ = 0;
  bool is_rapid_ = false;
  std::uint64_t finished_sequence_ = 0;
};

}  // namespace cnclab::motion
