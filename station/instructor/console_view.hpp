// The console's screen, drawn from what it knows.
#pragma once

#include "instructor/console_model.hpp"
#include "shared/screen.hpp"

namespace cnclab::instructor {

/// Rows 0 title, 1 headings, 2–16 the seats, 18 machine, 19 tick, 21 message or the command being typed, 22 and 23
/// keys.
[[nodiscard]] Screen draw_console(const ConsoleModel& model);

}  // namespace cnclab::instructor
