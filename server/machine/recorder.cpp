// Both ways through a recording.
#include "machine/recorder.hpp"

#include <algorithm>

namespace cnclab::machine {

namespace {

void note(ReplayReport& report, const RecordedTick& recorded, const RecordedTick& replayed) {
  ++report.ticks;
  if (recorded == replayed) return;
  ++report.diverging;
  if (!report.first) report.first = Divergence{report.ticks, recorded, replayed};
}

}  // namespace

MachineRecorder::MachineRecorder(Machine& machine, std::size_t most_bytes)
    : machine_(machine), memory_(std::max(most_bytes, kRecordingHeader)), writer_(memory_), size_(writer_.size()) {}

Inputs MachineRecorder::exchange(const Outputs& outputs) noexcept {
  const Inputs inputs = machine_.exchange(outputs);
  if (writer_.write({outputs, inputs})) {
    size_.store(writer_.size(), std::memory_order_release);
  } else {
    lost_.fetch_add(1, std::memory_order_relaxed);
  }
  return inputs;
}

std::vector<std::uint8_t> MachineRecorder::bytes() const {
  const auto size = static_cast<std::ptrdiff_t>(size_.load(std::memory_order_acquire));
  return {memory_.begin(), memory_.begin() + size};
}

Inputs ReplayMachine::exchange(const Outputs& outputs) noexcept {
  const auto tick = reader_.next();
  if (tick && *tick) {
    inputs_ = (*tick)->inputs;
    note(report_, **tick, {outputs, inputs_});
    return inputs_;
  }
  if (!tick) report_.fault = tick.error();
  ++report_.beyond;
  return inputs_;
}

ReplayReport play(std::span<const std::uint8_t> bytes, Machine& machine) {
  ReplayReport report;
  RecordingReader reader(bytes);
  for (;;) {
    const auto tick = reader.next();
    if (!tick) report.fault = tick.error();
    if (!tick || !*tick) return report;
    note(report, **tick, {(*tick)->outputs, machine.exchange((*tick)->outputs)});
  }
}

}  // namespace cnclab::machine
