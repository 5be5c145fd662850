// Between the database's rows and a control: programs and machine data loaded, changes carried out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "db/database.hpp"
#include "lab/media/cassettes.hpp"
#include "machine/machine_data.hpp"
#include "panel/control.hpp"
#include "panel/memory.hpp"

namespace cnclab::lab {

/// What of a student is in the database, read in one job of the store.
struct StoredControl {
  std::vector<db::StoredProgram> programs;
  std::vector<db::StoredDatum> machine_data;
  std::string state;
  StoredCassettes cassettes;
};

[[nodiscard]] StoredControl read_control(db::Database& database, db::PersonId person);

/// Blocks whose check code does not fit, or whose text is no block, are kept and marked as damaged (STO-003).
[[nodiscard]] panel::Memory memory_of(const std::vector<db::StoredProgram>& programs, int memory_bytes);

/// Has one of the machine data a check code that does not fit?
[[nodiscard]] bool is_damaged(const std::vector<db::StoredDatum>& data);
/// What the programs take of the memory, whether it is that large or not.
[[nodiscard]] int used_bytes(const panel::Memory& memory);

/// Where one is damaged the set from the ROM takes the place of all (ERR-014).
[[nodiscard]] machine::MachineData machine_data_of(const std::vector<db::StoredDatum>& data);

/// The lab machine's data as they were found, and the numbers whose value is not to be trusted.
struct FoundMachineData {
  machine::MachineData data;  ///< a damaged number has its default here: nothing may move by it (AUTH-011)
  std::vector<int> damaged;   ///< ascending: a wrong check code, or gone from a set that is written as a whole
};
/// ERR-014 is for a control's own data. On the shared machine the set from the ROM would lift every limit that the
/// instructor has set, so what is damaged is named and waits to be set again.
[[nodiscard]] FoundMachineData lab_machine_data_of(const std::vector<db::StoredDatum>& data);

[[nodiscard]] db::StoredBlock stored_block(int program, const language::Block& block);
[[nodiscard]] std::vector<db::StoredBlock> stored_blocks(const language::Program& program);
[[nodiscard]] db::StoredDatum stored_datum(int number, std::int64_t value);

/// A block of a version brings its words under another number; what is no block stays as it is.
[[nodiscard]] std::string renumbered_text(int program, const std::string& text, int number);
/// The texts of a version (db::Database::program_at).
[[nodiscard]] std::optional<db::BlockTexts> version_texts(db::Database& database, db::PersonId person, int program,
                                                          int version);
/// Its check code does not fit, or its text is no block of that number (STO-003).
[[nodiscard]] bool is_damaged(int program, const db::StoredBlock& block);

/// "put P0001 N003", "remove P0001 P0002", … for the journal (STO-006).
[[nodiscard]] std::string change_text(const panel::StoreRequest& request);

/// Carries out what a control wants stored. Throws what the database throws.
void carry_out(db::Database& database, db::PersonId person, const panel::StoreRequest& request,
               const db::Author& author);

}  // namespace cnclab::lab
