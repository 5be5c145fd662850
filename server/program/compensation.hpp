// What execution must know of compensation, though only the stages behind it move the path (COMP, D-64, D-69, D-74).
#pragma once

#include "program/block_run.hpp"
#include "program/ways.hpp"

namespace cnclab::program {

/// Is any of G41 to G44, G46 in force (D-69)?
[[nodiscard]] bool is_compensating(const ModalState& modal);

/// The same, or something of an earlier compensation has yet to be left.
[[nodiscard]] bool is_path_compensated(const ExecutionState& state);

/// Neither the position may be renamed nor a switch be searched while path and programmed position differ (D-64).
/// errors: compensation_impossible while it is in force; offset_not_left behind G40, G45 until the axes are led back
[[nodiscard]] Outcome check_uncompensated(const BlockRun& run);

/// What an earlier run has left on the axes (D-75): the plane's two are led back together, unless G43, G44 move each.
void begin_compensated(ExecutionState& state, const std::array<double, 3>& compensation_mm);

/// Keeps account of the axes whose path may lie beside the programmed position after the way to `target`.
void follow_compensation(ExecutionState& state, const Target& target);

/// Takes radius or length of the tool in force (D-74) for the block at `source`; 0 where there is none (COMP-003).
/// errors  checksum_wrong: the tool's row is damaged; nothing changed
[[nodiscard]] Outcome take_radius(ModalState& modal, const ProgramSet& programs, geometry::SourceBlock source);
[[nodiscard]] Outcome take_length(ModalState& modal, const ProgramSet& programs, geometry::SourceBlock source);

/// Tells the stages what a run finds in force at its start.
/// errors: word_out_of_range for a negative radius
[[nodiscard]] Outcome announce_compensation(BlockRun& run);

}  // namespace cnclab::program
