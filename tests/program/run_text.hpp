// Runs a program given as tape text and keeps everything that comes out of the interpreter.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/path_json.hpp"
#include "language/tape.hpp"
#include "program/interpreter.hpp"

namespace cnclab::program {

inline ProgramSet programs_of(std::string_view tape_text) {
  language::Tape tape = language::read_tape(tape_text, language::Reading::file);
  for (const language::Error& error : tape.errors)
    ADD_FAILURE() << language::explain(error, language::Tongue::english) << " in " << tape_text;
  ProgramSet programs;
  for (language::ReadProgram& program : tape.programs) programs.put(std::move(program.program));
  return programs;
}

struct RunResult {
  std::vector<geometry::PathItem> items;
  std::vector<ExecutedBlock> blocks;
  Parameters parameters{};  ///< after the run
  std::optional<language::Error> error;

  /// The order in which blocks ran: "P1N1 P1N2 …".
  [[nodiscard]] std::string order() const {
    std::ostringstream text;
    for (const ExecutedBlock& block : blocks)
      text << (block.sequence == 1 ? "P" : " P") << block.source.program << 'N' << block.source.block;
    return text.str();
  }
  /// JSON Lines as `cnclab-tool path` prints them.
  [[nodiscard]] std::string json() const {
    std::string text;
    for (const geometry::PathItem& item : items)
      if (geometry::append_json(text, item)) text += '\n';
    return text;
  }
  [[nodiscard]] language::ErrorCode code() const {
    EXPECT_TRUE(error.has_value()) << "no error: " << order();
    return error ? error->code : language::ErrorCode::memory_full;
  }
};

/// Input 1 at the start of the block with this sequence; 0: at START.
using InputLine = std::function<bool(std::uint64_t sequence)>;

inline RunResult run_programs(const ProgramSet& programs, const Settings& settings, const Start& start,
                              std::size_t most_blocks = 1000, const InputLine& input = {}) {
  RunResult result;
  auto interpreter = Interpreter::begin(programs, settings, start);
  if (!interpreter) {
    result.error = interpreter.error();
    return result;
  }
  while (result.blocks.size() < most_blocks && !interpreter->ended()) {
    if (const auto asked = interpreter->awaited_input(); asked && input) interpreter->answer_input(input(*asked));
    auto executed = interpreter->step(result.items);
    if (!executed) {
      result.error = executed.error();
      break;
    }
    result.blocks.push_back(*executed);
  }
  result.parameters = interpreter->parameters();
  return result;
}

/// Machine data that the examples need: travel of 9999.999 mm unless a test narrows it.
inline Settings wide_settings() {
  Settings settings;
  settings.travel_mm = {9999.999, 9999.999, 9999.999};
  return settings;
}

inline RunResult run_text(std::string_view tape_text, std::size_t most_blocks = 1000, Start start = {},
                          const Settings& settings = wide_settings()) {
  return run_programs(programs_of(tape_text), settings, start, most_blocks);
}

/// The items of one kind.
template <typename What>
std::vector<What> all_of(const RunResult& result) {
  std::vector<What> found;
  for (const geometry::PathItem& item : result.items)
    if (const What* what = std::get_if<What>(&item.what)) found.push_back(*what);
  return found;
}

}  // namespace cnclab::program
