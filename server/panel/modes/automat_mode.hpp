// AUTOMAT: a stored program runs (2.4, MOD-050 to MOD-064).
//
//   program prompt ──→──▶ start block prompt ──→──▶ ready ──START──▶ run ──┐
//                                                     ▲                    │ STOP, EINZELSATZ, M00: the rest waits
//                                                     └── end, error ──────┘
#pragma once

#include <optional>
#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct AutomatMode {
  enum class Phase : std::uint8_t { program, block, ready };

  Phase phase = Phase::program;
  DigitField program{4, {}, 0}, block{3, {}, 0};
  bool single_block = false;                ///< off on entering (D-16)
  bool has_ended = false;                   ///< the program came to its end: row 18 says so
  bool asks_zero = false;                   ///< START once more: the zero is right (DEC-27)
  bool is_rebuilt = false;                  ///< the run would begin in the middle (DEC-26) …
  std::optional<language::Error> no_state;  ///< … and what is damaged before it forbids that (STO-003)
  program::ModalState first_modal;          ///< with which the run would begin; shown before START (SCR-041)
  program::ProgramSet programs;             ///< which it would run, and whose blocks the window shows
  std::optional<language::Error> failure;   ///< START is refused until it is gone

  [[nodiscard]] std::uint16_t program_number() const { return static_cast<std::uint16_t>(program.value.value_or(0)); }
  [[nodiscard]] std::uint16_t block_number() const { return static_cast<std::uint16_t>(block.value.value_or(0)); }
};

/// As found after AUTOMAT in the menu: offers the program that ran last (MOD-050).
[[nodiscard]] AutomatMode open_automat(const ControlState& state);
/// MENU, or another machine: what still runs is abandoned; the modal state is that of the block really executed.
void close(AutomatMode& mode, ControlState& state);

[[nodiscard]] Place place_of(const AutomatMode& mode, const ControlState& state);
/// See modes.hpp: the second START must follow the first (DEC-27).
void disarm(AutomatMode& mode, Effect effect);
void press(AutomatMode& mode, ControlState& state, Effect effect, int figure);
/// Takes notice of what the machine did: ends, stops, errors.
void follow(AutomatMode& mode, ControlState& state);
void draw(const AutomatMode& mode, const ControlState& state, Monitor& monitor);
/// The first block on the screen whose check code did not fit when it was read, before the run (ERR-004).
[[nodiscard]] std::optional<geometry::SourceBlock> damaged_block(const AutomatMode& mode, const ControlState& state);
[[nodiscard]] std::string sentence_of(const AutomatMode& mode, const ControlState& state);

/// Confirms program and block and starts there, as keys would (EXT-060). False where no run has begun: the screen says
/// why.
[[nodiscard]] bool start_at(AutomatMode& mode, ControlState& state, geometry::SourceBlock place);
/// Would a START there ask first whether the zero is right (DEC-27)?
[[nodiscard]] bool would_ask_zero(const ControlState& state, geometry::SourceBlock place);
/// Program and block that a START would act on, or that run.
[[nodiscard]] geometry::SourceBlock current_block(const AutomatMode& mode, const ControlState& state);
/// Works out what a start at the acknowledged block begins with (DEC-26).
void prepare_start(AutomatMode& mode, const ControlState& state);

}  // namespace cnclab::panel
