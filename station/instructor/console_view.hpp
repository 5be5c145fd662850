// The console's screen, drawn from what it knows.
#pragma once

#include <optional>

#include "instructor/console_model.hpp"
#include "shared/screen.hpp"

namespace cnclab::instructor {

/// Two screens stand side by side from so many columns on, with one between them.
inline constexpr int kWideColumns = 2 * Screen::kColumns + 1;

struct Drawn {
  Screen screen;
  std::optional<Screen> beside;  ///< right of it, in wide terminals: the station's screen that is watched
};

/// Rows 0 title, 1 headings, 2–16 the seats, 18 machine, 19 tick, 21 message or the command being typed, 22 and 23
/// keys. `columns`: what the terminal has; below kWideColumns a watched screen takes the place of all that.
[[nodiscard]] Drawn draw_console(const ConsoleModel& model, int columns = Screen::kColumns);

}  // namespace cnclab::instructor
