// One machine under control: the link between the lab thread, which plans and asks, and the tick, which moves.
//
//        lab thread                                        tick thread
//   begin_run(), planner() ───────▶ ┌──────────────────────────────────┐ ── steps, signals ──▶ Machine
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
//     without a new `Go` under a valid lease (AUTH-009), but for the 1 mm back-off from a limit switch.
//  4. Runs have numbers that only grow. `begin_run` makes one; what is appended to the planner carries it, and the tick
//     drops everything of a run that was abandoned, also what the lab thread pushes in the same moment. So nothing of
//     an old run can ever move under a later Go.
//  5. Start commands (Go, Jog, RunReference, spindle or coolant on) remember how many stops there had been when they
//     were given; one that is older than a stop is dropped. So a START that waits in the ring cannot undo a STOP.
//
// A run, seen from the lab thread
//   auto* planner = channel.begin_run(epoch, start);   // at rest; nothing moves yet
//   planner->append(item) …; planner->plan();          // again and again while the run lasts: at most 65 536 ahead
//   channel.command(Go{epoch});                        // START; again after STOP, EINZELSATZ, halts
//   channel.snapshot()                                 // until !started; run_active tells whether a rest is kept
//   (D-39)
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
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

enum class MotionState : std::uint8_t {
  standstill,
  moving,    ///< a run, manual motion or reference run is under way; also in a dwell and with the potentiometer at 0
  stopping,  ///< braking, or backing off a limit switch
  halted,    ///< M00, M01, M16 …: the program waits in START state; Go releases it
  off,       ///< drives without current
};

/// Why the last motion ended. The first cause wins until the next start.
enum class StopCause : std::uint8_t {
  none,
  operator_stop,
  program_end,
  programmed_halt,
  waiting_for_input,
  single_block,
  limit_switch,
  power_off,
  machine_halt,
  lease_ended,
  lease_expired,
  error,
};

/// True where nothing of the run is kept: START begins anew.
[[nodiscard]] bool abandons_run(StopCause cause);

// Commands from the lab thread; all but Abandon, PowerOff and PowerOn need a valid epoch.
struct Go {
  Epoch epoch{};
};  ///< START: run, go on after STOP, release a halt or a wait
/// Forget the path (brakes with the STOP ramp first); the state is STOP, the position stays.
struct Abandon {};
struct SwitchSpindle {
  Epoch epoch{};
  geometry::Spindle spindle;
};
struct SwitchCoolant {
  Epoch epoch{};
  bool on = false;
};
struct SetIstwert {
  Epoch epoch{};
  std::array<bool, 3> axes{};
  std::array<double, 3> value_mm{};
};
/// Manual motion in a direction until stop (HA, TI); path speed = override × F MAX, at 0 slow single steps (DEC-40).
/// Refused towards an active limit switch (D-117). A run that was kept is abandoned.
struct Jog {
  Epoch epoch{};
  std::array<std::int8_t, 3> direction{};
};
/// Named axes (direction != 0) to their limit switches, 1 mm back, Istwert 0 (D-11); a stop ends it.
struct RunReference {
  Epoch epoch{};
  std::array<std::int8_t, 3> direction{};
};
struct PowerOff {};
struct PowerOn {};
using Command =
    std::variant<Abandon, Go, SwitchSpindle, SwitchCoolant, SetIstwert, Jog, RunReference, PowerOff, PowerOn>;

/// Input 1 in a tick in which blocks began (D-56).
struct BlockStart {
  std::uint64_t sequence = 0;  ///< the last block that began in this tick; 0: the START that took the run up
  bool input_1 = false;        ///< as that tick saw it
};

