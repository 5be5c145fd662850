// What the lab asks of a control while no key is pressed: its situation, whether its screen is due, its tones.
#include <algorithm>
#include <utility>

#include "panel/control_impl.hpp"
#include "panel/key_table.hpp"

namespace cnclab::panel {

Situation Control::situation() const {
  Situation situation{.mode = mode(), .started = is_running(), .alarm = !impl_->state.message.monitor.empty()};
  if (situation.mode == Mode::hand || situation.mode == Mode::teach_in)
    situation.alarm = situation.alarm || std::ranges::count(impl_->state.machine().limit, true) > 0;
  if (const auto* editor = std::get_if<EditorMode>(&impl_->active)) {
    situation.program = editor->number();
    situation.block = editor->is_open ? static_cast<std::uint16_t>(editor->line.number()) : std::uint16_t{0};
  }
  if (const auto* teach_in = std::get_if<TeachInMode>(&impl_->active)) {
    situation.program = teach_in->number();
    situation.block = teach_in->is_open ? static_cast<std::uint16_t>(teach_in->line.number()) : std::uint16_t{0};
  }
  // What a START would release may change under the student's eyes: a computer sends another program.
  const auto* external = std::get_if<ExternalDataMode>(&impl_->active);
  if (external != nullptr && impl_->place() == Place::external_polled) situation.program = impl_->state.editor_program;
  if (const auto* automat = std::get_if<AutomatMode>(&impl_->active)) {
    const geometry::SourceBlock current = current_block(*automat, impl_->state);
    situation.program = current.program;
    situation.block = current.block;
  }
  return situation;
}

Mode Control::mode() const { return mode_of(impl_->active); }

std::shared_ptr<const RunOrder> Control::run_order() const { return impl_->state.run.order(); }

bool Control::is_running() const { return is_start_state(impl_->place()); }

bool Control::is_busy() const {
  const auto* graphics = std::get_if<GraphicsMode>(&impl_->active);
  const bool plays = graphics != nullptr && (graphics->is_playing || graphics->is_stale || graphics->is_step_due ||
                                             (graphics->test && graphics->test->has_news()));
  return plays || is_running() || recorder_runs() || is_transfer(impl_->place());
}

bool Control::awaits_effect() const {
  const ControlState& state = impl_->state;
  const auto* graphics = std::get_if<GraphicsMode>(&impl_->active);
  if (graphics != nullptr && graphics->is_awaited) return true;
  const bool is_switching = state.is_switching && state.connection.channel && !state.connection.channel->is_settled();
  return is_switching || state.run.awaits_answer();
}

Indication Control::indication() const {
  const machine::Snapshot machine = impl_->state.machine();
  const auto* graphics = std::get_if<GraphicsMode>(&impl_->active);
  return {.istwert_mm = machine.istwert_mm,
          .limit = machine.limit,
          .spindle = machine.spindle,
          .coolant = machine.coolant,
          .is_referenced = machine.is_referenced,
          .state = machine.state,
          .pictures = graphics == nullptr ? 0 : graphics->pictures};
}

int Control::take_beeps() {
  const std::uint64_t signals = impl_->state.machine().signals;
  const int heard = static_cast<int>(std::min<std::uint64_t>(signals - std::min(signals, impl_->signals_heard), 100));
  impl_->signals_heard = signals;
  return std::exchange(impl_->state.beeps, 0) + heard;
}

bool Control::alarm_tone() const { return impl_->state.run.sounds_alarm(); }

}  // namespace cnclab::panel
