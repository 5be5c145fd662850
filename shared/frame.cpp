// The frame header's length, checked before its body is read.
#include "shared/frame.hpp"

namespace cnclab {

std::expected<std::size_t, FrameError> body_length(std::span<const std::uint8_t, kFrameHeader> header) {
  std::size_t length = 0;
  for (const std::uint8_t byte : header) length = (length << 8) | byte;
  if (length == 0) return std::unexpected(FrameError::empty);
  if (length > kLargestFrame) return std::unexpected(FrameError::too_large);
  return length;
}

}  // namespace cnclab
