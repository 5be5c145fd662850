// The station's folder of diskettes, tapes and printed pages (--media). Names come over the network and are not
// trusted: a name of a medium (shared/media_name.hpp) is opened inside this one folder, never through a link, and
// nothing but an ordinary file is read or replaced.
//
//   write   ".cnclab-PID.part" in the folder ── whole, on disk ──▶ renamed, in one step, to the file's name
#pragma once

#include <cnclab/v1/media.pb.h>

#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cnclab::station {

/// Where the files of a station lie.
struct MediaPlace {
  std::filesystem::path folder;
  /// The default place: made when it is first needed, and each student has a folder of the own in it, since several may
  /// share an account of the computer.
  bool is_default = false;
};

/// $XDG_DATA_HOME/cnclab/media, else ~/.local/share/cnclab/media; an empty path where neither is known.
[[nodiscard]] std::filesystem::path default_media_folder();

/// Holds a file descriptor; closes it.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

/// A file that is read from its beginning to its end.
class MediaSource {
 public:
  MediaSource(Descriptor file, std::uint64_t size) : file_(std::move(file)), left_(size) {}
  /// At most so many bytes, fewer at the end only. errors: NOT_READABLE, also where the file has become shorter
  [[nodiscard]] std::expected<std::string, v1::MediaFault> next(std::size_t most);
  [[nodiscard]] bool is_at_end() const { return left_ == 0; }

 private:
  Descriptor file_;
  std::uint64_t left_;
};

/// A file that is being written aside. What is not finished leaves nothing behind.
class MediaTarget {
 public:
  MediaTarget(std::shared_ptr<const Descriptor> folder, Descriptor file, std::string aside, std::string name);
  MediaTarget(MediaTarget&&) noexcept = default;
  MediaTarget& operator=(MediaTarget&&) noexcept = default;
  ~MediaTarget();
  /// errors: NO_ROOM, NOT_WRITABLE
  [[nodiscard]] std::expected<void, v1::MediaFault> append(std::string_view bytes);
  /// The file stands under its name, on disk.
  [[nodiscard]] std::expected<void, v1::MediaFault> finish();

 private:
  std::shared_ptr<const Descriptor> folder_;
  Descriptor file_;
  std::string aside_, name_;  ///< `aside_` is empty once it was renamed
};

class MediaFolder {
 public:
  /// errors: NO_FOLDER
  [[nodiscard]] static std::expected<MediaFolder, v1::MediaFault> open(const MediaPlace& place, std::string_view user);

  /// name     judged here
  /// errors   NOT_FOUND, NOT_READABLE, TOO_LARGE, REFUSED
  [[nodiscard]] std::expected<MediaSource, v1::MediaFault> read(const std::string& name) const;
  /// errors   NO_ROOM, NOT_WRITABLE, REFUSED
  [[nodiscard]] std::expected<MediaTarget, v1::MediaFault> write(const std::string& name) const;

 private:
  explicit MediaFolder(std::shared_ptr<const Descriptor> folder) : folder_(std::move(folder)) {}
  std::shared_ptr<const Descriptor> folder_;
};

}  // namespace cnclab::station
