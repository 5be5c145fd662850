// The tick side of a channel: authority first, then stops, orders, switches, motion, and what goes out.
//
// Everything here runs in the tick thread: it allocates nothing, locks nothing, waits for nothing. State is in few
// plain members; which of them matter follows from `activity_`:
//
//   none ──Go──▶ run ──STOP, EINZELSATZ, end──▶ none          run ──limit switch──▶ back_off ──1 mm──▶ none
//   none ──Jog──▶ hand ──stop, switch──▶ none                 none ──RunReference──▶ reference ──all done──▶ none
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "machine/axis_counters.hpp"
#include "machine/channel.hpp"
#include "machine/channel_mailbox.hpp"
#include "machine/manual_drives.hpp"

namespace cnclab::machine {

class ChannelTick {
 public:
  ChannelTick(Machine& machine, motion::SegmentQueue& queue, Mailbox& mail, const motion::Limits& limits);

  void tick(std::int64_t now_ns, double tick_s) noexcept;

 private:
  enum class Activity : std::uint8_t { none, run, hand, reference, back_off };
  enum class Waiting : std::uint8_t { no, dwell, halt, input, reference };
  struct Run {
    std::uint64_t number = 0;
    bool is_active = false;         ///< neither ended nor abandoned
    bool anchor_due = false;        ///< the next motion's start says what the present place is called
    Waiting waiting = Waiting::no;  ///< for what the front event waits; kept through STOP (D-39)
    double dwell_left_s = 0;
    std::array<std::int64_t, 4> origin{};  ///< steps at path coordinate 0
    std::array<BlockStart, 4> starts{};    ///< oldest first
    std::uint8_t start_count = 0;
    bool has_begun = false;  ///< its first START was taken
    bool is_program = true;
  };

  // channel_authority.cpp: who may, and what stops
  void guard_lease(std::int64_t now_ns) noexcept;
  [[nodiscard]] bool may(Epoch epoch) noexcept;
  void heed_stops() noexcept;
  void heed(StopCause cause) noexcept;
  void stop_for(StopCause cause) noexcept;
  void note_cause(StopCause cause) noexcept;
  void come_to_rest(StopCause cause) noexcept;
  void abandon_run() noexcept;
  void heed_machine() noexcept;
  void stop_at_switches(const Directions& active) noexcept;
  void power_off() noexcept;
  void lose_reference() noexcept;
  void lose_reference_if_fast() noexcept;
  void switch_off_tools() noexcept;

  // channel_orders.cpp: commands
  void take_orders() noexcept;
  void obey(const Command& command, bool is_fresh) noexcept;
  void obey(const BeginRun& order, bool is_fresh) noexcept;
  void obey(const UseLimits& order, bool is_fresh) noexcept;
  [[nodiscard]] bool may_start(Epoch epoch, bool is_fresh) noexcept;
  void go(Epoch epoch, bool is_fresh) noexcept;
  void start_hand(const Jog& jog, bool is_fresh) noexcept;
  void start_reference(const RunReference& reference, bool is_fresh) noexcept;
  void set_istwert(const SetIstwert& command) noexcept;
  void settle_limits() noexcept;
  void use_limits(const motion::Limits& limits) noexcept;
  void begin_activity(Activity activity) noexcept;
  void begin_by_hand(Activity activity, const Directions& directions) noexcept;
  void begin_workpiece() noexcept;

  // channel_run.cpp: the program's path
  void run_tick(double tick_s, const motion::Demand& demand) noexcept;
  [[nodiscard]] bool wait_tick(double tick_s) noexcept;
  void pass_event() noexcept;
  void note_block_start() noexcept;
  void anchor_path() noexcept;
  void anchor_at(const geometry::Point& place) noexcept;
  [[nodiscard]] bool place_axes(double tick_s) noexcept;
  void begin_program_reference(const geometry::Reference& reference) noexcept;
  void end_program_reference() noexcept;
  void note_reference(std::size_t axis, double istwert_mm) noexcept;

  // channel_events.cpp: what stands between the motions
  struct Execution;
  [[nodiscard]] bool is_void(const motion::Segment& event) const noexcept;
  [[nodiscard]] bool execute(const motion::Segment& event) noexcept;
  [[nodiscard]] bool is_input_active(const geometry::Wait& wait) const noexcept;
  void set_output(const geometry::Output& output) noexcept;

  // channel_tick.cpp
  void move(double tick_s) noexcept;
  void hand_tick(double tick_s, double ratio) noexcept;
  void reference_tick(double tick_s, double ratio) noexcept;
  void back_off_tick(double tick_s) noexcept;
  void send(const std::array<std::int64_t, 4>& before) noexcept;
  void report() noexcept;
  void trace(const Snapshot& state) noexcept;
  void show_tool() noexcept;
  [[nodiscard]] MotionState motion_state() const noexcept;
  [[nodiscard]] std::array<double, 4> path_mm() const noexcept;

  Machine& machine_;
  Mailbox& mail_;
  motion::Follower follower_;
  motion::Limits limits_;
  std::optional<motion::Limits> limits_due_;
  AxisCounters counters_;
  HandDrive hand_;
  SwitchDrive switches_;
  Inputs inputs_, inputs_before_;
  Outputs outputs_;

  Lease lease_;
  bool lease_valid_ = false;
  std::uint64_t expired_up_to_ = 0;
  Epoch holder_{};  ///< under which whatever is active was started; 0: nothing is

  Activity activity_ = Activity::none;
  Activity activity_before_ = Activity::none;  ///< in the last tick's motion: the switches answer to that
  Run run_;
  bool started_ = false;
  bool braking_ = false;
  bool abandon_at_rest_ = false;
  StopCause cause_ = StopCause::none;
  double speed_mm_per_s_ = 0;
  geometry::SourceBlock source_;
  std::uint64_t sequence_ = 0;
  struct Tool {
    int number = 0;
    double radius_mm = 0, length_mm = 0;
  };
  /// Whence the tool's way is counted for the workpiece: the place and its name when the program started.
  struct CutBase {
    std::array<std::int64_t, 4> steps{};
    std::array<double, 3> mm{};
    bool is_set = false;
    bool is_new = false;  ///< not told yet
    bool has_gap = false;
  };
  Tool tool_;
  CutBase cut_base_;
  std::array<bool, 3> referenced_{};
  std::array<std::int64_t, 3> reference_steps_{};
  std::array<std::int64_t, 4> start_steps_{};
  std::array<double, 4> start_istwert_mm_{};
  std::uint64_t references_lost_ = 0;
  std::uint8_t limit_axis_ = 0xFF;
  std::uint64_t tick_ = 0, stops_seen_ = 0, orders_ = 0, signals_ = 0, refused_ = 0, dropped_ = 0;
  TickLevels levels_;  ///< of this tick
  std::uint64_t resumptions_seen_ = 0;
  bool was_started_ = false;  ///< in the last tick: the tick in which a run ends is traced too
};

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

}  // namespace cnclab::machine
