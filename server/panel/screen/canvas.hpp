// The sheet on which a whole screen is drawn before it becomes shared rows.
//
// Writing into a plain array and making the rows once at the end keeps drawing cheap: a `Screen` copies a row each time
// it is written to.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "shared/screen.hpp"

namespace cnclab::panel {

class Canvas {
 public:
  Canvas();  ///< blank

  void put(int row, int column, char32_t code, Attribute attribute = Attribute::normal);
  /// Writes UTF-8 from (row, column) to the right; what leaves the grid or `width` is cut.
  void write(int row, int column, std::string_view utf8, Attribute attribute = Attribute::normal,
             int width = Screen::kColumns);
  [[nodiscard]] Screen screen() const;

 private:
  std::array<Screen::Row, Screen::kRows> rows_;
};

/// The original's monitor inside the frame: 16 lines of 64 characters (SCR-008, DEC-01), counted from 0.
class Monitor {
 public:
  static constexpr int kRows = 16, kColumns = 64;
  static constexpr int kMessageRow = 15;  ///< "the last screen line" (D-119)

  explicit Monitor(Canvas& canvas) : canvas_(canvas) {}

  void write(int row, int column, std::string_view utf8, Attribute attribute = Attribute::normal);
  void put(int row, int column, char32_t code, Attribute attribute = Attribute::normal);
  /// The entry marker (SCR-009): the cell holds □, the letter is not shown.
  void mark(int row, int column) { put(row, column, U'□'); }

 private:
  Canvas& canvas_;
};

/// Columns that a UTF-8 text takes; every character of the original is one column wide.
[[nodiscard]] int columns_of(std::string_view utf8);

}  // namespace cnclab::panel
