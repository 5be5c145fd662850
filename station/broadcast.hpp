// Waking every coroutine that waits for "something changed", within a time limit.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <vector>

namespace cnclab::station {

/// One thread. Whoever waits looks at the state itself before and after: a broadcast carries no value.
class Broadcast {
 public:
  using Clock = std::chrono::steady_clock;
  explicit Broadcast(boost::asio::any_io_executor executor) : executor_(std::move(executor)) {}
  Broadcast(const Broadcast&) = delete;
  Broadcast& operator=(const Broadcast&) = delete;
  ~Broadcast() = default;

  void notify();
  /// Returns after the next `notify`, or at `limit`.
  [[nodiscard]] boost::asio::awaitable<void> wait_until(Clock::time_point limit);

 private:
  boost::asio::any_io_executor executor_;
  std::vector<boost::asio::steady_timer*> waiting_;
};

}  // namespace cnclab::station
