// One door for programs in text: a tape or a printed listing, told apart by what stands in it.
#pragma once

#include <string_view>

#include "language/tape.hpp"

namespace cnclab::language {

enum class TextForm : std::uint8_t {
  tape,     ///< see tape.hpp
  listing,  ///< see listing.hpp
};

/// A text is a listing if some line that begins with a block's number shows, outside parentheses, what no tape has:
///
///   a word with a comma, with two points, or with a point before "#":   X+...5,000   F....   X......#04
///   an assignment:                                                      #01 = #02 + #03
///   the mark of a damaged block:                                        N003!
///
/// A text without any of these reads the same in both forms, and is called a tape.
[[nodiscard]] TextForm form_of_text(std::string_view text);

/// Reads programs in either form: `read_listing` or `read_tape`. The control itself reads no listings, so
/// `Reading::strict` takes every text for a tape.
///
/// tongue   of the notices
[[nodiscard]] Tape read_programs_text(std::string_view text, Reading reading, Tongue tongue = Tongue::german);

}  // namespace cnclab::language
