// The parts of a station's screen: the control's monitor of 16 rows, and what changes by itself taken out (DEC-01).
#include "harness/monitor.hpp"

#include <algorithm>

#include "harness/failure.hpp"
#include "shared/screen.hpp"

namespace cnclab::harness {
namespace {

constexpr std::size_t kMonitorColumn = 1, kMonitorColumns = 64, kSideColumn = 66;
constexpr std::size_t kClockRow = 1;

std::string cells(const ScreenRows& rows, int row, std::size_t from, std::size_t count) {
  const auto codes = from_utf8(rows.at(static_cast<std::size_t>(row)));
  if (codes.size() != Screen::kColumns) throw Failure("a screen row has " + std::to_string(codes.size()) + " columns");
  std::string text;
  for (const char32_t code : codes.substr(from, count)) text += to_utf8(code);
  return text;
}

}  // namespace

std::string monitor_row(const ScreenRows& rows, int row) {
  std::string text = cells(rows, row, kMonitorColumn, kMonitorColumns);
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string side_row(const ScreenRows& rows, int row) {
  std::string text = cells(rows, row, kSideColumn, Screen::kColumns - kSideColumn);
  text.erase(text.find_last_not_of(' ') + 1);
  text.erase(0, text.find_first_not_of(' '));
  return text;
}

ScreenRows without_clock(ScreenRows rows) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  auto& row = rows.at(kClockRow);
  const auto from = row.find("CNC 3300") == std::string::npos ? row.begin() : row.begin() + 12;
  std::replace_if(from, row.end(), is_digit, '0');
  return rows;
}

}  // namespace cnclab::harness
