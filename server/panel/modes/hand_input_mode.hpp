// HANDEINGABE: one G function at a time, keyed in and executed by START (2.2, MOD-020 to MOD-029).
//
//   G ──→──▶ words ──→ … ──▶ G again      START executes, the line stays: START repeats it
//   executing ──STOP──▶ the rest waits ──START──▶ executing, or MENU abandons it (KEY-024, KEY-043)
#pragma once

#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct HandInputMode {
  EntryLine line{1, 1, 1};
  language::Plane plane = language::Plane::xy;  ///< whose words the line shows
  bool is_done = false;                         ///< the line was executed: row 18 says so
};

/// Proposes G01 with empty words (SCR-033).
[[nodiscard]] HandInputMode open_hand_input(const ControlState& state);
/// MENU, HAND or another machine: a rest is abandoned.
void close(HandInputMode& mode, ControlState& state);

[[nodiscard]] Place place_of(const HandInputMode& mode, const ControlState& state);
void press(HandInputMode& mode, ControlState& state, Effect effect, int figure);
void follow(HandInputMode& mode, ControlState& state);
void draw(const HandInputMode& mode, const ControlState& state, Monitor& monitor);
[[nodiscard]] std::string sentence_of(const HandInputMode& mode, const ControlState& state);

/// START: executes the line, or complains with the marker on the word to blame.
void execute_line(HandInputMode& mode, ControlState& state);
/// The marker goes to the word to blame, else to the function, where the next digit begins another one. The line has no
/// place in a program that could be named; a damaged row of P0000 has.
void complain_of_line(HandInputMode& mode, ControlState& state, language::Error error);
/// Shows the words of the function as it stands there; false after a complaint.
[[nodiscard]] bool show_words(HandInputMode& mode, ControlState& state);

}  // namespace cnclab::panel
