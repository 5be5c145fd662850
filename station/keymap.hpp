// Which key of a plain keyboard presses which key of the control: the one table for code, help page and documentation.
//
// Every key of the control has a plain key that any terminal transmits; function keys are a second way only. No Alt
// combinations: a terminal sends them as Escape and a letter. Keys that are pressed together on the control have a key
// of their own here, because a terminal reports no release.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "shared/key.hpp"
#include "station/language.hpp"

namespace cnclab::station {

/// Keys that are no characters; named as they are on the keyboard.
enum class Special : std::uint8_t {
  enter,
  tab,
  backspace,
  escape,
  up,
  down,
  left,
  right,
  page_up,
  page_down,
  home,
  end,
  insert,
  remove,
  f1,
  f2,
  f3,
  f4,
  f5,
  f6,
  f7,
  f8,
  f9,
  f10,
  f11,
  f12,
  ctrl_c,
  ctrl_l,
};

/// What the terminal reports: a character (space included) or a special key.
using Input = std::variant<char32_t, Special>;

/// Keys going down together, held for `hold` before they go up.
struct Press {
  std::vector<Key> keys;
  std::chrono::milliseconds hold{0};
};
struct TurnPotentiometer {
  int percent;  ///< −100..100, added
};
enum class Local : std::uint8_t { help, log_out, redraw };
using Action = std::variant<Press, TurnPotentiometer, Local>;

/// The block of the keyboard (KEY-001) that a binding belongs to.
enum class KeyGroup : std::uint8_t { hand, mode, data, lab };

struct Binding {
  KeyGroup group;
  Action action;
  std::vector<Input> inputs;  ///< the first one is shown on the key cap; at least one is plain
  Text label;                 ///< as on the control, at most 20 columns
  Text cap;                   ///< for the key cap, at most 8 columns; empty: not drawn on the keyboard
};

[[nodiscard]] std::span<const Binding> keymap();
/// Nothing where the key means nothing here.
[[nodiscard]] const Binding* binding_of(const Input& input);
/// Presses STOP or MASCHINE HALT alone: acts whatever is on the screen, and is never dropped (AUTH-006).
[[nodiscard]] bool is_stop(const Press& press);
[[nodiscard]] bool is_stop(const Binding& binding);
[[nodiscard]] bool is_stop(const Input& input);
/// "Leertaste", "Bild↑", "F9", "x".
[[nodiscard]] std::string input_name(const Input& input, Language language);
/// Any keyboard and terminal has it: printable ASCII, Enter, Tab, Backspace.
[[nodiscard]] bool is_plain(const Input& input);

}  // namespace cnclab::station
