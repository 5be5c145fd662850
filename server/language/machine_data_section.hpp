// The machine data behind the programs of a whole-memory recording (DEC-34, DEC-62). Private to this folder.
#pragma once

#include "language/program_collector.hpp"
#include "language/tape_cursor.hpp"

namespace cnclab::language {

/// Reads "N03=500000N04=…" behind "MD"; the cursor stands behind it and stops at what is no entry. Every fault is
/// added to the errors of `programs`; data are given to it only where there was none.
void read_machine_data(TapeCursor& cursor, ProgramCollector& programs);

}  // namespace cnclab::language
