// Waiting for what another thread does.
#pragma once

#include <chrono>
#include <thread>

namespace cnclab::machine {

/// Waits for a condition with a limit; gives the processor away meanwhile.
template <class Condition>
bool comes_true(Condition&& condition) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (std::chrono::steady_clock::now() < limit) {
    if (condition()) return true;
    std::this_thread::yield();
  }
  return false;
}

}  // namespace cnclab::machine
