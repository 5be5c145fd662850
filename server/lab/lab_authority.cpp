// What authority decides is carried out here, in its order.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "lab/lab.hpp"

namespace cnclab::lab {

namespace {

constexpr std::uint64_t kReserve = 100;  ///< lease numbers kept ahead in the database
}  // namespace

std::string Lab::decide(const Event& event, language::Tongue tongue) {
  if (std::holds_alternative<Select>(event) && !machine_.damaged_data().empty())
    return damage_sentence(machine_.damaged_data(), tongue);
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
    machine_.channel()->grant(grant->epoch, grant->expiry_ns);
    return;  // renewed 20 times a second: nothing to draw
  }
  if (const auto* revoke = std::get_if<Revoke>(&action)) machine_.channel()->revoke(revoke->cause);
  if (const auto* connect = std::get_if<Connect>(&action)) {
    if (connect->to_lab_machine)
      connect_lab_machine(connect->login);
    else
      disconnect_lab_machine();
  }
  if (const auto* latch = std::get_if<Latch>(&action)) machine_.channel()->latch(latch->on);
  if (const auto* power = std::get_if<SwitchPower>(&action)) {
    const bool taken =
        power->on ? machine_.channel()->command(machine::PowerOn{}) : machine_.channel()->command(machine::PowerOff{});
    if (!taken) machine_.channel()->stop(machine::StopCause::power_off);
  }
  if (const auto* back = std::get_if<GiveKeysBack>(&action))
    if (const DeskPtr desk = seats_.with(back->login)) give_back_from_lost_console(desk);
  if (const auto* entry = std::get_if<Journal>(&action)) {
    // The student's own journal has it, also where the line has just gone; of what concerns no seat, the instructor's.
    const DeskPtr desk = entry->login == kNoLogin ? nullptr : seats_.with(entry->login);
    journal_.write(entry->kind, entry->detail, entry->station, desk ? desk->person.name : entry->who, entry->lease);
    spdlog::info("{} station {} lease {} {}", entry->kind, entry->station, static_cast<std::uint64_t>(entry->lease),
                 entry->detail);
  }
  everybody_changed();
}

void Lab::connect_lab_machine(LoginId login) {
  const DeskPtr desk = seats_.with(login);
  if (!desk) return;
  desk->stop_training();
  end_recording(desk, *desk->recorder, machine::StopCause::operator_stop);
  desk->on_lab_machine = true;
  const auto tools = configuration_.tool_list ? std::optional(machine_.tools()) : std::nullopt;
  desk->control.connect(
      {machine_.channel(), authority_.newest(), true, machine_.data(), configuration_.require_reference, tools});
  machine_.take_up_zero(desk->person.id, authority_.newest());
  lab_desk_ = desk;
  for (const VisitPtr& typing : {desk->visit.lock(), desk->taker.lock()})
    if (typing) send_beat(typing);  // ahead of the screen that shows the machine
}

void Lab::disconnect_lab_machine() {
  if (const DeskPtr desk = lab_desk_.lock()) {
    end_recording(desk, machine_.recorder(), machine_.snapshot().cause);
    machine_.keep_zero(desk->person.id);
    desk->connect_training();
  }
  lab_desk_.reset();
}

MachineView Lab::machine_view() const {
  const machine::Snapshot snapshot = machine_.snapshot();
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
  const bool is_console_behind = !desk->taken_by.empty() && desk->console_beat_ns < desk->station_beat_ns;
  const std::int64_t oldest_ns = is_console_behind ? desk->console_beat_ns : desk->station_beat_ns;
  static_cast<void>(decide(Heard{desk->login, oldest_ns, is_console_behind}, configuration_.tongue));
}

void Lab::heed_watchdog() {
  if (!machine_.take_stall()) return;
  spdlog::error("the beat stood still: the machine's current is cut until power-on (stall {})", machine_.stalls());
  journal_.write("watchdog", fmt::format("the beat stood still, current cut (stall {})", machine_.stalls()),
                 authority_.selected(), "", authority_.newest());
  static_cast<void>(decide(PowerSwitched{false}, configuration_.tongue));
}

void Lab::tell_late_ticks() {
  const machine::TickStatistics ticks = ticks_.statistics();
  const std::uint64_t told = std::exchange(late_ticks_told_, ticks.very_late);
  if (told == ticks.very_late) return;
  spdlog::warn("{} more ticks began more than 5 ms late, the longest so far {:.1f} ms: this computer has other work",
               ticks.very_late - told, static_cast<double>(ticks.longest_delay_ns) / 1e6);
}

void Lab::settle_machine_data() {
  if (authority_.phase() == Phase::nobody && machine_.settle_data()) journal_.write("machine_data", "new data hold");
}

void Lab::keep_epoch() {
  if (static_cast<std::uint64_t>(authority_.newest()) + kReserve / 2 < kept_epoch_) return;
  kept_epoch_ = static_cast<std::uint64_t>(authority_.newest()) + kReserve;
  store_.run([value = std::to_string(kept_epoch_)](db::Database& database) { database.put_value("epoch", value); },
             [](const std::expected<void, db::StoreError>& result) {
               if (!result) spdlog::error("lease number not stored: {}", result.error().text);
             });
}

}  // namespace cnclab::lab
