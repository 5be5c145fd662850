// Fields that move with the machine.
#include "panel/screen/motion_screen.hpp"

#include <array>
#include <cmath>
#include <string>

#include "language/screen_form.hpp"
#include "panel/screen/names.hpp"
#include "panel/screen/status_line.hpp"

namespace cnclab::panel {

void draw_start_and_stop(bool is_started, int start_row, Monitor& monitor) {
  monitor.write(start_row, 0, "START", is_started ? Attribute::inverse : Attribute::normal);
  monitor.write(start_row + 1, 0, "STOP", is_started ? Attribute::normal : Attribute::inverse);
}

void draw_istwerte(const machine::Snapshot& machine, Monitor& monitor) {
  constexpr std::array<std::string_view, 3> kAxes{"X ", "Y ", "Z "};
  constexpr double kUmPerMm = 1000;
  constexpr std::size_t kWidth = 10;  // a fifth digit takes the place of a blank
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const language::Micrometres value{std::llround(machine.istwert_mm[axis] * kUmPerMm)};
    std::string digits = language::istwert_text(value);
    if (digits.size() < kWidth) digits.insert(0, kWidth - digits.size(), ' ');
    monitor.write(kIstwertRow + static_cast<int>(axis), kIstwertColumn, std::string(kAxes[axis]) + digits);
  }
}

void draw_state_lines(const program::ModalState& modal, const ControlState& state, int start_row, Monitor& monitor) {
  monitor.write(start_row, kStateColumn, status_line(modal, state.settings.vocabulary.model));
  monitor.write(start_row + 1, kStateColumn, inputs_and_outputs(state.machine()));
}

void draw_tool_due(const Run& run, language::Tongue tongue, Monitor& monitor) {
  if (const int tool = run.tool_due(); tool != 0)
    monitor.write(Monitor::kMessageRow, 0, text(Text::insert_tool, tongue, {two_digits(tool)}));
}

std::string tool_sentence(int tool, language::Tongue tongue) {
  return text(Text::wait_tool, tongue, {two_digits(tool)});
}

}  // namespace cnclab::panel
