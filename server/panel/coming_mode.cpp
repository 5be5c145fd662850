// IN VORBEREITUNG.
#include "panel/coming_mode.hpp"

namespace cnclab::panel {

Place place_of(const ComingMode& mode) {
  switch (mode.mode) {
    case Mode::hand:
      return Place::hand;
    case Mode::hand_input:
      return Place::hand_input;
    case Mode::teach_in:
      return Place::teach_in;
    case Mode::external_data:
      return Place::external_data;
    case Mode::graphics:
      return Place::graphics;
    case Mode::erase_memory:
      return Place::erase_memory;
    case Mode::machine_data:
      return Place::machine_data;
    case Mode::memory_test:
      return Place::memory_test;
    case Mode::menu:
    case Mode::automat:
    case Mode::editor:
      break;  // these have modes of their own
  }
  return Place::menu;
}

void draw(const ComingMode&, const ControlState& state, Monitor& monitor) {
  const std::string_view notice = text(Text::in_preparation, state.tongue());
  monitor.write(Monitor::kRows / 2 - 1, (Monitor::kColumns - columns_of(notice)) / 2, notice);
}

std::string sentence_of(const ComingMode& mode, const ControlState& state) {
  return text(Text::wait_coming, state.tongue(), {title_of(mode.mode, state.tongue())});
}

}  // namespace cnclab::panel
