// Plays a random run on a real channel and checks every tick.
#pragma once

#include <string>

#include "channel_rig.hpp"
#include "limits_checker.hpp"
#include "random_run.hpp"

namespace cnclab::machine {

/// What became of a run, for the statistics of a test that must not pass by doing nothing.
struct Played {
  std::string broken;  ///< the rule that was broken and in which tick; empty when none was
  bool reached_end = false;
  int ticks = 0, moving_ticks = 0, rests_after_stop = 0, limit_stops = 0, program_references = 0;
};

class RunPlayer {
 public:
  explicit RunPlayer(const RandomRun& run);
  [[nodiscard]] Played play();

 private:
  void begin();
  void feed();
  void perform(const Action& action);
  void order(const Command& command, Doing begins);
  void end_lease();
  void must_rest();
  void tick();
  void conclude_tick(const Snapshot& before, const Snapshot& now);
  void note_orders(const Snapshot& before, const Snapshot& now);
  [[nodiscard]] bool is_in_reference(const Snapshot& before) const;
  void guard_progress(const Snapshot& before, const Snapshot& now);
  void release_all();
  void recover();
  void finish();
  [[nodiscard]] bool is_at_rest() const { return seen_.state == MotionState::standstill; }

  const RandomRun& run_;
  MachineData data_;
  std::vector<geometry::PathItem> items_;
  WatchedMachine machine_;
  Channel channel_;
  LimitsChecker checker_;
  Played played_;
  Snapshot seen_;
  std::int64_t now_ns_ = 0, expiry_ns_ = kNeverExpires;
  std::uint64_t epoch_ = 1;
  bool has_lease_ = true, must_rest_ = false, has_run_ = false, begin_due_ = false, was_fault_ = false;
  bool cut_ = false, ordered_ = false, is_overtaken_ = false;
  Doing doing_ = Doing::nothing, due_ = Doing::nothing;
  double ratio_ = 1;
  std::size_t fed_ = 0;
  int fault_ticks_ = 0, stuck_ticks_ = 0;
};

}  // namespace cnclab::machine
