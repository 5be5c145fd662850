// Moving by hand as HANDBETRIEB and TEACH IN share it: directions, START, STOP, spindle and coolant (2.1, 2.3).
#pragma once

#include <optional>
#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/run/manual_motion.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

/// While `motion` lasts, `directions` are those it moves in.
struct HandDriving {
  Directions directions{};
  ManualMotion motion;

  [[nodiscard]] bool has_direction() const { return directions != Directions{}; }
  [[nodiscard]] bool is_moving() const { return motion.state() != ManualMotion::State::none; }
};

/// The axis 0..2 and sign of a direction key, counted from +X.
struct DirectionKey {
  std::size_t axis = 0;
  std::int8_t sign = 1;
};
[[nodiscard]] DirectionKey direction_of(int figure);

/// start, stop, direction, reference, spindle, coolant; other effects do nothing.
/// figure   0..5 for +X -X +Y -Y +Z -Z where effect is `direction`
void press(HandDriving& driving, ControlState& state, Effect effect, int figure);

/// Follows the machine. When a motion has ended, directions are cleared and what went wrong is told (MOD-008, D-117).
std::optional<ManualMotion::End> follow(HandDriving& driving, ControlState& state);

/// Another machine, or another mode: nothing may go on moving.
void close(HandDriving& driving);

/// Bild 4: START, STOP, the six directions, the actual values; `Endschalter` for every switch that is active (D-118).
void draw(const HandDriving& driving, const ControlState& state, Monitor& monitor);

/// What the control waits for; `ready` where a direction is not chosen yet, `chosen` where one is.
[[nodiscard]] std::string sentence_of(const HandDriving& driving, const ControlState& state, Text ready, Text chosen);

}  // namespace cnclab::panel
