// A version read back, checked for room, and stored as the newest.
#include "lab/labor/program_versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "lab/stored_control.hpp"
#include "language/error.hpp"
#include "language/tape.hpp"

namespace cnclab::lab {

namespace {

/// What the changes brought and what stands there whole must be the same: else the record of the changes is damaged,
/// and a check code written for it now would make the damage good (STO-003).
void check_record(db::Database& database, db::PersonId person, const std::vector<db::StoredProgram>& programs,
                  std::uint16_t number) {
  const auto program = std::ranges::find(programs, number, &db::StoredProgram::number);
  if (program == programs.end()) return;
  const auto recorded = version_texts(database, person, number, 0).value_or(db::BlockTexts{});
  for (const db::StoredBlock& block : program->blocks) {
    if (is_damaged(number, block)) continue;
    const auto same = recorded.find(block.number);
    if (same == recorded.end() || same->second != block.text) throw damage(number, block.number, "");
  }
}

language::Program program_of(std::uint16_t number, const db::BlockTexts& texts) {
  language::Program program{number, {}};
  for (const auto& [place, text] : texts) {
    const auto block = language::read_block(text, number);
    if (block && block->number != place) throw damage(number, place, "");
    if (!block)
      throw Refusal{fmt::format("Ein Satz dieser Version ist nicht lesbar: {}", text),
                    fmt::format("A block of that version cannot be read: {}", text)};
    program.blocks.push_back(*block);
  }
  return program;
}

/// Two passes: F START/STOP may not exceed F MAX, whichever of them is set first.
machine::MachineData data_of(const std::map<int, std::int64_t>& values) {
  machine::MachineData data;
  for (const auto& [number, value] : values) static_cast<void>(data.set(number, value));
  for (const auto& [number, value] : values) {
    if (!data.set(number, value))
      throw Refusal{fmt::format("Der Wert {} von Nummer {:02} ist nicht mehr erlaubt.", value, number),
                    fmt::format("The value {} of number {:02} is not allowed any more.", value, number)};
  }
  return data;
}

machine::MachineData data_at(db::Database& database, db::PersonId person, int version) {
  const auto values = database.machine_data_at(person, version);
  if (!values)
    throw Refusal{fmt::format("Die Maschinendaten haben keine Version {}.", version),
                  fmt::format("The machine data have no version {}.", version)};
  return data_of(*values);
}

LaborVersion line_of(const db::DataVersion& version) {
  std::string numbers;
  for (const int number : version.numbers) numbers += fmt::format("{}{:02}", numbers.empty() ? "" : " ", number);
  return {version.version, version.author.time_ms, version.author.name, version.author.station, numbers, 0};
}

LaborVersion line_of(const db::ProgramVersion& version) {
  return {version.version,        version.author.time_ms, version.author.name,
          version.author.station, version.kind,           version.block};
}

template <class Version>
std::vector<LaborVersion> newest_first(const std::vector<Version>& versions) {
  std::vector<LaborVersion> lines;
  for (const Version& version : versions | std::views::reverse) lines.push_back(line_of(version));
  return lines;
}

}  // namespace

Refusal damage(int program, int block, const std::string& owner) {
  const std::string place = language::place_of({.code = language::ErrorCode::checksum_wrong,
                                                .program = static_cast<std::uint16_t>(program),
                                                .block = static_cast<std::uint16_t>(block),
                                                .in_tool_table = program == language::kToolTable});
  const std::string what = owner.empty() ? place : owner + " " + place;
  return {fmt::format("CHECKSUM FEHLER: {} ist beschädigt.", what),
          fmt::format("CHECKSUM FEHLER: {} is damaged.", what)};
}

void check_sound(const db::StoredProgram& program, const std::string& owner) {
  for (const db::StoredBlock& block : program.blocks)
    if (is_damaged(program.number, block)) throw damage(program.number, block.number, owner);
}

void restore_version(db::Database& database, db::PersonId person, std::uint16_t number, int version, int memory_bytes,
                     const db::Author& author) {
  const auto texts = version > 0 ? version_texts(database, person, number, version) : std::nullopt;
  if (!texts)
    throw Refusal{fmt::format("P{:04} hat keine Version {}.", number, version),
                  fmt::format("P{:04} has no version {}.", number, version)};
  if (texts->empty()) return database.remove_program(person, number, author);
  const language::Program program = program_of(number, *texts);
  const auto programs = database.programs(person);
  check_record(database, person, programs, number);
  panel::Memory memory = memory_of(programs, memory_bytes);
  memory.put_program(program);
  if (used_bytes(memory) > language::empty_memory_bytes(memory_bytes))
    throw Refusal{fmt::format("Der Speicher reicht für P{:04}, Version {}, nicht.", number, version),
                  fmt::format("The memory is too small for P{:04}, version {}.", number, version)};
  database.replace_program(person, number, stored_blocks(program), author);
}

machine::MachineData restore_machine_data_version(db::Database& database, db::PersonId person, int version,
                                                  const db::Author& author) {
  machine::MachineData data = data_at(database, person, version);
  carry_out(database, person, panel::PutMachineData{data}, author);
  return data;
}

std::vector<std::string> machine_data_lines(db::Database& database, db::PersonId person, std::optional<int> version) {
  if (!version)
    for (const db::StoredDatum& datum : database.machine_data(person))
      if (is_damaged({datum}))
        throw Refusal{fmt::format("CHECKSUM FEHLER: MD {:02} ist beschädigt.", datum.number),
                      fmt::format("CHECKSUM FEHLER: MD {:02} is damaged.", datum.number)};
  const int newest = static_cast<int>(database.machine_data_versions(person).size());
  const machine::MachineData data = data_at(database, person, version.value_or(newest));
  std::vector<std::string> lines;
  for (const auto& form : machine::datum_forms())
    lines.push_back(fmt::format("{:02} = {}", form.number, data.get(form.number)));
  return lines;
}

std::vector<LaborVersion> versions_of(db::Database& database, db::PersonId person, const Subject& of) {
  if (const auto* program = std::get_if<std::uint16_t>(&of)) return newest_first(database.versions(person, *program));
  auto lines = newest_first(database.machine_data_versions(person));
  if (!lines.empty()) lines.push_back({});
  return lines;
}

}  // namespace cnclab::lab
