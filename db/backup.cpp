// Copies through SQLite's backup interface; a plain copy of the file would miss what still lies in the -wal file.
#include "db/backup.hpp"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "db/file_lock.hpp"
#include "db/inspect.hpp"
#include "db/migrate.hpp"

namespace cnclab::db {
namespace {

// Made before SQLite opens it: the copy holds the private key and must not be readable for others even for a moment.
void make_private_file(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) throw SQLite::Exception(file.string() + ": " + std::generic_category().message(errno), errno);
  ::close(descriptor);
}

std::filesystem::path free_name_beside(const std::filesystem::path& file) {
  for (int number = 1;; ++number) {
    std::filesystem::path name = file.string() + ".replaced-" + std::to_string(number);
    if (!std::filesystem::exists(name)) return name;
  }
}

// A lab that has been started once has both; a copy that failed for want of room, or another file, has not.
bool holds_a_lab(const std::filesystem::path& file) {
  auto database = open_read_only(file);
  return schema_version(database) > 0 &&
         database.execAndGet("SELECT count(*) FROM lab WHERE key IN ('certificate', 'private_key')").getInt() == 2;
}

// The old -wal belongs to the old file; left here, SQLite would play it into the new one.
void move_aside(const std::filesystem::path& file, const std::filesystem::path& aside) {
  std::filesystem::rename(file, aside);
  for (const char* tail : {"-wal", "-shm"})
    if (std::filesystem::exists(file.string() + tail))
      std::filesystem::rename(file.string() + tail, aside.string() + tail);
}

}  // namespace

void copy_connection(SQLite::Database& from, const std::filesystem::path& to) {
  const std::filesystem::path part = to.string() + ".part";
  make_private_file(part);
  try {
    SQLite::Database copy(part.string(), SQLite::OPEN_READWRITE);
    SQLite::Backup(copy, from).executeStep();
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
  std::filesystem::rename(part, to);
}

std::expected<void, OpenError> copy_database(const std::filesystem::path& from, const std::filesystem::path& to) {
  const auto refused = [&](const std::string& why) {
    return std::unexpected(OpenError{OpenError::Kind::other, from.string() + ": cannot be copied to " + to.string() +
                                                                 " (" + why +
                                                                 "). Name a folder that can be written and has room."});
  };
  try {
    auto source = open_read_only(from);
    copy_connection(source, to);
    return {};
  } catch (const SQLite::Exception& exception) {
    return refused(exception.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return refused(error.code().message());
  }
}

std::expected<std::filesystem::path, OpenError> restore_database(const std::filesystem::path& from,
                                                                 const std::filesystem::path& file) {
  const auto lock = FileLock::take(file);
  if (!lock) return std::unexpected(lock_error(file, lock.error()));
  if (!std::filesystem::exists(from))
    return std::unexpected(OpenError{OpenError::Kind::other, from.string() + ": no such file. Name a backup."});
  if (auto error = inspect(from)) {
    if (error->kind == OpenError::Kind::damaged)  // its remedy would be another backup
      error->text = from.string() + ": is damaged, or no backup of a lab. Nothing was changed. Name another backup.";
    return std::unexpected(std::move(*error));
  }
  try {
    if (!holds_a_lab(from))
      return std::unexpected(
          OpenError{OpenError::Kind::other, from.string() + ": is no backup of a lab: there is no certificate in it. "
                                                            "Nothing was changed. Name another backup."});
  } catch (const SQLite::Exception& exception) {
    return std::unexpected(open_error(from, exception));
  }
  // Copied first and renamed last: whatever fails before leaves the old database in its place.
  const std::filesystem::path incoming = file.string() + ".incoming";
  if (auto copied = copy_database(from, incoming); !copied) return std::unexpected(std::move(copied.error()));
  try {
    std::filesystem::path aside;
    if (std::filesystem::exists(file)) {
      aside = free_name_beside(file);
      move_aside(file, aside);
    }
    std::filesystem::rename(incoming, file);
    return aside;
  } catch (const std::filesystem::filesystem_error& error) {
    return std::unexpected(OpenError{OpenError::Kind::not_writable,
                                     error.path1().string() + ": cannot be renamed (" + error.code().message() +
                                         "). Check the data folder's owner and rights."});
  }
}

}  // namespace cnclab::db
