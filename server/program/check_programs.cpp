// Checks stored programs block by block.
#include "program/check_programs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "language/check_block.hpp"
#include "program/functions.hpp"
#include "program/reachable.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

using language::Address;

bool names_program(const language::Block& block) {
  return block.function.kind == language::Function::Kind::g && block.function.code >= 20 && block.function.code <= 23;
}

bool names_own_block(const language::Block& block) {
  return block.function.kind == language::Function::Kind::parametric && block.function.code >= 50 &&
         block.function.code <= 54;
}

/// A word's number if it is known before execution.
std::optional<std::uint16_t> known(const language::Block& block, Address address) {
  const language::Word* word = block.find(address);
  if (word == nullptr || word->is_parameter || word->number < 0 || word->number > language::kLastProgram)
    return std::nullopt;
  return static_cast<std::uint16_t>(word->number);
}

Outcome check_target(const ProgramSet& programs, const language::Program& own, const language::Block& block,
                     geometry::SourceBlock source) {
  const auto number = names_program(block) ? known(block, Address::P) : std::optional(own.number);
  if (!number) return {};
  const std::string name = fmt::format("P{:04}", *number);
  if (language::is_reserved_for_cycles(*number))
    return error_at(language::ErrorCode::reserved_for_cycles, source, 'P', name);
  const language::Program* program = *number == language::kToolTable ? nullptr : programs.find(*number);
  if (program == nullptr) return error_at(language::ErrorCode::program_missing, source, 'P', name);
  const auto target = known(block, Address::N);
  if (target && !program->find(*target))
    return error_at(language::ErrorCode::block_missing, source, 'N', fmt::format("N{:03} in {}", *target, name));
  return {};
}

/// The plane in force where a block stands: the last G17, G18, G19 before it, else the one that its words fit (D-54).
void follow_plane(const language::Block& block, geometry::Plane& plane) {
  if (block.function.kind != language::Function::Kind::g) return;
  if (block.function.code == 17) plane = geometry::Plane::xy;
  if (block.function.code == 18) plane = geometry::Plane::xz;
  if (block.function.code == 19) plane = geometry::Plane::yz;
}

Outcome check_stored_block(const ProgramSet& programs, const language::Program& program, const language::Block& block,
                           language::Plane plane, const Settings& settings) {
  const geometry::SourceBlock source{.program = program.number, .block = block.number};
  if (block.is_damaged) return error_at(language::ErrorCode::checksum_wrong, source, 0);
  if (program.number != language::kToolTable)
    if (Outcome outcome = executable(block, source, settings.vocabulary); !outcome) return outcome;
  if (Outcome outcome = check_form_and_limits(block, source, plane, settings); !outcome) return outcome;
  if (names_program(block) || names_own_block(block)) return check_target(programs, program, block, source);
  return {};
}

}  // namespace

std::vector<language::Error> check_blocks(const ProgramSet& programs, const Settings& settings) {
  std::vector<language::Error> errors;
  for (const std::uint16_t number : programs.numbers()) {
    const language::Program& program = *programs.find(number);
    geometry::Plane plane = geometry::Plane::xy;
    for (const language::Block& block : program.blocks) {
      const language::Plane words_plane = language::plane_of_words(block, as_language(plane));
      if (Outcome outcome = check_stored_block(programs, program, block, words_plane, settings); !outcome)
        errors.push_back(outcome.error());
      follow_plane(block, plane);
    }
  }
  return errors;
}

std::vector<std::uint16_t> start_programs(const ProgramSet& programs) {
  std::vector<std::uint16_t> numbers = programs.numbers();
  std::erase(numbers, language::kToolTable);
  std::erase_if(numbers, [&](std::uint16_t number) { return programs.find(number)->blocks.empty(); });
  std::set<std::uint16_t> led_to;
  for (const std::uint16_t number : numbers)
    for (const language::Block& block : programs.find(number)->blocks)
      if (const auto target = known(block, Address::P); target && names_program(block) && *target != number)
        led_to.insert(*target);

  std::vector<std::uint16_t> starts;
  std::set<std::uint16_t> reached;
  const auto start_at = [&](std::uint16_t number) {
    starts.push_back(number);
    walk_reachable(programs, number, programs.find(number)->blocks.front().number,
                   [&reached](geometry::SourceBlock source, const language::Block&) {
                     reached.insert(source.program);
                     return true;
                   });
  };
  for (const std::uint16_t number : numbers)
    if (!led_to.contains(number)) start_at(number);
  for (const std::uint16_t number : numbers)
    if (!reached.contains(number)) start_at(number);
  std::ranges::sort(starts);
  return starts;
}

}  // namespace cnclab::program
