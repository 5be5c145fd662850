// What one terminal is told of its screen: the newest state, at most one update unacknowledged (architecture.md rule
// 5).
#pragma once

#include <cstdint>
#include <optional>

#include "cnclab/v1/screen.pb.h"
#include "shared/screen.hpp"
#include "shared/screen_wire.hpp"

namespace cnclab::lab {

/// A screen and what travels with it.
struct View {
  Screen screen;
  std::uint64_t handled_key = 0;
  std::uint64_t state = 0;
  bool alarm_tone = false;
  friend bool operator==(const View&, const View&) = default;
};

class ScreenFeed {
 public:
  /// Replaces what waits; beeps add up.
  void offer(const View& view, int beeps);
  /// The next update to send, or nothing while one is unacknowledged or nothing changed.
  [[nodiscard]] std::optional<v1::ScreenUpdate> next(RowForm form = RowForm::whole);
  /// False for a number that was never sent: the peer does not keep to the protocol.
  [[nodiscard]] bool acknowledge(std::uint64_t number);
  /// An update is on its way.
  [[nodiscard]] bool is_waiting() const { return in_flight_.has_value(); }

 private:
  View newest_, acknowledged_;
  std::optional<View> in_flight_;
  std::uint64_t number_ = 0;
  int beeps_ = 0;
};

}  // namespace cnclab::lab
