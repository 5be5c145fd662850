// Each waiter is a timer; a broadcast cancels them all.
#include "station/broadcast.hpp"

#include <algorithm>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>

namespace cnclab::station {

namespace asio = boost::asio;

void Broadcast::notify() {
  for (asio::steady_timer* const timer : waiting_) timer->cancel();
}

asio::awaitable<void> Broadcast::wait_until(Clock::time_point limit) {
  struct Place {
    std::vector<asio::steady_timer*>& waiting;
    asio::steady_timer& timer;
    ~Place() { std::erase(waiting, &timer); }
  };
  asio::steady_timer timer(executor_, limit);
  waiting_.push_back(&timer);
  const Place place{waiting_, timer};
  boost::system::error_code woken;
  co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, woken));
}

}  // namespace cnclab::station
