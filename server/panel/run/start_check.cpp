// The conditions of a START, in the order in which they are told.
#include "panel/run/start_check.hpp"

namespace cnclab::panel {

bool are_drives_off(const ControlState& state) {
  return state.connection.is_lab_machine && state.machine().state == machine::MotionState::off;
}

std::string_view drives_off_sentence(const ControlState& state) { return text(Text::said_drives_off, state.tongue()); }

bool may_move(ControlState& state) {
  if (!state.connection.channel) {
    state.hint = text(Text::said_no_machine, state.tongue());
    return false;
  }
  if (are_drives_off(state)) {
    state.hint = drives_off_sentence(state);
    return false;
  }
  if (!state.apply_data()) {
    state.hint = text(Text::said_not_at_rest, state.tongue());
    return false;
  }
  return true;
}

bool may_run(ControlState& state) {
  if (state.connection.requires_reference && !state.machine().is_referenced) {
    state.hint = text(Text::said_unreferenced, state.tongue());
    return false;
  }
  return may_move(state);
}

std::optional<machine::ToolList> tools_at(const ControlState& state) {
  std::optional<machine::ToolList> tools = state.connection.tools;
  if (tools) tools->set_in_spindle(state.machine().tool);
  return tools;
}

geometry::Point istwert_of(const machine::Snapshot& machine) {
  const auto& mm = machine.istwert_mm;
  return {mm[0], mm[1], mm[2], mm[3]};
}

}  // namespace cnclab::panel
