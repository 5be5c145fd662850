// The printer's listing (EXT-005, appendix of the manual): a program as the control prints it, and reading that back.
//
//   P0001
//
//   (09:00:00 16/06/83)
//
//   N001 G68 X+...0.000 Y+...0.000 Z+...0.000 (ISTWERT SETZEN)
//   N002 G01 X+..20.000 Y.....,... Z.....,... F.... S.... T01 M..
//   N003 ↓01          #01 = #02 + #03
//   %
//
// A line is a program's number, a block, "%", or nothing that counts: blanks and text in parentheses, with the texts of
// the block forms and the date among it, say nothing. In a block
//
//   dots before a number are places without a digit; a word of dots (and a comma) only is empty;
//   lengths are millimetres and have a point or a comma; "N003!" marks a damaged block (SCR-052);
//   "↓" may be written "\". The calculations have their operator or its name: "#01 = #02 + #03", "#55 = COPY #64".
#pragma once

#include <string>
#include <string_view>

#include "language/tape.hpp"

namespace cnclab::language {

/// One program as printed, from its number to "%"; several follow each other (D-108). Damaged blocks carry their mark.
///
/// time_stamp   time of printing, "09:00:00 16/06/83"
[[nodiscard]] std::string write_listing(const Program& program, std::string_view time_stamp, Tongue tongue);

/// Reads what `write_listing` writes and what the manual prints, by the rules of `read_tape` in a file: every error
/// with its line, programs with an error left out, nothing at all after a small letter outside parentheses. A marked
/// block is damaged again. There are no machine data in a listing.
///
/// tongue   of the notices
[[nodiscard]] Tape read_listing(std::string_view text, Tongue tongue = Tongue::german);

}  // namespace cnclab::language
