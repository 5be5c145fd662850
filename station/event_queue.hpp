// What has been typed and is yet to be handled.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "station/terminal_event.hpp"

namespace cnclab::station {

class EventQueue {
 public:
  /// More than anybody types ahead.
  static constexpr std::size_t kMost = 256;

  /// Beyond `kMost` an event is dropped, but a stop key never: each waits there once (AUTH-006).
  void push(const TerminalEvent& event);
  [[nodiscard]] std::optional<TerminalEvent> pop();

 private:
  std::deque<TerminalEvent> events_;
};

}  // namespace cnclab::station
