// One line of a listing, made bare and turned into tape text, which the readers of tapes understand. Private to this
// folder.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "language/error.hpp"

namespace cnclab::language {

/// A line without what does not count.
struct BareLine {
  std::string text;               ///< capitals, "\" for "↓", one blank for each other character without meaning
  char lower_case = 0;            ///< the first small letter outside parentheses; 0 where there is none
  bool has_open_comment = false;  ///< a "(" without its ")"
};

[[nodiscard]] BareLine bare_line(std::string_view line);

/// A block's line as tape text: "N003G01X+25.000F1000M03".
struct TapeLine {
  std::string tape;            ///< up to the fault, where there is one
  bool is_damaged = false;     ///< "N003!"
  std::optional<Error> fault;  ///< what no tape text can say; place and line are the caller's to fill in
};

/// text   of a bare line that begins with the block's letter
[[nodiscard]] TapeLine tape_line(std::string_view text);

/// The whole character at a place, which may take several bytes; for messages.
[[nodiscard]] std::string character_at(std::string_view text, std::size_t place);

}  // namespace cnclab::language
