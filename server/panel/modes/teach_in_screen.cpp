// Bild 4: what TEACH IN shows.
#include "panel/modes/teach_in_mode.hpp"

namespace cnclab::panel {

void draw(const TeachInMode& mode, const ControlState& state, Monitor& monitor) {
  constexpr int kProgramRow = 5, kLineRow = 6;
  draw(mode.driving, state, monitor);
  const std::string_view label = text(Text::program_number, state.tongue());
  const int column = columns_of(label);
  monitor.write(kProgramRow, 0, label);
  if (mode.program.value) monitor.write(kProgramRow, column, program_word(*mode.program.value));
  if (!mode.is_open) return monitor.mark(kProgramRow, column);
  mode.line.draw(monitor, kLineRow, language::Plane::xy, state.tongue(), EntryLine::Style::fixed_number);
}

std::string sentence_of(const TeachInMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  if (state.storing) return std::string(text(Text::wait_store, tongue));
  switch (place_of(mode)) {
    case Place::teach_program:
      if (!mode.program.value) return std::string(text(Text::said_number_missing, tongue));
      return text(Text::wait_teach_program, tongue, {program_text(*mode.program.value)});
    case Place::teach_word: {
      if (mode.driving.has_direction()) break;
      const auto& content = mode.line.content();
      const char letter = language::letter(content.words[content.word].address);
      return text(Text::wait_word, tongue, {std::string_view(&letter, 1)});
    }
    default:
      break;
  }
  const bool is_filled = !mode.line.block().words.empty();
  return sentence_of(mode.driving, state, is_filled ? Text::wait_teach_filled : Text::wait_teach_empty,
                     Text::wait_chosen_for_way);  // REFERENZ has no effect here (KEY-047)
}

}  // namespace cnclab::panel
