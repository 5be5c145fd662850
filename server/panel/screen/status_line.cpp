// Modal state and I/O cards as text.
#include "panel/screen/status_line.hpp"

#include <array>

namespace cnclab::panel {

namespace {

std::string digits(int value, std::size_t places) {
  const std::string text = std::to_string(value);
  return text.size() < places ? std::string(places - text.size(), '0') + text : text;
}

std::string lines_of(std::uint8_t card) {
  std::string text;
  for (unsigned line = 0; line < 8; ++line) text += ((card >> line) & 1U) != 0 ? '1' : '0';
  return text;
}

}  // namespace

std::string status_line(const program::ModalState& modal, language::Model model) {
  constexpr std::array<std::string_view, 3> kPlanes{"G17 ", "G18 ", "G19 "};
  constexpr std::array<std::string_view, 5> kRadius{"G40 ", "G41 ", "G42 ", "G43 ", "G44 "};
  std::string line;
  if (model == language::Model::cnc3300) {
    line += kPlanes[static_cast<std::size_t>(modal.plane)];
    line += kRadius[static_cast<std::size_t>(modal.radius)];
    line += modal.length_compensation ? "G46 " : "G45 ";
  }
  line += modal.scale_on ? "G75 " : "G74 ";
  line += modal.dimension == program::Dimension::absolute ? "G90 " : "G91 ";
  line.append("F").append(digits(modal.feed_mm_per_min, 4)).append(" S").append(digits(modal.spindle_rpm, 4));
  return line.append(" T").append(digits(modal.tool, 2)).append(" M").append(digits(modal.m, 2));
}

std::string inputs_and_outputs(const machine::Snapshot& snapshot) {
  return lines_of(snapshot.inputs[0]) + ' ' + lines_of(snapshot.outputs[0]) + ' ' + lines_of(snapshot.inputs[1]) + ' ' +
         lines_of(snapshot.outputs[1]);
}

}  // namespace cnclab::panel
