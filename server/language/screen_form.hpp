// A block as the monitor and the printer show it: placeholders, dots, texts (SCR-010 to SCR-016, SCR-051).
#pragma once

#include <string>

#include "language/block.hpp"
#include "language/block_form.hpp"

namespace cnclab::language {

/// The whole line, UTF-8: "N003 G01 X+..25.000 Y+..10.000 Z+...4.000 F1000 S.... T.. M03". A damaged block carries
/// "!" behind its number (SCR-052). At most 64 columns.
[[nodiscard]] std::string block_line(const Block& block, Plane plane, Tongue tongue);

/// One word with its address as shown: "X+..50.000", "X.....,...", "X......#04", "F1000", "F....", "H0010".
[[nodiscard]] std::string word_text(Address address, const Word* word);

/// An Istwert: "+0085.000" (SCR-010).
[[nodiscard]] std::string istwert_text(Micrometres value);

}  // namespace cnclab::language
