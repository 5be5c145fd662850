// HANDBETRIEB: the axes are moved by keys (2.1), with the sub mode ISTWERT (2.1.1) and the run to the reference points
// (2.1.2).
//
//   directions chosen ──START──▶ moving ──STOP, limit switch──▶ directions cleared
//        │      └──REFERENZ──▶ to the switches, 1 mm back, Istwert 0; STOP leads to the menu (MOD-013)
//        └──ISTWERT──▶ axis by a direction key, value by figures ──ISTWERT──▶ back
#pragma once

#include <optional>
#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/run/hand_driving.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct HandMode {
  HandDriving driving;
  bool sets_istwert = false;        ///< sub mode ISTWERT
  std::optional<std::size_t> axis;  ///< whose counter is changed, 0..2
  WordEntry value;                  ///< the counter as typed so far
  bool is_referenced_now = false;   ///< the reference run has just ended well: row 18 says so
};

[[nodiscard]] HandMode open_hand(const ControlState& state);
void close(HandMode& mode, ControlState& state);

[[nodiscard]] Place place_of(const HandMode& mode);
/// figure   0..9 of a digit, 0..5 of a direction key (+X -X +Y -Y +Z -Z)
void press(HandMode& mode, ControlState& state, Effect effect, int figure);
void follow(HandMode& mode, ControlState& state);
void draw(const HandMode& mode, const ControlState& state, Monitor& monitor);
[[nodiscard]] std::string sentence_of(const HandMode& mode, const ControlState& state);

/// Begins to set the counter of that axis; its present value is what the first digit replaces.
void choose_axis(HandMode& mode, const ControlState& state, std::size_t axis);

}  // namespace cnclab::panel
