// The live console in a terminal: fifteen seats, the machine, and the keys that command them.
#pragma once

#include <expected>

#include "instructor/command_line.hpp"
#include "instructor/failure.hpp"

namespace cnclab::instructor {

/// Asks for name and password where they are missing, then runs until the user quits or a signal ends it; the terminal
/// is as before. Needs a terminal of 80×24. is_ascii  draws without Unicode, as it also does in a locale without UTF-8
[[nodiscard]] std::expected<void, Failure> run_console(Access access, bool is_ascii);

}  // namespace cnclab::instructor
