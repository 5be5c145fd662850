// The copy of the program memory: blocks by number, bytes counted with every change.
#include "panel/memory.hpp"

#include <algorithm>
#include <utility>

namespace cnclab::panel {

namespace {

int cost_of(const language::Program& program) {
  int bytes = 0;
  for (const language::Block& block : program.blocks) bytes += language::cost_bytes(block);
  return bytes;
}

auto place_of(language::Program& program, std::uint16_t number) {
  return std::ranges::lower_bound(program.blocks, number, {}, &language::Block::number);
}

}  // namespace

const language::Program* Memory::find(std::uint16_t number) const {
  const auto found = std::ranges::find(programs_, number, &language::Program::number);
  return found == programs_.end() ? nullptr : &*found;
}

bool Memory::is_overfull() const { return used_bytes_ > language::empty_memory_bytes(memory_bytes_); }

int Memory::free_bytes() const { return std::max(0, language::empty_memory_bytes(memory_bytes_) - used_bytes_); }

language::Program& Memory::program_for(std::uint16_t number) {
  const auto found = std::ranges::find(programs_, number, &language::Program::number);
  if (found != programs_.end()) return *found;
  programs_.push_back(language::Program{number, {}});
  return programs_.back();
}

void Memory::put_program(language::Program program) {
  if (program.blocks.empty()) return remove_program(program.number);
  language::Program& place = program_for(program.number);
  used_bytes_ += cost_of(program) - cost_of(place);
  place = std::move(program);
}

void Memory::remove_program(std::uint16_t number) {
  const auto found = std::ranges::find(programs_, number, &language::Program::number);
  if (found == programs_.end()) return;
  used_bytes_ -= cost_of(*found);
  programs_.erase(found);
}

void Memory::put_block(std::uint16_t program, const language::Block& block) {
  language::Program& target = program_for(program);
  const auto place = place_of(target, block.number);
  used_bytes_ += language::cost_bytes(block);
  if (place != target.blocks.end() && place->number == block.number) {
    used_bytes_ -= language::cost_bytes(*place);
    *place = block;
    return;
  }
  target.blocks.insert(place, block);
}

void Memory::insert_block(std::uint16_t program, const language::Block& block) {
  language::Program& target = program_for(program);
  auto place = place_of(target, block.number);
  if (place == target.blocks.end() || place->number != block.number) return put_block(program, block);
  for (auto later = place; later != target.blocks.end(); ++later) ++later->number;
  target.blocks.insert(place, block);
  used_bytes_ += language::cost_bytes(block);
}

void Memory::delete_block(std::uint16_t program, std::uint16_t block) {
  const auto found = std::ranges::find(programs_, program, &language::Program::number);
  if (found == programs_.end()) return;
  const auto place = place_of(*found, block);
  if (place == found->blocks.end() || place->number != block) return;
  used_bytes_ -= language::cost_bytes(*place);
  found->blocks.erase(place);
  if (found->blocks.empty()) programs_.erase(found);
}

program::ProgramSet Memory::snapshot() const {
  program::ProgramSet set;
  for (const language::Program& program : programs_) set.put(program);
  return set;
}

}  // namespace cnclab::panel
