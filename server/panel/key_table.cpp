// The rows of KEY-090 for what the control can do, place by place.
#include "panel/key_table.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cnclab::panel {

namespace {

constexpr KeyRow one(Place place, Key key, Effect effect, Text help) { return {place, key, key, effect, help}; }
constexpr KeyRow digits(Place place) { return {place, Key::D0, Key::D9, Effect::digit, Text::help_digits}; }
constexpr KeyRow menu(Place place) { return one(place, Key::MENU, Effect::open_menu, Text::help_open_menu); }

constexpr std::array kRows{
    one(Place::menu, Key::HAND, Effect::open_hand, Text::menu_hand),
    one(Place::menu, Key::HANDEINGABE, Effect::open_hand_input, Text::menu_hand_input),
    one(Place::menu, Key::TEACH_IN, Effect::open_teach_in, Text::menu_teach_in),
    one(Place::menu, Key::AUTOMAT, Effect::open_automat, Text::menu_automat),
    one(Place::menu, Key::EXTERNE_DATEN, Effect::open_external_data, Text::menu_external_data),
    one(Place::menu, Key::GRAFIK, Effect::open_graphics, Text::menu_graphics),
    one(Place::menu, Key::SPEICHER_LOESCHEN, Effect::open_erase_memory, Text::menu_erase_memory),
    one(Place::menu, Key::EINGABE, Effect::open_editor, Text::menu_editor),

    // The direct changes of MOD-014 and MOD-015 work although the modes themselves are in preparation.
    one(Place::hand, Key::HANDEINGABE, Effect::open_hand_input, Text::menu_hand_input),
    one(Place::hand, Key::TEACH_IN, Effect::open_teach_in, Text::menu_teach_in),
    menu(Place::hand),
    one(Place::hand_input, Key::HAND, Effect::open_hand, Text::menu_hand),
    menu(Place::hand_input),
    one(Place::teach_in, Key::HAND, Effect::open_hand, Text::menu_hand),
    menu(Place::teach_in),
    menu(Place::external_data),
    menu(Place::graphics),
    menu(Place::erase_memory),
    menu(Place::machine_data),
    menu(Place::memory_test),

    digits(Place::editor_program),
    one(Place::editor_program, Key::CLEAR, Effect::clear, Text::help_clear),
    one(Place::editor_program, Key::ENTER, Effect::enter, Text::help_confirm),
    one(Place::editor_program, Key::DOWN, Effect::down, Text::help_first_blocks),
    menu(Place::editor_program),

    digits(Place::editor_number),
    one(Place::editor_number, Key::CLEAR, Effect::clear, Text::help_clear),
    one(Place::editor_number, Key::ENTER, Effect::enter, Text::help_confirm),
    one(Place::editor_number, Key::DOWN, Effect::down, Text::help_page),
    one(Place::editor_number, Key::SATZ_SUCHEN, Effect::search, Text::help_search),
    one(Place::editor_number, Key::EINGABE, Effect::store, Text::help_store),
    one(Place::editor_number, Key::SATZ_LOESCHEN, Effect::erase_block, Text::help_erase_block),
    menu(Place::editor_number),

    digits(Place::editor_function),
    one(Place::editor_function, Key::CLEAR, Effect::clear, Text::help_clear),
    one(Place::editor_function, Key::ENTER, Effect::enter, Text::help_words),
    one(Place::editor_function, Key::DOWN, Effect::down, Text::help_parametric),
    one(Place::editor_function, Key::EINGABE, Effect::store, Text::help_store),
    one(Place::editor_function, Key::SATZ_SUCHEN, Effect::search, Text::help_search),
    one(Place::editor_function, Key::SATZ_LOESCHEN, Effect::erase_block, Text::help_erase_block),
    menu(Place::editor_function),

    digits(Place::editor_word),
    one(Place::editor_word, Key::POINT, Effect::point, Text::help_point),
    one(Place::editor_word, Key::SIGN, Effect::sign, Text::help_sign),
    one(Place::editor_word, Key::CLEAR, Effect::clear, Text::help_clear),
    one(Place::editor_word, Key::ENTER, Effect::enter, Text::help_next_word),
    one(Place::editor_word, Key::DOWN, Effect::down, Text::help_parameter),
    one(Place::editor_word, Key::EINGABE, Effect::store, Text::help_store),
    one(Place::editor_word, Key::SATZ_SUCHEN, Effect::search, Text::help_search),
    one(Place::editor_word, Key::SATZ_LOESCHEN, Effect::erase_block, Text::help_erase_block),
    menu(Place::editor_word),

    digits(Place::automat_program),
    one(Place::automat_program, Key::CLEAR, Effect::clear, Text::help_clear),
    one(Place::automat_program, Key::ENTER, Effect::enter, Text::help_confirm),
    one(Place::automat_program, Key::EINZELSATZ, Effect::single_block, Text::help_single),
    menu(Place::automat_program),

    digits(Place::automat_block),
    one(Place::automat_block, Key::CLEAR, Effect::clear, Text::help_clear),
    one(Place::automat_block, Key::ENTER, Effect::enter, Text::help_confirm),
    one(Place::automat_block, Key::EINZELSATZ, Effect::single_block, Text::help_single),
    menu(Place::automat_block),

    one(Place::automat_ready, Key::START, Effect::start, Text::help_start),
    one(Place::automat_ready, Key::EINZELSATZ, Effect::single_block, Text::help_single),
    menu(Place::automat_ready),

    one(Place::automat_running, Key::STOP, Effect::stop, Text::help_stop),
    one(Place::automat_running, Key::EINZELSATZ, Effect::single_block, Text::help_single),

    one(Place::automat_waiting, Key::START, Effect::start, Text::help_start),
    one(Place::automat_waiting, Key::STOP, Effect::stop, Text::help_stop),
    one(Place::automat_waiting, Key::EINZELSATZ, Effect::single_block, Text::help_single),
};

}  // namespace

std::span<const KeyRow> key_table() { return kRows; }

Effect effect_of(Place place, Key key) {
  const auto row = std::ranges::find_if(kRows, [=](const KeyRow& candidate) {
    return candidate.place == place && candidate.first <= key && key <= candidate.last;
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
