// The operating modes as one value: which is active, and what each adds to screens and keys.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "panel/modes/automat_mode.hpp"
#include "panel/modes/editor_mode.hpp"
#include "panel/modes/erase_memory_mode.hpp"
#include "panel/modes/external_data_mode.hpp"
#include "panel/modes/graphics_mode.hpp"
#include "panel/modes/hand_input_mode.hpp"
#include "panel/modes/hand_mode.hpp"
#include "panel/modes/machine_data_mode.hpp"
#include "panel/modes/memory_test_mode.hpp"
#include "panel/modes/menu_mode.hpp"
#include "panel/modes/teach_in_mode.hpp"

namespace cnclab::panel {

using ActiveMode = std::variant<MenuMode, HandMode, HandInputMode, TeachInMode, AutomatMode, EditorMode, GraphicsMode,
                                EraseMemoryMode, MachineDataMode, MemoryTestMode, ExternalDataMode>;

[[nodiscard]] ActiveMode open_mode(Mode mode, ControlState& state);
/// Called before another mode becomes active.
void close_mode(ActiveMode& mode, ControlState& state);

[[nodiscard]] Mode mode_of(const ActiveMode& mode);
[[nodiscard]] Place place_of(const ActiveMode& mode, const ControlState& state);
/// A key was pressed, whether it has an effect here or not: what waits to be confirmed by the next key is over, unless
/// this is the key that confirms it. Comes before `press`.
void disarm(ActiveMode& mode, Effect effect);
/// figure   0..9 of a digit, 0..5 of a direction key
void press(ActiveMode& mode, ControlState& state, Effect effect, int figure);
/// Takes notice of what the machine and the time did.
void follow(ActiveMode& mode, ControlState& state);
/// The request is on disk and in the memory.
void stored(ActiveMode& mode, ControlState& state, const StoreRequest& request);
/// Does the effect act on the line as it stands? Point and sign need a word in millimetres, ↓ one that takes a
/// parameter (KEY-065).
[[nodiscard]] bool acts(const ActiveMode& mode, Effect effect);
/// Is there any use in its key now? Programs of the ROM can be looked at only (DEC-06), and a block is loaded before it
/// is deleted; a device has to be connected.
[[nodiscard]] bool is_of_use(const ActiveMode& mode, const ControlState& state, Effect effect, Key key);
void draw(const ActiveMode& mode, const ControlState& state, Monitor& monitor);
/// The first block on the screen whose check code did not fit when it was read (ERR-004).
[[nodiscard]] std::optional<geometry::SourceBlock> damaged_block(const ActiveMode& mode, const ControlState& state);
[[nodiscard]] std::string sentence_of(const ActiveMode& mode, const ControlState& state);

}  // namespace cnclab::panel
