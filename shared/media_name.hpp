// Names of files in a station's media folder. Names travel over the lab's connection, so neither end trusts the other:
// what is not plainly the name of a tape, diskette or printed page inside that one folder is no name at all.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cnclab {

/// What a file in the media folder is, and how its name ends.
enum class MediaKind : std::uint8_t {
  punched_tape,   ///< ".tap": rows of holes
  tape_text,      ///< ".txt": the tape to read, or a printed list
  diskette,       ///< ".nc"
  printed_pages,  ///< ".pdf"
  picture,        ///< ".svg"
};

inline constexpr std::size_t kLongestMediaName = 64;
inline constexpr std::size_t kLargestMediaWritten = 4UL * 1'048'576;  ///< bytes of a file that a station is to write
inline constexpr std::size_t kLargestMediaRead = 1'048'576;           ///< … is to send: the size of a cassette
inline constexpr std::size_t kMostMediaNames = 4;                     ///< that one request may try in turn

/// 1 to 64 characters of A–Z a–z 0–9 "_" "-" ".", a known ending, a stem that is not empty. No folders, no hidden
/// files, nothing that begins with "-" or holds "..", no device of any system (CON, LPT1, …).
[[nodiscard]] std::optional<MediaKind> media_kind(std::string_view name);
[[nodiscard]] inline bool is_media_name(std::string_view name) { return media_kind(name).has_value(); }

/// "P0001.tap"; without a number that of a whole memory: "SPEICHER.nc".
[[nodiscard]] std::string media_name(MediaKind kind, std::optional<int> program);

}  // namespace cnclab
