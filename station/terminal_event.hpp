// What a user does at a terminal.
#pragma once

#include <variant>

#include "station/keymap.hpp"

namespace cnclab::station {

struct Click {
  int row, column;  ///< 0-based cell
  friend bool operator==(const Click&, const Click&) = default;
};

/// A character that nobody pressed as a key of its own: pasted, or a stop key behind a begun escape sequence. A form
/// takes it as text; elsewhere only a stop key among them acts (AUTH-006: a stop is never lost).
struct Stray {
  char32_t character;
  friend bool operator==(const Stray&, const Stray&) = default;
};

using TerminalEvent = std::variant<Input, Click, Stray>;

}  // namespace cnclab::station
