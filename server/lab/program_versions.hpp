// Older versions of programs come back: by the student's own wish (key LABOR) or the instructor's (STO-005).
#pragma once

#include <cstdint>

#include "db/database.hpp"
#include "lab/refusal.hpp"

namespace cnclab::lab {

/// Makes an older version the newest, as one more change: nothing is lost by it, and a program that was deleted comes
/// back. A version without blocks (the one that a deletion made) removes the program again.
/// throws  Refusal: no such version, a block of it cannot be read, the memory is too small; nothing changed
void restore_version(db::Database& database, db::PersonId person, std::uint16_t program, int version, int memory_bytes,
                     const db::Author& author);

}  // namespace cnclab::lab
