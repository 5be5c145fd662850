// TEACH IN: the axes are moved by hand, the way or the place becomes the words of a G01 block (2.3, MOD-035 to
// MOD-043).
//
//   program prompt ──→──▶ line ──START … STOP──▶ X Y Z filled ──EINGABE──▶ stored, next number
//                          └──→──▶ words, to add F S T M
//
// Under G91 the words are the way since the last stored position, under G90 the place itself (D-38). The way is what
// the axes have done: a counter that is set anew in between is none.
#pragma once

#include <cstdint>
#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/run/hand_driving.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct TeachInMode {
  bool is_open = false;  ///< the program number was acknowledged; it stays until MENU
  DigitField program{4, {}, 0};
  EntryLine line{1, 1, 1};
  HandDriving driving;
  MachinePlace reference;  ///< last stored position; at first that on entering

  [[nodiscard]] std::uint16_t number() const { return static_cast<std::uint16_t>(program.value.value_or(0)); }
};

/// Offers the lowest free program number from P0001 (D-35).
[[nodiscard]] TeachInMode open_teach_in(const ControlState& state);
void close(TeachInMode& mode, ControlState& state);

[[nodiscard]] Place place_of(const TeachInMode& mode);
void press(TeachInMode& mode, ControlState& state, Effect effect, int figure);
void follow(TeachInMode& mode, ControlState& state);
void draw(const TeachInMode& mode, const ControlState& state, Monitor& monitor);
[[nodiscard]] std::string sentence_of(const TeachInMode& mode, const ControlState& state);
/// The block is on disk: its position is the next one's reference (MOD-039).
void stored(TeachInMode& mode, ControlState& state, const StoreRequest& request);

}  // namespace cnclab::panel
