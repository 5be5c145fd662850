// Frames: 4-byte big-endian length, then a protobuf message. The length is checked before anything is allocated.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string>

namespace cnclab {

inline constexpr std::size_t kFrameHeader = 4;
inline constexpr std::size_t kLargestFrame = 65'536;
inline constexpr std::uint32_t kProtocolVersion = 1;
inline constexpr std::size_t kLargestChunk = 4096;

enum class FrameError : std::uint8_t { empty, too_large };

/// Length of the body announced by a header: 1..kLargestFrame.
[[nodiscard]] std::expected<std::size_t, FrameError> body_length(std::span<const std::uint8_t, kFrameHeader> header);

/// Header and body in one string, ready to send; `Message` is a protobuf message of at most kLargestFrame bytes.
template <class Message>
[[nodiscard]] std::string frame(const Message& message) {
  const std::size_t size = message.ByteSizeLong();
  std::string bytes;
  bytes.reserve(kFrameHeader + size);
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>((size >> shift) & 0xFFU));
  message.AppendToString(&bytes);
  return bytes;
}

}  // namespace cnclab
