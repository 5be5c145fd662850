// One machine under control: the link between the lab thread, which plans and asks, and the tick, which moves.
//
//        lab thread                                        tick thread
//   queue / planner ── segments ──▶ ┌──────────────────────────────────┐ ── steps, signals ──▶ Machine
//   command() ──── bounded ring ──▶ │ Channel::tick: authority, events,│ ◀── switches, inputs ──
//   stop(), renew() ── atomics ───▶ │ Follower, limit switches, power  │
//   snapshot() ◀───── seqlock ───── └──────────────────────────────────┘
//
// What holds at all times
//  1. Nothing moves or switches on without a valid lease: its epoch is the current one and its expiry lies ahead. The
//     check stands here, where motion starts, not in the screens (architecture.md rule 1). A training machine has a
//     lease that never expires while its connection lives.
//  2. A stop is a level that the tick reads first; it cannot queue behind anything and is never lost (AUTH-006).
//  3. After a stop with a reason other than the operator's STOP the run is abandoned; nothing becomes active again
//     without a new `Start` under a valid lease (AUTH-009), but for the 1 mm back-off from a limit switch.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/path_item.hpp"
#include "machine/machine.hpp"
#include "machine/machine_data.hpp"
#include "motion/follower.hpp"
#include "motion/planner.hpp"
#include "motion/segment_queue.hpp"

namespace cnclab::machine {

/// The number of a grant of control (AUTH-002); 0 is nobody's.
enum class Epoch : std::uint64_t {};

enum class MotionState : std::uint8_t { standstill, moving, stopping, halted, off };

/// Why the last motion ended. The first cause wins until the next start.
enum class StopCause : std::uint8_t {
  none, operator_stop, program_end, programmed_halt, waiting_for_input, single_block,
  limit_switch, power_off, machine_halt, lease_ended, lease_expired, error,
};

// Commands from the lab thread; all but Abandon and PowerOff need a valid epoch.
struct BeginRun { Epoch epoch{}; };          ///< a new path stands in the queue (or comes); wait for START
struct Go { Epoch epoch{}; };                ///< START: run, go on after STOP, release a halt or a wait
struct Abandon {};                           ///< forget the path, the state is STOP; the position stays
struct SwitchSpindle { Epoch epoch{}; geometry::Spindle spindle; };
struct SwitchCoolant { Epoch epoch{}; bool on = false; };
struct SetIstwert { Epoch epoch{}; std::array<bool, 3> axes{}; std::array<double, 3> value_mm{}; };
/// Manual motion in a direction until stop (HA, TI); speed = override × F MAX.
struct Jog { Epoch epoch{}; std::array<std::int8_t, 3> direction{}; };
struct RunReference { Epoch epoch{}; std::array<std::int8_t, 3> direction{}; };
struct PowerOff {};
struct PowerOn {};
using Command = std::variant<BeginRun, Go, Abandon, SwitchSpindle, SwitchCoolant, SetIstwert, Jog, RunReference,
                             PowerOff, PowerOn>;

/// Everything the lab thread may want to know, as of one tick.
struct Snapshot {
  std::uint64_t tick = 0;
  MotionState state = MotionState::off;
  StopCause cause = StopCause::none;
  bool started = false;                        ///< START state: from START until rest after STOP or the end
  std::array<std::int64_t, 4> steps{};         ///< actual position from where the channel began, X Y Z U
  std::array<double, 4> istwert_mm{};          ///< counted steps, as the operator reads them (G68 applied)
  std::array<double, 4> path_mm{};             ///< actual position in path coordinates, for traces
  double speed_mm_per_min = 0;
  std::uint64_t sequence = 0;                  ///< PathItem::sequence being done, or done last
  geometry::SourceBlock source;                ///< its block
  std::uint64_t finished_sequence = 0;         ///< last block done completely
  geometry::SpindleTurn spindle = geometry::SpindleTurn::off;
  std::int32_t spindle_rpm = 0;
  bool coolant = false;
  std::array<std::uint8_t, 2> inputs{}, outputs{};
  bool input_1 = false;
  std::array<bool, 4> limit{};                 ///< a switch of this axis is active
  std::uint8_t limit_axis = 0xFF;              ///< axis of the last ENDSCHALTER stop, 0xFF none
  bool is_referenced = false;
  std::uint64_t signals = 0;                   ///< acoustic signals so far
  std::uint64_t refused = 0;                   ///< commands refused for their epoch so far
};

/// One tick as it really was, for traces; trivially copyable.
struct TracePoint {
  std::uint64_t tick = 0;
  std::array<std::int32_t, 4> steps{};  ///< position in path coordinates, X Y Z U
  float speed_mm_per_min = 0;
  std::int32_t spindle_rpm = 0;         ///< negative counterclockwise
  geometry::SourceBlock source;
};

class Channel {
 public:
  /// machine   outlives the channel
  Channel(Machine& machine, const MachineData& data);

  // --- lab thread ---------------------------------------------------------------------------------------------
  [[nodiscard]] motion::SegmentQueue& queue() { return queue_; }
  /// False when the command ring is full (64 waiting): the lab treats that as a hung tick.
  [[nodiscard]] bool command(const Command& command);
  /// Level: brake on the path and rest. Cleared by the next accepted Go.
  void stop(StopCause cause);
  void set_override(double ratio);           ///< potentiometer 0..1
  void set_single_block(bool on);
  /// Grants an epoch until `expiry_ns` of the tick's clock, or renews it. Epochs never go back.
  void grant(Epoch epoch, std::int64_t expiry_ns);
  /// Takes the grant away: stop on the ramp, spindle and coolant off, run abandoned.
  void revoke(StopCause cause);
  /// New machine data, at rest only (START takes a snapshot of them, DEC-28).
  [[nodiscard]] bool set_data(const MachineData& data);
  [[nodiscard]] Snapshot snapshot() const;
  /// From now on every tick of a run (START state) is kept in a bounded ring until it is drained; off by default.
  void record_trace(bool on);
  /// Appends what was traced since the last call; returns ticks that were lost because nobody drained in time.
  std::uint64_t drain_trace(std::vector<TracePoint>& out);

  // --- tick side ----------------------------------------------------------------------------------------------
  /// One tick of `tick_s` at `now_ns` (monotonic). Allocates, locks and waits for nothing.
  void tick(std::int64_t now_ns, double tick_s) noexcept;

 private:
  Machine& machine_;
  motion::SegmentQueue queue_;
};

inline constexpr std::int64_t kNeverExpires = INT64_MAX;

}  // namespace cnclab::machine
