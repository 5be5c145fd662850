// Rows of a screen to spans and back; what comes from the line is checked cell by cell.
#include "shared/screen_wire.hpp"

#include <cnclab/v1/screen.pb.h>

#include <algorithm>
#include <optional>
#include <ranges>
#include <span>

namespace cnclab {
namespace {

std::optional<Attribute> attribute_of(std::uint32_t number) {
  if (number > static_cast<std::uint32_t>(Attribute::dim)) return std::nullopt;
  return static_cast<Attribute>(number);
}

// A terminal would obey control characters instead of showing them.
char32_t shown(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0) ? U'\uFFFD' : code; }

void write_row(int index, std::span<const Cell> cells, v1::Row& row) {
  row.set_index(static_cast<std::uint32_t>(index));
  v1::Span* span = nullptr;
  for (const Cell& cell : cells) {
    const auto attribute = static_cast<std::uint32_t>(cell.attribute);
    if (span == nullptr || span->attribute() != attribute) {
      span = row.add_spans();
      span->set_attribute(attribute);
    }
    span->mutable_text()->append(to_utf8(cell.code));
  }
}

void write_part(int index, const Screen::Row& before, const Screen::Row& now, v1::Row& row) {
  const auto first = std::ranges::mismatch(before, now).in2 - now.begin();
  const auto behind =
      std::ranges::mismatch(before | std::views::reverse, now | std::views::reverse).in2.base() - now.begin();
  write_row(index, std::span(now).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(behind - first)),
            row);
  row.set_first_column(static_cast<std::uint32_t>(first));
}

/// base   the row as it is: what a part does not cover stays
std::expected<Screen::Row, std::string> read_row(const Screen::Row& base, const v1::Row& row) {
  Screen::Row cells = base;
  std::size_t column = row.first_column();
  for (const v1::Span& span : row.spans()) {
    const auto attribute = attribute_of(span.attribute());
    if (!attribute) return std::unexpected("unknown attribute " + std::to_string(span.attribute()));
    for (const char32_t code : from_utf8(span.text())) {
      if (column >= cells.size())
        return std::unexpected("row " + std::to_string(row.index()) + " is longer than 80 columns");
      cells[column++] = {shown(code), *attribute};
    }
  }
  const bool is_filled = row.has_first_column() ? column > row.first_column() : column == cells.size();
  if (!is_filled) {
    return std::unexpected("row " + std::to_string(row.index()) + " has " + std::to_string(column) +
                           " columns instead of 80");
  }
  return cells;
}

}  // namespace

void write_rows(const Screen& acknowledged, const Screen& newer, v1::ScreenUpdate& update, RowForm form) {
  update.clear_rows();
  for (const int index : acknowledged.changed_rows(newer)) {
    if (form == RowForm::whole)
      write_row(index, newer.row(index), *update.add_rows());
    else
      write_part(index, acknowledged.row(index), newer.row(index), *update.add_rows());
  }
}

std::expected<Screen, std::string> apply_rows(const Screen& base, const v1::ScreenUpdate& update) {
  Screen screen = base;
  for (const v1::Row& row : update.rows()) {
    if (row.index() >= static_cast<std::uint32_t>(Screen::kRows)) {
      return std::unexpected("row " + std::to_string(row.index()) + " is outside the screen's 24 rows");
    }
    const auto cells = read_row(screen.row(static_cast<int>(row.index())), row);
    if (!cells) return std::unexpected(cells.error());
    screen.set_row(static_cast<int>(row.index()), *cells);
  }
  return screen;
}

}  // namespace cnclab
