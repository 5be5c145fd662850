// The programs P9981..P9986 that the cycles G81..G86 call: part of the control, readable by all, writable by none.
//
// Their text is rom/cycles.cnc, embedded at build time. It has its own way in, because tapes and files lose programs of
// these numbers (DEC-06). P9987..P9989 are reserved but empty: whoever opens one finds no program (DEC-64).
#pragma once

#include <cstdint>
#include <string_view>

#include "language/block.hpp"

namespace cnclab::program {

/// P9981..P9986; nullptr for every other number.
/// threads  any; the programs are read once, at the first call, and stay for as long as the process runs
[[nodiscard]] const language::Program* rom_program(std::uint16_t number);

/// The program that a cycle calls (G81 → P9981, CYC-002); nullptr where the function is no cycle.
[[nodiscard]] const language::Program* rom_program_of(language::Function function);

/// The tape text of all of them, with comments.
[[nodiscard]] std::string_view rom_text();

}  // namespace cnclab::program
