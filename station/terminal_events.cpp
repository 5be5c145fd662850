// Waiting for the terminal to be readable, then taking all that ncurses makes of it.
#include "station/terminal_events.hpp"

#include <unistd.h>

#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <csignal>
#include <utility>

namespace cnclab::station {

namespace asio = boost::asio;

namespace {
// More than anybody types ahead; a pasted text beyond it is dropped.
constexpr std::size_t kMostWaiting = 256;
}  // namespace

TerminalEvents::TerminalEvents(const asio::any_io_executor& executor, Terminal& terminal, Broadcast& changed)
    : terminal_(terminal), changed_(changed), input_(executor, ::dup(STDIN_FILENO)), window_(executor, SIGWINCH) {}

asio::awaitable<void> TerminalEvents::collect() {
  using asio::experimental::awaitable_operators::operator||;
  co_await (collect_input() || collect_sizes());
}

asio::awaitable<void> TerminalEvents::collect_sizes() {
  for (;;) {
    co_await window_.async_wait(asio::use_awaitable);
    terminal_.resize();
    is_resized_ = true;
    changed_.notify();
  }
}

asio::awaitable<void> TerminalEvents::collect_input() {
  while (!terminal_.is_hung_up()) {
    co_await input_.async_wait(asio::posix::stream_descriptor::wait_read, asio::use_awaitable);
    while (const auto event = terminal_.next_event()) {
      if (waiting_.size() < kMostWaiting) waiting_.push_back(*event);
    }
    changed_.notify();
  }
}

std::optional<TerminalEvent> TerminalEvents::take() {
  if (waiting_.empty()) return std::nullopt;
  const TerminalEvent event = waiting_.front();
  waiting_.pop_front();
  return event;
}

bool TerminalEvents::take_resized() { return std::exchange(is_resized_, false); }

}  // namespace cnclab::station
