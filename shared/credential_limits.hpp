// How long names and passwords may be, in bytes of UTF-8: what a station lets be typed and what the server takes
// (SEC-002).
#pragma once

#include <cstddef>

namespace cnclab {

inline constexpr std::size_t kLongestName = 32;
inline constexpr std::size_t kShortestPassword = 8, kLongestPassword = 256;

}  // namespace cnclab
