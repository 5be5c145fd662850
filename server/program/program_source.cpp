// A set of programs, kept by number.
#include "program/program_source.hpp"

#include "program/rom_programs.hpp"

namespace cnclab::program {

void ProgramSet::put(language::Program program) {
  const std::uint16_t number = program.number;
  programs_[number] = std::make_shared<const language::Program>(std::move(program));
}

const language::Program* ProgramSet::find(std::uint16_t number) const {
  if (language::is_reserved_for_cycles(number)) return rom_program(number);
  const auto found = programs_.find(number);
  return found == programs_.end() ? nullptr : found->second.get();
}

std::vector<std::uint16_t> ProgramSet::numbers() const {
  std::vector<std::uint16_t> numbers;
  numbers.reserve(programs_.size());
  for (const auto& [number, program] : programs_) numbers.push_back(number);
  return numbers;
}

const language::Block* ProgramSet::row_of(int number) const {
  const language::Program* table = find(language::kToolTable);
  if (table == nullptr || number <= 0) return nullptr;
  const std::optional<std::size_t> row = table->find(static_cast<std::uint16_t>(number));
  return row ? &table->blocks[*row] : nullptr;
}

bool ProgramSet::has_damaged_row(int number) const {
  const language::Block* row = row_of(number);
  return row != nullptr && row->is_damaged;
}

std::optional<ToolData> ProgramSet::tool(int number) const {
  const language::Block* row = row_of(number);
  if (row == nullptr || row->is_damaged) return std::nullopt;
  const auto length = [row](language::Address address) {
    const language::Word* word = row->find(address);
    return language::Micrometres{word == nullptr ? 0 : word->number};
  };
  return ToolData{.radius = length(language::Address::R), .length = length(language::Address::L)};
}

}  // namespace cnclab::program
