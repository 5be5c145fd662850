// Consistent copies of a database, and putting one back (STO-008). From any thread, while others write.
#pragma once

#include <expected>
#include <filesystem>

#include "db/database.hpp"

namespace SQLite {
class Database;
}

namespace cnclab::db {

/// Copies what is committed in `from` to `to` (mode 0600), replacing a file of that name only when the copy is whole.
[[nodiscard]] std::expected<void, OpenError> copy_database(const std::filesystem::path& from,
                                                           const std::filesystem::path& to);

/// Puts the copy `from` in the place of the database `file` while no server uses it. What was there is kept as
/// FILE.replaced-1, -2 …; stale -wal and -shm files go with it. A copy that could not be opened changes nothing.
/// returns  where the old database lies now; empty where there was none
[[nodiscard]] std::expected<std::filesystem::path, OpenError> restore_database(const std::filesystem::path& from,
                                                                               const std::filesystem::path& file);

/// The copying itself, on an open connection that is not in a write transaction. Private to db/.
/// errors  SQLite::Exception
void copy_connection(SQLite::Database& from, const std::filesystem::path& to);

}  // namespace cnclab::db
