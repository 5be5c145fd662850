// Blocks that neither move along the path nor change a modal group: G04, G11, G68, G69.
#include "program/compensation.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

/// The axes with a word are called by its value from here on. The path does not jump: what the operator calls it
/// changes, the offset takes up the difference. Values are not scaled (D-64, D-68).
template <typename Event>
Event rename_axes(BlockRun& run) {
  Event event;
  for (std::size_t axis = 0; axis < kAxisWords.size(); ++axis) {
    const language::Word* word = run.block.find(kAxisWords[axis]);
    if (word == nullptr) continue;
    const std::int64_t value_nm = word->number * std::int64_t{1000};
    run.state.offset_nm[axis] += run.state.programmed_nm[axis] - value_nm;
    run.state.programmed_nm[axis] = value_nm;
    event.axes[axis] = true;
    event.value[axis] = static_cast<double>(word->number) / 1000;
  }
  return event;
}

}  // namespace

Outcome dwell(BlockRun& run) {
  const std::int64_t tenths = value_of(run.block, language::Address::H, 0);
  // G04 is skipped in a test run (G-041); a parameter of 0 is no dwell (DEC-53).
  if (!run.state.modal.test_run && tenths > 0) run.emit(geometry::Dwell{.seconds = static_cast<double>(tenths) / 10});
  return {};
}

/// G11 carries F, S, T and M only (G-110); they are executed with those of all other blocks.
Outcome only_words(BlockRun&) { return {}; }

Outcome set_actual(BlockRun& run) {
  if (Outcome plain = check_uncompensated(run); !plain) return plain;
  run.emit(rename_axes<geometry::SetActual>(run));
  return {};
}

/// Where the switches are only the machine knows; the path goes on from its own end, and the machine takes the place
/// where it stands by then as that point. The word's value is the Istwert there (G-690 to G-694).
Outcome search_switches(BlockRun& run) {
  if (Outcome plain = check_uncompensated(run); !plain) return plain;
  run.emit(rename_axes<geometry::Reference>(run));
  return {};
}

}  // namespace cnclab::program
