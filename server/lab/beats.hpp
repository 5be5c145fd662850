// The numbered beat that stations answer, so that the age of whatever they send is known (AUTH-007).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace cnclab::lab {

class Beats {
 public:
  static constexpr std::int64_t kPeriod_ns = 50'000'000;

  /// Begins the next beat when it is due; true when it did.
  bool advance(std::int64_t now_ns) {
    if (number_ != 0 && now_ns - sent_ns_[number_ % kKept] < kPeriod_ns) return false;
    ++number_;
    sent_ns_[number_ % kKept] = now_ns;
    return true;
  }
  [[nodiscard]] std::uint64_t number() const { return number_; }
  /// When a beat was sent; nothing for one that is too old (over 6 s) or was never sent.
  [[nodiscard]] std::optional<std::int64_t> sent_ns(std::uint64_t number) const {
    if (number == 0 || number > number_ || number_ - number >= kKept) return std::nullopt;
    return sent_ns_[number % kKept];
  }

 private:
  static constexpr std::uint64_t kKept = 128;
  std::array<std::int64_t, kKept> sent_ns_{};
  std::uint64_t number_ = 0;
};

}  // namespace cnclab::lab
