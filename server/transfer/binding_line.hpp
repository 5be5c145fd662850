// The first line of a serial line over TCP, which says whose it is (interfaces.md section 8): "STATION 7 k3Rt92Qd" LF.
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace cnclab::transfer {

struct Binding {
  int station = 0;    ///< 1..15
  std::string token;  ///< 1..64 letters, digits, "-", "_"; whether it is the right one is the lab's to judge
  friend bool operator==(const Binding&, const Binding&) = default;
};

/// The longest line without LF: who sends more before the first LF is no DNC sender.
inline constexpr std::size_t kLongestBinding = 80;

/// line     without its LF; one CR before it is allowed
/// errors   what is wrong with it, in English, for the log
[[nodiscard]] std::expected<Binding, std::string_view> parse_binding(std::string_view line);

}  // namespace cnclab::transfer
