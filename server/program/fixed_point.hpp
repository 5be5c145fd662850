// The arithmetic of parameters (D-91, DEC-52): fixed point with six decimals, as a contract.
//
// Unit      every value is a whole number of 1/1 000 000: of a mm, a degree, or of nothing.
// Range     ±9999.999 (D-91), that is ±kLargestValue. Operands may lie outside (#64..#66 far from zero); results never.
// Overflow  a result beyond the range becomes the nearest end of the range, and `carry` says so.
// Rounding  to the nearest 1/1 000 000, halves away from zero. Every function is correctly rounded: its result is the
//           exact one, rounded once. How each manages that stands at its definition.
#pragma once

#include <cstdint>
#include <optional>

namespace cnclab::program {

inline constexpr std::int64_t kParameterUnit = 1'000'000;        ///< 1
inline constexpr std::int64_t kLargestValue = 9'999'999'000;     ///< 9999.999
inline constexpr std::int64_t kFullTurn = 360 * kParameterUnit;  ///< 360°

/// A result within the range, and whether the range has cut it off.
struct Limited {
  std::int64_t value = 0;
  bool carry = false;
  friend bool operator==(const Limited&, const Limited&) = default;
};

/// The value itself, or the end of the range that it lies beyond.
[[nodiscard]] Limited limited(std::int64_t value);

[[nodiscard]] Limited sum(std::int64_t a, std::int64_t b);
[[nodiscard]] Limited difference(std::int64_t a, std::int64_t b);
[[nodiscard]] Limited product(std::int64_t a, std::int64_t b);
/// a / b; nothing for b = 0.
[[nodiscard]] std::optional<Limited> quotient(std::int64_t a, std::int64_t b);

/// The square root; 0 for negative values (D-91). Always within the range.
[[nodiscard]] std::int64_t square_root(std::int64_t value);
/// Sine and cosine of an angle in degrees, any number of turns; exact at multiples of 30° where the result is rational.
[[nodiscard]] std::int64_t sine(std::int64_t degrees);
[[nodiscard]] std::int64_t cosine(std::int64_t degrees);

}  // namespace cnclab::program
