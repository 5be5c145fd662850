// Dots, lines and cells.
#include "drawing/braille_canvas.hpp"

#include <algorithm>
#include <cmath>

namespace cnclab::drawing {

namespace {

/// Bits by row and column within the cell.
constexpr std::array<std::array<std::uint8_t, 2>, 4> kBits{{{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};

bool is_inside(int column, int row) {
  return column >= 0 && column < BrailleCanvas::kColumns && row >= 0 && row < BrailleCanvas::kRows;
}

std::size_t cell_of(int column, int row) {
  constexpr std::size_t kAcross = BrailleCanvas::kCellColumns;
  return static_cast<std::size_t>(row / 4) * kAcross + static_cast<std::size_t>(column / 2);
}

std::uint8_t bit_of(int column, int row) {
  return kBits[static_cast<std::size_t>(row % 4)][static_cast<std::size_t>(column % 2)];
}

/// Shortens from..to to what lies within low..high in one coordinate; false where nothing does.
bool clip(double Flat::* axis, double low, double high, Flat& from, Flat& to) {
  if (std::max(from.*axis, to.*axis) < low || std::min(from.*axis, to.*axis) > high) return false;
  const Flat a = from, b = to;
  const auto cut = [&](Flat& end) {
    const double wanted = std::clamp(end.*axis, low, high);
    if (wanted == end.*axis) return;
    const double share = (wanted - a.*axis) / (b.*axis - a.*axis);
    end = {a.right + share * (b.right - a.right), a.up + share * (b.up - a.up)};
    end.*axis = wanted;
  };
  cut(from);
  cut(to);
  return true;
}

}  // namespace

void BrailleCanvas::set(int column, int row, bool is_on) {
  if (!is_inside(column, row)) return;
  std::uint8_t& bits = cells_[cell_of(column, row)];
  bits = static_cast<std::uint8_t>(is_on ? bits | bit_of(column, row) : bits & ~bit_of(column, row));
}

bool BrailleCanvas::is_set(int column, int row) const {
  return is_inside(column, row) && (cells_[cell_of(column, row)] & bit_of(column, row)) != 0;
}

template <class Draw>
void BrailleCanvas::walk(Flat from, Flat to, const Draw& draw) {
  if (!clip(&Flat::right, -1, kColumns, from, to) || !clip(&Flat::up, -1, kRows, from, to)) return;
  const double right = to.right - from.right, down = to.up - from.up;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::max(std::abs(right), std::abs(down)))));
  for (int step = 0; step <= steps; ++step)
    draw(static_cast<int>(std::floor(from.right + right * step / steps)),
         static_cast<int>(std::floor(from.up + down * step / steps)));
}

void BrailleCanvas::line(Flat from, Flat to) {
  walk(from, to, [&](int column, int row) { set(column, row); });
}

void BrailleCanvas::dashed_line(Flat from, Flat to, int& phase) {
  constexpr int kDash = 3, kPeriod = 5;
  walk(from, to, [&](int column, int row) {
    if (phase++ % kPeriod < kDash) set(column, row);
  });
}

std::uint8_t BrailleCanvas::cell(int column, int row) const {
  return cells_[static_cast<std::size_t>(row) * std::size_t{kCellColumns} + static_cast<std::size_t>(column)];
}

std::string BrailleCanvas::row_text(int row) const {
  std::string text;
  for (int column = 0; column < kCellColumns; ++column) {
    const unsigned bits = cell(column, row);
    if (bits == 0) {
      text += ' ';
      continue;
    }
    text += '\xE2';  // U+2800 + bits in UTF-8
    text += static_cast<char>(0xA0U | bits >> 6U);
    text += static_cast<char>(0x80U | (bits & 0x3FU));
  }
  return text;
}

}  // namespace cnclab::drawing
