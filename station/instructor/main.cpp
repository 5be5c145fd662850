// cnclab-instructor: the console, or one command for scripts (interfaces.md section 4).
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "instructor/command_line.hpp"
#include "instructor/console.hpp"
#include "instructor/one_shot.hpp"

namespace {

using namespace cnclab::instructor;

/// Gives the exit code.
int report(const Failure& failure) {
  std::fprintf(stderr, "error: %s\n", failure.text.c_str());
  return failure.exit_code;
}

int run_command(const CommandLine& line) {
  boost::asio::io_context context;
  std::expected<void, Failure> result;
  boost::asio::co_spawn(context, run_one_shot(line.access, *line.command, stdout),
                        [&](const std::exception_ptr& error, std::expected<void, Failure> ended) {
                          if (error) std::rethrow_exception(error);
                          result = std::move(ended);
                        });
  context.run();
  if (result) return 0;
  report(result.error());
  return kRefused;  // whatever the reason (interfaces.md section 4)
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const auto line = read_command_line({argv + 1, argv + argc});
    if (!line) {
      std::fputs(line.error().text.c_str(), line.error().exit_code == 0 ? stdout : stderr);
      return line.error().exit_code;
    }
    if (line->command) return run_command(*line);
    const auto ended = run_console(line->access, line->is_ascii);
    return ended ? 0 : report(ended.error());
  } catch (const std::exception& error) {
    return report({kRefused, error.what()});
  }
}
