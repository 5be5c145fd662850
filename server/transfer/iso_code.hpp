// ISO 7-bit code with even parity in bit 8 (DIN 66024, EXT-033, EXT-044, D-103), and its control characters.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace cnclab::transfer {

inline constexpr char kNul = '\x00';
inline constexpr char kReaderOn = '\x11';   ///< DC1: the control asks for data (EXT-046)
inline constexpr char kReaderOff = '\x13';  ///< DC3, always sent twice (EXT-053)
inline constexpr char kTransmissionEnd = '%';

/// At least so many NUL stand between two programs (EXT-052).
inline constexpr std::size_t kSeparatorLength = 6;

/// The character with bit 8 set so that the number of ones is even: DC3 (13H) leaves as 93H, DC1 stays 11H.
[[nodiscard]] constexpr char with_even_parity(char character) {
  const unsigned code = static_cast<unsigned char>(character) & 0x7FU;
  return static_cast<char>(code | (std::popcount(code) % 2 == 1 ? 0x80U : 0U));
}

/// What a received byte means: bit 8 is masked, not checked (D-103).
[[nodiscard]] constexpr char without_parity(char byte) {
  return static_cast<char>(static_cast<unsigned char>(byte) & 0x7FU);
}

[[nodiscard]] std::string with_even_parity(std::string_view text);
[[nodiscard]] std::string without_parity(std::string_view bytes);

}  // namespace cnclab::transfer
