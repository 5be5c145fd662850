// Keys and screen of SPEICHER LÖSCHEN (Bild 8).
#include "panel/modes/erase_memory_mode.hpp"

#include <algorithm>

namespace cnclab::panel {

namespace {

using language::Error;
using language::ErrorCode;

constexpr std::size_t kMostLines = 11;  ///< the oldest scrolls off (DEC-59)

void erase_program(EraseMemoryMode& mode, ControlState& state) {
  if (!mode.program.value) {
    state.hint = text(Text::said_nothing_to_erase, state.tongue());
    return;
  }
  const auto number = static_cast<std::uint16_t>(*mode.program.value);
  mode.program.typed = 0;
  if (language::is_reserved_for_cycles(number))
    return state.complain(Error{.code = ErrorCode::reserved_for_cycles, .program = number});
  if (state.memory.find(number) == nullptr)
    return state.complain(Error{.code = ErrorCode::program_missing, .detail = program_word(number)});
  state.storing = RemovePrograms{{number}};
}

void erase_all(EraseMemoryMode& mode, ControlState& state) {
  mode.takes_all = false;
  if (state.connection.is_lab_machine) {  // its data would change under the lab's machine (DEC-39)
    state.hint = text(Text::said_not_on_lab_machine, state.tongue());
    return;
  }
  state.storing = state.whole_memory();
}

}  // namespace

Place place_of(const EraseMemoryMode& mode) { return mode.takes_all ? Place::erase_all : Place::erase_program; }

void disarm(EraseMemoryMode& mode, Effect effect) {
  if (effect != Effect::enter) mode.takes_all = false;
}

void press(EraseMemoryMode& mode, ControlState& state, Effect effect, int figure) {
  switch (effect) {
    case Effect::digit:
      return mode.program.digit(figure);
    case Effect::clear:
      mode.takes_all = true;
      return mode.program.clear();
    case Effect::enter:
      return mode.takes_all ? erase_all(mode, state) : erase_program(mode, state);
    default:
      return;
  }
}

void stored(EraseMemoryMode& mode, ControlState& state, const StoreRequest& request) {
  if (const auto* removed = std::get_if<RemovePrograms>(&request))
    for (const std::uint16_t number : removed->programs) mode.erased.emplace_back(number);
  if (std::holds_alternative<EraseMemory>(request)) {
    mode.erased.emplace_back(std::nullopt);
    state.initialise();
  }
  mode.program.clear();
  if (mode.erased.size() > kMostLines) mode.erased.erase(mode.erased.begin());
}

void draw(const EraseMemoryMode& mode, const ControlState& state, Monitor& monitor) {
  constexpr int kFirstRow = 2, kSaidOffset = 8;  // "P0001   PROGRAMM GELOESCHT"
  const language::Tongue tongue = state.tongue();
  const std::string_view label = text(Text::program_number, tongue);
  const int column = columns_of(label);
  int row = kFirstRow;
  for (const auto& number : mode.erased) {
    if (number) {
      monitor.write(row, 0, label);
      monitor.write(row, column, program_word(*number));
      monitor.write(row, column + kSaidOffset, text(Text::program_erased, tongue));
    } else {
      monitor.write(row, 0, text(Text::memory_erased, tongue));
    }
    ++row;
  }
  monitor.write(row, 0, label);
  if (mode.program.value) monitor.write(row, column, program_word(*mode.program.value));
  monitor.mark(row, column);
  monitor.write(row + 1, 0, text(Text::all_programs_hint, tongue));
}

std::string sentence_of(const EraseMemoryMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  if (state.storing) return std::string(text(Text::wait_erasing, tongue));
  if (mode.takes_all) return std::string(text(Text::wait_erase_all, tongue));
  if (!mode.program.value) return std::string(text(Text::wait_erase, tongue));
  return text(Text::wait_erase_program, tongue, {program_text(*mode.program.value)});
}

}  // namespace cnclab::panel
