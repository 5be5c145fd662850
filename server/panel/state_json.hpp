// What outlives a login: a control's state as JSON (SEAT-002, SEAT-004), always coming back in STOP.
//
//   { "v": 1, "mode": "EINGABEMODUS", "override": 80, "modal": {…}, "parameters": {"4": 25000000}, "istwert": [0,0,0],
//     "editor_program": 1, "automat_program": 1, "taught": {…}, "editor": {…} }
//
// Lengths are mm in "istwert" and "compensation", everything else is in the units of the structs. Reading takes any
// text: what is missing, of another type or out of range keeps its default.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "panel/modes/modes.hpp"

namespace cnclab::panel {

[[nodiscard]] std::string write_state(const ActiveMode& mode, const ControlState& state);

struct ReadState {
  std::optional<ActiveMode> mode;  ///< nothing where the text told none
  std::optional<std::array<double, 3>> istwert_mm;
};

/// Fills `state` (modal state, parameters, potentiometer, last programs) and returns what else was kept.
ReadState read_state(const std::string& json, ControlState& state);

}  // namespace cnclab::panel
