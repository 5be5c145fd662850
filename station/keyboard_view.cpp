// Laying out the three blocks and the lab's row from the keymap.
#include "station/keyboard_view.hpp"

#include "shared/screen.hpp"
#include "station/cell_text.hpp"

namespace cnclab::station {
namespace {

struct Area {
  KeyGroup group;
  Text title;
  int column, keys_in_row, width;
};

// Widths with a gap of one column between caps: 27 + 27 + 23 = 77 of 80 columns, and the lab's row of seven below.
constexpr Area kAreas[] = {
    {KeyGroup::hand, {"A HANDBETRIEB", "A MANUAL"}, 0, 3, 8},
    {KeyGroup::mode, {"B BETRIEBSARTEN", "B MODES"}, 28, 3, 8},
    {KeyGroup::data, {"C DATENEINGABE", "C DATA"}, 56, 4, 5},
};
constexpr int kLabRow = 10, kLabWidth = 10;

/// Cut to the cap's width, with a point where something is missing: "Leertas."
std::string abbreviated(const std::string& name, int width) {
  const std::u32string cells = from_utf8(name);
  const auto room = static_cast<std::size_t>(width);
  if (cells.size() <= room) return name;
  std::string cut;
  for (const char32_t cell : cells.substr(0, room - 1)) cut += to_utf8(cell);
  return cut + ".";
}

/// How the caps are written.
struct Script {
  Language language;
  bool is_ascii;
  [[nodiscard]] std::string fitted(const std::string& text, int width) const {
    return abbreviated(is_ascii ? spelled_out(std::string_view(text)) : text, width);
  }
};

KeyCap cap_of(const Binding& binding, int row, int column, int width, const Script& script) {
  return {&binding,
          row,
          column,
          width,
          script.fitted(std::string(binding.cap.in(script.language)), width),
          script.fitted(input_name(binding.inputs.front(), script.language), width)};
}

}  // namespace

KeyboardView::KeyboardView(Language language, bool is_ascii) {
  const Script script{language, is_ascii};
  for (const Area& area : kAreas) {
    titles_.push_back({area.column, std::string(area.title.in(language))});
    int index = 0;
    for (const Binding& binding : keymap()) {
      if (binding.group != area.group) continue;
      const int row = 1 + 2 * (index / area.keys_in_row);
      const int column = area.column + (index % area.keys_in_row) * (area.width + 1);
      caps_.push_back(cap_of(binding, row, column, area.width, script));
      ++index;
    }
  }
  int column = 0;
  for (const Binding& binding : keymap()) {
    if (binding.group != KeyGroup::lab || binding.cap.german.empty()) continue;
    caps_.push_back(cap_of(binding, kLabRow, column, kLabWidth, script));
    column += kLabWidth + 1;
  }
}

const KeyCap* KeyboardView::hit(int row, int column) const {
  for (const KeyCap& cap : caps_) {
    const bool is_in_row = row == cap.row || row == cap.row + 1;
    if (is_in_row && column >= cap.column && column < cap.column + cap.width) return &cap;
  }
  return nullptr;
}

}  // namespace cnclab::station
