// One open database: opened, checked, migrated; the repositories work on it. Not for two threads at once.
#pragma once

#include <chrono>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "db/types.hpp"

namespace cnclab::db {

/// How long a lock of somebody else's is waited for: longer than any hand-made query of a teacher, shorter than a
/// student's patience.
inline constexpr std::chrono::milliseconds kPatience{5000};

/// Why a database cannot be used; `text` says what happened, where, and what to do.
struct OpenError {
  enum class Kind { not_writable, damaged, newer, locked, other } kind{};
  std::string text;
};

/// The stored form of a block under another number.
using Renumber = std::function<std::string(const std::string& text, int new_number)>;

/// SQLite file in WAL mode, synchronous FULL, foreign keys on. ":memory:" for tests. The repositories' functions throw
/// `StoreFailure` (failure.hpp) when the store fails (disk full, locked, damaged); `Store` catches it once.
class Database {
 public:
  /// Opens or creates, checks integrity, migrates (after a copy beside the file, STO-008). A newer or damaged file is
  /// refused and left untouched.
  /// The folder must exist. FILE-lock beside it is held while it is open: a second server is refused (`locked`).
  [[nodiscard]] static std::expected<Database, OpenError> open(const std::filesystem::path& file);
  /// Opens for reading only, also while a server writes; checked as by `open`, changed by nothing.
  [[nodiscard]] static std::expected<Database, OpenError> open_to_read(const std::filesystem::path& file);
  /// How long the next transactions wait for a lock; kPatience when it was opened.
  void set_patience(std::chrono::milliseconds patience);
  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;
  ~Database();

  // People
  [[nodiscard]] std::vector<Person> people(bool with_archived);
  [[nodiscard]] std::optional<Person> person(const std::string& name);
  /// Returns the new id; nothing when the name exists (also archived).
  std::optional<PersonId> add_person(const Person& person, std::int64_t now_ms);
  void set_password(PersonId id, const std::string& hash, bool must_change);
  void set_language(PersonId id, const std::string& language);  ///< "de", "en", "" for the lab's
  void set_model(PersonId id, const std::string& model);        ///< "3300", "3250", "" for the lab's (DEC-08)
  void set_last_seen(PersonId id, std::int64_t now_ms);
  void archive(PersonId id, std::int64_t now_ms);
  void unarchive(PersonId id);
  void erase(PersonId id);  ///< for good, with everything the person has, journal entries of that name included
  /// False when another person has the name (also archived). The journal keeps the old name: it is append-only.
  bool rename(PersonId id, const std::string& name);

  // Programs. Each change is one version with its inverse (0001_first.sql, program_change).
  [[nodiscard]] std::vector<StoredProgram> programs(PersonId id);  ///< in storage order
  /// Stores one block: replaces the one of its number, or adds it; makes the program where there is none.
  void put_block(PersonId id, int program, const StoredBlock& block, const Author& author);
  /// Puts a block before the one that has its number; that and all that follow get numbers one higher (EDIT-020).
  /// `renumber` makes the stored form of a block under its new number.
  void insert_block(PersonId id, int program, const StoredBlock& block, const Author& author,
                    const std::function<StoredBlock(const StoredBlock&, int new_number)>& renumber);
  /// A block or program that is not there is no change. A program without blocks stays until it is removed.
  void delete_block(PersonId id, int program, int block, const Author& author);
  /// Replaces a whole program (tape, DNC, restore, instructor).
  void replace_program(PersonId id, int program, const std::vector<StoredBlock>& blocks, const Author& author);
  void remove_program(PersonId id, int program, const Author& author);
  [[nodiscard]] std::vector<ProgramVersion> versions(PersonId id, int program);  ///< oldest first
  /// The blocks' texts of a version by their numbers; nothing where there is no such version. 0 = newest. A version
  /// that removed the program has no blocks. The count of versions goes on when a removed program is stored again. It
  /// is what was stored then: damage that came later to the program's blocks is not in it, nor seen by it (STO-003).
  [[nodiscard]] std::optional<BlockTexts> program_at(PersonId id, int program, int version, const Renumber& renumber);

