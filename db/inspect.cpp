// The checks before a database is opened for writing, and their sentences.
#include "db/inspect.hpp"

#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "db/connection.hpp"
#include "db/migrate.hpp"

namespace cnclab::db {
namespace {

// "file:" URI; only these three characters mean something in its path.
std::string uri_of(const std::filesystem::path& file, const char* options) {
  std::string uri = "file:";
  for (const char character : std::filesystem::absolute(file).string()) {
    if (character == '?')
      uri += "%3f";
    else if (character == '#')
      uri += "%23";
    else if (character == '%')
      uri += "%25";
    else
      uri += character;
  }
  return uri + options;
}

OpenError damaged(const std::filesystem::path& file, const std::string& finding) {
  return {OpenError::Kind::damaged,
          file.string() + ": the database is damaged (" + finding +
              "). It was left as it is. Restore a backup: cnclab-server --restore BACKUP --data " +
              (file.has_parent_path() ? file.parent_path().string() : ".")};
}

OpenError foreign(const std::filesystem::path& file) {
  return {OpenError::Kind::other, file.string() +
                                      ": is a database of another program. It was left as it is. Name another data "
                                      "folder, or move the file away."};
}

OpenError newer(const std::filesystem::path& file, int found, int known) {
  return {OpenError::Kind::newer,
          file.string() + ": was written by a newer cnclab (database version " + std::to_string(found) +
              ", this program knows up to " + std::to_string(known) +
              "). It was left as it is. Install the newer cnclab, or name another data folder."};
}

std::optional<OpenError> check_content(SQLite::Database& database, const std::filesystem::path& file) {
  const int known = migrations().back().number;
  const int version = schema_version(database);
  const bool is_empty = database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0;
  if (is_empty && version == 0) return std::nullopt;
  if (database.execAndGet("PRAGMA application_id").getInt() != kApplicationId) return foreign(file);
  if (version > known) return newer(file, version, known);
  const std::string finding = database.execAndGet("PRAGMA quick_check(1)").getString();
  if (finding != "ok") return damaged(file, finding);
  return std::nullopt;
}

}  // namespace

SQLite::Database open_read_only(const std::filesystem::path& file) {
  // Whoever has a WAL database open has a -wal file, so without one nobody writes and the file may count as immutable:
  // then SQLite makes no -wal and -shm of its own.
  const bool has_wal = std::filesystem::exists(file.string() + "-wal");
  SQLite::Database database(uri_of(file, has_wal ? "" : "?immutable=1"), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
  // The last one to close would otherwise write the -wal file's content into the database.
  sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  return database;
}

std::optional<OpenError> inspect(const std::filesystem::path& file) {
  try {
    auto database = open_read_only(file);
    return check_content(database, file);
  } catch (const SQLite::Exception& exception) {
    return open_error(file, exception);
  }
}

OpenError lock_error(const std::filesystem::path& file, int number) {
  if (number == EWOULDBLOCK)
    return {OpenError::Kind::locked,
            file.string() +
                ": another cnclab-server works with this data folder. Stop it, or name another "
                "folder with --data."};
  return {OpenError::Kind::not_writable, file.parent_path().string() + ": the data folder cannot be written (" +
                                             std::generic_category().message(number) +
                                             "). Give this user the right to write there, or name another folder with "
                                             "--data."};
}

OpenError open_error(const std::filesystem::path& file, const SQLite::Exception& exception) {
  switch (kind_of(exception)) {
    case FailureKind::damaged:
      return damaged(file, exception.what());
    case FailureKind::locked:
      return {OpenError::Kind::locked,
              file.string() + ": another program holds the database. Close it and start again."};
    case FailureKind::full:
      return {OpenError::Kind::other, file.string() + ": the disk is full. Make room and start again."};
    case FailureKind::disk:
      return {OpenError::Kind::not_writable, file.string() + ": cannot be read and written (" + exception.what() +
                                                 "). Check its owner, its rights and the disk."};
    case FailureKind::refused:
      return {OpenError::Kind::other, file.string() + ": cannot be opened (" + exception.what() + ")."};
  }
  return {OpenError::Kind::other, file.string() + ": cannot be opened."};
}

}  // namespace cnclab::db
