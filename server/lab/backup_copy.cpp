// Copied through SQLite's backup interface, opened, and its name removed.
#include "lab/backup_copy.hpp"

#include <fstream>
#include <system_error>

#include "db/backup.hpp"

namespace cnclab::lab {

namespace {

BackupCopy::Result copy_of(const std::filesystem::path& database) {
  if (database.empty()) return std::unexpected("this server has no database file");
  const std::filesystem::path copy = database.string() + ".backup-under-way";
  if (const auto copied = db::copy_database(database, copy); !copied) return std::unexpected(copied.error().text);
  std::error_code failed;
  const std::uint64_t size = std::filesystem::file_size(copy, failed);
  auto stream = std::make_shared<std::ifstream>(copy, std::ios::binary);
  std::error_code ignored;
  std::filesystem::remove(copy, ignored);
  if (failed || !stream->is_open()) return std::unexpected(copy.string() + ": cannot be read");
  return BackupContent{std::move(stream), size};
}

}  // namespace

BackupCopy::~BackupCopy() {
  if (thread_.joinable()) thread_.join();
}

bool BackupCopy::make(std::function<void(Result)> done) {
  if (*busy_) return false;
  *busy_ = true;
  if (thread_.joinable()) thread_.join();
  thread_ = std::thread([database = database_, post = post_, busy = busy_, done = std::move(done)] {
    post([busy, done, result = copy_of(database)] {
      *busy = false;
      done(result);
    });
  });
  return true;
}

}  // namespace cnclab::lab
