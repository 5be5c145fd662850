// What the printer gives: lists set on pages of A4 in a monospaced script (EXT-003 to EXT-005, D-108).
//
//   CNC 3300  P0001                 schueler07          16/06/83 09:00:00  Seite 1/2      1 line, then one of "─"
//   P0001                                                                                 up to 64 lines of 80 columns
//   …
//
// A line wider than the page is broken, never cut. Form feeds in the text begin a page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language/units.hpp"

namespace cnclab::transfer {

inline constexpr std::size_t kPageColumns = 80;
inline constexpr std::size_t kPageLines = 66;  ///< 6 per inch on 11 inches, header included; A4 has room for 70

struct PrintHeader {
  std::string what;     ///< "CNC 3300  P0001", "WERKZEUGE", …
  std::string student;  ///< cut to what there is room for, as is `what`
  std::string date;     ///< as it is to stand there: "16/06/83 09:00:00"
  language::Tongue tongue = language::Tongue::german;
};

/// Lines of one page, UTF-8, each at most kPageColumns wide.
using PrintPage = std::vector<std::string>;

/// Sets a text of lines on pages; an empty one gives one page with its header. Control characters become blanks,
/// invalid UTF-8 becomes "?".
[[nodiscard]] std::vector<PrintPage> set_pages(std::string_view text, const PrintHeader& header);

/// The pages as a text file: form feed between them.
[[nodiscard]] std::string print_text(const std::vector<PrintPage>& pages);

}  // namespace cnclab::transfer
