// Names and passwords: from files, or asked for on the terminal.
#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>

#include "instructor/failure.hpp"

namespace cnclab::instructor {

/// The first line without its end. errors: cannot be read, empty.
[[nodiscard]] std::expected<std::string, Failure> password_in(const std::filesystem::path& file);

/// Asks on the terminal of the process, whatever stdin and stdout are; nothing where there is no terminal.
[[nodiscard]] std::optional<std::string> ask(const std::string& question);
/// As `ask`, without echo.
[[nodiscard]] std::optional<std::string> ask_secret(const std::string& question);
/// Twice, until both are the same; nothing where there is no terminal or the answer is empty.
[[nodiscard]] std::optional<std::string> ask_new_password();

}  // namespace cnclab::instructor
