// Start marks and check codes of recordings.
#include "transfer/cassette_recording.hpp"

#include <algorithm>
#include <boost/crc.hpp>

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
  std::size_t at = kMarkLength;
  for (std::uint32_t number = 0; payload.text.size() < mark->text_length; ++number) {
    const std::size_t length = std::min(kRecordingBlock, mark->text_length - payload.text.size());
    if (recording.size() - at < length + kCheckLength) return std::unexpected(Damaged{.at = recording.size()});
    const std::string_view block = recording.substr(at, length);
    at += length + kCheckLength;
    if (big_endian(recording.substr(at - kCheckLength, kCheckLength)) != check_code(number, block))
      return std::unexpected(Damaged{.at = at});
    payload.text += block;
  }
  return payload;
}

}  // namespace cnclab::transfer
