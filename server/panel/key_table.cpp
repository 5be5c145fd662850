// The rows of KEY-090, place by place.
#include "panel/key_table.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cnclab::panel {

namespace {

constexpr KeyRow one(Place place, Key key, Effect effect, Text help) { return {place, key, key, effect, help}; }
constexpr KeyRow needing(KeyRow::Needs needs, KeyRow row) {
  row.needs = needs;
  return row;
}
constexpr KeyRow digits(Place place) { return {place, Key::D0, Key::D9, Effect::digit, Text::help_digits}; }
constexpr KeyRow menu(Place place) { return one(place, Key::MENU, Effect::open_menu, Text::help_open_menu); }
constexpr KeyRow point(Place place) { return one(place, Key::POINT, Effect::point, Text::help_point); }
constexpr KeyRow sign(Place place) { return one(place, Key::SIGN, Effect::sign, Text::help_sign); }
constexpr KeyRow clear(Place place) { return one(place, Key::CLEAR, Effect::clear, Text::help_clear); }
constexpr KeyRow enter(Place place, Text help) { return one(place, Key::ENTER, Effect::enter, help); }
constexpr KeyRow start(Place place, Text help) { return one(place, Key::START, Effect::start, help); }
constexpr KeyRow stop(Place place, Text help) { return one(place, Key::STOP, Effect::stop, help); }
constexpr KeyRow hand(Place place) { return one(place, Key::HAND, Effect::open_hand, Text::menu_hand); }
constexpr KeyRow directions(Place place, Text help) {
  return {place, Key::PLUS_X, Key::MINUS_Z, Effect::direction, help};
}
constexpr KeyRow spindle(Place place) { return one(place, Key::FRAESER, Effect::spindle, Text::help_spindle); }
constexpr KeyRow coolant(Place place) { return one(place, Key::KUEHLMITTEL, Effect::coolant, Text::help_coolant); }
constexpr KeyRow hand_input(Place place) {
  return one(place, Key::HANDEINGABE, Effect::open_hand_input, Text::menu_hand_input);
}
constexpr KeyRow teach_in(Place place) { return one(place, Key::TEACH_IN, Effect::open_teach_in, Text::menu_teach_in); }
constexpr KeyRow devices(Place place, Key first, Key last, KeyRow::Needs needs) {
  return needing(needs, {place, first, last, Effect::digit, Text::help_device});
}
constexpr KeyRow istwert(Place place, Text help) { return one(place, Key::ISTWERT, Effect::istwert, help); }

constexpr std::array kRows{
    hand(Place::menu),
    hand_input(Place::menu),
    teach_in(Place::menu),
    one(Place::menu, Key::AUTOMAT, Effect::open_automat, Text::menu_automat),
    one(Place::menu, Key::EXTERNE_DATEN, Effect::open_external_data, Text::menu_external_data),
    needing(KeyRow::Needs::planned_functions,
            one(Place::menu, Key::GRAFIK, Effect::open_graphics, Text::menu_graphics)),
    one(Place::menu, Key::SPEICHER_LOESCHEN, Effect::open_erase_memory, Text::menu_erase_memory),
    one(Place::menu, Key::EINGABE, Effect::open_editor, Text::menu_editor),

    directions(Place::hand_ready, Text::help_directions),
    start(Place::hand_ready, Text::help_move),
    stop(Place::hand_ready, Text::help_drop_directions),
    one(Place::hand_ready, Key::REFERENZ, Effect::reference, Text::help_reference),
    istwert(Place::hand_ready, Text::help_istwert),
    spindle(Place::hand_ready),
    coolant(Place::hand_ready),
    hand_input(Place::hand_ready),
    teach_in(Place::hand_ready),
    menu(Place::hand_ready),

    directions(Place::hand_istwert, Text::help_axis),
    istwert(Place::hand_istwert, Text::help_istwert_off),
    spindle(Place::hand_istwert),
    coolant(Place::hand_istwert),
    hand_input(Place::hand_istwert),
    teach_in(Place::hand_istwert),
    menu(Place::hand_istwert),

    digits(Place::hand_value),
    point(Place::hand_value),
    sign(Place::hand_value),
    clear(Place::hand_value),
    directions(Place::hand_value, Text::help_axis),
    istwert(Place::hand_value, Text::help_istwert_off),
    spindle(Place::hand_value),
    coolant(Place::hand_value),
    hand_input(Place::hand_value),
    teach_in(Place::hand_value),
    menu(Place::hand_value),

    stop(Place::hand_moving, Text::help_stop),
    stop(Place::hand_reference, Text::help_stop_to_menu),

    digits(Place::input_function),
    enter(Place::input_function, Text::help_words),
    clear(Place::input_function),
    start(Place::input_function, Text::help_execute),
    hand(Place::input_function),
    menu(Place::input_function),

    digits(Place::input_word),
    point(Place::input_word),
    sign(Place::input_word),
    clear(Place::input_word),
    enter(Place::input_word, Text::help_next_word),
    start(Place::input_word, Text::help_execute),
    hand(Place::input_word),
    menu(Place::input_word),

    start(Place::input_rest, Text::help_rest),
    hand(Place::input_rest),
    menu(Place::input_rest),

    stop(Place::input_running, Text::help_stop),
    start(Place::input_waiting, Text::help_start),
    stop(Place::input_waiting, Text::help_stop),

    digits(Place::teach_program),
    clear(Place::teach_program),
    enter(Place::teach_program, Text::help_confirm),
    hand(Place::teach_program),
    menu(Place::teach_program),

    directions(Place::teach_ready, Text::help_directions),
    start(Place::teach_ready, Text::help_move),
    stop(Place::teach_ready, Text::help_drop_directions),
    enter(Place::teach_ready, Text::help_words),
    one(Place::teach_ready, Key::EINGABE, Effect::store, Text::help_store),
    spindle(Place::teach_ready),
    coolant(Place::teach_ready),
    hand(Place::teach_ready),
    menu(Place::teach_ready),

    digits(Place::teach_word),
    point(Place::teach_word),
    sign(Place::teach_word),
    clear(Place::teach_word),
    enter(Place::teach_word, Text::help_next_word),
    directions(Place::teach_word, Text::help_directions),
    start(Place::teach_word, Text::help_move),
    stop(Place::teach_word, Text::help_drop_directions),
    one(Place::teach_word, Key::EINGABE, Effect::store, Text::help_store),
    spindle(Place::teach_word),
    coolant(Place::teach_word),
    hand(Place::teach_word),
    menu(Place::teach_word),

    stop(Place::teach_moving, Text::help_stop),

    devices(Place::external_device, Key::D1, Key::D9, KeyRow::Needs::all_devices),
    devices(Place::external_device, Key::D2, Key::D2, KeyRow::Needs::few_devices),
    devices(Place::external_device, Key::D4, Key::D6, KeyRow::Needs::few_devices),
    devices(Place::external_device, Key::D8, Key::D9, KeyRow::Needs::few_devices),
    menu(Place::external_device),

    devices(Place::external_polled, Key::D1, Key::D9, KeyRow::Needs::all_devices),
    devices(Place::external_polled, Key::D2, Key::D2, KeyRow::Needs::few_devices),
    devices(Place::external_polled, Key::D4, Key::D6, KeyRow::Needs::few_devices),
    devices(Place::external_polled, Key::D8, Key::D9, KeyRow::Needs::few_devices),
    start(Place::external_polled, Text::help_release),
    menu(Place::external_polled),

    digits(Place::external_write),
    one(Place::external_write, Key::CLEAR, Effect::clear, Text::help_choose_all),
    enter(Place::external_write, Text::help_transfer),
    menu(Place::external_write),

    digits(Place::external_read),
    one(Place::external_read, Key::CLEAR, Effect::clear, Text::help_choose_all),
    one(Place::external_read, Key::SIGN, Effect::sign, Text::help_adopt),
    enter(Place::external_read, Text::help_transfer),
    menu(Place::external_read),

    stop(Place::external_transfer, Text::help_abort),

    stop(Place::external_leader, Text::help_abort),
    enter(Place::external_leader, Text::help_leader),

    stop(Place::external_reading, Text::help_abort),
    one(Place::external_reading, Key::SIGN, Effect::sign, Text::help_adopt),

    digits(Place::external_release),
    clear(Place::external_release),
    enter(Place::external_release, Text::help_other_number),
    start(Place::external_release, Text::help_release),
    stop(Place::external_release, Text::help_withdraw),
    menu(Place::external_release),

    digits(Place::graphics_program),
    clear(Place::graphics_program),
    enter(Place::graphics_program, Text::help_confirm),
    menu(Place::graphics_program),

    start(Place::graphics, Text::help_play),
    stop(Place::graphics, Text::help_stop),
    one(Place::graphics, Key::EINZELSATZ, Effect::single_block, Text::help_single),
    KeyRow{Place::graphics, Key::D1, Key::D4, Effect::digit, Text::help_view},
    KeyRow{Place::graphics, Key::D5, Key::D6, Effect::digit, Text::help_zoom},
    directions(Place::graphics, Text::help_pan),
    one(Place::graphics, Key::DOWN, Effect::down, Text::help_next_finding),
    menu(Place::graphics),

    digits(Place::erase_program),
    enter(Place::erase_program, Text::help_erase_program),
    one(Place::erase_program, Key::CLEAR, Effect::clear, Text::help_erase_choose_all),
    menu(Place::erase_program),

    enter(Place::erase_all, Text::help_erase_all),
    digits(Place::erase_all),
    clear(Place::erase_all),
    menu(Place::erase_all),

    digits(Place::machine_data),
    clear(Place::machine_data),
    enter(Place::machine_data, Text::help_next_datum),
    one(Place::machine_data, Key::EINGABE, Effect::enter, Text::help_next_datum),
    menu(Place::machine_data),

    one(Place::memory_list, Key::SPEICHER_LOESCHEN, Effect::test_memory, Text::help_test_memory),
    menu(Place::memory_list),
    one(Place::memory_running, Key::RESET, Effect::reset, Text::help_end_test),

    digits(Place::editor_program),
    clear(Place::editor_program),
    enter(Place::editor_program, Text::help_confirm),
    one(Place::editor_program, Key::DOWN, Effect::down, Text::help_first_blocks),
    menu(Place::editor_program),

    digits(Place::editor_number),
    clear(Place::editor_number),
    enter(Place::editor_number, Text::help_confirm),
    one(Place::editor_number, Key::DOWN, Effect::down, Text::help_page),
    one(Place::editor_number, Key::SATZ_SUCHEN, Effect::search, Text::help_search),
    one(Place::editor_number, Key::EINGABE, Effect::store, Text::help_store),
    one(Place::editor_number, Key::SATZ_LOESCHEN, Effect::erase_block, Text::help_erase_block),
    menu(Place::editor_number),

    digits(Place::editor_function),
    clear(Place::editor_function),
    enter(Place::editor_function, Text::help_words),
    needing(KeyRow::Needs::parameters, one(Place::editor_function, Key::DOWN, Effect::down, Text::help_parametric)),
    one(Place::editor_function, Key::EINGABE, Effect::store, Text::help_store),
    one(Place::editor_function, Key::SATZ_SUCHEN, Effect::search, Text::help_search),
    one(Place::editor_function, Key::SATZ_LOESCHEN, Effect::erase_block, Text::help_erase_block),
    menu(Place::editor_function),

    digits(Place::editor_word),
    point(Place::editor_word),
    sign(Place::editor_word),
    clear(Place::editor_word),
    enter(Place::editor_word, Text::help_next_word),
    needing(KeyRow::Needs::parameters, one(Place::editor_word, Key::DOWN, Effect::down, Text::help_parameter)),
    one(Place::editor_word, Key::EINGABE, Effect::store, Text::help_store),
    one(Place::editor_word, Key::SATZ_SUCHEN, Effect::search, Text::help_search),
    one(Place::editor_word, Key::SATZ_LOESCHEN, Effect::erase_block, Text::help_erase_block),
    menu(Place::editor_word),

    digits(Place::automat_program),
    clear(Place::automat_program),
    enter(Place::automat_program, Text::help_confirm),
    one(Place::automat_program, Key::EINZELSATZ, Effect::single_block, Text::help_single),
    menu(Place::automat_program),

    digits(Place::automat_block),
    clear(Place::automat_block),
    enter(Place::automat_block, Text::help_confirm),
    one(Place::automat_block, Key::EINZELSATZ, Effect::single_block, Text::help_single),
    menu(Place::automat_block),

    start(Place::automat_ready, Text::help_start),
    one(Place::automat_ready, Key::EINZELSATZ, Effect::single_block, Text::help_single),
    menu(Place::automat_ready),

    stop(Place::automat_running, Text::help_stop),
    one(Place::automat_running, Key::EINZELSATZ, Effect::single_block, Text::help_single),

    start(Place::automat_waiting, Text::help_start),
    stop(Place::automat_waiting, Text::help_stop),
    one(Place::automat_waiting, Key::EINZELSATZ, Effect::single_block, Text::help_single),
};

}  // namespace

