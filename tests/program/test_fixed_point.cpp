// The arithmetic of parameters against exact and more precise arithmetic (D-91, DEC-52).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "program/fixed_point.hpp"
#include "random_cases.hpp"

namespace cnclab::program {
namespace {

__extension__ using Wide = __int128;

constexpr std::int64_t kUnit = 1'000'000;
constexpr int kCases = 20;  // of each property, for each of RapidCheck's

constexpr std::int64_t mm(std::int64_t whole, std::int64_t millionths = 0) { return whole * kUnit + millionths; }

/// Values of every size in and a little out of the range, small ones as often as large ones.
std::int64_t any_value() {
  const std::int64_t scale = *rc::gen::element<std::int64_t>(10, 1'000, kUnit, mm(100), mm(9999), mm(20'000));
  return between(-scale, scale);
}

/// |exact| ≤ ½ unit away, or beyond the range and cut off there. numerator / denominator is the exact result.
void expect_rounded(Limited result, Wide numerator, Wide denominator) {
  if (denominator < 0) numerator = -numerator, denominator = -denominator;
  const Wide doubled = 2 * numerator, half_above = (2 * Wide{kLargestValue} + 1) * denominator;
  if (doubled >= half_above || doubled <= -half_above) {
    RC_ASSERT(result == (Limited{numerator > 0 ? kLargestValue : -kLargestValue, true}));
    return;
  }
  RC_ASSERT(!result.carry);
  const Wide error = Wide{result.value} * denominator - numerator;  // result − exact, in 1/denominator
  RC_ASSERT(2 * error <= denominator);
  RC_ASSERT(2 * error >= -denominator);
  if (2 * error == denominator) RC_ASSERT(numerator > 0);  // a half goes away from zero
  if (2 * error == -denominator) RC_ASSERT(numerator < 0);
}

RC_GTEST_PROP(FixedPointProperty, SumsAreExact, ()) {
  for (int i = 0; i < kCases; ++i) {
    const std::int64_t a = any_value(), b = any_value();
    expect_rounded(sum(a, b), Wide{a} + b, 1);
    expect_rounded(difference(a, b), Wide{a} - b, 1);
    expect_rounded(limited(a), a, 1);
  }
}

RC_GTEST_PROP(FixedPointProperty, ProductsAndQuotientsAreRoundedOnce, ()) {
  for (int i = 0; i < kCases; ++i) {
    const std::int64_t a = any_value(), b = any_value();
    expect_rounded(product(a, b), Wide{a} * b, kUnit);
    if (b != 0) expect_rounded(quotient(a, b).value(), Wide{a} * kUnit, b);
  }
}

RC_GTEST_PROP(FixedPointProperty, RootsAreTheNearest, ()) {
  for (int i = 0; i < kCases; ++i) {
    const std::int64_t value = std::min(std::abs(any_value()), kLargestValue);
    const Wide root = square_root(value), square = Wide{value} * kUnit;
    // (root − ½)² < square < (root + ½)², times four
    RC_ASSERT((2 * root + 1) * (2 * root + 1) > 4 * square);
    if (root > 0) RC_ASSERT((2 * root - 1) * (2 * root - 1) < 4 * square);
  }
}

TEST(FixedPoint, EndsOfTheRange_D91) {
  EXPECT_EQ(kLargestValue, mm(9999, 999'000));
  EXPECT_EQ(sum(kLargestValue, 1), (Limited{kLargestValue, true}));
  EXPECT_EQ(sum(kLargestValue, -1), (Limited{kLargestValue - 1, false}));
  EXPECT_EQ(difference(-kLargestValue, 1), (Limited{-kLargestValue, true}));
  EXPECT_EQ(product(mm(100), mm(100)), (Limited{kLargestValue, true}));
  EXPECT_EQ(product(mm(-100), mm(100)), (Limited{-kLargestValue, true}));
  EXPECT_EQ(quotient(mm(1), 1), (Limited{kLargestValue, true}));
  EXPECT_EQ(quotient(mm(1), 0), std::nullopt);
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(product(kMost, kMost), (Limited{kLargestValue, true}));
  EXPECT_EQ(difference(-kMost, kMost), (Limited{-kLargestValue, true}));
}

TEST(FixedPoint, HalvesGoAwayFromZero_DEC52) {
  EXPECT_EQ(product(1, mm(0, 500'000)).value, 1);  // 0.0000005
  EXPECT_EQ(product(-1, mm(0, 500'000)).value, -1);
  EXPECT_EQ(product(1, mm(0, 499'999)).value, 0);
  EXPECT_EQ(quotient(1, mm(2))->value, 1);
  EXPECT_EQ(quotient(1, mm(-2))->value, -1);
  EXPECT_EQ(quotient(mm(2), mm(3))->value, 666'667);
  EXPECT_EQ(quotient(mm(360), mm(7))->value, mm(51, 428'571));
}

TEST(FixedPoint, Roots_PAR020) {
  EXPECT_EQ(square_root(mm(-4)), 0);
  EXPECT_EQ(square_root(0), 0);
  EXPECT_EQ(square_root(mm(9)), mm(3));
  EXPECT_EQ(square_root(mm(2)), mm(1, 414'214));
  EXPECT_EQ(square_root(1), 1'000);
  EXPECT_EQ(square_root(kLargestValue), mm(99, 999'995));
}

TEST(FixedPoint, RationalSinesAreExact_PAR021_PAR022) {
  struct Row {
    int degrees;
    std::int64_t sine, cosine;
  };
  constexpr std::int64_t kOne = kUnit, kHalf = kUnit / 2, kRoot3 = 866'025, kRoot2 = 707'107;
  constexpr Row kRows[] = {{0, 0, kOne},           {30, kHalf, kRoot3},    {45, kRoot2, kRoot2},  {60, kRoot3, kHalf},
                           {90, kOne, 0},          {120, kRoot3, -kHalf},  {150, kHalf, -kRoot3}, {180, 0, -kOne},
                           {210, -kHalf, -kRoot3}, {240, -kRoot3, -kHalf}, {270, -kOne, 0},       {300, -kRoot3, kHalf},
                           {330, -kHalf, kRoot3},  {360, 0, kOne}};
  for (const Row& row : kRows) {
    for (const int turns : {-27, -1, 0, 1, 26}) {
      EXPECT_EQ(sine(mm(row.degrees + 360 * turns)), row.sine) << row.degrees << " + " << turns << " turns";
      EXPECT_EQ(cosine(mm(row.degrees + 360 * turns)), row.cosine) << row.degrees << " + " << turns << " turns";
    }
  }
}

/// The nearest number of six decimals, or (at a tie, which only a rational sine could be) one of the two.
void expect_nearest(std::int64_t result, long double exact, std::int64_t angle) {
  EXPECT_LE(std::abs(static_cast<long double>(result) - exact * kUnit), 0.5L + 1e-9L) << angle;
}

TEST(FixedPoint, SinesOfAllTenthsOfDegrees_D91) {
  for (int tenths = -7200; tenths <= 7200; ++tenths) {
    const std::int64_t angle = std::int64_t{tenths} * (kUnit / 10);
    const long double radians = static_cast<long double>(tenths) / 1800 * std::numbers::pi_v<long double>;
    expect_nearest(sine(angle), std::sin(radians), angle);
    expect_nearest(cosine(angle), std::cos(radians), angle);
  }
}

TEST(FixedPoint, RootsOfAllTenths) {
  for (int tenths = 0; tenths <= 7200; ++tenths)
    expect_nearest(square_root(std::int64_t{tenths} * (kUnit / 10)), std::sqrt(static_cast<long double>(tenths) / 10),
                   tenths);
}

RC_GTEST_PROP(FixedPointProperty, SinesOfAnyAngleAreTheNearest, ()) {
  for (int i = 0; i < kCases; ++i) {
    const std::int64_t angle = any_value();
    const long double radians =
        static_cast<long double>(angle % (360 * kUnit)) / (180 * kUnit) * std::numbers::pi_v<long double>;
    RC_ASSERT(std::abs(static_cast<long double>(sine(angle)) - std::sin(radians) * kUnit) < 0.5L + 1e-9L);
    RC_ASSERT(std::abs(static_cast<long double>(cosine(angle)) - std::cos(radians) * kUnit) < 0.5L + 1e-9L);
  }
}

}  // namespace
}  // namespace cnclab::program
