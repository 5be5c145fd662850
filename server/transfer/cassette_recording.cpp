// Start marks and check codes of recordings.
#include "transfer/cassette_recording.hpp"

#include <algorithm>
#include <boost/crc.hpp>
#include <optional>

#include "transfer/big_endian.hpp"

namespace cnclab::transfer {

namespace {

constexpr std::string_view kMark = "\x16\x16\x16\x01";
constexpr char kProgram = 'P', kWholeMemory = 'M';
constexpr std::size_t kHeaderLength = 7, kCheckLength = 4;

std::uint32_t crc_of(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::uint32_t check_code(std::uint32_t number, std::string_view block) {
  std::string bytes;
  append_big_endian(bytes, number, 4);
  return crc_of(bytes.append(block));
}

struct RecordedBlock {
  std::uint32_t number = 0;  ///< from 0
  std::string_view text;
  bool is_sound = false;  ///< its check code fits
};

/// Goes through the blocks behind a start mark.
class RecordedBlocks {
 public:
  RecordedBlocks(std::string_view recording, std::size_t text_length) : recording_(recording), left_(text_length) {}

  /// Nothing behind the last block, and where the recording is cut off.
  std::optional<RecordedBlock> next() {
    const std::size_t length = std::min(kRecordingBlock, left_);
    if (length == 0 || recording_.size() - at_ < length + kCheckLength) return std::nullopt;
    const std::string_view text = recording_.substr(at_, length);
    const std::uint32_t code = big_endian(recording_.substr(at_ + length, kCheckLength));
    at_ += length + kCheckLength;
    left_ -= length;
    const std::uint32_t number = number_++;
    return RecordedBlock{number, text, code == check_code(number, text)};
  }
  [[nodiscard]] std::size_t position() const { return at_; }  ///< the first byte behind the last block given

 private:
  std::string_view recording_;
  std::size_t at_ = kMarkLength, left_;
  std::uint32_t number_ = 0;
};

}  // namespace

std::string encode_recording(const Payload& payload) {
  std::string header(1, payload.is_whole_memory ? kWholeMemory : kProgram);
  append_big_endian(header, payload.program, 2);
  append_big_endian(header, static_cast<std::uint32_t>(payload.text.size()), 4);
  std::string bytes(kMark);
  bytes += header;
  append_big_endian(bytes, crc_of(header), 4);
  std::uint32_t number = 0;
  for (std::string_view rest = payload.text; !rest.empty(); ++number) {
    const std::string_view block = rest.substr(0, kRecordingBlock);
    bytes += block;
    append_big_endian(bytes, check_code(number, block), 4);
    rest.remove_prefix(block.size());
  }
  return bytes;
}

std::expected<StartMark, Damaged> decode_mark(std::string_view recording) {
  const Damaged damaged{.at = std::min(recording.size(), kMarkLength)};
  if (recording.size() < kMarkLength || !recording.starts_with(kMark)) return std::unexpected(damaged);
  const std::string_view header = recording.substr(kMark.size(), kHeaderLength);
  if (big_endian(recording.substr(kMark.size() + kHeaderLength, kCheckLength)) != crc_of(header))
    return std::unexpected(damaged);
  if (header[0] != kProgram && header[0] != kWholeMemory) return std::unexpected(damaged);
  return StartMark{.is_whole_memory = header[0] == kWholeMemory,
                   .program = static_cast<std::uint16_t>(big_endian(header.substr(1, 2))),
                   .text_length = big_endian(header.substr(3, 4))};
}

std::expected<Payload, Damaged> decode_recording(std::string_view recording) {
  const auto mark = decode_mark(recording);
  if (!mark) return std::unexpected(mark.error());
  Payload payload{.is_whole_memory = mark->is_whole_memory, .program = mark->program, .text = {}};
  RecordedBlocks blocks(recording, mark->text_length);
  while (const auto block = blocks.next()) {
    if (!block->is_sound) return std::unexpected(Damaged{.at = blocks.position()});
    payload.text += block->text;
  }
  if (payload.text.size() < mark->text_length) return std::unexpected(Damaged{.at = recording.size()});
  return payload;
}

RecordingFaults recording_faults(std::string_view recording) {
  RecordingFaults faults;
  if (recording.size() < kMarkLength) return faults;
  const auto mark = decode_mark(recording);
  faults.is_mark_damaged = !mark;
  if (!mark) return faults;
  RecordedBlocks blocks(recording, mark->text_length);
  while (const auto block = blocks.next())
    if (!block->is_sound) faults.blocks.push_back(block->number);
  return faults;
}

}  // namespace cnclab::transfer
