// Takes the current from the machine when the tick no longer comes (rule 7 of machine.hpp).
//
// It looks from a thread of its own, so a driver that hangs in `exchange` does not stop it. It is no emergency stop.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "machine/channel.hpp"
#include "machine/tick_thread.hpp"

namespace cnclab::machine {

/// Decides, without threads or clocks: did the count of ticks stand still for longer than the limit?
class StallDetector {
 public:
  explicit StallDetector(std::chrono::nanoseconds limit) : limit_(limit) {}
  /// True once per stall.
  [[nodiscard]] bool look(std::uint64_t ticks, std::int64_t now_ns);

 private:
  std::chrono::nanoseconds limit_;
  std::uint64_t ticks_ = 0;
  std::int64_t since_ns_ = 0;
  bool has_looked_ = false;
  bool is_told_ = false;
};

class Watchdog {
 public:
  /// A hundred ticks: far more than an ordinary scheduler's delay, and some millimetres of a spindle's way.
  static constexpr std::chrono::milliseconds kLimit{100};
  /// For a beat without real-time scheduling: a busy computer may hold it up for longer than a hundred ticks. The axes
  /// stand still meanwhile, since nobody sends them steps.
  static constexpr std::chrono::milliseconds kPatientLimit{500};

  /// beat   outlives the watchdog
  explicit Watchdog(const TickThread& beat, std::chrono::milliseconds limit = kLimit);
  ~Watchdog();

  /// This channel's machine is cut when the beat stalls. Training machines need it not: they stop with the tick.
  void guard(std::shared_ptr<Channel> channel);
  /// Stalls so far, for the log and `status`.
  [[nodiscard]] std::uint64_t stalls() const;

 private:
  void run();

  const TickThread& beat_;
  std::chrono::milliseconds limit_;
  mutable std::mutex mutex_;
  std::condition_variable ended_;
  std::vector<std::shared_ptr<Channel>> guarded_;
  std::uint64_t stalls_ = 0;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace cnclab::machine