/// Everything the lab thread may want to know, as of one tick.
struct Snapshot {
  std::uint64_t tick = 0;
  MotionState state = MotionState::off;
  StopCause cause = StopCause::none;
  bool started = false;                       ///< START state: from START until rest after STOP or the end
  std::uint64_t run = 0;                      ///< number of the run that the tick has taken up last
  bool run_active = false;                    ///< it was neither ended nor abandoned: Go starts it or goes on with it
  std::uint64_t orders = 0;                   ///< begin_run, command, set_data taken so far (see is_settled)
  Epoch epoch{};                              ///< the lease that the tick knows
  bool lease_valid = false;                   ///< false once it was revoked or has expired; it never comes back
  std::array<std::int64_t, 4> steps{};        ///< actual position from where the channel began, X Y Z U
  std::array<double, 4> istwert_mm{};         ///< counted steps, as the operator reads them (G68 applied)
  std::array<double, 4> path_mm{};            ///< exact position in the coordinates of the run's path
  std::array<std::int64_t, 4> start_steps{};  ///< where the last START found the axes …
  std::array<double, 4> start_istwert_mm{};   ///< … and what that place was called
  double speed_mm_per_min = 0;
  std::uint64_t sequence = 0;           ///< PathItem::sequence being done, or done last
  geometry::SourceBlock source;         ///< its block
  std::uint64_t finished_sequence = 0;  ///< last block done completely
  geometry::SpindleTurn spindle = geometry::SpindleTurn::off;
  std::int32_t spindle_rpm = 0;
  bool coolant = false;
  std::array<std::uint8_t, 2> inputs{}, outputs{};
  bool input_1 = false;
  std::array<BlockStart, 4> block_starts{};  ///< of this run, oldest first; see input_1_at_start
  std::uint8_t block_start_count = 0;        ///< how many of them there are
  std::array<bool, 4> limit{};               ///< a switch of this axis is active
  std::uint8_t limit_axis = 0xFF;  ///< axis of the ENDSCHALTER stop since the last start, whatever the cause; 0xFF none
  bool is_referenced = false;
  std::array<std::int64_t, 3> reference_steps{};  ///< where the last reference run left each axis
  std::uint64_t references_lost = 0;              ///< how often a known position was lost so far
  int tool = 0;               ///< T that was called last: the tool in the spindle (DEC-29), 0 none yet
  std::uint64_t signals = 0;  ///< acoustic signals so far
  std::uint64_t refused = 0;  ///< commands refused for their epoch so far
  std::uint64_t dropped = 0;  ///< commands that did not fit the state (or came before a stop) so far
};

/// Input 1 as it was in the tick in which block `sequence` (PathItem::sequence; 0 = START) of the run began, for G21
/// and G23. Nothing before that block has begun. Blocks that began in one tick share an entry; of more than four ticks
/// with starts the older ones are forgotten, and the oldest known answers for them.
[[nodiscard]] std::optional<bool> input_1_at_start(const Snapshot& now, std::uint64_t sequence);

/// What acted on a run in one tick, as the tick itself saw it: with it a run can be played again (STO-007).
struct TickLevels {
  float override_ratio = 1;  ///< potentiometer 0..1
  /// Bit 0 Input 1, 8..15 card 1, 16..23 card 2: as the tick found them, and as they came back from the machine. Only
  /// behind a rest, which is not traced, a tick finds others than the one before it brought.
  std::uint32_t inputs_found = 0, inputs = 0;
  std::uint16_t stops = 0;  ///< bit = StopCause, those heard in this tick
  bool single_block = false;
  bool go = false;                       ///< a START took effect: begin, going on, release of a halt
  std::array<std::int8_t, 3> by_hand{};  ///< directions of a Jog or RunReference that took effect
  bool is_reference = false;             ///< it was a RunReference
  /// How often path has come that had waited (`note_resumption`): up to this tick, and of those since the tick before
  /// or, behind a rest, since that began.
  std::uint64_t resumption = 0;
  std::uint32_t resumptions = 0;
  friend bool operator==(const TickLevels&, const TickLevels&) = default;
};

/// One tick as it really was, for traces; trivially copyable.
struct TracePoint {
  std::uint64_t tick = 0;
  std::array<std::int32_t, 4> steps{};  ///< position in path coordinates, by hand in those of the Istwert; X Y Z U
  float speed_mm_per_min = 0;
  std::int32_t spindle_rpm = 0;  ///< negative counterclockwise
  geometry::SourceBlock source;
  TickLevels levels;
};

struct CutFeed;