std::span<const KeyRow> key_table() { return kRows; }

bool has_row(const KeyRow& row, const language::Vocabulary& vocabulary) {
  const bool is_3300 = vocabulary.model == language::Model::cnc3300;
  switch (row.needs) {
    case KeyRow::Needs::nothing:
      return true;
    case KeyRow::Needs::planned_functions:
      return is_3300 && vocabulary.planned_functions;
    case KeyRow::Needs::parameters:
    case KeyRow::Needs::all_devices:
      return is_3300;
    case KeyRow::Needs::few_devices:
      return !is_3300;
  }
  return true;
}

Effect effect_of(Place place, Key key, const language::Vocabulary& vocabulary) {
  const auto row = std::ranges::find_if(kRows, [=](const KeyRow& candidate) {
    return candidate.place == place && candidate.first <= key && key <= candidate.last &&
           has_row(candidate, vocabulary);
  });
  return row == kRows.end() ? Effect::ignored : row->effect;
}

Mode mode_opened_by(Effect effect) {
  constexpr std::array kOpened{
      std::pair{Effect::open_hand, Mode::hand},
      std::pair{Effect::open_hand_input, Mode::hand_input},
      std::pair{Effect::open_teach_in, Mode::teach_in},
      std::pair{Effect::open_automat, Mode::automat},
      std::pair{Effect::open_external_data, Mode::external_data},
      std::pair{Effect::open_graphics, Mode::graphics},
      std::pair{Effect::open_erase_memory, Mode::erase_memory},
      std::pair{Effect::open_editor, Mode::editor},
  };
  const auto found = std::ranges::find(kOpened, effect, &std::pair<Effect, Mode>::first);
  return found == kOpened.end() ? Mode::menu : found->second;
}

}  // namespace cnclab::panel
