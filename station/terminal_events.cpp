// Waiting for the terminal to be readable, then taking all that ncurses makes of it.
#include "station/terminal_events.hpp"

#include <sys/epoll.h>
#include <unistd.h>

#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <csignal>
#include <utility>

namespace cnclab::station {

namespace asio = boost::asio;

namespace {

// A descriptor that is readable when stdin is. Asio makes what it waits for non-blocking; on stdin itself, or a
// duplicate, every program that has the same terminal would find that, also when this one is gone.
int watch_of_stdin() {
  const int watch = ::epoll_create1(EPOLL_CLOEXEC);
  epoll_event readable{.events = EPOLLIN, .data = {}};
  if (watch >= 0) ::epoll_ctl(watch, EPOLL_CTL_ADD, STDIN_FILENO, &readable);
  return watch;
}

}  // namespace

TerminalEvents::TerminalEvents(const asio::any_io_executor& executor, Terminal& terminal, Broadcast& changed)
    : terminal_(terminal), changed_(changed), input_(executor, watch_of_stdin()), window_(executor, SIGWINCH) {}

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
    while (const auto event = terminal_.next_event()) waiting_.push(*event);
    changed_.notify();
  }
}

std::optional<TerminalEvent> TerminalEvents::take() { return waiting_.pop(); }

bool TerminalEvents::take_resized() { return std::exchange(is_resized_, false); }

}  // namespace cnclab::station
