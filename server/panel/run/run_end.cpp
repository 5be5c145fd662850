// One table of causes, told the same way in every motion mode.
#include "panel/run/run_end.hpp"

#include <string_view>

#include "testrun/finding.hpp"

namespace cnclab::panel {

namespace {

constexpr std::string_view kAxes = "XYZU";

void tell_limit_switch(ControlState& state, Text sentence = Text::said_limit_switch) {
  const std::uint8_t axis = state.machine().limit_axis;
  const std::size_t index = axis < kAxes.size() ? axis : 0;
  state.message = Message{std::string(text(Text::limit_switch, state.tongue())), limit_column(index),
                          text(sentence, state.tongue(), {kAxes.substr(index, 1)})};
}

}  // namespace

void tell_break(ControlState& state, machine::StopCause cause) {
  const bool is_on_switch = state.machine().limit_axis < kAxes.size();
  if (is_on_switch && cause != machine::StopCause::limit_switch) return tell_limit_switch(state);
  switch (cause) {
    case machine::StopCause::limit_switch:
      return tell_limit_switch(state);
    case machine::StopCause::power_off:
      state.message.sentence = text(Text::said_power_off, state.tongue());
      return;
    case machine::StopCause::machine_halt:
      state.message.sentence = text(Text::said_machine_halt, state.tongue());
      return;
    case machine::StopCause::lease_ended:
    case machine::StopCause::lease_expired:
      state.message.sentence = text(Text::said_lease, state.tongue());
      return;
    case machine::StopCause::none:
    case machine::StopCause::operator_stop:
    case machine::StopCause::program_end:
    case machine::StopCause::programmed_halt:
    case machine::StopCause::waiting_for_input:
    case machine::StopCause::single_block:
    case machine::StopCause::error:
      return;
  }
}

void tell_back_off(ControlState& state) { tell_limit_switch(state, Text::said_backing_off); }

void tell_milling(ControlState& state, const machine::MillingEvent& event) {
  if (!state.message.monitor.empty()) return;
  testrun::Finding finding{.block = event.source};
  switch (event.kind) {
    case machine::MillingEvent::Kind::rapid_in_material:
      finding.kind = testrun::Finding::Kind::rapid_in_material;
      break;
    case machine::MillingEvent::Kind::spindle_off_in_material:
      finding.kind = testrun::Finding::Kind::spindle_off_in_material;
      break;
  }
  state.message.sentence = testrun::explain(finding, state.tongue());
}

}  // namespace cnclab::panel
