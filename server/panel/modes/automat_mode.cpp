// The keys of AUTOMAT, and how a run's end comes back to the operator.
#include "panel/modes/automat_mode.hpp"

#include <utility>

#include "panel/run/run_end.hpp"
#include "panel/run/start_check.hpp"
#include "program/reachable.hpp"
#include "program/rebuild_modal.hpp"

namespace cnclab::panel {

namespace {

using language::Error;
using language::ErrorCode;

void confirm_program(AutomatMode& mode, ControlState& state) {
  if (!mode.program.value) {
    state.complain(ErrorCode::program_missing, std::string(text(Text::said_number_missing, state.tongue())));
    return;
  }
  const std::uint16_t number = mode.program_number();
  mode.program.typed = 0;  // after a complaint the next digit begins another number
  if (language::is_reserved_for_cycles(number))
    return state.complain(Error{.code = ErrorCode::reserved_for_cycles, .program = number});
  const language::Program* program = number == language::kToolTable ? nullptr : state.memory.find(number);
  if (program == nullptr) return state.complain_cannot_run(number);
  mode.block.offer(program->blocks.front().number);
  mode.phase = AutomatMode::Phase::block;
}

void confirm_block(AutomatMode& mode, ControlState& state) {
  const language::Program* program = state.memory.find(mode.program_number());
  mode.block.typed = 0;
  if (program == nullptr || !program->find(mode.block_number()))
    return state.complain(Error{
        .code = ErrorCode::block_missing, .program = mode.program_number(), .detail = block_word(mode.block_number())});
  mode.phase = AutomatMode::Phase::ready;
  mode.has_ended = false;
  mode.failure.reset();
  prepare_start(mode, state);
  if (mode.no_state) state.complain(*mode.no_state);
}

void press_prompt(DigitField& field, Effect effect, int figure) {
  if (effect == Effect::digit) field.digit(figure);
  if (effect == Effect::clear) field.clear();
}

/// What went wrong comes first; what to do about START follows where rows 18 and 19 have room for it.
void refuse_start(ControlState& state, const Error& failure) {
  constexpr int kRoom = 2 * Screen::kColumns;
  const std::string fault = language::explain(failure, state.tongue());
  const std::string both = text(Text::said_failed_before, state.tongue(), {fault});
  state.complain(failure.code, columns_of(both) <= kRoom ? both : fault);
}

/// Does the run measure from the machine's zero anywhere it can come to?
bool uses_absolute(const AutomatMode& mode) {
  constexpr language::Function kAbsolute{language::Function::Kind::g, 90};
  bool found = mode.first_modal.dimension == program::Dimension::absolute;
  program::walk_reachable(mode.programs, mode.program_number(), mode.block_number(),
                          [&](geometry::SourceBlock, const language::Block& block) {
                            found = found || block.function == kAbsolute;
                            return !found;
                          });
  return found;
}

/// DEC-27: the first start of such a program under a lease asks whether the zero is right; a second START says yes.
bool is_zero_open(const AutomatMode& mode, const ControlState& state) {
  return state.connection.is_lab_machine && !state.is_zero_confirmed && uses_absolute(mode);
}

bool must_confirm_zero(AutomatMode& mode, ControlState& state) {
  if (!is_zero_open(mode, state)) return false;
  state.is_zero_confirmed = mode.asks_zero;
  mode.asks_zero = true;
  if (!state.is_zero_confirmed) state.hint = text(Text::said_confirm_zero, state.tongue());
  return !state.is_zero_confirmed;
}

void begin_run(AutomatMode& mode, ControlState& state) {
  if (mode.failure) return refuse_start(state, *mode.failure);
  if (!may_run(state)) return;
  mode.has_ended = false;
  prepare_start(mode, state);
  if (mode.no_state) return refuse_start(state, *mode.no_state);
  if (must_confirm_zero(mode, state)) return;
  RunOrder order{.programs = mode.programs,
                 .start = {.program = mode.program_number(),
                           .block = mode.block_number(),
                           .position = istwert_of(state.machine()),
                           .modal = mode.first_modal,
                           .parameters = state.parameters,
                           .compensation_mm = state.compensation_mm},
                 .data = state.effective_data(),
                 .vocabulary = state.settings.vocabulary,
                 .io_cards = state.settings.io_cards,
                 .rests_accumulate = state.settings.rests_accumulate,
                 .long_work = state.settings.long_work,
                 .tools = tools_at(state)};
  state.connection.channel->set_single_block(mode.single_block);
  const auto begun = state.run.begin(state.connection, std::move(order));
  if (!begun) {
    mode.failure = begun.error();
    return state.complain(begun.error());
  }
  state.automat_program = mode.program_number();
}

void press_single_block(AutomatMode& mode, ControlState& state) {
  if (state.run.ignores_single_block()) {
    state.hint = text(Text::hint_single_hidden, state.tongue());  // KEY-046
    return;
  }
  const bool is_started = is_start_state(place_of(mode, state));
  if (is_started && mode.single_block) {
    state.hint = text(Text::hint_single_off, state.tongue());  // KEY-045
    return;
  }
  mode.single_block = !mode.single_block;
  if (state.connection.channel) state.connection.channel->set_single_block(mode.single_block);
}

void press_ready(AutomatMode& mode, ControlState& state, Effect effect) {
  switch (effect) {
    case Effect::start:
      return state.run.is_present() ? state.run.go_on() : begin_run(mode, state);
    case Effect::stop:
      return state.run.stop();
    default:
      return;
  }
}

}  // namespace

AutomatMode open_automat(const ControlState& state) {
  AutomatMode mode;
  mode.program.offer(state.automat_program);
  if (state.connection.channel) state.connection.channel->set_single_block(false);
  return mode;
}

void close(AutomatMode& mode, ControlState& state) {
  if (state.connection.channel) state.connection.channel->set_single_block(false);
  mode.single_block = false;
  const auto end = state.run.abandon();
  if (!end) return;
  state.take_over(*end);
}

void prepare_start(AutomatMode& mode, const ControlState& state) {
  const language::Program* program = state.memory.find(mode.program_number());
  mode.first_modal = state.modal;
  mode.programs = state.memory.snapshot();
  mode.no_state.reset();
  mode.is_rebuilt = program != nullptr && state.settings.start_in_middle_rebuilds &&
                    mode.block_number() != program->blocks.front().number;
  if (!mode.is_rebuilt) return;
  const auto rebuilt = program::rebuild_modal(mode.programs, *program, mode.block_number(), state.modal);
  if (rebuilt)
    mode.first_modal = program::within(*rebuilt, state.settings.vocabulary);
  else
    mode.no_state = rebuilt.error();
}

Place place_of(const AutomatMode& mode, const ControlState& state) {
  switch (mode.phase) {
    case AutomatMode::Phase::program:
      return Place::automat_program;
    case AutomatMode::Phase::block:
      return Place::automat_block;
    case AutomatMode::Phase::ready:
      break;
  }
  switch (state.run.state()) {
    case Run::State::none:
    case Run::State::stopped:
    case Run::State::between:
      return Place::automat_ready;
    case Run::State::running:
    case Run::State::braking:
      return Place::automat_running;
    case Run::State::waiting:
      return Place::automat_waiting;
  }
  return Place::automat_ready;
}

void disarm(AutomatMode& mode, Effect effect) {
  if (effect != Effect::start) mode.asks_zero = false;
}

void press(AutomatMode& mode, ControlState& state, Effect effect, int figure) {
  if (effect == Effect::single_block) return press_single_block(mode, state);
  switch (mode.phase) {
    case AutomatMode::Phase::program:
      if (effect == Effect::enter) return confirm_program(mode, state);
      return press_prompt(mode.program, effect, figure);
    case AutomatMode::Phase::block:
      if (effect == Effect::enter) return confirm_block(mode, state);
      return press_prompt(mode.block, effect, figure);
    case AutomatMode::Phase::ready:
      return press_ready(mode, state, effect);
  }
}

void follow(AutomatMode& mode, ControlState& state) {
  const Run::State before = state.run.state();
  const std::optional<RunEnd> end = state.run.poll();
  if (state.run.is_backing_off()) tell_back_off(state);
  if (state.run.state() != before) state.hint.clear();  // it spoke of what is over now
  if (!end) return;
  state.take_over(*end);
  switch (end->kind) {
    case RunEnd::Kind::program_end:
      mode.has_ended = true;  // the window returns to the acknowledged start block (D-40)
      break;
    case RunEnd::Kind::failed:
      mode.failure = end->error;
      if (end->error) state.complain(*end->error);
      break;
    case RunEnd::Kind::broken:
      tell_break(state, end->cause);
      break;
    case RunEnd::Kind::refused:
      state.message.sentence = text(Text::said_start_refused, state.tongue());
      break;
  }
  prepare_start(mode, state);
}

bool start_at(AutomatMode& mode, ControlState& state, geometry::SourceBlock place) {
  mode.program.offer(place.program);
  confirm_program(mode, state);
  if (mode.phase != AutomatMode::Phase::block) return false;
  mode.block.offer(place.block);
  confirm_block(mode, state);
  if (mode.phase != AutomatMode::Phase::ready) return false;
  begin_run(mode, state);
  return state.run.is_present();
}

bool would_ask_zero(const ControlState& state, geometry::SourceBlock place) {
  AutomatMode mode;
  mode.program.offer(place.program);
  mode.block.offer(place.block);
  prepare_start(mode, state);
  return is_zero_open(mode, state);
}

geometry::SourceBlock current_block(const AutomatMode& mode, const ControlState& state) {
  if (state.run.is_present()) return state.run.shown_block();
  if (mode.failure && mode.failure->block != 0) return {mode.failure->program, mode.failure->block};
  const bool has_block = mode.phase == AutomatMode::Phase::ready;
  return {mode.program_number(), has_block ? mode.block_number() : std::uint16_t{0}};
}

}  // namespace cnclab::panel
