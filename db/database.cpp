// Opening, checking and migrating a database, and its transactions.
#include "db/database.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string>
#include <utility>

#include "db/backup.hpp"
#include "db/inspect.hpp"
#include "db/migrate.hpp"
#include "db/statements.hpp"

namespace cnclab::db {
namespace {

constexpr int kBusyTimeout_ms = static_cast<int>(kPatience.count());

SQLite::Database open_to_write(const std::filesystem::path& file) {
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusyTimeout_ms);
  database.exec("PRAGMA foreign_keys = ON");
  database.exec("PRAGMA trusted_schema = OFF");
  if (file != ":memory:") {
    database.execAndGet("PRAGMA journal_mode = WAL");
    database.exec("PRAGMA synchronous = FULL");
  }
  return database;
}

// A run that has no end belonged to a server that ended without one; its length is what was traced of it (STO-007).
void close_open_runs(SQLite::Database& database) {
  database.exec(
      "UPDATE run SET ended = 'server_lost', ticks = (SELECT coalesce(sum(length(data)), 0) / 36 FROM run_trace "
      "WHERE run_id = run.id) WHERE ended IS NULL");
  database.exec("UPDATE run SET seconds = ticks / 1000.0 WHERE seconds IS NULL");
}

// The database holds the certificate's private key: made for its owner only; -wal and -shm take over the mode.
int make_private(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return errno;
  ::close(descriptor);
  return 0;
}

}  // namespace

Database::Database(std::unique_ptr<Statements> statements) : statements_(std::move(statements)) {}
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

std::expected<Database, OpenError> Database::open(const std::filesystem::path& file) {
  try {
    std::optional<FileLock> lock;
    if (file != ":memory:") {
      auto taken = FileLock::take(file);
      if (!taken) return std::unexpected(lock_error(file, taken.error()));
      lock = std::move(*taken);
      if (!std::filesystem::exists(file)) {
        if (const int number = make_private(file)) return std::unexpected(lock_error(file, number));
      } else if (::faccessat(AT_FDCWD, file.c_str(), R_OK | W_OK, AT_EACCESS) != 0) {
        return std::unexpected(lock_error(file, errno));
      }
      if (auto error = inspect(file)) return std::unexpected(std::move(*error));
    }
    auto sqlite = open_to_write(file);
    migrate(sqlite, file, migrations());
    close_open_runs(sqlite);
    return Database(std::make_unique<Statements>(std::move(sqlite), std::move(lock)));
  } catch (const SQLite::Exception& exception) {
    return std::unexpected(open_error(file, exception));
  } catch (const std::filesystem::filesystem_error& error) {
    return std::unexpected(lock_error(file, error.code().value()));
  }
}

std::expected<Database, OpenError> Database::open_to_read(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    return std::unexpected(
        OpenError{OpenError::Kind::other, file.string() + ": no such file. Name the lab's database."});
  if (auto error = inspect(file)) return std::unexpected(std::move(*error));
  try {
    auto sqlite = open_read_only(file);
    sqlite.setBusyTimeout(kBusyTimeout_ms);
    const int known = migrations().back().number;
    const int version = schema_version(sqlite);
    if (version == 0)
      return std::unexpected(OpenError{OpenError::Kind::other, file.string() + ": is empty, there is no lab in it."});
    if (version != known)
      return std::unexpected(OpenError{OpenError::Kind::other,
                                       file.string() + ": has the older database version " + std::to_string(version) +
                                           " (this program reads " + std::to_string(known) +
                                           "). Start cnclab-server with it once; that brings it up to date."});
    return Database(std::make_unique<Statements>(std::move(sqlite), std::nullopt));
  } catch (const SQLite::Exception& exception) {
    return std::unexpected(open_error(file, exception));
  }
}

void Database::set_patience(std::chrono::milliseconds patience) {
  statements_->sqlite().setBusyTimeout(static_cast<int>(patience.count()));
}

bool Database::in_transaction() const { return statements_->in_transaction(); }

void Database::transaction(const std::function<void()>& work) {
  const bool nested = in_transaction();
  statements_->execute(nested ? "SAVEPOINT nested" : "BEGIN IMMEDIATE");
  try {
    work();
    statements_->execute(nested ? "RELEASE nested" : "COMMIT");
  } catch (...) {
    // On a full disk SQLite itself may have rolled everything back; then there is nothing left to undo.
    if (in_transaction()) statements_->execute(nested ? "ROLLBACK TO nested; RELEASE nested" : "ROLLBACK");
    throw;
  }
}

void Database::backup_to(const std::filesystem::path& file) {
  const std::string own = statements_->sqlite().getFilename();
  if (own != ":memory:") {
    if (const auto copied = copy_database(own, file); !copied)
      throw StoreFailure(FailureKind::disk, copied.error().text);
    return;
  }
  try {
    copy_connection(statements_->sqlite(), file);
  } catch (const SQLite::Exception& exception) {
    fail(exception, "copy to " + file.string());
  }
}

}  // namespace cnclab::db
