// What the machines do: each run is recorded, and told where the tool does wrong.
#include <fmt/format.h>

#include "lab/lab.hpp"

namespace cnclab::lab {

namespace {

std::string_view name_of(machine::StopCause cause) {
  using machine::StopCause;
  switch (cause) {
    case StopCause::none:
      return "none";
    case StopCause::operator_stop:
      return "stop";
    case StopCause::program_end:
      return "program_end";
    case StopCause::programmed_halt:
      return "halt";
    case StopCause::waiting_for_input:
      return "wait";
    case StopCause::single_block:
      return "single_block";
    case StopCause::limit_switch:
      return "limit_switch";
    case StopCause::power_off:
      return "power_off";
    case StopCause::machine_halt:
      return "machine_halt";
    case StopCause::lease_ended:
      return "lease_ended";
    case StopCause::lease_expired:
      return "lease_expired";
    case StopCause::error:
      return "error";
  }
  return "";
}

std::string_view name_of(machine::MillingEvent::Kind kind) {
  switch (kind) {
    case machine::MillingEvent::Kind::rapid_in_material:
      return "rapid in material";
    case machine::MillingEvent::Kind::spindle_off_in_material:
      return "spindle off in material";
  }
  return "";
}

}  // namespace

void Lab::record_run(const DeskPtr& desk) {
  RunRecorder& recorder = desk->on_lab_machine ? machine_.recorder() : *desk->recorder;
  const machine::Channel& channel = desk->on_lab_machine ? *machine_.channel() : *desk->training();
  const auto order = desk->control.run_order();
  const machine::Snapshot snapshot = channel.snapshot();
  // A run that the control has given up may still be braking: its last ticks belong to it.
  const bool has_left = recorder.is_recording() && recorder.order() != order.get();
  const bool is_over = has_left && (order != nullptr || !snapshot.started);
  const bool hand_is_over = recorder.is_recording() && recorder.order() == nullptr && !snapshot.started;
  if (is_over || hand_is_over) end_recording(desk, recorder, snapshot.cause);
  // By hand only the lab's machine is of interest.
  const bool by_hand = desk->on_lab_machine && snapshot.started;
  if (!recorder.is_recording() && (order || by_hand)) {
    std::optional<HandStart> hand;
    if (!order)
      hand = HandStart{snapshot.start_istwert_mm, machine::on_lab_machine(desk->control.data(), machine_.data())};
    const auto situation = desk->control.situation();
    const int program = order ? order->start.program : situation.program;
    const int block = order ? order->start.block : situation.block;
    recorder.begin({desk->person.id, desk->station,
                    static_cast<std::uint64_t>(desk->on_lab_machine ? authority_.newest() : Epoch{}), program, block,
                    clock_.unix_ms(), order, desk->on_lab_machine ? machine_.data() : order->data, hand});
    journal_.write("run", fmt::format("P{:04} N{:03} {}", program, block, desk->on_lab_machine ? "lab" : "training"),
                   desk->station, desk->person.name, desk->on_lab_machine ? authority_.newest() : Epoch{});
  }
  recorder.poll();
}

void Lab::end_recording(const DeskPtr& desk, RunRecorder& recorder, machine::StopCause cause) {
  if (!recorder.is_recording()) return;
  recorder.end(std::string(name_of(cause)));
  journal_.write("run_end", std::string(name_of(cause)), desk->station, desk->person.name);
}

void Lab::tell_milling(const DeskPtr& desk) {
  tell_milling(desk, desk->take_milling_news(), Epoch{});
  if (desk->on_lab_machine) tell_milling(desk, machine_.take_milling_news(), authority_.newest());
}

void Lab::tell_milling(const DeskPtr& desk, const std::vector<machine::MillingEvent>& news, Epoch lease) {
  for (const machine::MillingEvent& event : news) {
    const bool is_watched = (lease != Epoch{}) == desk->on_lab_machine;
    if (is_watched) desk->control.tell_milling(event);
    desk->errors_ns.push_back(clock_.monotonic_ns());  // INS-001
    desk->is_dirty = true;
    journal_.write(
        "milling",
        fmt::format("{} P{:04} N{:03} at X{:+.3f} Y{:+.3f} Z{:+.3f}, {}", name_of(event.kind), event.source.program,
                    event.source.block, event.mm[0], event.mm[1], event.mm[2], lease == Epoch{} ? "training" : "lab"),
        desk->station, desk->person.name, lease);
  }
}

}  // namespace cnclab::lab