  // Machine data (person 0: the lab machine)
  [[nodiscard]] std::vector<StoredDatum> machine_data(PersonId id);
  void put_machine_datum(PersonId id, const StoredDatum& datum, const Author& author);
  /// Oldest first. What one author stored at one time is one version.
  [[nodiscard]] std::vector<DataVersion> machine_data_versions(PersonId id);
  /// The values by their numbers as a version left them, 0: before the first change; nothing where there is no such
  /// version. A number that is missing has its default.
  [[nodiscard]] std::optional<std::map<int, std::int64_t>> machine_data_at(PersonId id, int version);

  // A control between two logins
  [[nodiscard]] std::string control_state(PersonId id);  ///< "" where none was kept
  void put_control_state(PersonId id, const std::string& state, std::int64_t now_ms);

  // Cassettes (DEC-33). What belongs to another person is as good as not there.
  [[nodiscard]] std::vector<StoredCassette> cassettes(PersonId id);  ///< by name
  /// Nothing where the name is taken, or kMostCassettes are there.
  std::optional<CassetteId> add_cassette(PersonId id, const std::string& name, const std::string& tape,
                                         std::int64_t now_ms);
  [[nodiscard]] std::optional<std::string> tape(PersonId id, CassetteId cassette);
  void put_tape(PersonId id, CassetteId cassette, const std::string& tape, std::int64_t now_ms);
  void insert_cassette(PersonId id, std::optional<CassetteId> cassette);            ///< nothing: the recorder is empty
  bool rename_cassette(PersonId id, CassetteId cassette, const std::string& name);  ///< false: the name is taken
  void remove_cassette(PersonId id, CassetteId cassette);

  // Journal
  void add_journal(const std::vector<JournalEntry>& entries);
  /// Oldest first. person "" = everybody's.
  [[nodiscard]] std::vector<JournalEntry> journal(const std::string& person, std::int64_t since_ms);
  void forget_journal_before(std::int64_t time_ms);

  // Runs
  std::int64_t begin_run(const RunRecord& run);
  /// Takes seconds, ended, ticks and digest of `run`.
  void end_run(std::int64_t id, const RunRecord& run);
  /// Goes on numbering behind those that the run has already.
  void add_run_events(std::int64_t run, const std::vector<RunEvent>& events);
  [[nodiscard]] std::vector<RunEvent> run_events(std::int64_t run);  ///< in their order
  [[nodiscard]] std::optional<RunRecord> run(std::int64_t id);
  void add_trace(std::int64_t run, std::int64_t first_tick, const std::string& data);
  [[nodiscard]] std::vector<RunRecord> runs(PersonId id);  ///< newest first
  [[nodiscard]] std::string trace(std::int64_t run);       ///< all records joined
  /// Keeps of each person the newest `keep` runs, and none that began before.
  void forget_old_runs(std::int64_t before_ms, int keep);
  void forget_old_traces(int keep);  ///< keeps the traces of the newest `keep` runs that have one

  // Single values of the lab
  [[nodiscard]] std::optional<std::string> value(const std::string& key);
  void put_value(const std::string& key, const std::string& value);

  /// Runs `work` in one transaction; rolled back when it throws. Inside another one it is a savepoint of its own.
  void transaction(const std::function<void()>& work);
  [[nodiscard]] bool in_transaction() const;
  /// A consistent copy of what is committed, while others write (STO-008). `copy_database` (backup.hpp) does it from
  /// another thread, so that the writer does not wait.
  void backup_to(const std::filesystem::path& file);

 private:
  struct Statements;
  explicit Database(std::unique_ptr<Statements> statements);
  std::unique_ptr<Statements> statements_;
};

}  // namespace cnclab::db
