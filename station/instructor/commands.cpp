// The commands of cnclab-instructor, put together.
#include "instructor/commands.hpp"

#include "instructor/command_table.hpp"

namespace cnclab::instructor {

void add_commands(CLI::App& app, std::optional<Command>& command) {
  app.require_subcommand(0, 1);
  CommandTable table(app, command);
  add_machine_commands(table);
  add_roster_commands(table);
  add_program_commands(table);
}

}  // namespace cnclab::instructor
