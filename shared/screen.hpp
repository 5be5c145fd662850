// The 24×80 screen that a control draws and a terminal shows, and the difference between two of them.
//
// Rows are shared between copies, so keeping the last acknowledged screen costs pointers and comparing equal rows costs
// nothing. Only rows that differ travel (proto/cnclab/v1/screen.proto).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cnclab {

enum class Attribute : std::uint8_t { normal, inverse, bold, dim };

struct Cell {
  char32_t code = U' ';
  Attribute attribute = Attribute::normal;
  friend bool operator==(const Cell&, const Cell&) = default;
};

class Screen {
 public:
  static constexpr int kRows = 24, kColumns = 80;
  using Row = std::array<Cell, kColumns>;

  Screen();  ///< blank

  [[nodiscard]] const Cell& at(int row, int column) const;
  void put(int row, int column, Cell cell);  ///< outside the grid: ignored
  /// Writes UTF-8 from (row, column) to the right, cut at `width` cells (default: end of row).
  void write(int row, int column, std::string_view utf8, Attribute attribute = Attribute::normal, int width = kColumns);
  [[nodiscard]] const Row& row(int index) const { return *rows_[static_cast<std::size_t>(index)]; }
  void set_row(int index, const Row& row);
  /// The row as UTF-8, exactly 80 columns.
  [[nodiscard]] std::string text(int row) const;
  /// Rows of `newer` that differ from this screen.
  [[nodiscard]] std::vector<int> changed_rows(const Screen& newer) const;
  friend bool operator==(const Screen& a, const Screen& b);

 private:
  std::array<std::shared_ptr<const Row>, kRows> rows_;
};

/// UTF-8 of one code point; and back, U+FFFD for malformed bytes.
[[nodiscard]] std::string to_utf8(char32_t code);
[[nodiscard]] std::string to_utf8(std::u32string_view text);
[[nodiscard]] std::u32string from_utf8(std::string_view utf8);
/// The text in at most `columns`, 3 or more; of a longer one its middle is left out, so that names that differ at their
/// ends still do: "schuel…26-01".
[[nodiscard]] std::string shortened(std::string_view utf8, std::size_t columns);

}  // namespace cnclab
