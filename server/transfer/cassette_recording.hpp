// One recording as it lies on a cassette: the transfer text behind a start mark and length, in blocks that each carry a
// check code, so that a damaged byte is found (DEC-33, D-107).
//
//   recording = 16H 16H 16H 01H  header  crc32(header)  { block crc32(number, block) }
//   header    = kind ("P" program, "M" whole memory)  program number, 2 bytes  length of the text, 4 bytes
//   block     = 128 bytes of text; the last one what is left
//
// All numbers big-endian. The check code is CRC-32 (IEEE 802.3); a block's number goes into it, so that blocks cannot
// change places. Text: as punched_tape.hpp `line_text`; of a whole memory `disk_text` (DEC-34).
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

namespace cnclab::transfer {

/// What a transfer carries.
struct Payload {
  bool is_whole_memory = false;
  std::uint16_t program = 0;  ///< of a single program; else 0
  std::string text;           ///< 7-bit
  friend bool operator==(const Payload&, const Payload&) = default;
};

/// What the start mark says.
struct StartMark {
  bool is_whole_memory = false;
  std::uint16_t program = 0;
  std::uint32_t text_length = 0;
};

inline constexpr std::size_t kMarkLength = 4 + 7 + 4;      ///< start mark, header and its check code, bytes
inline constexpr std::size_t kRecordingBlock = 128;        ///< bytes of text
inline constexpr std::size_t kRecordingBlockLength = 132;  ///< with its check code

/// Bytes of a recording of `text_length` bytes of text.
[[nodiscard]] constexpr std::size_t recording_length(std::size_t text_length) {
  return kMarkLength + text_length + (text_length + kRecordingBlock - 1) / kRecordingBlock * 4;
}

[[nodiscard]] std::string encode_recording(const Payload& payload);

/// A byte is not as it was written, or the end is missing.
struct Damaged {
  std::size_t at = 0;  ///< the first byte behind the piece whose check code does not fit
};

/// recording   kMarkLength bytes or more are looked at
[[nodiscard]] std::expected<StartMark, Damaged> decode_mark(std::string_view recording);
[[nodiscard]] std::expected<Payload, Damaged> decode_recording(std::string_view recording);

/// Where a recording is not what was written. That it is cut off, since another begins upon it or the tape ended, is no
/// fault: what there is of it is judged.
struct RecordingFaults {
  bool is_mark_damaged = false;         ///< what follows cannot be judged then
  std::vector<std::uint32_t> blocks{};  ///< those whose check code does not fit, from 0, ascending
};
[[nodiscard]] RecordingFaults recording_faults(std::string_view recording);

}  // namespace cnclab::transfer
