// One run of a program on the simulated machine in virtual time: no clock, no thread, one call per tick.
#pragma once

#include <cstdint>
#include <deque>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "machine/channel.hpp"
#include "machine/simulated_machine.hpp"
#include "program/checked_path.hpp"
#include "tool/job.hpp"

namespace cnclab::tool {

/// How a run ended, with the names of the summary.
enum class RunEnd : std::uint8_t { program_end, halt, wait, limit_switch, error, block_limit, time_limit };
[[nodiscard]] std::string_view name_of(RunEnd end);

/// An event as it happened.
struct TimedItem {
  double time_s = 0;
  geometry::PathItem item;
};

struct RunSummary {
  RunEnd ended = RunEnd::program_end;
  std::uint64_t blocks = 0;  ///< done completely
  double machine_time_s = 0;
  double path_mm = 0;
  std::array<double, 4> istwert_mm{};  ///< as the operator reads it at the end
  std::vector<TimedItem> events;       ///< the first `kMostEvents`
  std::uint64_t events_left_off = 0;
  std::optional<std::uint8_t> limit_axis;  ///< X Y Z U as 0..3
  std::optional<language::Error> error;
};

/// A looping program makes events without end; a summary keeps so many.
inline constexpr std::size_t kMostEvents = 10'000;

/// Writes down every tick's steps on their way to the machine.
class StepRecorder final : public machine::Machine {
 public:
  StepRecorder(machine::Machine& machine, std::ostream* out) : machine_(machine), out_(out) {}
  machine::Inputs exchange(const machine::Outputs& outputs) noexcept override;

 private:
  machine::Machine& machine_;
  std::ostream* out_;
};

/// Where the run writes while it goes; null where nobody asked.
struct Recording {
  std::ostream* trace = nullptr;  ///< CSV, one row per tick
  std::ostream* steps = nullptr;  ///< four little-endian int32 per tick
};

class Simulation {
 public:
  Simulation(const Job& job, const Options& options, Recording recording);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Runs to the end. errors: the program cannot begin
  [[nodiscard]] std::expected<RunSummary, language::Error> run();

 private:
  struct Waiting {
    geometry::PathItem item;
    double length_mm = 0;
  };

  void feed(program::CheckedPath& path, motion::Planner& planner);
  bool take_block(program::CheckedPath& path);
  void account(const machine::Snapshot& now);
  void note_event(const geometry::PathItem& item);
  void write_trace();
  void conclude(RunEnd end, const machine::Snapshot& last);
  [[nodiscard]] std::optional<RunEnd> end_of(const machine::Snapshot& now) const;
  [[nodiscard]] double time_s() const;

  const Job& job_;
  const Options& options_;
  Recording recording_;
  machine::SimulatedMachine machine_;
  StepRecorder recorder_;
  machine::Channel channel_;
  std::deque<Waiting> waiting_;             ///< pushed and not yet passed
  std::deque<geometry::PathItem> pending_;  ///< finished and not yet pushed: a contour comes as a whole
  std::uint64_t passed_ = 0;                ///< segments that the machine has passed
  std::uint64_t fed_blocks_ = 0;
  bool all_fed_ = false;
  double way_in_element_mm_ = 0;
  std::uint64_t ticks_ = 0;
  std::vector<machine::TracePoint> trace_;
  RunSummary summary_;
};

}  // namespace cnclab::tool
