// Sums, products and quotients in 128 bits; roots in integers; sines in long double after exact reduction.
#include "program/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cnclab::program {

namespace {

/// Holds every product of two 64-bit numbers.
__extension__ using Wide = __int128;

Limited limited_wide(Wide value) {
  if (value > kLargestValue) return {.value = kLargestValue, .carry = true};
  if (value < -kLargestValue) return {.value = -kLargestValue, .carry = true};
  return {.value = static_cast<std::int64_t>(value), .carry = false};
}

/// a / b to the nearest whole number, halves away from zero; b > 0.
Wide divided(Wide a, Wide b) {
  const Wide quotient = a / b, rest = a % b;  // towards zero; the rest has the sign of a
  const Wide size_of_rest = rest < 0 ? -rest : rest;
  if (size_of_rest < b - size_of_rest) return quotient;
  return a < 0 ? quotient - 1 : quotient + 1;
}

/// The sine of 0°..90°.
///
/// Integer reduction has left an angle that is exact, so the only errors are those of π/180 and of std::sin, together
/// below 1e-12 units of the result. No sine comes that near to the middle between two results: the nearest of all
/// 90 000 001 angles, 6.336789°, is 8.6e-9 units away (every one of them was computed and compared once).
std::int64_t sine_of_quadrant(std::int64_t degrees) {
  constexpr std::int64_t kRightAngle = 90 * kParameterUnit;
  constexpr long double kPerUnit = std::numbers::pi_v<long double> / (180.0L * kParameterUnit);
  constexpr std::int64_t kEighth = kRightAngle / 2;
  // The smaller of an angle and its complement keeps the argument, and with it its error, small.
  const long double result = degrees <= kEighth ? std::sin(static_cast<long double>(degrees) * kPerUnit)
                                                : std::cos(static_cast<long double>(kRightAngle - degrees) * kPerUnit);
  return std::llround(result * kParameterUnit);
}

}  // namespace

Limited limited(std::int64_t value) { return limited_wide(value); }
Limited sum(std::int64_t a, std::int64_t b) { return limited_wide(Wide{a} + b); }
Limited difference(std::int64_t a, std::int64_t b) { return limited_wide(Wide{a} - b); }
Limited product(std::int64_t a, std::int64_t b) { return limited_wide(divided(Wide{a} * b, kParameterUnit)); }

std::optional<Limited> quotient(std::int64_t a, std::int64_t b) {
  if (b == 0) return std::nullopt;
  const Wide dividend = Wide{a} * kParameterUnit, divisor = b;
  return limited_wide(divisor < 0 ? divided(-dividend, -divisor) : divided(dividend, divisor));
}

/// √(value · unit) in whole numbers. std::sqrt gives a root that is at most one off; integers put it right. A middle
/// between two results is never met: (n + ½)² is no whole number.
std::int64_t square_root(std::int64_t value) {
  if (value <= 0) return 0;
  const Wide square = Wide{value} * kParameterUnit;
  Wide root = static_cast<Wide>(std::sqrt(static_cast<long double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  if (square - root * root > root) ++root;  // above (root + ½)²
  return limited_wide(root).value;
}

std::int64_t sine(std::int64_t degrees) {
  constexpr std::int64_t kHalfTurn = kFullTurn / 2, kQuarterTurn = kFullTurn / 4;
  degrees %= kFullTurn;
  const bool is_negative = degrees < 0;
  degrees = std::abs(degrees);  // sin −x = −sin x
  const bool is_lower_half = degrees > kHalfTurn;
  if (is_lower_half) degrees -= kHalfTurn;                    // sin (x + 180°) = −sin x
  if (degrees > kQuarterTurn) degrees = kHalfTurn - degrees;  // sin (180° − x) = sin x
  const std::int64_t result = sine_of_quadrant(degrees);
  return is_negative != is_lower_half ? -result : result;
}

/// cos x = sin (90° − |x|); the reduction first keeps the difference within 64 bits.
std::int64_t cosine(std::int64_t degrees) { return sine(kFullTurn / 4 - std::abs(degrees % kFullTurn)); }

}  // namespace cnclab::program
