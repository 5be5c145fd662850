// Is a block complete, and are its values allowed? (EDIT-011, EDIT-014 to EDIT-016, D-45, D-46, D-51)
#pragma once

#include <expected>
#include <vector>

#include "language/block.hpp"
#include "language/block_form.hpp"
#include "language/error.hpp"

namespace cnclab::language {

/// What EINGABE compares word values with: the control's machine data (MD 03 to MD 07).
struct EntryLimits {
  Micrometres x, y, z;     ///< maximum travel
  std::int64_t f_max = 0;  ///< mm/min
  std::int64_t s_max = 0;  ///< rev/min
};

/// Checks form and completeness; with limits also the values (transferred blocks are stored without, DEC-13).
///
/// plane    which form an arc has where its words fit several; its words alone decide where they fit one only
/// limits   nullptr: the formats' own. G04 H0000 is refused as a value, so whoever executes it by a parameter of 0
///          skips the dwell before (DEC-53)
/// returns  nothing, or the first fault in word order: code, the block's number and the word to put the marker on
[[nodiscard]] std::expected<void, Error> check_block(const Block& block, Plane plane, const Vocabulary& vocabulary,
                                                     const EntryLimits* limits);

/// `check_block` for every block, with the plane that the program has chosen before it; all faults, not only the first.
[[nodiscard]] std::vector<Error> check_program(const Program& program, const Vocabulary& vocabulary,
                                               const EntryLimits* limits);

/// Bytes of program memory that a block takes (D-22, DEC-54, DEC-66); a tool row costs 12.
[[nodiscard]] int cost_bytes(const Block& block);

/// Free bytes of an empty memory: 16290 for the original's 16384 (DEC-07).
[[nodiscard]] constexpr int empty_memory_bytes(int memory_bytes) { return memory_bytes - 94; }

}  // namespace cnclab::language
