// Walks the flow of programs without executing them.
#include "program/reachable.hpp"

#include <map>

#include "program/rom_programs.hpp"

namespace cnclab::program {

namespace {

using language::Address;
using language::Function;

bool is_g(const language::Block& block, int code) {
  return block.function.kind == Function::Kind::g && block.function.code == code;
}

bool jumps_within_program(const language::Block& block) {
  return block.function.kind == Function::Kind::parametric && block.function.code >= 50 && block.function.code <= 54;
}

bool names_other_program(const language::Block& block) {
  return block.function.kind == Function::Kind::g && block.function.code >= 20 && block.function.code <= 23;
}

/// No way leads from this block to the next one.
bool never_goes_on(const language::Block& block) {
  if (jumps_always(block)) return true;
  const language::Word* m = block.find(Address::M);
  return m != nullptr && m->number == 2;
}

std::optional<Place> target_of(const ProgramSet& programs, const language::Program& own, const language::Block& block) {
  if (const language::Program* rom = rom_program_of(block.function)) return Place{rom, 0};
  if (!names_other_program(block) && !jumps_within_program(block)) return std::nullopt;
  const language::Word* number = block.find(Address::N);
  const language::Word* other = block.find(Address::P);
  if (number == nullptr || number->is_parameter) return std::nullopt;
  const language::Program* program = &own;
  if (names_other_program(block)) {
    if (other == nullptr || other->is_parameter || other->number == language::kToolTable) return std::nullopt;
    program = programs.find(static_cast<std::uint16_t>(other->number));
  }
  if (program == nullptr) return std::nullopt;
  const auto index = program->find(static_cast<std::uint16_t>(number->number));
  if (!index) return std::nullopt;
  return Place{program, *index};
}

}  // namespace

bool jumps_always(const language::Block& block) {
  return is_g(block, 20) || (block.function.kind == Function::Kind::parametric && block.function.code == 53);
}

std::optional<Place> unconditional_target(const ProgramSet& programs, const language::Program& own,
                                          const language::Block& block) {
  return jumps_always(block) ? target_of(programs, own, block) : std::nullopt;
}

void walk_reachable(const ProgramSet& programs, std::uint16_t program, std::uint16_t block, const BlockVisitor& visit) {
  const language::Program* first = programs.find(program);
  const auto index = first == nullptr ? std::nullopt : first->find(block);
  if (!index) return;
  std::map<const language::Program*, std::vector<bool>> seen;
  std::vector<Place> open{{first, *index}};
  while (!open.empty()) {
    Place place = open.back();
    open.pop_back();
    std::vector<bool>& marks = seen[place.program];
    marks.resize(place.program->blocks.size());
    for (; place.index < marks.size() && !marks[place.index]; ++place.index) {
      marks[place.index] = true;
      const language::Block& here = place.program->blocks[place.index];
      if (!visit({.program = place.program->number, .block = here.number}, here)) return;
      if (const auto target = target_of(programs, *place.program, here)) open.push_back(*target);
      if (never_goes_on(here)) break;
    }
  }
}

}  // namespace cnclab::program
