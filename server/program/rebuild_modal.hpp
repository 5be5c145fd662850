// The modal state for a start in the middle of a program (DEC-26).
#pragma once

#include <expected>

#include "language/block.hpp"
#include "language/block_form.hpp"
#include "language/error.hpp"
#include "program/modal_state.hpp"
#include "program/program_source.hpp"

namespace cnclab::program {

/// The state that the blocks before `start_block` would leave: read in number order, their G groups, F, S, T and
/// M20..M24 are taken over `modal`. Jumps, calls, waits, halts, motion and outputs are skipped, spindle and coolant
/// stay as they are (of a cycle only G91 and G45 are taken, which it ends with), words that name a parameter are left
/// out (parameters stay untouched). Compensation takes the data of its tool from P0000 among `programs` (D-74).
///
/// errors  checksum_wrong: a block before the start, or the row of a tool that is compensated there, is damaged. What
/// it
///         would leave in force is not known, so nothing may start behind it (STO-003).
[[nodiscard]] std::expected<ModalState, language::Error> rebuild_modal(const ProgramSet& programs,
                                                                       const language::Program& program,
                                                                       std::uint16_t start_block, ModalState modal);

/// The state without what this control has no function for (a kept state of the other model, MODEL-007 to MODEL-010):
/// each group stands as after switching on, since nothing could switch it off.
[[nodiscard]] ModalState within(ModalState modal, const language::Vocabulary& vocabulary);

}  // namespace cnclab::program
