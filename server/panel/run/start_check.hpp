// What every START has to find before anything moves.
#pragma once

#include <optional>

#include "panel/control_state.hpp"

namespace cnclab::panel {

/// The lab's machine is connected, and the instructor or the watchdog has switched its drives off.
[[nodiscard]] bool are_drives_off(const ControlState& state);
/// What that means, and who can change it.
[[nodiscard]] std::string_view drives_off_sentence(const ControlState& state);

/// Is a machine connected that stands still with the data that hold now? Row 18 says what is missing.
[[nodiscard]] bool may_move(ControlState& state);
/// As `may_move`, for a run: a machine that requires it must have been referenced (DEC-27).
[[nodiscard]] bool may_run(ControlState& state);

/// The machine's tool list with the tool that is in the spindle now; nothing where it keeps none (DEC-29).
[[nodiscard]] std::optional<machine::ToolList> tools_at(const ControlState& state);

/// Where the machine stands, as the operator reads it.
[[nodiscard]] geometry::Point istwert_of(const machine::Snapshot& machine);

}  // namespace cnclab::panel
