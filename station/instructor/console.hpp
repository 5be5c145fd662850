// The live console in a terminal: fifteen seats, the machine, and the keys that command them.
#pragma once

#include <expected>

#include "instructor/command_line.hpp"
#include "instructor/failure.hpp"

namespace cnclab::instructor {

/// Asks for name and password where they are missing, then runs until the user quits. Needs a terminal of 80×24.
[[nodiscard]] std::expected<void, Failure> run_console(Access access);

}  // namespace cnclab::instructor
