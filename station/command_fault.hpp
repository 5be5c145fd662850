// What is wrong with a command line, in the user's language: which word, and how the command is written.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "station/language.hpp"

namespace cnclab::station {

/// A file named in a command cannot be sent as it is.
class UnfitFile : public CLI::ParseError {
 public:
  /// what   file and line
  /// why    in both languages
  UnfitFile(const std::string& what, const Text& why) : ParseError("UnfitFile", what, 1), why_(why) {}
  [[nodiscard]] const Text& why() const { return why_; }

 private:
  Text why_;
};

/// One sentence about `error`, which parsing with `app` has thrown.
[[nodiscard]] std::string fault_text(const CLI::App& app, const CLI::ParseError& error, Language language);

/// "select 1-15 [--force]": a command of `app` with everything that it takes.
[[nodiscard]] std::string usage_of(const CLI::App& command);

}  // namespace cnclab::station
