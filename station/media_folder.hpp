// The station's folder of diskettes, tapes and printed pages (--media). Names come over the network and are not
// trusted: a name of a medium (shared/media_name.hpp) is opened inside this one folder, never through a link, and
// nothing but an ordinary file is read or replaced.
//
//   write   ".cnclab-PID.part" in the folder ── whole, on disk ──▶ renamed, in one step, to the file's name
//
// Bytes that are still on their way are none of the folder's business: a file is read at once and written at once, so
// that only a process that is killed in the very moment of writing leaves such a part. The next one to write removes
// it.
#pragma once

#include <cnclab/v1/media.pb.h>

#include <cstdint>
#include <expected>
#include <filesystem>
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

class MediaFolder {
 public:
  /// errors: NO_FOLDER
  [[nodiscard]] static std::expected<MediaFolder, v1::MediaFault> open(const MediaPlace& place, std::string_view user);

  /// All bytes of the file as it stands now: 1..kLargestMediaRead.
  /// name     judged here, as in the others
  /// errors   NOT_FOUND, NOT_READABLE, TOO_LARGE, REFUSED
  [[nodiscard]] std::expected<std::string, v1::MediaFault> read(const std::string& name) const;
  /// Whether it is worth while to fetch the bytes of that file.
  /// errors   NOT_WRITABLE, REFUSED
  [[nodiscard]] std::expected<void, v1::MediaFault> may_write(const std::string& name) const;
  /// The file stands under its name, whole and on disk; on an error what stood there before.
  /// errors   NO_ROOM, NOT_WRITABLE, REFUSED
  [[nodiscard]] std::expected<void, v1::MediaFault> write(const std::string& name, std::string_view bytes) const;

 private:
  explicit MediaFolder(Descriptor folder) : folder_(std::move(folder)) {}
  [[nodiscard]] std::expected<void, v1::MediaFault> write_aside(const std::string& aside, std::string_view bytes) const;
  [[nodiscard]] std::expected<void, v1::MediaFault> give_name(const std::string& aside, const std::string& name) const;

  Descriptor folder_;
};

}  // namespace cnclab::station
