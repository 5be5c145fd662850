// Which key has which effect where: KEY-090 as data. Key handling, the help rows and the tests all read this one table.
//
// A `Place` is finer than an operating mode: the same key does different things at the program prompt and in a word.
// What a place has no row for is ignored there (KEY conventions: no change, no message, no beep).
#pragma once

#include <cstdint>
#include <span>

#include "panel/mode.hpp"
#include "panel/texts.hpp"
#include "shared/key.hpp"

namespace cnclab::panel {

enum class Place : std::uint8_t {
  menu,
  // Modes in preparation
  hand,
  hand_input,
  teach_in,
  external_data,
  graphics,
  erase_memory,
  machine_data,
  memory_test,
  // EINGABEMODUS
  editor_program,   ///< program number prompt, and the overview
  editor_number,    ///< the marker stands on N
  editor_function,  ///< … on G or ↓
  editor_word,      ///< … on a word
  // AUTOMAT
  automat_program,  ///< program number prompt
  automat_block,    ///< start block prompt
  automat_ready,    ///< STOP state: not yet started, stopped, or between two single blocks
  automat_running,  ///< START state
  automat_waiting,  ///< START state, the program waits: programmed halt or an input (KEY-013)
};

inline constexpr int kPlaces = static_cast<int>(Place::automat_waiting) + 1;

enum class Effect : std::uint8_t {
  ignored,
  open_hand,
  open_hand_input,
  open_teach_in,
  open_automat,
  open_external_data,
  open_graphics,
  open_erase_memory,
  open_editor,
  open_menu,
  digit,
  point,
  sign,
  down,
  clear,
  enter,
  store,
  search,
  erase_block,
  start,
  stop,
  single_block,
};

/// A row of the table: in this place the keys from `first` to `last` have this effect.
struct KeyRow {
  Place place{};
  Key first{}, last{};
  Effect effect = Effect::ignored;
  Text help{};  ///< what the help rows say of it
};

[[nodiscard]] std::span<const KeyRow> key_table();

[[nodiscard]] Effect effect_of(Place place, Key key);

/// The mode that an opening effect leads to.
[[nodiscard]] constexpr bool is_opening(Effect effect) {
  return effect >= Effect::open_hand && effect <= Effect::open_menu;
}
[[nodiscard]] Mode mode_opened_by(Effect effect);  ///< effect: `is_opening`

/// Is the place one of START state? (KEY-011)
[[nodiscard]] constexpr bool is_start_state(Place place) {
  return place == Place::automat_running || place == Place::automat_waiting;
}

}  // namespace cnclab::panel
