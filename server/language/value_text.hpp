// Small pieces of number text that the writer, the screen form and the messages share. Private to this folder.
#pragma once

#include <cstdint>
#include <string>

#include "language/block.hpp"
#include "language/block_form.hpp"

namespace cnclab::language {

/// At least `digits` digits with leading zeros; value >= 0.
void append_digits(std::string& text, std::int64_t value, int digits);

/// "25.000", "-0.005": millimetres with three decimals.
[[nodiscard]] std::string millimetres_text(std::int64_t value_um);

/// A word's value for a message: "4000", "-1500.000", "#04".
[[nodiscard]] std::string value_text(const Word& word);
/// The same for a number that may be too large for a word.
[[nodiscard]] std::string value_text(Address address, std::int64_t value);

/// What a format allows: "0001..9999", "-9999.999..9999.999".
[[nodiscard]] std::string range_text(const WordFormat& format);

}  // namespace cnclab::language