class Channel {
 public:
  /// machine   outlives the channel; has seen no tick yet
  Channel(Machine& machine, const MachineData& data);
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  // --- lab thread ---------------------------------------------------------------------------------------------
  /// Begins a run from `position` (path coordinates of where the machine stands now) with the machine data that hold
  /// now (DEC-28). A former run is abandoned. Append to the planner, `plan()`, then command(Go).
  /// is_program  a new workpiece is put under the tool when it starts (DEC-24); HANDEINGABE goes on in the old one
  /// returns  the planner, restarted; nullptr when the command ring is full
  /// The tick takes the run up only at rest and under a valid lease: snapshot().run == planner->run() tells.
  [[nodiscard]] motion::Planner* begin_run(Epoch epoch, const geometry::Point& position, bool is_program = true);
  /// The planner of the newest run.
  [[nodiscard]] motion::Planner& planner();
  [[nodiscard]] const motion::SegmentQueue& queue() const;
  /// False when the command ring is full (64 waiting): the lab treats that as a hung tick.
  [[nodiscard]] bool command(const Command& command);
  /// True when the tick has taken everything given so far and snapshot() shows its effect: ask before concluding from
  /// `started == false` that a run is over.
  [[nodiscard]] bool is_settled() const;
  /// Level: brake on the path and rest. Cleared by the next accepted Go, Jog or RunReference. Every cause but
  /// operator_stop also switches spindle and coolant off and abandons the run.
  void stop(StopCause cause);
  /// Any thread, for the watchdog: the machine's `cut`, and a power-off as soon as the tick is alive again.
  void cut() noexcept;
  /// MASCHINE HALT: stops as stop(machine_halt), and every start command is dropped until it is off again (AUTH-006).
  void latch(bool on);
  void set_override(double ratio);  ///< potentiometer 0..1
  void set_single_block(bool on);
  /// The path goes on behind a question, or whatever else it had to wait for: the tick that finds it is traced, since
  /// the way depends on it.
  void note_resumption(bool input_1);
  /// Input 1 as it was answered at the resumption of that number (`TickLevels::resumption`), which is one of the newest
  /// kResumptionsKept.
  [[nodiscard]] bool answer_at_resumption(std::uint64_t number) const;
  /// These outputs (bits of cards 1 and 2) go off with the power; the others keep their state, as at stops (AUTH-003).
  void set_outputs_off_at_power_off(const std::array<std::uint8_t, 2>& cards);
  /// Grants an epoch until `expiry_ns` of the tick's clock, or renews it. Epochs never go back: an older one, and one
  /// that was revoked or that the tick has seen expire, stays invalid.
  void grant(Epoch epoch, std::int64_t expiry_ns);
  /// Takes the grant away: stop on the ramp, spindle and coolant off, run abandoned.
  void revoke(StopCause cause);
  /// New machine data, at rest only; runs take them up when they begin (DEC-28). False while started or moving.
  [[nodiscard]] bool set_data(const MachineData& data);
  [[nodiscard]] Snapshot snapshot() const;
  /// From now on every tick of a run (START state, and each tick in which a START took effect, even one that rests in
  /// the same tick) is kept in a bounded ring until it is drained; off by default.
  void record_trace(bool on);
  /// Appends what was traced since the last call; returns ticks that were lost because nobody drained in time.
  std::uint64_t drain_trace(std::vector<TracePoint>& out);

  /// From now on the tool's way is pushed into this feed, in programs and by hand; nullptr: no longer. What does not
  /// fit is dropped and counted there. Change it only while the tick does not run, or to a feed that outlives the
  /// channel.
  void feed_cuts(CutFeed* feed);

  // --- tick side ----------------------------------------------------------------------------------------------
  /// One tick of `tick_s` at `now_ns` (monotonic). Allocates, locks and waits for nothing.
  void tick(std::int64_t now_ns, double tick_s) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

inline constexpr std::int64_t kNeverExpires = INT64_MAX;
/// Twice the blocks that a run reads ahead while it rests: each ends one wait at most, and nobody asks before START.
inline constexpr std::size_t kResumptionsKept = 16'384;

}  // namespace cnclab::machine
