// Cells to lines and inverse runs.
#include "lab/labor/hardcopy.hpp"

#include <algorithm>
#include <vector>

#include "drawing/pdf.hpp"
#include "drawing/text_pages.hpp"
#include "lab/clock.hpp"

namespace cnclab::lab {

namespace {

std::vector<drawing::InverseRun> inverse_runs(const Screen& screen) {
  std::vector<drawing::InverseRun> runs;
  for (int row = 0; row < Screen::kRows; ++row)
    for (int column = 0; column < Screen::kColumns; ++column) {
      if (screen.at(row, column).attribute != Attribute::inverse) continue;
      const bool goes_on = !runs.empty() && runs.back().row == row && runs.back().column + runs.back().length == column;
      if (goes_on)
        ++runs.back().length;
      else
        runs.push_back({.row = row, .column = column, .length = 1});
    }
  return runs;
}

}  // namespace

panel::PutFiles hardcopy_of(const Screen& screen, const std::string& title, const std::string& name) {
  std::vector<std::string> rows;
  std::string text = title + '\n';
  for (int row = 0; row < Screen::kRows; ++row) {
    rows.push_back(screen.text(row));
    const std::size_t last = rows.back().find_last_not_of(' ');
    text += rows.back().substr(0, last == std::string::npos ? 0 : last + 1) + '\n';
  }
  panel::PutFiles files{.files = {{name + ".txt", std::move(text)}}, .is_printed = true};
  const drawing::Picture page = drawing::screen_page(rows, inverse_runs(screen), title);
  if (auto pdf = drawing::pdf_of({&page, 1})) files.files.push_back({name + ".pdf", std::move(*pdf)});
  return files;
}

std::string hardcopy_name(std::int64_t unix_ms) {
  std::string digits = iso_time(unix_ms).substr(0, 19);  // "2026-11-22T10:15:00"
  std::erase_if(digits, [](char c) { return c == '-' || c == ':'; });
  std::ranges::replace(digits, 'T', '-');
  return "BILD-" + digits;
}

}  // namespace cnclab::lab
