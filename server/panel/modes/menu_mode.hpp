// MENU: the eight operating modes with their keys (SCR-020 to SCR-022, D-18).
#pragma once

#include "panel/control_state.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct MenuMode {};

void draw(const MenuMode& mode, const ControlState& state, Monitor& monitor);

}  // namespace cnclab::panel
