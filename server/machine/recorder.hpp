// Recording a run at the seam, and feeding a recorded run back to the control or to a machine.
//
//   record     control ──▶ MachineRecorder ──▶ machine           bytes (recording.hpp)
//   replay 1   control ──▶ ReplayMachine                         the recorded inputs come back, outputs are compared
//   replay 2   play(bytes, machine)                              the recorded outputs go out, inputs are compared
//
// Replay 1 shows that the control does the same again when the machine answers the same; replay 2 runs a recorded run
// on a simulated machine, for pictures and workpieces.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <expected>
#include <optional>
#include <string_view>
#include <vector>

#include "machine/recording.hpp"

namespace cnclab::machine {

/// Passes everything on and keeps it. Bounded: when the memory is used up it goes on passing, and says so.
class MachineRecorder final : public Machine {
 public:
  /// 16 MiB are more than an hour of milling. Never less than the header.
  static constexpr std::size_t kUsualBytes = 16U << 20U;

  /// machine   outlives the recorder
  explicit MachineRecorder(Machine& machine, std::size_t most_bytes = kUsualBytes);

  Inputs exchange(const Outputs& outputs) noexcept override;
  void cut() noexcept override { machine_.cut(); }

  /// Any thread: what was recorded until now, whole ticks.
  [[nodiscard]] std::vector<std::uint8_t> bytes() const;
  /// Any thread: ticks that did not fit any more.
  [[nodiscard]] std::uint64_t ticks_lost() const { return lost_.load(std::memory_order_relaxed); }

 private:
  Machine& machine_;
  std::vector<std::uint8_t> memory_;  ///< of fixed size
  RecordingWriter writer_;
  std::atomic<std::size_t> size_{0};
  std::atomic<std::uint64_t> lost_{0};
};

/// Where a replay first left the recording.
struct Divergence {
  std::uint64_t tick = 0;  ///< from 1
  RecordedTick recorded, replayed;
};

/// How a replay went.
struct ReplayReport {
  std::uint64_t ticks = 0;      ///< of the recording that were replayed
  std::uint64_t beyond = 0;     ///< ticks after its end
  std::uint64_t diverging = 0;  ///< ticks that differ
  std::optional<Divergence> first;
  std::string_view fault;  ///< the recording itself is damaged from `ticks` on; empty where it is not
};

/// The machine of a recorded run: answers tick by tick as the real one did, whatever it is told.
///
/// Behind the recording's end, or its first damaged tick, it answers with the last inputs.
class ReplayMachine final : public Machine {
 public:
  /// bytes   outlive the machine
  explicit ReplayMachine(std::span<const std::uint8_t> bytes) : reader_(bytes) {}

  Inputs exchange(const Outputs& outputs) noexcept override;

  /// Tick side, or after the last tick.
  [[nodiscard]] const ReplayReport& report() const { return report_; }

 private:
  RecordingReader reader_;
  Inputs inputs_;
  ReplayReport report_;
};

/// Sends the recorded outputs to a machine, as fast as it takes them.
[[nodiscard]] ReplayReport play(std::span<const std::uint8_t> bytes, Machine& machine);

}  // namespace cnclab::machine
