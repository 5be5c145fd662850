// What the command line said, and the commands that act on it (interfaces.md section 5).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "language/units.hpp"

namespace cnclab::tool {

inline constexpr int kExitError = 1;  ///< a program, a file or a value is wrong: said on stderr
inline constexpr int kExitUsage = 2;

struct Options {
  std::string file;                      ///< "-" is standard input; `verify`: the database
  std::string dialect;                   ///< empty: by content
  bool is_strict = false;                ///< read as the control does (DEC-30)
  std::string tools_file;                ///< empty: P0000 of FILE, if any
  std::string machine_data_file;         ///< empty: EPROM set
  std::optional<std::uint16_t> program;  ///< nothing: the first that is not P0000 (DEC-32)
  std::optional<std::uint16_t> block;    ///< nothing: the program's first
  std::uint64_t most_blocks = 10'000'000;
  double most_seconds = 3600;  ///< machine time
  double tick_ms = 1;
  std::string trace_file, steps_file;
  std::string out_file, view = "xy", target;
  language::Tongue tongue = language::Tongue::english;         ///< of messages
  language::Tongue listing_tongue = language::Tongue::german;  ///< of listings: the original's, unless asked otherwise
};

// Each returns the exit code.
int check(const Options& options);
int path(const Options& options);
int run(const Options& options);
int plot(const Options& options);
int convert(const Options& options);
int verify(const Options& options);

}  // namespace cnclab::tool
