// Keys, clicks and changes of size from the terminal, through the one event loop of the process.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/signal_set.hpp>
#include <optional>

#include "station/broadcast.hpp"
#include "station/event_queue.hpp"
#include "station/terminal.hpp"

namespace cnclab::station {

class TerminalEvents {
 public:
  /// `changed` is notified when something has arrived.
  TerminalEvents(const boost::asio::any_io_executor& executor, Terminal& terminal, Broadcast& changed);

  /// Collects until the terminal is hung up.
  [[nodiscard]] boost::asio::awaitable<void> collect();
  [[nodiscard]] std::optional<TerminalEvent> take();
  /// The window's size has changed since the last call; the terminal knows it already.
  [[nodiscard]] bool take_resized();

 private:
  boost::asio::awaitable<void> collect_input();
  boost::asio::awaitable<void> collect_sizes();

  Terminal& terminal_;
  Broadcast& changed_;
  boost::asio::posix::stream_descriptor input_;  ///< readable when the terminal is
  boost::asio::signal_set window_;
  EventQueue waiting_;
  bool is_resized_ = false;
};

}  // namespace cnclab::station
