// What a cell looks like on this terminal: plain ASCII where it has no Unicode (DEC-01), never a control character.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

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

/// The screen with every arrow `→` as `->` (DEC-01). The text behind an arrow moves right by one column up to where two
/// columns are blank, or the field ends; an arrow without that room stays, to become `>`.
[[nodiscard]] Screen with_wide_arrows(Screen screen);

/// A text from the server without control characters, for stderr and replies: one line.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace cnclab::station
