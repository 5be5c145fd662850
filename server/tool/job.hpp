// Everything a command works on: programs, tools and machine data, read from their files.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "language/tape.hpp"
#include "machine/machine_data.hpp"
#include "program/interpreter.hpp"
#include "tool/options.hpp"

namespace cnclab::tool {

/// One job of the tool. Faults of the tape are kept, not printed: `check` has more to say.
struct Job {
  std::string file;
  std::string tools_file;  ///< where the tool table comes from; empty: FILE
  language::Tongue tongue = language::Tongue::english;
  program::ProgramSet programs;                       ///< those of FILE, with the tool table of --tools
  std::set<std::uint16_t> partly_read;                ///< of these only the blocks that have no fault of the tape
  std::vector<std::uint16_t> in_file_order;           ///< their numbers as they stand in FILE
  std::vector<language::MachineDatum> recorded_data;  ///< machine data in FILE; they are converted, never run with
  machine::MachineData data;
  program::Settings settings;
  program::Start start;
  std::vector<language::Error> tape_errors;
  std::vector<std::string> notices;
  std::map<std::uint16_t, std::vector<int>> lines;  ///< of each program: the line of each of its blocks

  /// Prints "FILE:LINE: P0001 N003: message", with what is known of it.
  void print(language::Error error) const;
  [[nodiscard]] int line_of(std::uint16_t number, std::uint16_t block) const;
};

/// Reads all files that the options name.
/// returns  the job, or nothing after the problem was printed
[[nodiscard]] std::optional<Job> open_job(const Options& options);

/// The same for commands that need faultless tapes: prints their faults and returns nothing.
[[nodiscard]] std::optional<Job> open_sound_job(const Options& options);

}  // namespace cnclab::tool
