// The numbers of stored programs: integers only, no floating point (architecture.md "Values that flow").
#pragma once

#include <compare>
#include <cstdint>

namespace cnclab::language {

/// A length as the control counts it: 1/1000 mm. Words hold ±9 999 999 (BLK-005); sums may be larger.
struct Micrometres {
  std::int64_t value = 0;
  friend auto operator<=>(const Micrometres&, const Micrometres&) = default;
};

[[nodiscard]] constexpr double to_mm(Micrometres length) { return static_cast<double>(length.value) / 1000.0; }

inline constexpr std::int64_t kLargestWord_um = 9'999'999;

/// The control's language on screens and in messages (German like the original, English selectable).
enum class Tongue : std::uint8_t { german, english };

/// The plane chosen by G17, G18, G19, as far as entry and storage care: it fixes the words of arcs (D-54).
enum class Plane : std::uint8_t { xy, xz, yz };

/// CNC 3300, or the reduced CNC 3250 (section MODEL).
enum class Model : std::uint8_t { cnc3300, cnc3250 };

}  // namespace cnclab::language
