// Machine data: one datum after the other, 01 to 22 and round again (chapter 5, MD-001 to MD-005, D-112, D-113).
//
//   NR nn  format text  value ──→ or EINGABE──▶ taken over where something was typed, next datum
#pragma once

#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct MachineDataMode {
  int number = 1;  ///< of the datum shown: 01 time, 02 date, or one of machine::datum_forms
  DigitField value{6, {}, 0};
  bool awaits_clock = false;  ///< just come back, before the control knows the time: MD 01, 02 are shown with the beat
};

[[nodiscard]] MachineDataMode open_machine_data(const ControlState& state);
[[nodiscard]] Place place_of(const MachineDataMode& mode);
void press(MachineDataMode& mode, ControlState& state, Effect effect, int figure);
void follow(MachineDataMode& mode, ControlState& state);
void draw(const MachineDataMode& mode, const ControlState& state, Monitor& monitor);
[[nodiscard]] std::string sentence_of(const MachineDataMode& mode, const ControlState& state);
void stored(MachineDataMode& mode, ControlState& state, const StoreRequest& request);

/// Shows the datum and its present value, which the first digit replaces.
void show_datum(MachineDataMode& mode, const ControlState& state, int number);

/// Is there such a datum?
[[nodiscard]] bool has_datum(int number);

/// The list that the printer gives: "06  F MAX                     3000 mm/min", one datum per line.
[[nodiscard]] std::string machine_data_list(const machine::MachineData& data, language::Tongue tongue);

}  // namespace cnclab::panel
