// What a cell looks like on this terminal: plain ASCII where it has no Unicode (DEC-01), never a control character.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "shared/screen.hpp"

namespace cnclab::station {

/// What a terminal can show.
enum class Glyphs : std::uint8_t {
  all,
  no_braille,  ///< a console's font of 512 signs: frames and umlauts, but not the dots of GRAFIK
  ascii,
};

/// One code point that fills exactly one column: the same, or its ASCII likeness.
[[nodiscard]] char32_t shown_code(char32_t code, Glyphs glyphs);

/// The screen with signs as two characters that are more than one without Unicode: `→` as `->` (DEC-01), ä as `ae` and
/// Ä as `AE`, as the original's own texts have them, ± as `+-`. The text behind moves right by one column up to where
/// two columns are blank, or the field ends; a sign without that room stays, to become its likeness of one column.
[[nodiscard]] Screen spelled_out(Screen screen);
/// The same of a text that has room.
[[nodiscard]] std::string spelled_out(std::string_view text);

/// A text from the server without control characters, for stderr and replies: one line.
[[nodiscard]] std::string printable(std::string_view text);

/// Lines of at most `columns` characters, broken at blanks where there are any; none of an empty text.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

}  // namespace cnclab::station
