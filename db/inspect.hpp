// Looks at a database file without changing a byte of it. Private to db/.
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <optional>

#include "db/database.hpp"

namespace cnclab::db {

/// Opens for reading only. Where no -wal file lies beside it nothing at all is made in the folder.
/// errors  SQLite::Exception
[[nodiscard]] SQLite::Database open_read_only(const std::filesystem::path& file);

/// Why this file cannot be our database: damaged, newer, or something else; nothing where it is fine. An empty file is.
[[nodiscard]] std::optional<OpenError> inspect(const std::filesystem::path& file);

/// The error of a lock file that could not be taken; `number` is its errno.
[[nodiscard]] OpenError lock_error(const std::filesystem::path& file, int number);

/// The error that an exception while opening stands for.
[[nodiscard]] OpenError open_error(const std::filesystem::path& file, const SQLite::Exception& exception);

}  // namespace cnclab::db
