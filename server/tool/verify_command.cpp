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
#include "transfer/cassette.hpp"
#include "transfer/cassette_recording.hpp"

namespace cnclab::tool {

namespace {

/// What was looked at, for the last line.
struct Count {
  std::size_t people = 0, programs = 0, blocks = 0, data = 0, recordings = 0, faults = 0;
};

/// As the control takes a block from its store (SYS-018, ERR-010): readable, under its own number, with its code.
bool is_sound(std::uint16_t program, const db::StoredBlock& stored) {
  const auto block = language::read_block(stored.text, program);
  return block && block->number == stored.number && language::check_code(program, stored.text) == stored.check_code;
}

/// Everything that carries a check code, person by person: blocks, machine data, recordings on cassettes.
class Verification {
 public:
  Verification(const Options& options, db::Database& database, Count& count)
      : options_(options), database_(database), count_(count) {}

  void run() {
    for (const db::Person& person : database_.people(true)) {
      ++count_.people;
      owner_ = person.name;
      for (const db::StoredProgram& program : database_.programs(person.id)) look_at(program);
      look_at_data(person.id);
      for (const db::StoredCassette& cassette : database_.cassettes(person.id))
        look_at(cassette.name, database_.tape(person.id, cassette.id).value_or(""));
    }
    owner_ = tr("Maschine des Labors", "the lab's machine");
    look_at_data(db::kLabMachine);
  }

 private:
  [[nodiscard]] std::string tr(const char* german, const char* english) const {
    return say(options_.tongue, german, english);
  }

  /// "FILE: P0001 N003: anna: message".
  void fault(const std::string& place, const std::string& message) {
    ++count_.faults;
    print_problem(fmt::format("{}: {}", options_.file, place), fmt::format("{}: {}", owner_, message));
  }

  void look_at(const db::StoredProgram& stored) {
    const auto program = static_cast<std::uint16_t>(stored.number);
    ++count_.programs;
    count_.blocks += stored.blocks.size();
    for (const db::StoredBlock& block : stored.blocks) {
      if (is_sound(program, block)) continue;
      const language::Error error{.code = language::ErrorCode::checksum_wrong,
                                  .program = program,
                                  .block = static_cast<std::uint16_t>(block.number),
                                  .in_tool_table = program == language::kToolTable};
      fault(language::place_of(error), language::message_of(error, options_.tongue));
    }
  }

  void look_at_data(db::PersonId person) {
    for (const db::StoredDatum& datum : database_.machine_data(person)) {
      ++count_.data;
      if (language::datum_check_code(datum.number, datum.value) == datum.check_code) continue;
      fault(fmt::format("MD {:02}", datum.number),
            tr("ist beschädigt. Statt aller gelten die Maschinendaten des EPROM (ERR-014): neu eingeben.",
               "is damaged. The machine data of the EPROM are in force in place of all (ERR-014): enter them again."));
    }
  }

  void look_at(const std::string& name, const std::string& tape) {
    const auto cassette = transfer::Cassette::deserialize(tape);
    if (!cassette)
      return fault(name, fmt::format("{} ({})", tr("Kassette nicht lesbar", "cassette unreadable"), cassette.error()));
    int number = 0;
    for (const transfer::TapePiece& piece : cassette->pieces())
      look_at(fmt::format("{} {} {}", name, tr("Aufnahme", "recording"), ++number), piece);
  }

  void look_at(const std::string& place, const transfer::TapePiece& piece) {
    ++count_.recordings;
    const transfer::RecordingFaults faults = transfer::recording_faults(piece.bytes);
    const std::string remedy = tr("ist beschädigt. Neu aufnehmen.", "is damaged. Record it again.");
    if (faults.is_mark_damaged) fault(place, tr("Startmarke ", "start mark ") + remedy);
    for (const std::uint32_t block : faults.blocks)
      fault(place, fmt::format("{} {} {}", tr("Block", "block"), block + 1, remedy));
  }

  const Options& options_;
  db::Database& database_;
  Count& count_;
  std::string owner_;  ///< of what is looked at
};

/// errors  why the database cannot be used
std::expected<void, db::OpenError> verify_codes(const Options& options, Count& count) {
  auto database = db::Database::open_to_read(options.file);
  if (!database) return std::unexpected(database.error());
  Verification(options, *database, count).run();
  return {};
}

/// OpenError names the file itself. Its remedy, to restore a backup, is for the database in a data folder alone.
int say_unusable(const Options& options, const db::OpenError& error) {
  const bool is_in_use = std::filesystem::path(options.file).filename() == "cnclab.db";
  if (error.kind == db::OpenError::Kind::damaged && !is_in_use)
    print_problem(options.file, say(options.tongue, "ist beschädigt oder keine Datenbank eines Labors.",
                                    "is damaged, or no database of a lab."));
  else
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
  if (!faults) return say_unusable(options, faults.error());
  Count count{.faults = faults->size()};
  for (const std::string& fault : *faults) print_problem(options.file, fault);
  try {
    if (const auto read = verify_codes(options, count); !read) return say_unusable(options, read.error());
  } catch (const db::StoreFailure& failure) {
    print_problem(options.file, failure.what());
    return kExitError;
  }
  fmt::print("{}\n",
             fmt::format(fmt::runtime(say(options.tongue,
                                          "{} Personen, {} Programme, {} Sätze, {} Maschinendaten, {} "
                                          "Aufnahmen: {} Fehler",
                                          "{} people, {} programs, {} blocks, {} machine data, {} "
                                          "recordings: {} faults")),
                         count.people, count.programs, count.blocks, count.data, count.recordings, count.faults));
  return count.faults == 0 ? 0 : kExitError;
}

}  // namespace cnclab::tool
