// Prepared statements and the translation of SQLite's result codes.
#include "db/connection.hpp"

#include <sqlite3.h>

#include <cerrno>

namespace cnclab::db {

FailureKind kind_of(const SQLite::Exception& exception, int system_error) {
  switch (exception.getErrorCode() & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return FailureKind::locked;
    case SQLITE_FULL:
      return FailureKind::full;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return FailureKind::damaged;
    case SQLITE_IOERR:
      return system_error == ENOSPC || system_error == EDQUOT || system_error == EFBIG ? FailureKind::full
                                                                                       : FailureKind::disk;
    case SQLITE_CANTOPEN:
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
    case SQLITE_PROTOCOL:
      return FailureKind::disk;
    default:
      return FailureKind::refused;
  }
}

void fail(const SQLite::Exception& exception, std::string_view step, int system_error) {
  throw StoreFailure(kind_of(exception, system_error), std::string(exception.what()) + " (" + std::string(step) + ")");
}

SQLite::Statement& Connection::statement(const char* sql) {
  const auto found = statements_.find(sql);
  if (found != statements_.end()) return *found->second;
  try {
    auto statement = std::make_unique<SQLite::Statement>(database_, sql);
    return *statements_.emplace(sql, std::move(statement)).first->second;
  } catch (const SQLite::Exception& exception) {
    fail(exception, sql);
  }
}

bool Connection::in_transaction() { return sqlite3_get_autocommit(database_.getHandle()) == 0; }

// sqlite3_system_errno() knows nothing of what fails within a COMMIT; errno itself does, as long as nothing else fails.
void Connection::execute(const char* sql) {
  errno = 0;
  try {
    database_.exec(sql);
  } catch (const SQLite::Exception& exception) {
    fail(exception, sql, errno);
  }
}

bool Query::next() {
  errno = 0;
  try {
    return statement_.executeStep();
  } catch (const SQLite::Exception& exception) {
    fail(exception, sql_, errno);
  }
}

void Query::bind(int index, std::int64_t value) { statement_.bind(index, value); }
void Query::bind(int index, double value) { statement_.bind(index, value); }
void Query::bind(int index, const std::string& value) { statement_.bind(index, value); }

void Query::bind(int index, const Blob& value) {
  statement_.bind(index, static_cast<const void*>(value.bytes.data()), static_cast<int>(value.bytes.size()));
}

}  // namespace cnclab::db
