// Which key has which effect where: KEY-090 as data. Key handling, the help rows and the tests all read this one table.
//
// A `Place` is finer than an operating mode: the same key does different things at the program prompt and in a word.
// What a place has no row for is ignored there (KEY conventions: no change, no message, no beep).
#pragma once

#include <cstdint>
#include <span>

#include "language/block_form.hpp"
#include "panel/mode.hpp"
#include "panel/screen/texts.hpp"
#include "shared/key.hpp"

namespace cnclab::panel {

enum class Place : std::uint8_t {
  menu,
  // HANDBETRIEB
  hand_ready,      ///< STOP state: directions are chosen
  hand_istwert,    ///< sub mode ISTWERT, no axis chosen yet
  hand_value,      ///< … the value of an axis is typed
  hand_moving,     ///< START state
  hand_reference,  ///< START state, to the reference points
  // HANDEINGABE
  input_function,  ///< the marker stands on G
  input_word,      ///< … on a word
  input_rest,      ///< stopped inside a block: its rest waits for START (KEY-024)
  input_running,   ///< START state
  input_waiting,   ///< START state, an M function waits for an input: START ends the waiting (KEY-013)
  // TEACH IN
  teach_program,  ///< program number prompt
  teach_ready,    ///< STOP state, no word chosen
  teach_word,     ///< STOP state, the marker stands on a word
  teach_moving,   ///< START state
  // EXTERNE DATEN
  external_device,    ///< a device is to be chosen
  external_polled,    ///< … while the line is polled under REMOTE: START releases a remote start (AUTH-013)
  external_write,     ///< program number prompt of an output
  external_read,      ///< … of an input: the machine data may be chosen along (KEY-066)
  external_transfer,  ///< under way (D-107): an output
  external_leader,    ///< … its cassette's leader still turns
  external_reading,   ///< … an input
  external_release,   ///< program and block of the remote start that is released
  // GRAFIK
  graphics_program,  ///< program number prompt
  graphics,          ///< the picture, playing or not
  // SPEICHER LÖSCHEN
  erase_program,  ///< program number prompt
  erase_all,      ///< C was pressed: → erases the whole memory
  // Service
  machine_data,
  memory_list,     ///< the numbers that the test would go through
  memory_running,  ///< until RESET (ERR-033)
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
  direction,
  istwert,
  spindle,
  coolant,
  reference,
  test_memory,
  reset,  ///< everywhere, apart from the table; listed where nothing else is left
};

/// A row of the table: in this place the keys from `first` to `last` have this effect.
struct KeyRow {
  Place place{};
  Key first{}, last{};
  Effect effect = Effect::ignored;
  Text help{};  ///< what the help rows say of it
  /// Only where the control has what it leads to: GRAFIK is a planned function, and the 3250 has neither it nor
  /// parameters (MODEL-003, MODEL-006); of the devices it lacks printer and punched tape (MODEL-004, MODEL-005).
  enum class Needs : std::uint8_t {
    nothing,
    planned_functions,
    parameters,
    all_devices,
    few_devices,
  } needs = Needs::nothing;
};

[[nodiscard]] std::span<const KeyRow> key_table();
/// Does a control of this vocabulary have the row?
[[nodiscard]] bool has_row(const KeyRow& row, const language::Vocabulary& vocabulary);

[[nodiscard]] Effect effect_of(Place place, Key key, const language::Vocabulary& vocabulary = {});

/// The mode that an opening effect leads to.
[[nodiscard]] constexpr bool is_opening(Effect effect) {
  return effect >= Effect::open_hand && effect <= Effect::open_menu;
}
[[nodiscard]] Mode mode_opened_by(Effect effect);  ///< effect: `is_opening`

/// Is the place one of a transfer of EXTERNE DATEN that is under way? (D-107)
[[nodiscard]] constexpr bool is_transfer(Place place) {
  return place == Place::external_transfer || place == Place::external_leader || place == Place::external_reading;
}

/// Is the place one of START state? (KEY-011)
[[nodiscard]] constexpr bool is_start_state(Place place) {
  return place == Place::hand_moving || place == Place::hand_reference || place == Place::input_running ||
         place == Place::input_waiting || place == Place::teach_moving || place == Place::automat_running ||
         place == Place::automat_waiting;
}

}  // namespace cnclab::panel
