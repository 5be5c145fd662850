// Waiting with a condition and a limit, by the monotonic clock; nothing here waits longer than it must.
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

namespace cnclab::harness {

using namespace std::chrono_literals;
using Milliseconds = std::chrono::milliseconds;

/// Long enough for whatever comes by itself, on a busy machine too.
constexpr auto kLimit = 10s;

/// The moment at which waiting ends.
class Deadline {
 public:
  explicit Deadline(Milliseconds limit) : end_(std::chrono::steady_clock::now() + limit) {}
  [[nodiscard]] bool has_passed() const { return std::chrono::steady_clock::now() >= end_; }
  /// Rest of the time, never negative; as `poll` takes it.
  [[nodiscard]] int remaining_ms() const {
    const auto rest = std::chrono::ceil<Milliseconds>(end_ - std::chrono::steady_clock::now());
    return static_cast<int>(std::max<Milliseconds::rep>(rest.count(), 0));
  }

 private:
  std::chrono::steady_clock::time_point end_;
};

/// Asks `condition` again and again until it holds or the limit has passed; returns whether it held. For conditions
/// that only a question can answer (a one-shot command, a file); everything else is waited for on its descriptor.
template <class Condition>
[[nodiscard]] bool eventually(Milliseconds limit, const Condition& condition) {
  constexpr auto kBetweenQuestions = 10ms;
  const Deadline deadline(limit);
  while (!condition()) {
    if (deadline.has_passed()) return false;
    std::this_thread::sleep_for(kBetweenQuestions);
  }
  return true;
}

}  // namespace cnclab::harness
