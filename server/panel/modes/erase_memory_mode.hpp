// SPEICHER LÖSCHEN: single programs, or the whole memory (2.7, MOD-075 to MOD-079, D-43, DEC-59).
//
//   prompt ──digits, →──▶ that program is erased, a line tells it, a new prompt
//     └──C──▶ → erases everything: all programs, machine data from ROM, modal state as after switching on
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct EraseMemoryMode {
  DigitField program{4, {}, 0};
  bool takes_all = false;  ///< C was the last key: → means the whole memory
  /// What was erased since the mode was opened, oldest first; nothing stands for the whole memory.
  std::vector<std::optional<std::uint16_t>> erased;
};

[[nodiscard]] Place place_of(const EraseMemoryMode& mode);
/// See modes.hpp: C must come directly before → (DEC-59).
void disarm(EraseMemoryMode& mode, Effect effect);
void press(EraseMemoryMode& mode, ControlState& state, Effect effect, int figure);
void draw(const EraseMemoryMode& mode, const ControlState& state, Monitor& monitor);
[[nodiscard]] std::string sentence_of(const EraseMemoryMode& mode, const ControlState& state);
void stored(EraseMemoryMode& mode, ControlState& state, const StoreRequest& request);

}  // namespace cnclab::panel
