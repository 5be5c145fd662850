// The five lines of AUTOMAT: the current block on top and those that follow it (D-31, DEC-63).
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/path_item.hpp"
#include "language/block.hpp"
#include "language/units.hpp"
#include "program/program_source.hpp"

namespace cnclab::panel {

struct WindowLine {
  const language::Block* block = nullptr;  ///< lives as long as the set
  language::Plane plane{};                 ///< whose words it shows (D-54)
  geometry::SourceBlock place;
};

/// Blocks from `first` on in stored order, following only jumps without condition; fewer at the end of the program.
[[nodiscard]] std::vector<WindowLine> window_from(const program::ProgramSet& programs, geometry::SourceBlock first,
                                                  std::size_t lines, language::Plane plane);

}  // namespace cnclab::panel
