// Printed lists and screens as pictures of pages: letters as words, frames, arrows and dots as shapes, since no font of
// a PDF reader has them all.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/picture.hpp"

namespace cnclab::drawing {

/// One page of lines, UTF-8, as `transfer::set_pages` gives them: 80 columns and 66 lines fill A4.
[[nodiscard]] Picture text_page(std::span<const std::string> lines, std::string_view title);

/// A run of cells that stands inverse on a screen.
struct InverseRun {
  int row = 0, column = 0, length = 0;
};

/// A hardcopy of a screen of 24 rows of 80 columns (SYS-013).
[[nodiscard]] Picture screen_page(std::span<const std::string> rows, std::span<const InverseRun> inverse,
                                  std::string_view title);

}  // namespace cnclab::drawing
