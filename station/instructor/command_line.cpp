// The command line of cnclab-instructor: how to connect, and at most one command (interfaces.md section 4).
#include "instructor/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "instructor/commands.hpp"
#include "instructor/failure.hpp"
#include "station/cell_text.hpp"
#include "station/command_fault.hpp"
#include "station/known_hosts.hpp"
#include "station/utf8.hpp"

namespace cnclab::instructor {
namespace {

constexpr auto kDescription =
    "Instructor of the CNC training lab.\n"
    "Without a command: the console. With one: prints JSON, one object per line, and exits 0,\n"
    "or prints `error: ...` and exits 1.";

void add_access(CLI::App& app, Access& access, std::string& server) {
  app.add_option("--server", server, "server as HOST:PORT")->capture_default_str()->type_name("HOST:PORT");
  app.add_option("--user", access.user, "instructor's name; asked for where it is missing")->type_name("NAME");
  app.add_option("--password-file", access.password_file, "password in the first line; asked for where it is missing")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  app.add_option("--new-password-file", access.new_password_file, "answers a forced change, and for passwd")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  app.add_option("--fingerprint", access.trust.fingerprint, "SHA256:... that the server prints at its start");
}

EarlyEnd refused(const std::string& text) { return {.exit_code = kRefused, .text = "error: " + text + "\n"}; }

}  // namespace

std::optional<std::uint32_t> program_number(const std::string& text) {
  constexpr std::size_t kDigits = 4;
  const std::string digits = text.starts_with("P") || text.starts_with("p") ? text.substr(1) : text;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (digits.empty() || digits.size() > kDigits || !std::ranges::all_of(digits, is_digit)) return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(digits));
}

std::string with_sent_file(const Command& command, const std::string& error) {
  const auto digits = error.find_first_not_of("0123456789");
  const bool names_line = digits != 0 && digits != std::string::npos && error[digits] == ':';
  return command.sent_file.empty() || !names_line ? error : command.sent_file.string() + ":" + error;
}

std::expected<CommandLine, EarlyEnd> read_command_line(const std::vector<std::string>& arguments) {
  const auto language = station::language_of_locale();
  for (const auto& argument : arguments)
    if (station::line_not_utf8(argument))
      return std::unexpected(
          refused(station::printable(argument) + ": " + std::string(station::kNotUtf8.in(language))));
  CommandLine line;
  std::string server = "127.0.0.1:3300";
  CLI::App app(kDescription, "cnclab-instructor");
  add_access(app, line.access, server);
  app.add_flag("--ascii", line.is_ascii, "the console draws without Unicode");
  app.set_version_flag("--version", "cnclab-instructor " CNCLAB_VERSION);
  add_commands(app, line.command);
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 takes them
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return std::unexpected(refused(station::fault_text(app, error, language)));
    std::ostringstream help;
    app.exit(error, help, help);
    return std::unexpected(EarlyEnd{.exit_code = 0, .text = help.str()});
  }
  const auto address = station::parse_address(server);
  if (!address) return std::unexpected(refused("--server " + server + ": HOST:PORT"));
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

std::expected<Command, std::string> read_command(const std::vector<std::string>& words, station::Language language) {
  std::optional<Command> command;
  CLI::App app("", "");
  app.set_help_flag();  // the page of `?` is the help here
  add_commands(app, command);
  try {
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    return std::unexpected(station::fault_text(app, error, language));
  }
  constexpr station::Text kNone{"Einen Befehl eingeben, z. B. students.", "A command is needed, e.g. students."};
  constexpr station::Text kNotHere{
      "passwd: nur als cnclab-instructor … passwd, damit das Passwort nicht am Bildschirm steht.",
      "passwd: only as cnclab-instructor … passwd, so that the password is not on the screen."};
  if (!command) return std::unexpected(std::string(kNone.in(language)));
  if (command->changes_own_password) return std::unexpected(std::string(kNotHere.in(language)));
  return *command;
}

}  // namespace cnclab::instructor
