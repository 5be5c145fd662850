// SQLite as the repositories use it: statements prepared once and kept, failures as `StoreFailure`. Private to db/.
#pragma once

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "db/failure.hpp"
#include "db/file_lock.hpp"
#include "db/types.hpp"

namespace cnclab::db {

/// What SQLite's result code means to a user. `system_error` is the errno behind an I/O error, 0 if unknown: SQLite
/// calls only ENOSPC a full disk, but a spent quota (EDQUOT) and a limit on file sizes (EFBIG) need the same remedy.
[[nodiscard]] FailureKind kind_of(const SQLite::Exception& exception, int system_error = 0);

/// Rethrows what SQLiteCpp throws as `StoreFailure`; `step` says what was being done.
[[noreturn]] void fail(const SQLite::Exception& exception, std::string_view step, int system_error = 0);

/// One connection with its prepared statements, found again by their text.
class Connection {
 public:
  Connection(SQLite::Database database, std::optional<FileLock> lock)
      : lock_(std::move(lock)), database_(std::move(database)) {}

  [[nodiscard]] SQLite::Database& sqlite() { return database_; }
  [[nodiscard]] SQLite::Statement& statement(const char* sql);
  [[nodiscard]] bool in_transaction();
  /// Runs statements without results, e.g. BEGIN.
  void execute(const char* sql);

 private:
  std::optional<FileLock> lock_;  // first, so that it is let go last
  SQLite::Database database_;
  std::unordered_map<std::string_view, std::unique_ptr<SQLite::Statement>> statements_;
};

/// Bytes for a BLOB column; STRICT tables tell them from text.
struct Blob {
  const std::string& bytes;
};

/// One use of a prepared statement: binds ?1, ?2 … in the order of its arguments and resets at the end.
class Query {
 public:
  template <class... Values>
  Query(Connection& connection, const char* sql, const Values&... values)
      : sql_(sql), statement_(connection.statement(sql)) {
    int index = 0;
    (bind(++index, values), ...);
  }
  ~Query() { statement_.tryReset(); }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  /// Goes to the next row; false when there is none.
  bool next();
  void run() {
    while (next()) {
    }
  }

  [[nodiscard]] std::int64_t integer(int column) const { return statement_.getColumn(column).getInt64(); }
  [[nodiscard]] int small(int column) const { return statement_.getColumn(column).getInt(); }
  [[nodiscard]] double real(int column) const { return statement_.getColumn(column).getDouble(); }
  [[nodiscard]] std::string text(int column) const { return statement_.getColumn(column).getString(); }
  [[nodiscard]] bool is_null(int column) const { return statement_.isColumnNull(column); }

 private:
  void bind(int index, std::int64_t value);
  void bind(int index, int value) { bind(index, std::int64_t{value}); }
  void bind(int index, std::uint32_t value) { bind(index, std::int64_t{value}); }
  void bind(int index, std::uint64_t value) { bind(index, static_cast<std::int64_t>(value)); }
  void bind(int index, bool value) { bind(index, std::int64_t{value}); }
  void bind(int index, PersonId value) { bind(index, static_cast<std::int64_t>(value)); }
  void bind(int index, CassetteId value) { bind(index, static_cast<std::int64_t>(value)); }
  void bind(int index, double value);
  void bind(int index, const std::string& value);
  void bind(int index, const char* value) { bind(index, std::string(value)); }
  void bind(int index, const Blob& value);

  const char* sql_;
  SQLite::Statement& statement_;
};

}  // namespace cnclab::db
