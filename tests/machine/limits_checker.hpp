// The rules of motion, checked tick by tick on what really came out of a channel: positions, steps, speed.
//
// Rules, with their sources (issue's "limits as invariants", DEC-20 to DEC-23, architecture.md Motion)
//   1  each axis lies within half a step of the exact position, and that lies on the commanded path
//   2  path speed <= programmed feed × potentiometer <= F MAX, but for braking towards a potentiometer turned back
//   3  path acceleration <= RAMPE; from and to rest a jump of at most F START/STOP
//   4  at a joint no axis' velocity steps by more than F START/STOP; on arcs v²/r <= RAMPE
//   5  what has to stop slows down in every tick, at least by STOPVERZÖGERUNG
//   6  without a valid lease nothing begins, spindle and coolant are off
//   7  stops without ramp at limit switches, power-off and faults alone
//   8  the reported speed is the one really travelled
//   9  what has to stop rests within its braking time: its speed over STOPVERZÖGERUNG (of the axis' share of it in a
//      reference run), and two ticks
#pragma once

#include <optional>
#include <string>

#include "machine/channel.hpp"
#include "path_oracle.hpp"

namespace cnclab::machine {

enum class Doing : std::uint8_t { nothing, run, hand, reference };

/// What the test knows about a tick, from its own orders.
struct Tick {
  Snapshot before, now;
  Outputs sent;
  Doing doing = Doing::nothing;
  double ratio = 1;
  bool must_rest = false;  ///< a stop was given and no START since
  bool has_lease = true;
  bool is_cut = false;  ///< power-off or fault, in this tick or the one before
};

class LimitsChecker {
 public:
  LimitsChecker(PathOracle path, const motion::Limits& limits, double tick_s)
      : path_(std::move(path)), limits_(limits), tick_s_(tick_s) {}

  /// A run begins at the path's first point, where the axes stand at `steps`.
  void begin_run(const std::array<std::int64_t, 4>& steps, const geometry::Point& start);
  /// A reference run of the program is over: the path goes on where the axes stand now, at `steps`.
  void anchor(const std::array<std::int64_t, 4>& steps, std::size_t index);
  /// The rule that this tick breaks, in words; empty when it keeps to all of them.
  [[nodiscard]] std::string broken_rule(const Tick& tick);

  [[nodiscard]] const PathOracle& path() const { return path_; }

 private:
  struct Place {
    std::size_t index = 0;  ///< of the motion item, path_.size() before the first
    double way_mm = 0;
    double total_mm = 0;
  };

  [[nodiscard]] std::string rest_rule(const Tick& tick) const;
  [[nodiscard]] std::string authority_rule(const Tick& tick) const;
  [[nodiscard]] std::string ramp_rule(const Tick& tick) const;
  [[nodiscard]] std::string stop_rule(const Tick& tick) const;
  [[nodiscard]] std::string due_rule(const Tick& tick);
  [[nodiscard]] std::string manual_rule(const Tick& tick);
  [[nodiscard]] std::string run_rule(const Tick& tick);
  [[nodiscard]] std::string half_step_rule(const Tick& tick) const;
  [[nodiscard]] std::string locate(const Tick& tick, Place& place) const;
  [[nodiscard]] std::string speed_rule(const Tick& tick, const Place& place);
  [[nodiscard]] std::string joint_rule(const Tick& tick, const Place& place) const;
  [[nodiscard]] std::string honesty_rule(const Tick& tick, const Place& place) const;
  [[nodiscard]] double cap(std::size_t index, double ratio) const;
  void lower_ceiling(const Tick& tick);

  PathOracle path_;
  motion::Limits limits_;
  double tick_s_;
  geometry::Point start_;
  std::array<std::int64_t, 4> origin_{};
  Place place_;
  double ceiling_ = 0;                ///< speed from which braking towards a lowered potentiometer goes on, mm/s
  double ratio_before_ = 1;           ///< potentiometer in the last tick
  std::optional<int> ticks_to_rest_;  ///< while something has to stop
};

}  // namespace cnclab::machine
