// One value between two threads: the writer never waits, the reader sees a whole value or tries again.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>

namespace cnclab::machine {

/// One writer, any number of readers. Words are relaxed atomics between two counts, so there is no data race.
template <class T>
class SeqLock {
  static_assert(std::is_trivially_copyable_v<T>);
  static constexpr std::size_t kWords = (sizeof(T) + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);

 public:
  explicit SeqLock(const T& value = T{}) { store(value); }

  void store(const T& value) noexcept {
    std::array<std::uint64_t, kWords> words{};
    std::memcpy(words.data(), &value, sizeof(T));
    const std::uint64_t count = count_.load(std::memory_order_relaxed);
    count_.store(count + 1, std::memory_order_relaxed);
    for (std::size_t i = 0; i < kWords; ++i) words_[i].store(words[i], std::memory_order_release);
    count_.store(count + 2, std::memory_order_release);
  }

  /// Nothing while the writer is at it.
  [[nodiscard]] std::optional<T> try_load() const noexcept {
    const std::uint64_t before = count_.load(std::memory_order_acquire);
    if (before % 2 != 0) return std::nullopt;
    std::array<std::uint64_t, kWords> words;
    for (std::size_t i = 0; i < kWords; ++i) words[i] = words_[i].load(std::memory_order_acquire);
    if (count_.load(std::memory_order_relaxed) != before) return std::nullopt;
    T value;
    std::memcpy(static_cast<void*>(&value), words.data(), sizeof(T));
    return value;
  }

  /// Not for the tick: waits for the writer.
  [[nodiscard]] T load() const noexcept {
    for (;;) {
      if (const auto value = try_load()) return *value;
    }
  }

 private:
  std::atomic<std::uint64_t> count_{0};
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

}  // namespace cnclab::machine
