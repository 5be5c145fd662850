// Opening, reading and replacing files below one descriptor.
#include "station/media_folder.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <utility>

#include "shared/media_name.hpp"

namespace cnclab::station {

namespace {

namespace fs = std::filesystem;

std::unexpected<v1::MediaFault> fault(v1::MediaFault what) { return std::unexpected(what); }

/// What went wrong in writing, from errno.
v1::MediaFault write_fault(int number) {
  const bool is_full = number == ENOSPC || number == EDQUOT || number == EFBIG;
  return is_full ? v1::MEDIA_FAULT_NO_ROOM : v1::MEDIA_FAULT_NOT_WRITABLE;
}

constexpr std::string_view kAsideBegins = ".cnclab-", kAsideEnds = ".part";
constexpr std::time_t kOrphaned_s = 600;  ///< far longer than a file of 4 MiB needs on any disk

/// Takes away what processes that were killed while they wrote have left: parts that are much older than one that was
/// begun `now`, by the clock of the same disk.
void remove_orphans(int folder, std::time_t now) {
  const int number = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const std::unique_ptr<DIR, decltype([](DIR* open) { ::closedir(open); })> entries(number < 0 ? nullptr
                                                                                               : ::fdopendir(number));
  if (!entries) return;
  while (const dirent* const entry = ::readdir(entries.get())) {
    const std::string_view name = entry->d_name;
    struct stat about{};
    if (name.starts_with(kAsideBegins) && name.ends_with(kAsideEnds) &&
        ::fstatat(folder, entry->d_name, &about, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(about.st_mode) &&
        about.st_mtime < now - kOrphaned_s)
      ::unlinkat(folder, entry->d_name, 0);
  }
}

/// A folder's name for a student: characters that may mean something in a path as %XX.
std::string folder_name(std::string_view user) {
  std::string name;
  for (const char c : user) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                          c == '-' || (c == '.' && !name.empty());
    name += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return name.empty() ? "%" : name;
}

/// Parents included, for its owner only.
bool make_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return true;
  if (folder.has_parent_path() && folder.parent_path() != folder && !make_folder(folder.parent_path())) return false;
  return ::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST;
}

}  // namespace

fs::path default_media_folder() {
  const auto below = [](const char* variable, const char* rest) {
    const char* const value = std::getenv(variable);
    return value != nullptr && value[0] == '/' ? fs::path(value) / rest : fs::path();
  };
  const fs::path data = below("XDG_DATA_HOME", "cnclab/media");
  return data.empty() ? below("HOME", ".local/share/cnclab/media") : data;
}

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}
Descriptor::~Descriptor() {
  if (is_open()) ::close(number_);
}

std::expected<MediaFolder, v1::MediaFault> MediaFolder::open(const MediaPlace& place, std::string_view user) {
  const fs::path folder = place.is_default ? place.folder / folder_name(user) : place.folder;
  if (place.is_default && !make_folder(folder)) return fault(v1::MEDIA_FAULT_NO_FOLDER);
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!descriptor.is_open()) return fault(v1::MEDIA_FAULT_NO_FOLDER);
  return MediaFolder(std::move(descriptor));
}

std::expected<std::string, v1::MediaFault> MediaFolder::read(const std::string& name) const {
  if (!is_media_name(name)) return fault(v1::MEDIA_FAULT_REFUSED);
  // Not blocking: a pipe of that name would wait for a writer.
  const Descriptor file(::openat(folder_.number(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file.is_open()) return fault(errno == ENOENT ? v1::MEDIA_FAULT_NOT_FOUND : v1::MEDIA_FAULT_NOT_READABLE);
  struct stat about{};
  if (::fstat(file.number(), &about) != 0 || !S_ISREG(about.st_mode)) return fault(v1::MEDIA_FAULT_NOT_READABLE);
  const auto size = static_cast<std::uint64_t>(about.st_size);
  if (size == 0 || size > kLargestMediaRead) return fault(v1::MEDIA_FAULT_TOO_LARGE);
  std::string bytes(size, '\0');
  for (std::size_t filled = 0; filled < bytes.size();) {
    const ssize_t count = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return fault(v1::MEDIA_FAULT_NOT_READABLE);  // also where it becomes shorter this moment
    filled += static_cast<std::size_t>(count);
  }
  return bytes;
}

std::expected<void, v1::MediaFault> MediaFolder::may_write(const std::string& name) const {
  if (!is_media_name(name)) return fault(v1::MEDIA_FAULT_REFUSED);
  if (::faccessat(folder_.number(), ".", W_OK | X_OK, AT_EACCESS) != 0) return fault(v1::MEDIA_FAULT_NOT_WRITABLE);
  return {};
}

std::expected<void, v1::MediaFault> MediaFolder::write(const std::string& name, std::string_view bytes) const {
  if (!is_media_name(name)) return fault(v1::MEDIA_FAULT_REFUSED);
  const std::string aside = fmt::format("{}{}{}", kAsideBegins, ::getpid(), kAsideEnds);
  ::unlinkat(folder_.number(), aside.c_str(), 0);  // a process of this number that was killed has left it
  auto written = write_aside(aside, bytes);
  if (written) written = give_name(aside, name);
  if (!written) ::unlinkat(folder_.number(), aside.c_str(), 0);
  return written;
}

std::expected<void, v1::MediaFault> MediaFolder::write_aside(const std::string& aside, std::string_view bytes) const {
  const Descriptor file(
      ::openat(folder_.number(), aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644));
  if (!file.is_open()) return fault(write_fault(errno));
  struct stat begun{};
  if (::fstat(file.number(), &begun) == 0) remove_orphans(folder_.number(), begun.st_mtime);
  while (!bytes.empty()) {
    const ssize_t count = ::write(file.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return fault(write_fault(count < 0 ? errno : ENOSPC));
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  if (::fdatasync(file.number()) != 0) return fault(write_fault(errno));
  return {};
}

std::expected<void, v1::MediaFault> MediaFolder::give_name(const std::string& aside, const std::string& name) const {
  struct stat there{};
  const bool is_taken = ::fstatat(folder_.number(), name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0;
  if (is_taken && !S_ISREG(there.st_mode)) return fault(v1::MEDIA_FAULT_NOT_WRITABLE);
  if (::renameat(folder_.number(), aside.c_str(), folder_.number(), name.c_str()) != 0)
    return fault(write_fault(errno));
  return {};
}

}  // namespace cnclab::station
