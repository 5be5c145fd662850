// Older versions of programs and machine data come back: by the student's own wish (key LABOR) or the instructor's
// (STO-005).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/database.hpp"
#include "lab/labor/labor_menu.hpp"
#include "lab/refusal.hpp"
#include "machine/machine_data.hpp"

namespace cnclab::lab {

/// The refusal that names a damaged block (STO-003), and whose it is where `owner` is not empty.
[[nodiscard]] Refusal damage(int program, int block, const std::string& owner);

/// For whatever carries a program out of the store: outside it has no check code that could tell (STO-003).
/// throws  Refusal: one of its blocks is damaged
void check_sound(const db::StoredProgram& program, const std::string& owner);

/// Makes an older version the newest, as one more change: nothing is lost by it, and a program that was deleted comes
/// back. A version without blocks (the one that a deletion made) removes the program again.
/// It is restored as its changes brought it, whatever damage the blocks have taken since (STO-003).
/// throws  Refusal: no such version, a block of it cannot be read, the record of the changes is damaged, the memory is
///         too small; nothing changed
void restore_version(db::Database& database, db::PersonId person, std::uint16_t program, int version, int memory_bytes,
                     const db::Author& author);

/// Makes the machine data again what they were after a change of them, 0: as delivered. Only what differs is stored, as
/// one more version.
/// returns  the data that hold now
/// throws   Refusal: no such version, or its values are not allowed any more; nothing changed
[[nodiscard]] machine::MachineData restore_machine_data_version(db::Database& database, db::PersonId person,
                                                                int version, const db::Author& author);

/// The machine data stand among a person's programs under this number, as `MD` on a tape (DEC-34).
inline constexpr std::uint32_t kMachineDataProgram = 10'000;

/// The lines of a machine-data file, `NN = value`, of a version; the newest where none is given.
/// throws  Refusal: no such version; the newest are asked for and damaged
[[nodiscard]] std::vector<std::string> machine_data_lines(db::Database& database, db::PersonId person,
                                                          std::optional<int> version);

/// For the menu, newest first. Machine data have version 0, the delivery, as well.
[[nodiscard]] std::vector<LaborVersion> versions_of(db::Database& database, db::PersonId person, const Subject& of);

}  // namespace cnclab::lab
