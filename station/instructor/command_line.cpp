// The command line of cnclab-instructor: how to connect, and at most one command (interfaces.md section 4).
#include "instructor/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "instructor/commands.hpp"
#include "station/known_hosts.hpp"

namespace cnclab::instructor {
namespace {

constexpr auto kDescription =
    "Instructor of the CNC training lab.\n"
    "Without a command: the console. With one: prints JSON, one object per line, and exits 0,\n"
    "or prints `error: ...` and exits 1.";

void add_access(CLI::App& app, Access& access, std::string& server) {
  app.add_option("--server", server, "server as HOST:PORT")->capture_default_str();
  app.add_option("--user", access.user, "instructor's name; asked for where it is missing");
  app.add_option("--password-file", access.password_file, "password in the first line; asked for where it is missing")
      ->check(CLI::ExistingFile);
  app.add_option("--new-password-file", access.new_password_file, "answers a forced change, and for passwd")
      ->check(CLI::ExistingFile);
  app.add_option("--fingerprint", access.trust.fingerprint, "SHA256:... that the server prints at its start");
}

}  // namespace

std::optional<std::uint32_t> program_number(const std::string& text) {
  constexpr std::size_t kDigits = 4;
  const std::string digits = text.starts_with("P") || text.starts_with("p") ? text.substr(1) : text;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (digits.empty() || digits.size() > kDigits || !std::ranges::all_of(digits, is_digit)) return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(digits));
}

std::expected<CommandLine, EarlyEnd> read_command_line(const std::vector<std::string>& arguments) {
  constexpr int kUsage = static_cast<int>(station::ExitCode::usage);
  CommandLine line;
  std::string server = "127.0.0.1:3300";
  CLI::App app(kDescription, "cnclab-instructor");
  add_access(app, line.access, server);
  add_commands(app, line.command);
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 takes them
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = app.exit(error, out, err);
    return std::unexpected(EarlyEnd{.exit_code = code == 0 ? 0 : kUsage, .text = code == 0 ? out.str() : err.str()});
  }
  const auto address = station::parse_address(server);
  if (!address) return std::unexpected(EarlyEnd{kUsage, "--server " + server + ": HOST:PORT is needed\n"});
  line.access.address = *address;
  line.access.trust.known_hosts = station::default_known_hosts();
  return line;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool is_quoted = false, has_word = false;
  for (const char c : line) {
    if (c == '"') {
      is_quoted = !is_quoted;
      if (!has_word) words.emplace_back();
      has_word = true;
    } else if (c == ' ' && !is_quoted) {
      has_word = false;
    } else {
      if (!has_word) words.emplace_back();
      has_word = true;
      words.back() += c;
    }
  }
  return words;
}

std::expected<Command, std::string> read_command(const std::vector<std::string>& words) {
  std::optional<Command> command;
  CLI::App app("", "");
  add_commands(app, command);
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    std::string text = error.what();
    return std::unexpected(text.substr(0, text.find('\n')));
  }
  if (!command) return std::unexpected("a command is needed, e.g. students");
  if (command->changes_own_password)
    return std::unexpected("passwd: run `cnclab-instructor … passwd`, so that the password is not on the screen");
  return *command;
}

}  // namespace cnclab::instructor
