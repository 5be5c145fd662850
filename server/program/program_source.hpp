// Where the interpreter finds programs: a control's memory, a file, a snapshot of a run (DEC-28).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "language/block.hpp"

namespace cnclab::program {

/// Radius and length of a tool from P0000; nothing where it is not listed (COMP-003).
struct ToolData {
  language::Micrometres radius, length;
};

/// An unchanging set of programs, shared by value: START takes one and later changes do not reach it (DEC-28).
class ProgramSet {
 public:
  ProgramSet() = default;
  /// Later programs of the same number replace earlier ones.
  void put(language::Program program);
  /// The program, or nullptr. The pointer lives as long as this set. P9981..P9986 are in every set: those of the ROM,
  /// never any that were put there (DEC-06).
  [[nodiscard]] const language::Program* find(std::uint16_t number) const;
  /// The numbers of all programs that were put, ascending; P0000 among them.
  [[nodiscard]] std::vector<std::uint16_t> numbers() const;
  /// The tool's row in P0000, if any. A damaged row has no data: nobody can compute with them by mistake.
  [[nodiscard]] std::optional<ToolData> tool(int number) const;
  /// Has the tool a row whose check code did not fit when it was read (ERR-010)? Who needs its data must stop.
  [[nodiscard]] bool has_damaged_row(int number) const;

 private:
  [[nodiscard]] const language::Block* row_of(int number) const;

  std::map<std::uint16_t, std::shared_ptr<const language::Program>> programs_;
};

}  // namespace cnclab::program
