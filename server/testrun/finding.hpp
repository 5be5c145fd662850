// What a test run has to say about a program, in words with program and block.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/path_item.hpp"
#include "language/error.hpp"

namespace cnclab::testrun {

struct Finding {
  enum class Kind : std::uint8_t {
    travel_exceeded,           ///< the limit switch would be met; the run ends there
    rapid_in_material,         ///< G00 cuts
    spindle_off_in_material,   ///< the cutter stands
    tool_missing_in_material,  ///< it cuts, and no tool was called or the one called has no radius
    tool_not_in_table,         ///< a T that P0000 does not have: no compensation, and no message either (D-74)
    contour_in_parts,          ///< a contour too long to be checked as a whole: from here on in parts (DEC-09)
    endless_loop,              ///< the block limit was reached
    too_long,                  ///< … the limit of machine time
    error,                     ///< what would stop the control too: compensation, F0000, F above F MAX, jumps, …
  };
  Kind kind{};
  geometry::SourceBlock block;
  char axis = 0;  ///< travel_exceeded
  /// travel_exceeded: mm; tool_not_in_table: its number; contour_in_parts: blocks; too_long: hours
  double found = 0, least = 0, most = 0;
  std::optional<language::Error> error = {};  ///< error
};

/// "P0001 N003: …" and what to do about it; without the place where the block is not of a stored program.
[[nodiscard]] std::string explain(const Finding& finding, language::Tongue tongue);

}  // namespace cnclab::testrun
