// A control's program memory as the panel sees it: the newest stored state, in storage order.
//
// The database is the truth; this is its copy while a student is logged in. It changes only when a store has been
// confirmed, so the screen never shows what is not on disk (architecture.md rule 3).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "language/block.hpp"
#include "language/check_block.hpp"
#include "program/program_source.hpp"

namespace cnclab::panel {

class Memory {
 public:
  explicit Memory(int memory_bytes = 16384) : memory_bytes_(memory_bytes) {}

  [[nodiscard]] const std::vector<language::Program>& programs() const { return programs_; }
  [[nodiscard]] const language::Program* find(std::uint16_t number) const;
  [[nodiscard]] int free_bytes() const;

  void put_program(language::Program program);  ///< replaces, or appends in storage order
  void remove_program(std::uint16_t number);
  void put_block(std::uint16_t program, const language::Block& block);
  /// Inserts before the block of the same number and raises the numbers that follow (EDIT-020).
  void insert_block(std::uint16_t program, const language::Block& block);
  void delete_block(std::uint16_t program, std::uint16_t block);

  /// What a run takes at START (DEC-28).
  [[nodiscard]] program::ProgramSet snapshot() const;

 private:
  int memory_bytes_;
  std::vector<language::Program> programs_;
};

}  // namespace cnclab::panel
