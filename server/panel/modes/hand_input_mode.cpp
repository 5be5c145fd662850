// Keys and screen of HANDEINGABE (Bild 3).
#include "panel/modes/hand_input_mode.hpp"

#include "panel/modes/line_keys.hpp"
#include "panel/run/run_end.hpp"
#include "panel/screen/motion_screen.hpp"

namespace cnclab::panel {

namespace {

void press_enter(HandInputMode& mode, ControlState& state) {
  if (mode.line.marker() == EntryLine::Marker::word && !mode.line.is_at_last_word()) return mode.line.next_word();
  // Behind the last word G comes again, so that another function can be chosen without leaving the mode.
  if (mode.line.marker() == EntryLine::Marker::word) return mode.line.go_to_function();
  (void)show_words(mode, state);
}

void press_clear(HandInputMode& mode) {
  const bool is_empty_function = mode.line.marker() == EntryLine::Marker::function && !mode.line.function();
  if (!is_empty_function) mode.line.clear();
}

void tell_end(HandInputMode& mode, ControlState& state, const RunEnd& end) {
  switch (end.kind) {
    case RunEnd::Kind::program_end:
      mode.is_done = true;
      return;
    case RunEnd::Kind::failed:
      if (end.error) complain_of_line(mode, state, *end.error);
      return;
    case RunEnd::Kind::broken:
      return tell_break(state, end.cause);
    case RunEnd::Kind::refused:
      state.message.sentence = text(Text::said_start_refused, state.tongue());
      return;
  }
}

}  // namespace

HandInputMode open_hand_input(const ControlState& state) {
  HandInputMode mode;
  mode.plane = state.plane();
  constexpr language::Function kProposed{language::Function::Kind::g, 1};
  if (const auto* form = language::find_form(kProposed, mode.plane, state.settings.vocabulary))
    mode.line.show_words(*form);
  mode.line.go_to_function();
  if (state.connection.channel) state.connection.channel->set_single_block(false);
  return mode;
}

void close(HandInputMode&, ControlState& state) {
  if (const auto end = state.run.abandon()) state.take_over(*end);
}

Place place_of(const HandInputMode& mode, const ControlState& state) {
  switch (state.run.state()) {
    case Run::State::running:
    case Run::State::braking:
      return Place::input_running;
    case Run::State::waiting:
      return Place::input_waiting;
    case Run::State::stopped:
    case Run::State::between:
      return Place::input_rest;
    case Run::State::none:
      break;
  }
  return mode.line.marker() == EntryLine::Marker::word ? Place::input_word : Place::input_function;
}

void press(HandInputMode& mode, ControlState& state, Effect effect, int figure) {
  mode.is_done = false;
  if (key_into(mode.line, effect, figure)) return;
  switch (effect) {
    case Effect::clear:
      return press_clear(mode);
    case Effect::enter:
      return press_enter(mode, state);
    case Effect::start:
      return state.run.is_present() ? state.run.go_on() : execute_line(mode, state);
    case Effect::stop:
      return state.run.stop();
    default:
      return;
  }
}

void follow(HandInputMode& mode, ControlState& state) {
  const Run::State before = state.run.state();
  const std::optional<RunEnd> end = state.run.poll();
  if (state.run.is_backing_off()) tell_back_off(state);
  if (state.run.state() != before) state.hint.clear();
  if (!end) return;
  state.take_over(*end);
  tell_end(mode, state, *end);
}

void draw(const HandInputMode& mode, const ControlState& state, Monitor& monitor) {
  constexpr int kLineRow = 5;
  draw_start_and_stop(is_start_state(place_of(mode, state)), kLowStartRow, monitor);
  draw_state_lines(state.run.is_present() ? state.run.modal() : state.modal, state, kLowStartRow, monitor);
  draw_istwerte(state.machine(), monitor);
  draw_tool_due(state.run, state.tongue(), monitor);
  mode.line.draw(monitor, kLineRow, mode.plane, state.tongue(), EntryLine::Style::without_number);
}

std::string sentence_of(const HandInputMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  switch (place_of(mode, state)) {
    case Place::input_running:
      if (state.run.state() == Run::State::braking) return std::string(text(Text::wait_axes_brake, tongue));
      return std::string(
          text(state.awaits_potentiometer() ? Text::wait_input_potentiometer : Text::wait_input_running, tongue));
    case Place::input_waiting:
      if (const int tool = state.run.tool_due(); tool != 0) return tool_sentence(tool, tongue);
      return std::string(text(Text::wait_input_waiting, tongue));
    case Place::input_rest:
      return std::string(text(Text::wait_input_rest, tongue));
    case Place::input_word: {
      if (mode.is_done) break;
      const auto& content = mode.line.content();
      const char letter = language::letter(content.words[content.word].address);
      return text(Text::wait_input_word, tongue, {std::string_view(&letter, 1)});
    }
    default:
      break;
  }
  return std::string(text(mode.is_done ? Text::wait_input_done : Text::wait_input_function, tongue));
}

}  // namespace cnclab::panel
