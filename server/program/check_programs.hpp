// Everything that can be known to be wrong with a set of programs before it runs, for `check`.
#pragma once

#include <cstdint>
#include <vector>

#include "language/error.hpp"
#include "program/interpreter.hpp"

namespace cnclab::program {

/// Every fault of every program: incomplete blocks, values above the machine data, functions that the control does not
/// have, wrong values of cycles, jumps and calls that lead nowhere. In the order of programs and blocks.
[[nodiscard]] std::vector<language::Error> check_blocks(const ProgramSet& programs, const Settings& settings);

/// The faults that show only in execution (F missing, wrong plane, circle, nesting, a call of itself, a contour that
/// the tool cannot follow or in which it cuts into another element, DEC-09), found by executing from `start` without a
/// machine; one for each block, in the order in which they are met. Each G21 and G23 is tried with Input 1 inactive and
/// active. A faulty block is passed over, so that the faults behind it are found too. In all at most `most_blocks` are
/// executed, since a program may loop.
[[nodiscard]] std::vector<language::Error> dry_run(const ProgramSet& programs, const Settings& settings,
                                                   const Start& start, std::uint64_t most_blocks);

/// The programs at which somebody would press START: those that no other program calls or jumps to. Where programs lead
/// to each other in a ring, so that none of these comes to them, the lowest of the ring. P0000 is none.
[[nodiscard]] std::vector<std::uint16_t> start_programs(const ProgramSet& programs);

}  // namespace cnclab::program
