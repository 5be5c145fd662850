// Opening, reading and replacing files below one descriptor.
#include "station/media_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
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

std::expected<std::string, v1::MediaFault> MediaSource::next(std::size_t most) {
  std::string bytes(std::min<std::uint64_t>(most, left_), '\0');
  for (std::size_t filled = 0; filled < bytes.size();) {
    const ssize_t count = ::read(file_.number(), bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return fault(v1::MEDIA_FAULT_NOT_READABLE);
    filled += static_cast<std::size_t>(count);
  }
  left_ -= bytes.size();
  return bytes;
}

MediaTarget::MediaTarget(std::shared_ptr<const Descriptor> folder, Descriptor file, std::string aside, std::string name)
    : folder_(std::move(folder)), file_(std::move(file)), aside_(std::move(aside)), name_(std::move(name)) {}

MediaTarget::~MediaTarget() {
  if (folder_ && !aside_.empty()) ::unlinkat(folder_->number(), aside_.c_str(), 0);
}

std::expected<void, v1::MediaFault> MediaTarget::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return fault(write_fault(count < 0 ? errno : ENOSPC));
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return {};
}

std::expected<void, v1::MediaFault> MediaTarget::finish() {
  if (::fdatasync(file_.number()) != 0) return fault(write_fault(errno));
  struct stat there{};
  const bool is_taken = ::fstatat(folder_->number(), name_.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0;
  if (is_taken && !S_ISREG(there.st_mode)) return fault(v1::MEDIA_FAULT_NOT_WRITABLE);
  if (::renameat(folder_->number(), aside_.c_str(), folder_->number(), name_.c_str()) != 0)
    return fault(write_fault(errno));
  aside_.clear();
  return {};
}

std::expected<MediaFolder, v1::MediaFault> MediaFolder::open(const MediaPlace& place, std::string_view user) {
  const fs::path folder = place.is_default ? place.folder / folder_name(user) : place.folder;
  if (place.is_default && !make_folder(folder)) return fault(v1::MEDIA_FAULT_NO_FOLDER);
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!descriptor.is_open()) return fault(v1::MEDIA_FAULT_NO_FOLDER);
  return MediaFolder(std::make_shared<const Descriptor>(std::move(descriptor)));
}

std::expected<MediaSource, v1::MediaFault> MediaFolder::read(const std::string& name) const {
  if (!is_media_name(name)) return fault(v1::MEDIA_FAULT_REFUSED);
  // Not blocking: a pipe of that name would wait for a writer.
  Descriptor file(::openat(folder_->number(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!file.is_open()) return fault(errno == ENOENT ? v1::MEDIA_FAULT_NOT_FOUND : v1::MEDIA_FAULT_NOT_READABLE);
  struct stat about{};
  if (::fstat(file.number(), &about) != 0 || !S_ISREG(about.st_mode)) return fault(v1::MEDIA_FAULT_NOT_READABLE);
  const auto size = static_cast<std::uint64_t>(about.st_size);
  if (size == 0 || size > kLargestMediaRead) return fault(v1::MEDIA_FAULT_TOO_LARGE);
  return MediaSource(std::move(file), size);
}

std::expected<MediaTarget, v1::MediaFault> MediaFolder::write(const std::string& name) const {
  if (!is_media_name(name)) return fault(v1::MEDIA_FAULT_REFUSED);
  std::string aside = fmt::format(".cnclab-{}.part", ::getpid());
  ::unlinkat(folder_->number(), aside.c_str(), 0);  // a process of this number that was killed has left it
  Descriptor file(
      ::openat(folder_->number(), aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644));
  if (!file.is_open()) return fault(write_fault(errno));
  return MediaTarget(folder_, std::move(file), std::move(aside), name);
}

}  // namespace cnclab::station
