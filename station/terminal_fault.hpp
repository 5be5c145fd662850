// Whether the terminal is one to draw on.
#pragma once

#include <optional>

#include "station/language.hpp"

namespace cnclab::station {

/// Why nothing can be drawn on the terminal of stdout: TERM is unknown, or names one whose cursor cannot be placed.
/// Nothing where it can. To be asked before ncurses has the terminal.
[[nodiscard]] std::optional<Text> terminal_fault();

}  // namespace cnclab::station
