// A bounded queue with room for every stop key.
#include "station/event_queue.hpp"

#include <algorithm>
#include <iterator>

namespace cnclab::station {
namespace {

std::optional<Input> key_of(const TerminalEvent& event) {
  if (const auto* const input = std::get_if<Input>(&event)) return *input;
  if (const auto* const stray = std::get_if<Stray>(&event)) return Input(stray->character);
  return std::nullopt;
}

}  // namespace

void EventQueue::push(const TerminalEvent& event) {
  if (events_.size() < kMost) return events_.push_back(event);
  const auto key = key_of(event);
  if (!key || !is_stop(*key)) return;
  const bool waits = std::any_of(std::next(events_.begin(), kMost), events_.end(),
                                 [&](const TerminalEvent& other) { return key_of(other) == key; });
  if (!waits) events_.push_back(event);
}

std::optional<TerminalEvent> EventQueue::pop() {
  if (events_.empty()) return std::nullopt;
  const TerminalEvent event = events_.front();
  events_.pop_front();
  return event;
}

}  // namespace cnclab::station
