// Numbers as bytes, most significant first. Private to this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cnclab::transfer {

inline void append_big_endian(std::string& bytes, std::uint32_t value, int length) {
  for (int byte = length - 1; byte >= 0; --byte) bytes += static_cast<char>(value >> (8 * byte) & 0xFFU);
}

/// The number in all of `bytes`, at most four.
[[nodiscard]] inline std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
  return value;
}

}  // namespace cnclab::transfer
