// Which blocks a run can come to, as far as the stored words say it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "geometry/path_item.hpp"
#include "language/block.hpp"
#include "program/program_source.hpp"

namespace cnclab::program {

/// A block of a program by its index.
struct Place {
  const language::Program* program = nullptr;
  std::size_t index = 0;
};

/// A jump without condition: G20, ↓53.
[[nodiscard]] bool jumps_always(const language::Block& block);

/// Where a jump without condition (G20, ↓53) leads; nothing for other blocks, and where the target is missing or named
/// by a parameter (DEC-63).
[[nodiscard]] std::optional<Place> unconditional_target(const ProgramSet& programs, const language::Program& own,
                                                        const language::Block& block);

/// Called once per block; false ends the walk.
using BlockVisitor = std::function<bool(geometry::SourceBlock, const language::Block&)>;

/// Visits every block that can be reached from `block` of `program`: stored order, jumps and calls by G20 to G23,
/// jumps by ↓50 to ↓54, the ROM programs of G81 to G86. Targets that are missing or given by a parameter are left out.
void walk_reachable(const ProgramSet& programs, std::uint16_t program, std::uint16_t block, const BlockVisitor& visit);

}  // namespace cnclab::program
