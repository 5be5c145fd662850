// What the machines do: each run is recorded, and told where the tool does wrong.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

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

std::string_view name_of(db::FailureKind kind) {
  switch (kind) {
    case db::FailureKind::locked:
      return "database locked";
    case db::FailureKind::full:
      return "disk full";
    case db::FailureKind::damaged:
      return "database damaged";
    case db::FailureKind::disk:
      return "disk not writable";
    case db::FailureKind::refused:
      return "refused by the database";
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

/// By hand the lab's machine is of interest, on the training machine what TEACH IN makes blocks of (STO-007).
bool Lab::is_hand_recorded(const Desk& desk) const {
  return desk.on_lab_machine || desk.control.mode() == panel::Mode::teach_in;
}

void Lab::record_run(const DeskPtr& desk) {
  RunRecorder& recorder = desk->on_lab_machine ? machine_.recorder() : *desk->recorder;
  const machine::Channel& channel = desk->on_lab_machine ? *machine_.channel() : *desk->training();
  const auto order = desk->control.run_order();
  recorder.poll();
  const machine::Snapshot snapshot = channel.snapshot();  // no older than what was polled
  // A run that the control has given up may still be braking: its last ticks belong to it.
  const bool has_left = recorder.is_recording() && recorder.order() != order.get();
  const bool is_over = has_left && (order != nullptr || !snapshot.started);
  const bool hand_is_over = recorder.is_by_hand() && (!snapshot.started || recorder.has_hand_start());
  if (is_over || hand_is_over) end_recording(desk, recorder, snapshot.cause);
  const bool by_hand = !order && recorder.has_hand_start() && is_hand_recorded(*desk);
  if (!recorder.is_recording() && (order || by_hand)) begin_recording(desk, recorder, order, snapshot);
  if (!recorder.is_recording()) recorder.pass_over();
  recorder.poll();
}

void Lab::begin_recording(const DeskPtr& desk, RunRecorder& recorder,
                          const std::shared_ptr<const panel::RunOrder>& order, const machine::Snapshot& snapshot) {
  std::optional<HandStart> hand;
  const machine::MachineData& data = desk->control.data();
  if (!order)
    hand = HandStart{snapshot.start_istwert_mm,
                     desk->on_lab_machine ? machine::on_lab_machine(data, machine_.data()) : data};
  const auto situation = desk->control.situation();
  const int program = order ? order->start.program : situation.program;
  const int block = order ? order->start.block : situation.block;
  const Epoch lease = desk->on_lab_machine ? authority_.newest() : Epoch{};
  const std::string what = fmt::format("P{:04} N{:03} {}", program, block, desk->on_lab_machine ? "lab" : "training");
  recorder.begin({desk->person.id, desk->station, static_cast<std::uint64_t>(lease), program, block, clock_.unix_ms(),
                  order,
                  desk->on_lab_machine ? machine_.data()
                  : order              ? order->data
                                       : data,
                  hand, loss_teller(what, *desk, lease)});
  journal_.write("run", what, desk->station, desk->person.name, lease);
}

std::function<void(const db::StoreError&)> Lab::loss_teller(const std::string& what, const Desk& desk, Epoch lease) {
  return [this, alive = alive_, what, station = desk.station, student = desk.person.name,
          lease](const db::StoreError& error) {
    spdlog::error("{}: run {} is not recorded, or not wholly: {} ({})", student, what, error.text, error.detail);
    if (!*alive) return;
    ++runs_lost_;
    journal_.write("run_lost", fmt::format("{}: {}", what, name_of(error.kind)), station, student, lease);
  };
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
