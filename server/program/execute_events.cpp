// Blocks that neither move nor change a modal group: G04, G11, G68.
#include "program/words.hpp"

namespace cnclab::program {

Outcome dwell(BlockRun& run) {
  const std::int64_t tenths = value_of(run.block, language::Address::H, 0);
  // G04 is skipped in a test run (G-041); a parameter of 0 is no dwell (DEC-53).
  if (!run.state.modal.test_run && tenths > 0) run.emit(geometry::Dwell{.seconds = static_cast<double>(tenths) / 10});
  return {};
}

/// G11 carries F, S, T and M only (G-110); they are executed with those of all other blocks.
Outcome only_words(BlockRun&) { return {}; }

Outcome set_actual(BlockRun& run) {
  constexpr std::array kAxes{language::Address::X, language::Address::Y, language::Address::Z};
  const ModalState& modal = run.state.modal;
  if (modal.radius != RadiusCompensation::off || modal.length_compensation)  // D-64
    return error_at(language::ErrorCode::compensation_impossible, run.source, 'G', "G68");
  geometry::SetActual event;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const language::Word* word = run.block.find(kAxes[axis]);
    if (word == nullptr) continue;
    const std::int64_t value_nm = word->number * 1000;
    // The path does not jump: what the operator calls it changes, the offset takes up the difference (G-680).
    run.state.offset_nm[axis] += run.state.programmed_nm[axis] - value_nm;
    run.state.programmed_nm[axis] = value_nm;
    event.axes[axis] = true;
    event.value[axis] = static_cast<double>(word->number) / 1000;
  }
  run.emit(event);
  return {};
}

}  // namespace cnclab::program
