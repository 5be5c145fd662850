// EINGABEMODUS: programs are entered and changed block by block (2.6, EDIT).
//
//   program prompt ──→/↓──▶ entry line: number ──→──▶ function ──→──▶ words ──EINGABE──▶ stored, next number
//        │ C, then →/↓                  ▲                                                    │
//        └──▶ overview                  └────────────────────────────────────────────────────┘
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct EditorMode {
  DigitField program{4, {}, 0};
  std::optional<std::size_t> overview;  ///< index of the first program listed
  bool is_open = false;                 ///< the program number was acknowledged; it stays until MENU (EDIT-021)
  EntryLine line{1, 1, 0};
  language::Plane plane = language::Plane::xy;  ///< whose words the line shows (D-54)
  std::optional<std::uint16_t> list_from;       ///< number of the first block listed
  std::uint8_t proposed_g = 0;                  ///< D-44

  [[nodiscard]] std::uint16_t number() const { return static_cast<std::uint16_t>(program.value.value_or(0)); }
};

/// As found after EINGABE in the menu: offers the program last worked on.
[[nodiscard]] EditorMode open_editor(const ControlState& state);

[[nodiscard]] Place place_of(const EditorMode& mode);
/// figure   0..9 where effect is `digit`
void press(EditorMode& mode, ControlState& state, Effect effect, int figure);
void draw(const EditorMode& mode, const ControlState& state, Monitor& monitor);
/// The first block on the screen whose check code did not fit when it was read (ERR-004).
[[nodiscard]] std::optional<geometry::SourceBlock> damaged_block(const EditorMode& mode, const ControlState& state);
[[nodiscard]] std::string sentence_of(const EditorMode& mode, const ControlState& state);
/// The request is on disk and in the memory: the next number is offered (EDIT-013).
void stored(EditorMode& mode, ControlState& state, const StoreRequest& request);

// Parts of the mode, each in its own file.

/// EINGABE: checks the line and asks for it to be stored, or complains with the marker on the faulty word.
void store_line(EditorMode& mode, ControlState& state);
/// SATZ LÖSCHEN.
void erase_loaded_block(EditorMode& mode, ControlState& state);
/// Checks the function field and shows its words; false after a complaint.
[[nodiscard]] bool show_words(EditorMode& mode, ControlState& state);
/// Is the number in the line one that a block can have? Complains where not.
[[nodiscard]] bool check_number(EditorMode& mode, ControlState& state);

/// The program as it can be looked at: from the memory, or one of the cycles' from the ROM, which nobody can change
/// (DEC-06); nullptr where there is none.
[[nodiscard]] const language::Program* program_in(const ControlState& state, std::uint16_t number);

/// The plane that holds for a block: the last G17, G18, G19 before it in its program, else `fallback` (D-54).
[[nodiscard]] language::Plane plane_before(const language::Program* program, int block, language::Plane fallback);

inline constexpr int kListedBlocks = 10;                                 ///< EDIT-004
inline constexpr std::size_t kProgramsPerLine = 8, kOverviewLines = 10;  ///< D-32

}  // namespace cnclab::panel
