// Writing characters into cells, with everything outside the grid cut off.
#include "panel/screen/canvas.hpp"

#include <algorithm>

namespace cnclab::panel {

Canvas::Canvas() {
  for (Screen::Row& row : rows_) row.fill(Cell{});
}

void Canvas::put(int row, int column, char32_t code, Attribute attribute) {
  if (row < 0 || row >= Screen::kRows || column < 0 || column >= Screen::kColumns) return;
  rows_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = Cell{code, attribute};
}

void Canvas::write(int row, int column, std::string_view utf8, Attribute attribute, int width) {
  int written = 0;
  for (const char32_t code : from_utf8(utf8)) {
    if (written == width) return;
    put(row, column + written, code, attribute);
    ++written;
  }
}

Screen Canvas::screen() const {
  Screen screen;
  for (int row = 0; row < Screen::kRows; ++row) screen.set_row(row, rows_[static_cast<std::size_t>(row)]);
  return screen;
}

void Monitor::write(int row, int column, std::string_view utf8, Attribute attribute) {
  if (row < 0 || row >= kRows || column < 0 || column >= kColumns) return;
  canvas_.write(row + 1, column + 1, utf8, attribute, kColumns - column);
}

void Monitor::put(int row, int column, char32_t code, Attribute attribute) {
  if (row < 0 || row >= kRows || column < 0 || column >= kColumns) return;
  canvas_.put(row + 1, column + 1, code, attribute);
}

int columns_of(std::string_view utf8) {
  return static_cast<int>(std::ranges::count_if(utf8, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

}  // namespace cnclab::panel
