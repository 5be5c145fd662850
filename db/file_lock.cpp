// The lock file beside a database.
#include "db/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace cnclab::db {

std::expected<FileLock, int> FileLock::take(const std::filesystem::path& database) {
  const std::filesystem::path path = database.string() + "-lock";
  FileLock lock(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  if (lock.descriptor_ == kNone) return std::unexpected(errno);
  if (::flock(lock.descriptor_, LOCK_EX | LOCK_NB) != 0) return std::unexpected(errno);
  return lock;
}

FileLock::~FileLock() {
  if (descriptor_ != kNone) ::close(descriptor_);
}

}  // namespace cnclab::db
