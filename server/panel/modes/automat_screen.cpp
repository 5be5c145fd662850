// Bild 5: what AUTOMAT shows, with the START and STOP fields of Bild 3 (D-27).
#include <algorithm>
#include <string>

#include "language/screen_form.hpp"
#include "panel/modes/automat_mode.hpp"
#include "panel/screen/block_window.hpp"
#include "panel/screen/motion_screen.hpp"

namespace cnclab::panel {

namespace {

constexpr int kProgramRow = 4, kWindowRow = 8;
constexpr std::size_t kWindowLines = 5;

void draw_prompts(const AutomatMode& mode, const ControlState& state, Monitor& monitor) {
  const std::string_view label = text(Text::program_number, state.tongue());
  const int column = kStateColumn + columns_of(label);
  constexpr int kBlockOffset = 6;  // "P0001 "
  const geometry::SourceBlock current = current_block(mode, state);
  monitor.write(kProgramRow, kStateColumn, label);
  const bool is_asked = mode.phase == AutomatMode::Phase::program;
  const int number = is_asked ? mode.program_number() : current.program;
  if (!is_asked || mode.program.value) monitor.write(kProgramRow, column, program_word(number));
  if (is_asked) monitor.mark(kProgramRow, column);
  if (mode.phase != AutomatMode::Phase::block) return;
  monitor.write(kProgramRow, column + kBlockOffset, std::string(1, 'N').append(mode.block.text()));
  monitor.mark(kProgramRow, column + kBlockOffset);
}

void draw_lines(const std::vector<WindowLine>& window, const ControlState& state, Monitor& monitor) {
  int row = kWindowRow;
  for (const WindowLine& line : window)
    monitor.write(row++, 0, language::block_line(*line.block, line.plane, state.tongue()));
}

void draw_window(const AutomatMode& mode, const ControlState& state, const program::ModalState& modal,
                 Monitor& monitor) {
  const auto plane = static_cast<language::Plane>(modal.plane);
  const geometry::SourceBlock current = current_block(mode, state);
  if (state.run.is_present()) {
    if (state.run.shows_blocks())
      draw_lines(window_from(state.run.programs(), current, kWindowLines, plane), state, monitor);
    return;
  }
  if (mode.phase != AutomatMode::Phase::ready) return;
  draw_lines(window_from(mode.programs, current, kWindowLines, plane), state, monitor);
}

}  // namespace

std::optional<geometry::SourceBlock> damaged_block(const AutomatMode& mode, const ControlState& state) {
  if (mode.phase != AutomatMode::Phase::ready || state.run.is_present()) return std::nullopt;
  const auto window = window_from(mode.programs, current_block(mode, state), kWindowLines, state.plane());
  const auto damaged = std::ranges::find_if(window, [](const WindowLine& line) { return line.block->is_damaged; });
  if (damaged == window.end()) return std::nullopt;
  return damaged->place;
}

void draw(const AutomatMode& mode, const ControlState& state, Monitor& monitor) {
  draw_start_and_stop(is_start_state(place_of(mode, state)), kHighStartRow, monitor);
  const program::ModalState modal = state.run.is_present()                    ? state.run.modal()
                                    : mode.phase == AutomatMode::Phase::ready ? mode.first_modal
                                                                              : state.modal;
  draw_state_lines(modal, state, kHighStartRow, monitor);
  draw_istwerte(state.machine(), monitor);
  draw_tool_due(state.run, state.tongue(), monitor);
  draw_prompts(mode, state, monitor);
  draw_window(mode, state, modal, monitor);
}

std::string sentence_of(const AutomatMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  const geometry::SourceBlock current = current_block(mode, state);
  const std::string program = program_text(current.program), block = block_text(current.block);
  if (mode.phase == AutomatMode::Phase::program)
    return mode.program.value ? text(Text::wait_automat_program, tongue, {program})
                              : std::string(text(Text::said_number_missing, tongue));
  if (mode.phase == AutomatMode::Phase::block) return std::string(text(Text::wait_automat_block, tongue));
  switch (state.run.state()) {
    case Run::State::none:
      break;
    case Run::State::running:
      return text(state.awaits_potentiometer() ? Text::wait_potentiometer : Text::wait_running, tongue,
                  {program, block});
    case Run::State::waiting:
      if (const int tool = state.run.tool_due(); tool != 0) return tool_sentence(tool, tongue);
      return text(state.machine().cause == machine::StopCause::waiting_for_input ? Text::wait_input : Text::wait_halt,
                  tongue, {program, block});
    case Run::State::braking:
      return text(Text::wait_stopping, tongue, {program, block});
    case Run::State::stopped:
      return text(Text::wait_stopped, tongue, {program, block});
    case Run::State::between:
      return text(Text::wait_single, tongue, {program, block});
  }
  if (mode.has_ended) return text(Text::wait_ended, tongue, {block});
  if (mode.no_state) return language::explain(*mode.no_state, tongue);
  if (mode.is_rebuilt) return text(Text::wait_ready_rebuilt, tongue, {block});
  return text(Text::wait_ready, tongue, {program, block});
}

}  // namespace cnclab::panel
