// A picture in characters: each cell of the monitor holds 2 × 4 dots of a braille pattern (DEC-37). A terminal without
// braille shows how full each cell is (station/cell_text.cpp).
//
//     dots of a cell   1 4      bit of dot n = n − 1, code = U+2800 + bits
//                      2 5
//                      3 6
//                      7 8
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "drawing/picture.hpp"

namespace cnclab::drawing {

/// Monitor rows 3 to 15: 64 × 13 cells. Dots are counted from the top left.
class BrailleCanvas {
 public:
  static constexpr int kCellColumns = 64, kCellRows = 13;
  static constexpr int kColumns = kCellColumns * 2, kRows = kCellRows * 4;

  /// Outside the canvas nothing happens.
  void set(int column, int row, bool is_on = true);
  [[nodiscard]] bool is_set(int column, int row) const;
  /// A line in dots, coordinates right and down; both ends may lie far outside. A dashed one has three dots and two
  /// gaps; `phase` counts its dots on from stroke to stroke.
  void line(Flat from, Flat to);
  void dashed_line(Flat from, Flat to, int& phase);

  /// A blank where a cell is empty; UTF-8.
  [[nodiscard]] std::string row_text(int row) const;

 private:
  template <class Draw>
  static void walk(Flat from, Flat to, const Draw& draw);
  [[nodiscard]] std::uint8_t cell(int column, int row) const;

  std::array<std::uint8_t, std::size_t{kCellColumns} * kCellRows> cells_{};
};

}  // namespace cnclab::drawing
