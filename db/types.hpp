// The values that the database gives and takes. Nothing of SQL or SQLite shows here.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cnclab::db {

enum class PersonId : std::int64_t {};
inline constexpr PersonId kLabMachine{0};  ///< owner of the lab machine's data

struct Person {
  PersonId id{};
  std::string name{};
  std::string role{};      ///< "student", "instructor", "observer"
  std::string language{};  ///< "", "de", "en"
  std::string model{};     ///< "", "3300", "3250"
  std::string password_hash{};
  bool must_change = false;
  std::int64_t last_seen_ms = 0;
  std::optional<std::int64_t> archived_ms{};
};

/// Who changes something, from where, when; kept with every change (STO-005).
struct Author {
  std::string name{};
  int station = 0;
  std::int64_t time_ms = 0;
};

/// A block in its stored form; the check code is compared by whoever understands blocks (STO-003).
struct StoredBlock {
  int number = 0;
  std::string text{};
  std::uint32_t check_code = 0;
  friend bool operator==(const StoredBlock&, const StoredBlock&) = default;
};

using BlockTexts = std::map<int, std::string>;  ///< by the blocks' numbers

struct StoredProgram {
  int number = 0;
  int version = 0;
  std::int64_t changed_ms = 0;
  std::vector<StoredBlock> blocks{};  ///< ascending
};

/// A version of a program in the list of versions.
struct ProgramVersion {
  int version = 0;
  std::string kind{};  ///< "put", "insert", "delete", "replace", "remove"
  int block = 0;
  Author author{};
};

/// Machine data that were changed together, in the list of their versions.
struct DataVersion {
  int version = 0;  ///< 1, 2, 3 …; 0 is the state before the first change
  std::vector<int> numbers{};
  Author author{};
};

struct StoredDatum {
  int number = 0;
  std::int64_t value = 0;
  std::uint32_t check_code = 0;
};

enum class CassetteId : std::int64_t {};
inline constexpr int kMostCassettes = 10;  ///< of one person (DEC-33)

/// A cassette in the list of a person's; the tape itself is read apart.
struct StoredCassette {
  CassetteId id{};
  std::string name{};
  bool is_inserted = false;  ///< it lies in the recorder
  std::int64_t changed_ms = 0;
  std::size_t bytes = 0;  ///< of the tape
};

struct JournalEntry {
  std::int64_t time_ms = 0;
  int station = 0;
  std::string person{};
  std::string kind{};
  std::string detail{};
  std::uint64_t lease = 0;
};

struct RunRecord {
  std::int64_t id = 0;
  PersonId person{};
  int station = 0;
  std::string machine{};  ///< "training" or "lab"
  std::uint64_t lease = 0;
  std::int64_t started_ms = 0;
  int program = 0, block = 0;
  std::string setup{};  ///< JSON
  std::optional<double> seconds{};
  std::string ended{};
  std::int64_t ticks = 0;  ///< while it was started
  std::string digest{};    ///< of its steps; empty where it was recorded without
};

/// What acted on a run, by the tick it acted in: counted from 0 at START, and only while the run is started.
struct RunEvent {
  std::int64_t tick = 0;
  std::string kind{};  ///< "go", "stop", "override", "single_block", "inputs"
  double value = 0;
  friend bool operator==(const RunEvent&, const RunEvent&) = default;
};

}  // namespace cnclab::db
