// The commands of cnclab-instructor as subcommands of its command line, each filling a request.
#pragma once

#include "instructor/command_line.hpp"

namespace CLI {
class App;
}

namespace cnclab::instructor {

/// Adds every command of interfaces.md section 4. Parsing sets `command` to the one that was given; both arguments
/// must live while `app` parses.
void add_commands(CLI::App& app, std::optional<Command>& command);

}  // namespace cnclab::instructor
