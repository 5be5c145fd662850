// One motion by hand: in chosen directions until STOP, or to the reference points (2.1, 2.1.2, D-11).
//
//   begin ──▶ moving ──STOP──▶ braking ──▶ none        the channel moves; this only follows its snapshot
//               └── limit switch, power, lease, switches found ──▶ none
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "machine/channel.hpp"
#include "panel/connection.hpp"

namespace cnclab::panel {

/// Sign of the chosen travel of X, Y, Z; 0 = not chosen.
using Directions = std::array<std::int8_t, 3>;

class ManualMotion {
 public:
  enum class Kind : std::uint8_t { jog, reference };
  enum class State : std::uint8_t { none, moving, braking };

  struct End {
    Kind kind{};
    bool is_refused = false;  ///< it never began: lease, halt, drives off, or towards an active switch (D-117)
    machine::StopCause cause = machine::StopCause::none;
  };

  /// Starts at once; at least one direction is chosen. A machine that does not take it is told by `poll`.
  void begin(const Connection& connection, Kind kind, const Directions& directions);
  void stop();
  /// Follows the machine; the end once it stands still again.
  std::optional<End> poll();

  [[nodiscard]] State state() const;
  [[nodiscard]] Kind kind() const { return kind_; }  ///< of the present motion

 private:
  Connection connection_;
  machine::Snapshot seen_;
  Kind kind_{};
  bool is_present_ = false;
  bool is_stopped_ = false;           ///< STOP was pressed since it began
  std::uint64_t answer_tick_ = 0;     ///< from this tick on the snapshot knows of the command
  std::uint64_t refused_before_ = 0;  ///< commands not taken before this one
};

}  // namespace cnclab::panel
