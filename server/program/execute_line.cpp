// Straight ways: G00, G01, G12 (G-000 to G-012, G-120; D-59, DEC-22).
#include "program/ways.hpp"
#include "program/words.hpp"

namespace cnclab::program {

Outcome execute_rapid(BlockRun& run) {
  const auto target = target_of(run);
  if (!target) return std::unexpected(target.error());
  go_straight(run, *target, run.settings.f_max_mm_per_min, true);
  return {};
}

Outcome execute_line(BlockRun& run) {
  const auto target = target_of(run);
  if (!target) return std::unexpected(target.error());
  if (target->named_axes == 0) return {};
  if (Outcome feed = check_feed(run); !feed) return feed;
  go_straight(run, *target, run.state.modal.feed_mm_per_min, false);
  return {};
}

/// Always incremental, untouched by scale and compensation, with the modal F (G-120 to G-122, D-62).
Outcome execute_fourth_axis(BlockRun& run) {
  if (Outcome feed = check_feed(run); !feed) return feed;
  const std::int64_t way_nm = value_of(run.block, language::Address::U, 0) * 1000;
  if (way_nm == 0) return {};
  ExecutionState& state = run.state;
  const geometry::Point from = state.path;
  state.fourth_axis_nm += way_nm;
  state.path.u = static_cast<double>(state.fourth_axis_nm) / kNanometresPerMm;
  run.emit(geometry::Line{
      .from = from, .to = state.path, .feed_mm_per_min = static_cast<double>(state.modal.feed_mm_per_min)});
  run.out.back().is_fourth_axis = true;
  return {};
}

}  // namespace cnclab::program
