// The 1 ms beat: one thread ticks the lab's machine and all training machines.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "machine/channel.hpp"

namespace cnclab::machine {

/// Late ticks are counted, never skipped silently (architecture.md rule 6).
struct TickStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t late = 0;       ///< began more than 1 ms after their time
  std::uint64_t very_late = 0;  ///< of these, more than 5 ms (LOAD-003)
  std::int64_t longest_delay_ns = 0;
};

class TickThread {
 public:
  static constexpr std::chrono::nanoseconds kPeriod{1'000'000};
  static constexpr int kMostChannels = 64;

  /// Starts the thread; real-time priority and locked memory where the system allows it.
  TickThread();
  ~TickThread();  ///< stops and joins

  /// What was granted of real-time scheduling and memory locking, as one line for the log.
  [[nodiscard]] const std::string& privileges() const;
  /// Real-time scheduling was granted, memory was locked: where one was not, that line is a warning.
  [[nodiscard]] bool is_real_time() const;
  [[nodiscard]] bool has_locked_memory() const;

  /// Takes part in the beat from the next tick on. Lab thread; false when all places are taken.
  [[nodiscard]] bool add(std::shared_ptr<Channel> channel);
  /// Returns once the tick no longer touches the channel.
  void remove(const std::shared_ptr<Channel>& channel);

  [[nodiscard]] TickStatistics statistics() const;
  /// The tick's clock: CLOCK_MONOTONIC in ns.
  [[nodiscard]] static std::int64_t now_ns();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::machine
