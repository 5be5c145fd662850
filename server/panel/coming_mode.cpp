// IN VORBEREITUNG.
#include "panel/coming_mode.hpp"

namespace cnclab::panel {

Place place_of(const ComingMode&) { return Place::external_data; }

void draw(const ComingMode&, const ControlState& state, Monitor& monitor) {
  const std::string_view notice = text(Text::in_preparation, state.tongue());
  monitor.write(Monitor::kRows / 2 - 1, (Monitor::kColumns - columns_of(notice)) / 2, notice);
}

std::string sentence_of(const ComingMode& mode, const ControlState& state) {
  return text(Text::wait_coming, state.tongue(), {title_of(mode.mode, state.tongue())});
}

}  // namespace cnclab::panel
