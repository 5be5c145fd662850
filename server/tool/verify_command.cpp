// `cnclab-tool verify`: is a lab's database, or a backup of it, still what was written?
#include <fmt/format.h>

#include <filesystem>

#include "db/database.hpp"
#include "db/failure.hpp"
#include "db/integrity.hpp"
#include "language/error.hpp"
#include "language/tape.hpp"
#include "tool/options.hpp"
#include "tool/text_file.hpp"

namespace cnclab::tool {

namespace {

/// What was looked at, for the last line.
struct Count {
  std::size_t people = 0, programs = 0, blocks = 0, faults = 0;
};

/// As the control takes a block from its store (SYS-018, ERR-010): readable, under its own number, with its code.
bool is_sound(std::uint16_t program, const db::StoredBlock& stored) {
  const auto block = language::read_block(stored.text, program);
  return block && block->number == stored.number && language::check_code(program, stored.text) == stored.check_code;
}

void verify_program(const Options& options, const db::Person& person, const db::StoredProgram& stored, Count& count) {
  const auto program = static_cast<std::uint16_t>(stored.number);
  ++count.programs;
  count.blocks += stored.blocks.size();
  for (const db::StoredBlock& block : stored.blocks) {
    if (is_sound(program, block)) continue;
    ++count.faults;
    const language::Error error{.code = language::ErrorCode::checksum_wrong,
                                .program = program,
                                .block = static_cast<std::uint16_t>(block.number),
                                .in_tool_table = program == language::kToolTable};
    print_problem(fmt::format("{}: {}", options.file, language::place_of(error)),
                  fmt::format("{}: {}", person.name, language::message_of(error, options.tongue)));
  }
}

/// errors  why the database cannot be used
std::expected<void, db::OpenError> verify_blocks(const Options& options, Count& count) {
  auto database = db::Database::open_to_read(options.file);
  if (!database) return std::unexpected(database.error());
  for (const db::Person& person : database->people(true)) {
    ++count.people;
    for (const db::StoredProgram& program : database->programs(person.id))
      verify_program(options, person, program, count);
  }
  return {};
}

/// OpenError names the file itself.
int say_unusable(const db::OpenError& error) {
  fmt::print(stderr, "{}\n", error.text);
  return kExitError;
}

}  // namespace

int verify(const Options& options) {
  if (!std::filesystem::is_regular_file(options.file)) {
    print_problem(options.file,
                  say(options.tongue, "keine Datei. Die Datenbank des Labors angeben, z. B. var/cnclab.db.",
                      "is no file. Name the lab's database, e.g. var/cnclab.db."));
    return kExitError;
  }
  const auto faults = db::integrity_faults(options.file);
  if (!faults) return say_unusable(faults.error());
  Count count{.faults = faults->size()};
  for (const std::string& fault : *faults) print_problem(options.file, fault);
  try {
    if (const auto read = verify_blocks(options, count); !read) return say_unusable(read.error());
  } catch (const db::StoreFailure& failure) {
    print_problem(options.file, failure.what());
    return kExitError;
  }
  fmt::print("{}\n", fmt::format(fmt::runtime(say(options.tongue, "{} Personen, {} Programme, {} Sätze: {} Fehler",
                                                  "{} people, {} programs, {} blocks: {} faults")),
                                 count.people, count.programs, count.blocks, count.faults));
  return count.faults == 0 ? 0 : kExitError;
}

}  // namespace cnclab::tool
