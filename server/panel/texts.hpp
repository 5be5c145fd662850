// Every text of the panel in both languages: one table, German as the original, English complete (DEC-02).
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "language/units.hpp"
#include "panel/mode.hpp"
#include "shared/key.hpp"

namespace cnclab::panel {

enum class Text : std::uint16_t {
  // The monitor
  program_number,
  in_preparation,
  limit_switch,
  not_stored,
  no_programs,
  program_erased,
  memory_erased,
  all_programs_hint,
  graphics_way,
  graphics_findings,
  datum_refused,
  ram_defective,
  datum_time,
  datum_date,
  datum_x_travel,
  datum_y_travel,
  datum_z_travel,
  datum_f_max,
  datum_s_max,
  datum_stop_deceleration,
  datum_start_stop,
  datum_creep,
  datum_ramp,
  datum_x_steps,
  datum_y_steps,
  datum_z_steps,
  datum_u_steps,
  datum_polarity,
  datum_baud,
  datum_beeper,
  menu_hand,
  menu_hand_input,
  menu_teach_in,
  menu_automat,
  menu_external_data,
  menu_graphics,
  menu_erase_memory,
  menu_editor,
  // The side column
  side_seat,
  side_training,
  side_machine,
  side_controller,
  side_nobody,
  side_unreferenced,
  side_override,
  side_start,
  side_single,
  side_spindle,
  side_coolant,
  side_limit,
  side_message,
  side_halt,
  // The bottom row
  all_keys,
  // What keys do: the help rows
  help_open_menu,
  help_digits,
  help_point,
  help_sign,
  help_clear,
  help_confirm,
  help_first_blocks,
  help_page,
  help_search,
  help_store,
  help_erase_block,
  help_parametric,
  help_parameter,
  help_next_word,
  help_words,
  help_start,
  help_stop,
  help_single,
  help_directions,
  help_move,
  help_drop_directions,
  help_reference,
  help_istwert,
  help_istwert_off,
  help_axis,
  help_spindle,
  help_coolant,
  help_stop_to_menu,
  help_execute,
  help_rest,
  help_erase_program,
  help_erase_choose_all,
  help_erase_all,
  help_view,
  help_zoom,
  help_pan,
  help_next_finding,
  help_play,
  help_next_datum,
  help_test_memory,
  help_destroy_memory,
  // Row 18: what the control waits for
  wait_menu,
  wait_coming,
  wait_editor_program,
  wait_editor_empty,
  wait_overview,
  wait_number,
  wait_function,
  wait_word,
  wait_store,
  wait_automat_program,
  wait_automat_block,
  wait_ready,
  wait_ready_rebuilt,
  wait_running,
  wait_stopping,
  wait_stopped,
  wait_single,
  wait_halt,
  wait_input,
  wait_ended,
  wait_hand,
  wait_chosen,
  wait_hand_moving,
  wait_axes_brake,
  wait_reference,
  wait_referenced,
  wait_off_switch,
  wait_istwert_axis,
  wait_istwert_value,
  wait_input_function,
  wait_input_word,
  wait_input_running,
  wait_input_waiting,
  wait_input_rest,
  wait_input_done,
  wait_teach_program,
  wait_teach_empty,
  wait_teach_filled,
  wait_erase,
  wait_erase_program,
  wait_erase_all,
  wait_erasing,
  wait_graphics_program,
  wait_graphics_ready,
  wait_graphics_single,
  wait_graphics_playing,
  wait_graphics_sound,
  wait_machine_data,
  wait_memory_list,
  wait_memory_confirm,
  wait_memory_running,
  // Row 18: what was wrong, what to do
  said_limit_switch,
  said_power_off,
  said_machine_halt,
  said_lease,
  said_start_refused,
  said_not_at_rest,
  said_no_machine,
  said_failed_before,
  said_not_stored,
  said_no_more_blocks,
  said_not_loaded,
  said_tool_number,
  said_overflow_n999,
  said_parameter_unfinished,
  said_code_missing,
  said_block_number,
  said_number_missing,
  said_connected,
  said_not_on_lab_machine,
  said_no_direction,
  said_towards_switch,
  said_switch_stuck,
  said_unreferenced,
  said_barred,
  said_number_for_teaching,
  said_program_full,
  said_nothing_to_erase,
  said_datum_refused,
  said_ram_defective,
  said_data_restored,
  hint_running,
  hint_waiting,
  hint_menu_first,
  hint_no_effect,
  hint_storing,
  hint_coming,
  hint_single_off,
  hint_moving,
  hint_rest,
  count_
};

inline constexpr std::size_t kTexts = static_cast<std::size_t>(Text::count_);

struct TextRow {
  Text id{};
  std::string_view german, english;
};

/// The whole table in the order of `Text`; for tests.
[[nodiscard]] const std::array<TextRow, kTexts>& text_table();

[[nodiscard]] std::string_view text(Text id, language::Tongue tongue);
/// The text with each "{}" replaced by the next value; surplus values are left out.
[[nodiscard]] std::string text(Text id, language::Tongue tongue, std::initializer_list<std::string_view> values);

/// The title on the monitor: "AUTOMAT", "EINGABEMODUS", …; empty for the menu.
[[nodiscard]] std::string_view title_of(Mode mode, language::Tongue tongue);

/// The label of the key on the original keyboard (D-08): "SPEICHER LÖSCHEN", "→", "C", "+/-".
[[nodiscard]] std::string_view label_of(Key key);

}  // namespace cnclab::panel
