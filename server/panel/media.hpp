// Files that a control wants from, or has for, the place where its student sits: the drive, the reader and punch, and
// the printer of the station (interfaces.md, --media). Names are those of shared/media_name.hpp.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace cnclab::panel {

struct MediaFile {
  std::string name, bytes;
};
/// All of them are written, or what was written before the fault stays.
struct PutFiles {
  std::vector<MediaFile> files;
  bool is_printed = false;  ///< the one called ".pdf" also goes to the lab's printer, where there is one
};
/// The first of these that is there is read.
struct GetFile {
  std::vector<std::string> names;
};
using MediaRequest = std::variant<PutFiles, GetFile>;

}  // namespace cnclab::panel
