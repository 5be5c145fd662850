// lab.toml: read, checked, and printed with comments (interfaces.md section 2).
#pragma once

#include <expected>
#include <filesystem>
#include <string>
#include <string_view>

#include "lab/configuration.hpp"

namespace cnclab {

/// errors: file, line and what is wrong: unknown key, wrong type, value outside its limits.
[[nodiscard]] std::expected<lab::Configuration, std::string> read_configuration(const std::filesystem::path& file);

/// The same for a text; errors name `file`.
[[nodiscard]] std::expected<lab::Configuration, std::string> parse_configuration(
    std::string_view text, const std::filesystem::path& file = "lab.toml");

/// Every key with its value and a comment, as a file that `read_configuration` reads.
[[nodiscard]] std::string print_configuration(const lab::Configuration& configuration);

}  // namespace cnclab
