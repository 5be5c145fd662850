// A bounded ring between one writing and one reading thread, without locks.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace cnclab::machine {

template <class T, std::size_t kSize>
class SpscRing {
 public:
  /// Writer. False when full: nothing changed.
  [[nodiscard]] bool push(const T& value) noexcept {
    const std::uint64_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_.load(std::memory_order_acquire) >= kSize) return false;
    places_[head % kSize] = value;
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// Reader. Nothing when empty.
  [[nodiscard]] std::optional<T> pop() noexcept {
    const std::uint64_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_.load(std::memory_order_acquire)) return std::nullopt;
    std::optional<T> value = places_[tail % kSize];
    tail_.store(tail + 1, std::memory_order_release);
    return value;
  }

 private:
  std::array<T, kSize> places_{};
  alignas(64) std::atomic<std::uint64_t> head_{0};
  alignas(64) std::atomic<std::uint64_t> tail_{0};
};

}  // namespace cnclab::machine
