// Keys in, screens out: the one place where key table, modes, run and storing come together.
#include "panel/control.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "panel/control_impl.hpp"
#include "panel/key_table.hpp"
#include "panel/remote_line.hpp"
#include "panel/run/run_end.hpp"
#include "panel/run/start_check.hpp"
#include "panel/screen/names.hpp"
#include "panel/screen/screen_frame.hpp"
#include "panel/state_json.hpp"

namespace cnclab::panel {

namespace {

void apply(const StoreRequest& request, ControlState& state) {
  if (const auto* put = std::get_if<PutBlock>(&request)) state.memory.put_block(put->program, put->block);
  if (const auto* insert = std::get_if<InsertBlock>(&request))
    state.memory.insert_block(insert->program, insert->block);
  if (const auto* erased = std::get_if<DeleteBlock>(&request))
    state.memory.delete_block(erased->program, erased->block);
  if (const auto* removed = std::get_if<RemovePrograms>(&request))
    for (const std::uint16_t program : removed->programs) state.memory.remove_program(program);
  if (const auto* data = std::get_if<PutMachineData>(&request)) state.data = data->data;
  if (const auto* put = std::get_if<PutPrograms>(&request)) {
    for (const std::uint16_t program : put->removed) state.memory.remove_program(program);
    for (const language::Program& program : put->programs) state.memory.put_program(program);
    if (put->data) state.data = *put->data;
  }
  if (const auto* all = std::get_if<EraseMemory>(&request)) {
    for (const std::uint16_t program : all->programs) state.memory.remove_program(program);
    state.data = all->data;
  }
}

bool stores_block(const StoreRequest& request) {
  return std::holds_alternative<PutBlock>(request) || std::holds_alternative<InsertBlock>(request);
}

/// Row 18 says why a key had no effect.
std::string hint_for(Key key, Place place, const Settings& settings) {
  const std::string_view label = label_of(key);
  const language::Tongue tongue = settings.tongue;
  if (place == Place::input_rest) return text(Text::hint_rest, tongue, {label});
  if (place == Place::automat_running) return text(Text::hint_running, tongue, {label});
  if (place == Place::automat_waiting || place == Place::input_waiting)
    return text(Text::hint_waiting, tongue, {label});
  if (place == Place::memory_running) return text(Text::hint_memory_test, tongue, {label});
  if (is_transfer(place)) return text(Text::hint_transfer, tongue, {label});
  if (is_start_state(place)) return text(Text::hint_moving, tongue, {label});
  if (place != Place::menu && is_opening(effect_of(Place::menu, key, settings.vocabulary)))
    return text(Text::hint_menu_first, tongue, {label});
  return text(Text::hint_no_effect, tongue, {label});
}

bool is_labs_own(Key key) {
  return key == Key::none || key == Key::MELDUNG || key == Key::MASCHINE_HALT || key == Key::LABOR;
}

/// A block that has just come onto the screen was read for that, and its check code did not fit (ERR-004, 6.8).
void tell_damage(const std::optional<geometry::SourceBlock>& before, const std::optional<geometry::SourceBlock>& now,
                 ControlState& state) {
  if (!now || now == before || !state.message.monitor.empty()) return;
  state.complain(language::Error{.code = language::ErrorCode::checksum_wrong,
                                 .program = now->program,
                                 .block = now->block,
                                 .in_tool_table = now->program == language::kToolTable});
}

/// AUTOMAT and GRAFIK each have an EINZELSATZ of their own; the lamp shows that of the mode that is active.
bool is_single_block(const ActiveMode& mode) {
  if (const auto* automat = std::get_if<AutomatMode>(&mode)) return automat->single_block;
  const auto* graphics = std::get_if<GraphicsMode>(&mode);
  return graphics != nullptr && graphics->single_block;
}

constexpr int kBeeperDatum = 22;

/// The machine that is about to be taken away may have run onto a switch while it braked for the lease.
void tell_limit_of_lost_lease(ControlState& state) {
  const machine::StopCause cause = state.machine().cause;
  const bool is_lost = cause == machine::StopCause::lease_ended || cause == machine::StopCause::lease_expired;
  if (is_lost && state.machine().limit_axis < state.machine().limit.size()) tell_break(state, cause);
}

/// What the effect has to know of its key: the digit, or which of the six direction keys.
int figure_of(Effect effect, Key key) {
  if (effect == Effect::direction) return static_cast<int>(key) - static_cast<int>(Key::PLUS_X);
  return digit_of(key).value_or(0);
}

}  // namespace

Control::Control(const Settings& settings, Memory memory, machine::MachineData data)
    : impl_(std::make_unique<Impl>(settings, std::move(memory), std::move(data))) {}

Control::~Control() = default;

void Control::connect(Connection connection) {
  ControlState& state = impl_->state;
  const bool had_run = state.run.is_present();
  const Mode mode = mode_of(impl_->active);
  const bool drives = mode == Mode::hand || mode == Mode::hand_input || mode == Mode::teach_in || mode == Mode::automat;
  const bool serves = mode == Mode::machine_data || mode == Mode::memory_test;
  const bool falls_back = drives || (serves && connection.is_lab_machine);  // AUTH-003, DEC-39
  Outcome outcome;
  const bool leaves_lab_machine = state.connection.is_lab_machine;
  if (leaves_lab_machine) tell_limit_of_lost_lease(state);
  if (falls_back) impl_->change_mode(Mode::menu, outcome);
  state.connection = std::move(connection);
  // AUTH-003: G40 G45 G74 M20 become active; spindle and coolant are off.
  program::ModalState& modal = state.modal = with_tools_off(state.modal);
  const program::ModalState power_on;
  modal.radius = power_on.radius;
  modal.length_compensation = modal.scale_on = false;
  modal.scale = power_on.scale;
  modal.blocks_hidden = modal.subprogram_blocks_hidden = modal.potentiometer_off = modal.test_run = false;
  state.compensation_mm = {};
  state.taught = {};  // positions of another machine mean nothing here
  // What ended the motion that this change has cut off is still to be told: `Endschalter` with its axis (ERR-020).
  state.hint.clear();  // it spoke of the machine before
  const bool is_limit_told = leaves_lab_machine && state.message.monitor == text(Text::limit_switch, state.tongue());
  if (!is_limit_told) state.message = {};
  if (had_run && !is_limit_told) state.message.sentence = text(Text::said_connected, state.tongue());
  impl_->signals_heard = state.machine().signals;
  state.is_zero_confirmed = false;
  if (auto* external = std::get_if<ExternalDataMode>(&impl_->active)) external->armed.reset();  // of another lease
  state.applied_data.reset();
  (void)state.apply_data();  // where it does not stand still yet, the next START tries again
  set_override(state.override_percent);
  impl_->set_kept_istwert();
}

Outcome Control::press(Key key, const Now& now) {
  Outcome outcome;
  ControlState& state = impl_->state;
  state.now = now;
  if (is_labs_own(key)) {
    note_labs_key();
    return outcome;
  }
  if (key == Key::STOP) impl_->stop_machine();
  state.hint.clear();
  state.is_switching = false;
  if (state.storing) {
    if (key != Key::STOP && state.settings.hints)
      state.hint = text(Text::hint_storing, state.tongue(), {label_of(key)});
    return outcome;
  }
  if (key == Key::RESET) {
    impl_->reset(outcome);
    return outcome;
  }
  const Place place = impl_->place();
  const Effect effect = effect_of(place, key, state.settings.vocabulary);
  disarm(impl_->active, effect);
  const auto damaged_before = damaged_block(impl_->active, state);
  if (effect == Effect::ignored || !acts(impl_->active, effect)) {
    // While an axis is driven off its switch row 18 says so already.
    if (state.settings.hints && !state.run.is_backing_off()) state.hint = hint_for(key, place, state.settings);
    return outcome;
  }
  state.message = {};
  if (is_opening(effect))
    impl_->change_mode(mode_opened_by(effect), outcome);
  else
    panel::press(impl_->active, state, effect, figure_of(effect, key));
  impl_->obey_mode(outcome);
  tell_damage(damaged_before, damaged_block(impl_->active, state), state);
  outcome.store = state.storing;
  impl_->hand_out_media(outcome);
  impl_->hand_out_line(outcome);
  return outcome;
}

void Control::note_labs_key() { disarm(impl_->active, Effect::ignored); }

Outcome Control::press_chord(const std::vector<Key>& keys, const Now& now) {
  Outcome outcome;
  if (keys.size() == 1) return press(keys.front(), now);
  const auto holds = [&](std::initializer_list<Key> chord) {
    return keys.size() == chord.size() &&
           std::ranges::all_of(chord, [&](Key key) { return std::ranges::count(keys, key) == 1; });
  };
  if (impl_->state.storing) return outcome;
  impl_->state.now = now;
  impl_->state.hint.clear();
  disarm(impl_->active, Effect::ignored);
  if (holds({Key::DOWN, Key::RESET})) {
    impl_->reset(outcome);
    impl_->state.initialise();  // cold start: the working state goes too, the memory stays (ERR-040, D-121)
  }
  if (holds({Key::ENTER, Key::RESET})) {
    impl_->reset(outcome);
    impl_->open_service_mode(Mode::machine_data, outcome);
  }
  // D-17: polled in the menu only; elsewhere the keys are data.
  const auto [first, second, third] =
      impl_->state.settings.keys_19inch ? std::tuple(Key::D1, Key::D4, Key::D7) : std::tuple(Key::D3, Key::D6, Key::D9);
  if (holds({first, second, third}) && impl_->place() == Place::menu)
    impl_->open_service_mode(Mode::memory_test, outcome);
  return outcome;
}

void Control::release(Key key, const Now& now) {
  impl_->state.now = now;
  auto* external = std::get_if<ExternalDataMode>(&impl_->active);
  if (key == Key::ENTER && external != nullptr) release_enter(*external, impl_->state);
}

void Control::set_override(int percent) {
  impl_->state.override_percent = std::clamp(percent, 0, 100);
  if (impl_->state.connection.channel)
    impl_->state.connection.channel->set_override(impl_->state.override_percent / 100.0);
}

bool Control::is_storing() const { return impl_->state.storing.has_value(); }

void Control::store_done(const std::string& error) {
  ControlState& state = impl_->state;
  if (!state.storing) return;
  const StoreRequest request = *std::exchange(state.storing, std::nullopt);
  state.hint.clear();  // of a key that came while it was being stored
  const bool is_from_line = state.port.is_storing;
  if (is_from_line && !error.empty()) panel::line_stored(impl_->active, state, request, false);
  if (!error.empty()) {
    state.message = Message{std::string(text(Text::not_stored, state.tongue())), 0,
                            text(Text::said_not_stored, state.tongue(), {error})};
    return;
  }
  apply(request, state);
  if (stores_block(request) && state.data.get(kBeeperDatum) == 1) ++state.beeps;  // EDIT-027
  is_from_line ? panel::line_stored(impl_->active, state, request, true) : stored(impl_->active, state, request);
}

Outcome Control::poll(const Now& now) {
  Outcome outcome;
  ControlState& state = impl_->state;
  state.now = now;
  state.clock.run_on(now);
  const Place place = impl_->place();
  const std::string hint = state.hint;
  const bool has_taken_orders = state.connection.channel && state.connection.channel->is_settled();
  if (const auto turn = state.machine().spindle; has_taken_orders && turn != geometry::SpindleTurn::off)
    state.last_turn = turn;  // of a spindle that RESET has yet to stop it is no more than that
  const bool was_storing = state.storing.has_value();
  if (state.recorder && !std::holds_alternative<ExternalDataMode>(impl_->active))
    static_cast<void>(state.recorder->advance(impl_->time()));  // winding goes on in every mode
  impl_->take_media_answer();
  follow(impl_->active, state);
  impl_->obey_mode(outcome);
  follow_line(impl_->active, state);
  impl_->obey_mode(outcome);
  if (state.hint == hint && impl_->place() != place) state.hint.clear();  // it spoke of what is over
  if (!was_storing) outcome.store = state.storing;
  impl_->hand_out_media(outcome);
  impl_->hand_out_line(outcome);
  outcome.picture = std::exchange(state.picture, std::nullopt);
  return outcome;
}

std::string Control::Impl::sentence(const SideView& side) const {
  if (!side.notice.empty()) return side.notice;
  if (!state.hint.empty()) return state.hint;
  if (!state.message.sentence.empty()) return state.message.sentence;
  const Place here = place();
  const bool may_start = here == Place::menu || here == Place::hand_ready || here == Place::automat_ready;
  if (may_start && are_drives_off(state)) return std::string(drives_off_sentence(state));
  return sentence_of(active, state);
}

Screen Control::draw(const Now& now, const SideView& side) const {
  const ControlState& state = impl_->state;
  Canvas canvas;
  Monitor monitor(canvas);
  draw_frame(canvas);
  draw_header(monitor, mode(), state.settings, state.clock.at(now), state.memory.free_bytes());
  panel::draw(impl_->active, state, monitor);
  monitor.write(Monitor::kMessageRow, state.message.column, state.message.monitor);
  const machine::Snapshot machine = state.machine();
  const Lamps lamps{.start = machine.started || is_running(),
                    .single_block = is_single_block(impl_->active),
                    .coolant = machine.coolant,
                    .limit = std::ranges::find(machine.limit, true) != machine.limit.end(),
                    .is_referenced = machine.is_referenced,
                    .spindle = machine.spindle};
  draw_side(canvas, side, lamps, state.tongue());
  const auto lists = [&](Effect effect, Key key) {
    return side.keys_work && is_of_use(impl_->active, state, effect, key);
  };
  draw_bottom(canvas, {side.bar, impl_->sentence(side), lists}, impl_->place(), state.settings);
  return canvas.screen();
}

void Control::set_ram_fault(bool is_faulty) { impl_->state.is_ram_faulty = is_faulty; }
bool Control::has_ram_fault() const { return impl_->state.is_ram_faulty; }

void Control::tell_data_restored() {
  ControlState& state = impl_->state;
  state.complain(language::ErrorCode::checksum_wrong, std::string(text(Text::said_data_restored, state.tongue())));
}

void Control::set_workpiece(const machine::WorkpieceSpec& spec) { impl_->state.settings.workpiece = spec; }

const machine::WorkpieceSpec& Control::workpiece() const { return impl_->state.settings.workpiece; }

void Control::tell_milling(const machine::MillingEvent& event) { panel::tell_milling(impl_->state, event); }

const Memory& Control::memory() const { return impl_->state.memory; }

const machine::MachineData& Control::data() const { return impl_->state.data; }

int Control::override_percent() const { return impl_->state.override_percent; }

std::string Control::save_state() const { return write_state(impl_->active, impl_->state); }

void Control::restore_state(const std::string& json) {
  close_mode(impl_->active, impl_->state);
  ReadState read = read_state(json, impl_->state);
  impl_->active = read.mode ? std::move(*read.mode) : ActiveMode{MenuMode{}};
  impl_->state.message = {};
  impl_->state.hint.clear();
  impl_->kept_istwert_mm = read.istwert_mm;
  set_override(impl_->state.override_percent);
  impl_->set_kept_istwert();
}

void Control::replace_memory(Memory memory) {
  impl_->state.memory = std::move(memory);
  auto* automat = std::get_if<AutomatMode>(&impl_->active);
  if (automat == nullptr || automat->phase == AutomatMode::Phase::program || impl_->state.run.is_present()) return;
  const language::Program* program = impl_->state.memory.find(automat->program_number());
  if (program == nullptr || !program->find(automat->block_number()))
    automat->phase = AutomatMode::Phase::program;
  else
    prepare_start(*automat, impl_->state);
}

void Control::replace_data(machine::MachineData data) {
  impl_->state.data = std::move(data);
  (void)impl_->state.apply_data();  // where the machine does not stand still, the next START tries again
  auto* shown = std::get_if<MachineDataMode>(&impl_->active);
  if (shown != nullptr && shown->value.typed == 0) show_datum(*shown, impl_->state, shown->number);
}

void Control::drop_hint() { impl_->state.hint.clear(); }

void Control::set_tongue(language::Tongue tongue) {
  impl_->state.settings.tongue = tongue;
  impl_->state.message = {};
  impl_->state.hint.clear();
}

}  // namespace cnclab::panel
