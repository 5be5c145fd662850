// What the motion screens (Bild 2 to 5) have in common: START, STOP, actual values, active functions.
#pragma once

#include "panel/control_state.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

inline constexpr int kIstwertRow = 2;    ///< of X; Y and Z below
inline constexpr int kHighStartRow = 2;  ///< START in AUTOMAT, STOP below (Bild 5)
inline constexpr int kLowStartRow = 3;   ///< START in the modes of Bild 3 and 4
inline constexpr int kStateColumn = 7;   ///< of the two lines beside START and STOP

/// The fields START and STOP; the one that holds is inverse (SCR-026).
void draw_start_and_stop(bool is_started, int start_row, Monitor& monitor);
/// "X  +0085.000" and so on at the right (SCR-010, DEC-60).
void draw_istwerte(const machine::Snapshot& machine, Monitor& monitor);
/// Active functions beside START, inputs and outputs beside STOP (SCR-016, SCR-032).
void draw_state_lines(const program::ModalState& modal, const ControlState& state, int start_row, Monitor& monitor);

inline constexpr int kIstwertColumn = 51;

/// `Werkzeug Tnn einsetzen` on the last line while a run waits for it, and the sentence for row 18 (DEC-29).
void draw_tool_due(const Run& run, language::Tongue tongue, Monitor& monitor);
[[nodiscard]] std::string tool_sentence(int tool, language::Tongue tongue);

}  // namespace cnclab::panel
