// Jumps and calls: G20 to G23 (G-200 to G-230; D-56, D-57, D-58).
#include <fmt/core.h>

#include "program/words.hpp"

namespace cnclab::program {

namespace {

/// Finds program and block of the words P and N and puts them into `run.flow`.
Outcome find_target(BlockRun& run) {
  const std::int64_t number = value_of(run.block, language::Address::P, 0);
  const std::int64_t block = value_of(run.block, language::Address::N, 0);
  if (language::is_reserved_for_cycles(static_cast<int>(number)))  // DEC-64
    return error_at(language::ErrorCode::reserved_for_cycles, run.source, 'P', fmt::format("P{:04}", number));
  const language::Program* program =
      number == language::kToolTable ? nullptr : run.programs.find(static_cast<std::uint16_t>(number));
  if (program == nullptr)
    return error_at(language::ErrorCode::program_missing, run.source, 'P', fmt::format("P{:04}", number));
  const std::optional<std::size_t> index = program->find(static_cast<std::uint16_t>(block));
  if (!index)
    return error_at(language::ErrorCode::block_missing, run.source, 'N',
                    fmt::format("N{:03} in P{:04}", block, number));
  run.flow.program = program;
  run.flow.index = *index;
  return {};
}

}  // namespace

Outcome jump(BlockRun& run) {
  run.flow.kind = Flow::Kind::jump;
  return find_target(run);
}

Outcome call(BlockRun& run) {
  if (Outcome found = find_target(run); !found) return found;
  // A program may call itself: how deep is all that counts (D-58).
  if (run.levels.size() > static_cast<std::size_t>(kDeepestCall))  // level 0 is the main program
    return error_at(language::ErrorCode::nesting_too_deep, run.source, 'P',
                    fmt::format("P{:04}", run.flow.program->number), std::to_string(kDeepestCall));
  run.flow.kind = Flow::Kind::call;
  run.flow.repeats = static_cast<int>(value_of(run.block, language::Address::W, 0));
  return {};
}

Outcome jump_on_input(BlockRun& run) { return run.input_is_active ? jump(run) : Outcome{}; }
Outcome call_on_input(BlockRun& run) { return run.input_is_active ? call(run) : Outcome{}; }

}  // namespace cnclab::program
