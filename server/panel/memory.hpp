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

/// At all times: every program has at least one block, its blocks ascend, and `free_bytes` is their cost taken from the
/// empty memory. Programs that arrive by other ways than the keys (a teacher's copy) may make it negative for the
/// arithmetic, but it is shown and returned as 0 then.
class Memory {
 public:
  explicit Memory(int memory_bytes = 16384) : memory_bytes_(memory_bytes) {}

  [[nodiscard]] const std::vector<language::Program>& programs() const { return programs_; }
  /// The program, or nullptr; valid until the next change.
  [[nodiscard]] const language::Program* find(std::uint16_t number) const;
  /// Does it hold more than there is room for? Only copies that are tried out may.
  [[nodiscard]] bool is_overfull() const;
  [[nodiscard]] int free_bytes() const;  ///< SCR-006, never below 0

  void put_program(language::Program program);  ///< replaces, or appends in storage order; without blocks: removes
  void remove_program(std::uint16_t number);
  void put_block(std::uint16_t program, const language::Block& block);
  /// Inserts before the block of the same number and raises the numbers that follow by one (EDIT-020, D-47). Where no
  /// block has that number it is put there. The caller sees to it that no number passes N999.
  void insert_block(std::uint16_t program, const language::Block& block);
  /// Removes the block; a program without blocks goes with its last one.
  void delete_block(std::uint16_t program, std::uint16_t block);

  /// What a run takes at START (DEC-28).
  [[nodiscard]] program::ProgramSet snapshot() const;

 private:
  language::Program& program_for(std::uint16_t number);

  int memory_bytes_;
  int used_bytes_ = 0;
  std::vector<language::Program> programs_;
};

}  // namespace cnclab::panel
