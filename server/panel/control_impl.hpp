// What a Control is made of; for its own files only.
#pragma once

#include <utility>

#include "panel/control.hpp"
#include "panel/control_state.hpp"
#include "panel/modes/modes.hpp"

namespace cnclab::panel {

struct Control::Impl {
  Impl(const Settings& settings, Memory memory, machine::MachineData data)
      : state(settings, std::move(memory), std::move(data)) {}

  void change_mode(Mode next, Outcome& outcome) {
    close_mode(active, state);
    active = open_mode(next, state);
    outcome.mode_changed = true;
  }

  /// Opens the mode that the active one asked for, if any.
  void obey_mode(Outcome& outcome) {
    if (const auto next = std::exchange(state.next_mode, std::nullopt)) change_mode(*next, outcome);
  }

  /// RESET in any state: as STOP, spindle and coolant off, menu; programs and parameters stay (D-121, DEC-39).
  void reset(Outcome& outcome) {
    change_mode(Mode::menu, outcome);
    outcome.was_reset = true;
    state.message = {};
    if (state.connection.channel) state.connection.channel->stop(machine::StopCause::operator_stop);
    state.reset_modal_state();
  }

  /// Modes that must not be entered while the lab's machine is connected (DEC-39).
  void open_service_mode(Mode mode, Outcome& outcome) {
    if (state.connection.is_lab_machine) {
      state.hint = text(Text::said_not_on_lab_machine, state.tongue());
      return;
    }
    change_mode(mode, outcome);
  }

  /// STOP reaches the machine in every mode, whatever else it does (AUTH-006).
  void stop_machine() const {
    if (state.connection.channel && state.connection.channel->snapshot().started)
      state.connection.channel->stop(machine::StopCause::operator_stop);
  }

  /// The Istwert that was kept, once a training machine is there to count on.
  void set_kept_istwert() {
    if (!kept_istwert_mm || !state.connection.channel || state.connection.is_lab_machine) return;
    (void)state.connection.channel->command(
        machine::SetIstwert{state.connection.epoch, {true, true, true}, *kept_istwert_mm});
    kept_istwert_mm.reset();
  }

  void hand_out_media(Outcome& outcome) {
    if (!state.media || state.is_media_pending) return;
    media_answer.reset();  // to a request that was broken off
    outcome.media = std::exchange(state.media, std::nullopt);
    state.is_media_pending = true;
  }

  void hand_out_line(Outcome& outcome) {
    SerialPort& port = state.port;
    outcome.line_news = std::exchange(port.news, {});
    outcome.is_from_line = port.is_storing;
    if (port.asked && !std::exchange(port.has_handed_out_start, true)) outcome.remote_start = port.asked;
  }

  /// In `poll`, since what was read is a request to store it, which leaves with an outcome.
  void take_media_answer() {
    const auto answer = std::exchange(media_answer, std::nullopt);
    auto* external = std::get_if<ExternalDataMode>(&active);
    if (answer && external != nullptr) media_answered(*external, state, *answer);
  }

  [[nodiscard]] transfer::Time time() const {
    return std::chrono::duration_cast<transfer::Time>(std::chrono::nanoseconds(state.now.monotonic_ns));
  }

  [[nodiscard]] Place place() const { return place_of(active, state); }
  [[nodiscard]] std::string sentence(const SideView& side) const;

  ControlState state;
  ActiveMode active = MenuMode{};
  std::uint64_t signals_heard = 0;
  std::optional<std::expected<std::string, std::string>> media_answer;  ///< to be taken in
  std::optional<std::array<double, 3>> kept_istwert_mm;
};

}  // namespace cnclab::panel
