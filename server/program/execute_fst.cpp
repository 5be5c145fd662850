// F, S and T: modal, effective at block start (FST-001 to FST-013).
#include <fmt/core.h>

#include "program/words.hpp"

namespace cnclab::program {

namespace {

void change_speed(BlockRun& run, int rpm) {
  ModalState& modal = run.state.modal;
  modal.spindle_rpm = rpm;
  if (run.settings.io_cards[2]) run.emit(geometry::SpindleDigits{.rpm = rpm});  // FST-004, D-124
  const language::Word* m = run.block.find(language::Address::M);
  const bool starts_here = m != nullptr && (m->number == 3 || m->number == 4 || m->number == 13 || m->number == 14);
  // A spindle that runs follows at once; one that this block starts gets its speed with the M function.
  if (modal.spindle != geometry::SpindleTurn::off && (!starts_here || modal.test_run))
    run.emit(geometry::Spindle{.turn = modal.spindle, .rpm = static_cast<double>(rpm)});
}

Outcome change_tool(BlockRun& run, int number) {
  if (Outcome row = check_tool_row(run.programs, number, run.source); !row) return row;
  run.state.modal.tool = number;
  const ToolData tool = run.programs.tool(number).value_or(ToolData{});
  run.emit(geometry::ToolChange{
      .number = number, .radius_mm = language::to_mm(tool.radius), .length_mm = language::to_mm(tool.length)});
  return {};
}

}  // namespace

Outcome check_tool_row(const ProgramSet& programs, int tool, geometry::SourceBlock source) {
  if (!programs.has_damaged_row(tool)) return {};
  return error_at(language::ErrorCode::checksum_wrong, source, 0, fmt::format("P0000 T{:03}", tool));
}

Outcome execute_feed_speed_tool(BlockRun& run) {
  using language::Address;
  if (const language::Word* feed = run.block.find(Address::F))
    run.state.modal.feed_mm_per_min = static_cast<int>(feed->number);
  if (const language::Word* speed = run.block.find(Address::S)) change_speed(run, static_cast<int>(speed->number));
  if (const language::Word* tool = run.block.find(Address::T)) return change_tool(run, static_cast<int>(tool->number));
  return {};
}

}  // namespace cnclab::program
