// A recorded run once more, offline: same programs, data, start and events, tick by tick, and its steps compared
// (STO-007).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/types.hpp"
#include "machine/machine_data.hpp"
#include "panel/run/run.hpp"

namespace cnclab::lab {

/// Everything of a run that its trajectory follows from, and what the trajectory was.
struct RecordedRun {
  panel::RunOrder order;                                 ///< of a motion by hand only `data` counts
  std::optional<std::array<double, 4>> hand_istwert_mm;  ///< a motion by hand, and where it began
  bool is_lab_machine = false;
  machine::MachineData machine_data;    ///< of the machine itself
  std::array<std::int64_t, 4> steps{};  ///< where it stood
  std::vector<db::RunEvent> events;
  std::uint64_t ticks = 0;
  std::string digest;
  std::vector<std::array<std::int32_t, 4>> trace;  ///< positions of each tick; empty where none was kept
};

struct ReplayResult {
  bool same = false;
  std::uint64_t ticks = 0;                       ///< that the replay took
  double largest_deviation_mm = 0;               ///< of any axis in any tick; 0 where there is no trace to compare with
  std::string detail;                            ///< where it differs first; empty if nowhere
  std::vector<machine::TracePoint> points = {};  ///< the way that the replay took, tick after tick
};

/// A second of machine time takes about a millisecond. Any thread; no clock, no I/O.
[[nodiscard]] ReplayResult replay(const RecordedRun& run);

}  // namespace cnclab::lab
