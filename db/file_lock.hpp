// A file that says "somebody works with this database": two servers on one data folder would both own the machine.
#pragma once

#include <expected>
#include <filesystem>
#include <utility>

namespace cnclab::db {

/// Holds an exclusive flock on FILE-lock beside the database until it goes; the system lets go of it when the process
/// dies. The database file itself is not used for it: closing a second descriptor would end SQLite's own locks.
class FileLock {
 public:
  /// errors  the `errno` of what failed; EWOULDBLOCK when another holder lives
  [[nodiscard]] static std::expected<FileLock, int> take(const std::filesystem::path& database);
  FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, kNone)) {}
  FileLock& operator=(FileLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~FileLock();

 private:
  static constexpr int kNone = -1;
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = kNone;
};

}  // namespace cnclab::db
