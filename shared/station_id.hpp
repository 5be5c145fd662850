// The address of a station: 1 to 15, the original's four-bit slide switch (SEAT-001, HW-031 to HW-046).
#pragma once

#include <compare>
#include <cstdint>
#include <optional>

namespace cnclab {

class StationId {
 public:
  static constexpr int kFirst = 1, kLast = 15;
  /// Nothing outside 1..15.
  [[nodiscard]] static constexpr std::optional<StationId> of(std::int64_t number) {
    if (number < kFirst || number > kLast) return std::nullopt;
    return StationId(static_cast<int>(number));
  }
  [[nodiscard]] constexpr int number() const { return number_; }
  friend auto operator<=>(const StationId&, const StationId&) = default;

 private:
  constexpr explicit StationId(int number) : number_(number) {}
  int number_;
};

}  // namespace cnclab
