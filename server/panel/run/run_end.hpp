// What the operator is told when a motion ended otherwise than by its own end or STOP.
#pragma once

#include <cstddef>

#include "machine/milling.hpp"
#include "panel/control_state.hpp"

namespace cnclab::panel {

/// The column of an axis' `Endschalter` on the monitor's last line: X, Y, Z, U from left to right (ERR-022, D-118).
[[nodiscard]] constexpr int limit_column(std::size_t axis) {
  constexpr int kColumnsPerAxis = 16;
  return static_cast<int>(axis) * kColumnsPerAxis;
}

/// Row 18 for what the machine or the lab broke off. An axis that ran onto its switch stands on the monitor's last line
/// too, whatever had begun to stop it before.
void tell_break(ControlState& state, machine::StopCause cause);

/// ERR-020 while it lasts: `Endschalter` stands at once, and row 18 says that the axis is being driven free.
void tell_back_off(ControlState& state);

/// Row 18 for what the tool did to the workpiece in a block, or by hand. What the monitor complains of stays.
void tell_milling(ControlState& state, const machine::MillingEvent& event);

}  // namespace cnclab::panel
