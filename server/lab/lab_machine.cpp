// The lab's machine: what authority decides is carried out here, in its order.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "lab/lab.hpp"

namespace cnclab::lab {

namespace {

constexpr std::uint64_t kReserve = 100;  ///< lease numbers kept ahead in the database

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

}  // namespace

std::string Lab::decide(const Event& event, language::Tongue tongue) {
  std::string refusal;
  for (const Action& action : authority_.apply(event, machine_view(), clock_.monotonic_ns())) {
    if (const auto* refused = std::get_if<Refuse>(&action))
      refusal = tongue == language::Tongue::german ? refused->german : refused->english;
    carry_out(action);
  }
  keep_epoch();
  return refusal;
}

void Lab::carry_out(const Action& action) {
  if (const auto* grant = std::get_if<Grant>(&action)) {
    channel_->grant(grant->epoch, grant->expiry_ns);
    return;  // renewed 20 times a second: nothing to draw
  }
  if (const auto* revoke = std::get_if<Revoke>(&action)) channel_->revoke(revoke->cause);
  if (const auto* connect = std::get_if<Connect>(&action)) {
    if (connect->to_lab_machine)
      connect_lab_machine(connect->login);
    else
      disconnect_lab_machine();
  }
  if (const auto* latch = std::get_if<Latch>(&action)) channel_->latch(latch->on);
  if (const auto* power = std::get_if<SwitchPower>(&action)) {
    const bool taken = power->on ? channel_->command(machine::PowerOn{}) : channel_->command(machine::PowerOff{});
    if (!taken) channel_->stop(machine::StopCause::power_off);
  }
  if (const auto* entry = std::get_if<Journal>(&action)) {
    const DeskPtr desk = seated_at(entry->station);
    write_journal(entry->kind, entry->detail, entry->station, desk ? desk->person.name : "", entry->lease);
    spdlog::info("{} station {} lease {} {}", entry->kind, entry->station, static_cast<std::uint64_t>(entry->lease),
                 entry->detail);
  }
  everybody_changed();
}

void Lab::connect_lab_machine(LoginId login) {
  for (const auto& [id, desk] : desks_) {
    if (desk->login != login) continue;
    desk->stop_training();
    end_recording(desk, *desk->recorder, machine::StopCause::operator_stop);
    desk->on_lab_machine = true;
    const auto tools = configuration_.tool_list ? std::optional(tool_list_) : std::nullopt;
    desk->control.connect(
        {channel_, authority_.newest(), true, machine_data_, configuration_.require_reference, tools});
    if (const auto mm = zeros_.istwert(static_cast<std::int64_t>(id), channel_->snapshot()))  // DEC-27
      static_cast<void>(channel_->command(machine::SetIstwert{authority_.newest(), {true, true, true}, *mm}));
    lab_desk_ = desk;
    for (const VisitPtr& typing : {desk->visit.lock(), desk->taker.lock()})
      if (typing) send_beat(typing);  // ahead of the screen that shows the machine
  }
}

void Lab::disconnect_lab_machine() {
  if (const DeskPtr desk = lab_desk_.lock()) {
    end_recording(desk, recorder_, channel_->snapshot().cause);
    zeros_.keep(static_cast<std::int64_t>(desk->person.id), channel_->snapshot());
    desk->connect_training();
  }
  lab_desk_.reset();
}

MachineView Lab::machine_view() const {
  const machine::Snapshot snapshot = channel_->snapshot();
  MachineView view;
  view.moving = snapshot.state == machine::MotionState::moving || snapshot.state == machine::MotionState::stopping;
  view.run_active = snapshot.started;
  view.lease_dead = snapshot.epoch == authority_.newest() && !snapshot.lease_valid;
  view.spindle_on = snapshot.spindle != geometry::SpindleTurn::off;
  const DeskPtr desk = lab_desk_.lock();
  view.manual_motion = view.moving && desk &&
                       (desk->control.mode() == panel::Mode::hand || desk->control.mode() == panel::Mode::teach_in);
  return view;
}

void Lab::heard(const VisitPtr& visit, std::uint64_t beat) {
  const DeskPtr desk = typed_at(*visit);
  const auto sent_ns = beats_.sent_ns(beat);
  if (!desk || !sent_ns) return;
  std::int64_t& own_ns = visit->desk ? desk->station_beat_ns : desk->console_beat_ns;
  own_ns = std::max(own_ns, *sent_ns);
  // Where a console types, both must live: at the station STOP is pressed by whoever stands at the machine (AUTH-016).
  const std::int64_t oldest_ns =
      desk->taken_by.empty() ? desk->station_beat_ns : std::min(desk->station_beat_ns, desk->console_beat_ns);
  static_cast<void>(decide(Heard{desk->login, oldest_ns}, configuration_.tongue));
}

void Lab::keep_epoch() {
  if (static_cast<std::uint64_t>(authority_.newest()) + kReserve / 2 < kept_epoch_) return;
  kept_epoch_ = static_cast<std::uint64_t>(authority_.newest()) + kReserve;
  store_.run([value = std::to_string(kept_epoch_)](db::Database& database) { database.put_value("epoch", value); },
             [](const std::expected<void, db::StoreError>& result) {
               if (!result) spdlog::error("lease number not stored: {}", result.error().text);
             });
}

void Lab::record_run(const DeskPtr& desk) {
  RunRecorder& recorder = desk->on_lab_machine ? recorder_ : *desk->recorder;
  const machine::Channel& channel = desk->on_lab_machine ? *channel_ : *desk->training();
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
      hand = HandStart{snapshot.start_istwert_mm, machine::on_lab_machine(desk->control.data(), machine_data_)};
    const auto situation = desk->control.situation();
    const int program = order ? order->start.program : situation.program;
    const int block = order ? order->start.block : situation.block;
    recorder.begin({desk->person.id, desk->station,
                    static_cast<std::uint64_t>(desk->on_lab_machine ? authority_.newest() : Epoch{}), program, block,
                    clock_.unix_ms(), order, desk->on_lab_machine ? machine_data_ : order->data, hand});
    write_journal("run", fmt::format("P{:04} N{:03} {}", program, block, desk->on_lab_machine ? "lab" : "training"),
                  desk->station, desk->person.name, desk->on_lab_machine ? authority_.newest() : Epoch{});
  }
  recorder.poll();
}

void Lab::end_recording(const DeskPtr& desk, RunRecorder& recorder, machine::StopCause cause) {
  if (!recorder.is_recording()) return;
  recorder.end(std::string(name_of(cause)));
  write_journal("run_end", std::string(name_of(cause)), desk->station, desk->person.name);
}

}  // namespace cnclab::lab
