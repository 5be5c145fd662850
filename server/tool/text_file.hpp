// Reading the files that the tool is given, with a clear word where one cannot be used.
#pragma once

#include <expected>
#include <string>

#include "language/units.hpp"

namespace cnclab::tool {

/// Larger files are refused: 64 MiB hold more than a million blocks.
inline constexpr std::size_t kLargestFile_bytes = 64UL * 1024 * 1024;

/// The bytes of a file, or of standard input for "-".
/// errors   why it cannot be read, as one sentence with the remedy
[[nodiscard]] std::expected<std::string, std::string> read_file(const std::string& name, language::Tongue tongue);

/// The same for a file that must be text: control characters that no tape has, and bytes that are no UTF-8, are errors.
[[nodiscard]] std::expected<std::string, std::string> read_text_file(const std::string& name, language::Tongue tongue);

/// One of two sentences.
[[nodiscard]] inline std::string say(language::Tongue tongue, std::string german, std::string english) {
  return tongue == language::Tongue::german ? std::move(german) : std::move(english);
}

/// "FILE: message" on stderr.
void print_problem(const std::string& file, const std::string& message);

}  // namespace cnclab::tool
