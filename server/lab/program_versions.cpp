// A version read back, checked for room, and stored as the newest.
#include "lab/program_versions.hpp"

#include <fmt/format.h>

#include "lab/stored_control.hpp"
#include "language/tape.hpp"

namespace cnclab::lab {

namespace {

language::Program program_of(std::uint16_t number, const std::vector<std::string>& texts) {
  language::Program program{number, {}};
  for (const std::string& text : texts) {
    const auto block = language::read_block(text, number);
    if (!block)
      throw Refusal{fmt::format("Ein Satz dieser Version ist nicht lesbar: {}", text),
                    fmt::format("A block of that version cannot be read: {}", text)};
    program.blocks.push_back(*block);
  }
  return program;
}

}  // namespace

void restore_version(db::Database& database, db::PersonId person, std::uint16_t number, int version, int memory_bytes,
                     const db::Author& author) {
  const auto texts = version > 0 ? database.program_at(person, number, version) : std::nullopt;
  if (!texts)
    throw Refusal{fmt::format("P{:04} hat keine Version {}.", number, version),
                  fmt::format("P{:04} has no version {}.", number, version)};
  if (texts->empty()) return database.remove_program(person, number, author);
  const language::Program program = program_of(number, *texts);
  panel::Memory memory = memory_of(database.programs(person), memory_bytes);
  memory.put_program(program);
  if (used_bytes(memory) > language::empty_memory_bytes(memory_bytes))
    throw Refusal{fmt::format("Der Speicher reicht für P{:04}, Version {}, nicht.", number, version),
                  fmt::format("The memory is too small for P{:04}, version {}.", number, version)};
  database.replace_program(person, number, stored_blocks(program), author);
}

}  // namespace cnclab::lab
