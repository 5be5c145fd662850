// The command line of cnclab-instructor: how to connect, and at most one command (interfaces.md section 4).
#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cnclab/v1/instructor.pb.h"
#include "station/client.hpp"
#include "station/language.hpp"

namespace cnclab::instructor {

/// How to reach the server and whom to be there.
struct Access {
  station::Address address;
  station::Trust trust;
  std::string user;                         ///< empty: asked for on the terminal
  std::filesystem::path password_file;      ///< empty: asked for on the terminal
  std::filesystem::path new_password_file;  ///< answers a forced change
};

/// A command and what becomes of its answer.
struct Command {
  v1::InstructorRequest request;
  bool changes_own_password = false;   ///< `passwd`: the new password comes from the access options or the terminal
  std::filesystem::path content_file;  ///< where the content goes that comes as chunks; empty: none is expected
  bool is_collection = false;          ///< the content is everybody's programs: one file for each beside content_file
  std::filesystem::path sent_file;     ///< whose text the request carries: faults in it name it
};

/// The server's error about `command`: where it names a line of the file that was sent, as FILE:LINE: message.
[[nodiscard]] std::string with_sent_file(const Command& command, const std::string& error);

struct CommandLine {
  Access access;
  bool is_ascii = false;           ///< the console draws without Unicode
  std::optional<Command> command;  ///< nothing: the console
};

/// The program ends before it has connected: help (0, stdout) or a wrong command line ("error: …", 1, stderr).
struct EarlyEnd {
  int exit_code = 0;
  std::string text;
};

/// arguments   without the program's name
[[nodiscard]] std::expected<CommandLine, EarlyEnd> read_command_line(const std::vector<std::string>& arguments);

/// A command as the console's own command line takes it. errors: what is wrong with it, in one line
[[nodiscard]] std::expected<Command, std::string> read_command(const std::vector<std::string>& words,
                                                               station::Language language);
/// Words between blanks; "…" keeps blanks together.
[[nodiscard]] std::vector<std::string> words_of(const std::string& line);

/// "P0001" or "1": 0..9999.
[[nodiscard]] std::optional<std::uint32_t> program_number(const std::string& text);

}  // namespace cnclab::instructor
