// Brings a database to the newest schema. Private to db/ and its tests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace SQLite {
class Database;
}

namespace cnclab::db {

/// One numbered file of db/migrations; old ones are never edited once a release has used them.
struct Migration {
  int number = 0;  ///< 1, 2, 3 … without gaps; PRAGMA user_version after it
  const char* name = "";
  const char* sql = "";
};

/// All migrations, ascending; made by the build from db/migrations/*.sql.
[[nodiscard]] std::span<const Migration> migrations();

/// "CNCL", in the header of every database of ours (PRAGMA application_id).
inline constexpr std::int32_t kApplicationId = 0x434E434C;

/// The schema's number in this database; 0 where it is empty.
[[nodiscard]] int schema_version(SQLite::Database& database);

/// Runs what is missing, each in a transaction of its own with its number. An older database is copied to
/// FILE.version-N first (STO-008); ":memory:" is not.
/// errors  SQLite::Exception; what was not finished is rolled back
void migrate(SQLite::Database& database, const std::filesystem::path& file, std::span<const Migration> steps);

}  // namespace cnclab::db
