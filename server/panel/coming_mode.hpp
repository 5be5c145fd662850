// Operating modes in preparation: their header and title stand, their keys but MENU have no effect yet (2 L259).
#pragma once

#include <string>

#include "panel/canvas.hpp"
#include "panel/control_state.hpp"
#include "panel/key_table.hpp"

namespace cnclab::panel {

struct ComingMode {
  Mode mode = Mode::hand;
};

[[nodiscard]] Place place_of(const ComingMode& mode);
void draw(const ComingMode& mode, const ControlState& state, Monitor& monitor);
[[nodiscard]] std::string sentence_of(const ComingMode& mode, const ControlState& state);

}  // namespace cnclab::panel
