// Compensation: G40 to G46 become orders to the stages that move the path (G-400 to G-461; D-64, D-72, D-74).
#include <fmt/core.h>

#include <cmath>
#include <string>

#include "program/compensation.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

geometry::OffsetSide side_of(RadiusCompensation radius) {
  switch (radius) {
    case RadiusCompensation::off:
      return geometry::OffsetSide::off;
    case RadiusCompensation::left:
      return geometry::OffsetSide::left;
    case RadiusCompensation::right:
      return geometry::OffsetSide::right;
    case RadiusCompensation::plus:
      return geometry::OffsetSide::plus;
    case RadiusCompensation::minus:
      return geometry::OffsetSide::minus;
  }
  return geometry::OffsetSide::off;
}

void order_radius(BlockRun& run) {
  const ModalState& modal = run.state.modal;
  run.emit(geometry::RadiusOffset{
      .side = side_of(modal.radius), .radius_mm = language::to_mm(modal.tool_radius), .plane = modal.plane});
}

void order_length(BlockRun& run) {
  const ModalState& modal = run.state.modal;
  run.emit(geometry::LengthOffset{.length_mm = language::to_mm(modal.tool_length), .plane = modal.plane});
}

/// Scale and compensation exclude each other (COMP-018).
Outcome check_unscaled(const BlockRun& run) {
  if (!run.state.modal.scale_on) return {};
  return error_at(language::ErrorCode::scale_not_allowed, run.source, 'G', "G75", "G74");
}

/// A table that came by tape may hold what nobody can key in (D-50, DEC-13).
Outcome check_radius(const BlockRun& run) {
  const ModalState& modal = run.state.modal;
  if (modal.tool_radius.value >= 0) return {};
  return error_at(language::ErrorCode::word_out_of_range, run.source, 'T',
                  fmt::format("T{:02} R {:.3f}", modal.tool, language::to_mm(modal.tool_radius)), "R >= 0");
}

Outcome begin_radius(BlockRun& run, RadiusCompensation radius) {
  if (Outcome unscaled = check_unscaled(run); !unscaled) return unscaled;
  if (Outcome taken = take_radius(run.state.modal, run.programs, run.source); !taken) return taken;
  run.state.modal.radius = radius;
  if (Outcome size = check_radius(run); !size) return size;
  order_radius(run);
  return {};
}

bool follows_contour(RadiusCompensation radius) {
  return radius == RadiusCompensation::left || radius == RadiusCompensation::right;
}

bool moves_each_axis(RadiusCompensation radius) {
  return radius == RadiusCompensation::plus || radius == RadiusCompensation::minus;
}

AxisSet moved_axes(const ExecutionState& state, const Target& target) {
  AxisSet moved = 0;
  for (std::size_t axis = 0; axis < target.programmed_nm.size(); ++axis)
    if (target.programmed_nm[axis] != state.programmed_nm[axis]) moved |= axis_bit(axis);
  return moved;
}

AxisSet axes_that_span(geometry::Plane plane) {
  const auto [first, second] = indices_of(plane).in_plane;
  return static_cast<AxisSet>(axis_bit(first) | axis_bit(second));
}

/// " X Y"
std::string names_of(AxisSet axes) {
  std::string names;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((axes & axis_bit(axis)) != 0) names += std::string(" ") + "XYZ"[axis];
  return names;
}

AxisSet without(AxisSet axes, AxisSet removed) { return static_cast<AxisSet>(axes & ~removed); }

}  // namespace

bool is_compensating(const ModalState& modal) {
  return modal.radius != RadiusCompensation::off || modal.length_compensation;
}

bool is_path_compensated(const ExecutionState& state) {
  return is_compensating(state.modal) || state.shifted_axes != 0 || state.contour_axes != 0;
}

Outcome check_uncompensated(const BlockRun& run) {
  if (!is_path_compensated(run.state)) return {};
  const std::string function = "G" + std::to_string(run.block.function.code);
  if (is_compensating(run.state.modal))
    return error_at(language::ErrorCode::compensation_impossible, run.source, 'G', function, "G40, G45");
  return error_at(language::ErrorCode::offset_not_left, run.source, 'G', function,
                  "G01" + names_of(static_cast<AxisSet>(run.state.shifted_axes | run.state.contour_axes)));
}

void begin_compensated(ExecutionState& state, const std::array<double, 3>& compensation_mm) {
  constexpr double kSmallest_mm = 1e-6;
  AxisSet shifted = 0;
  for (std::size_t axis = 0; axis < compensation_mm.size(); ++axis)
    if (std::abs(compensation_mm[axis]) >= kSmallest_mm) shifted |= axis_bit(axis);
  const AxisSet plane = axes_that_span(state.modal.plane);
  const bool together = !moves_each_axis(state.modal.radius) && (shifted & plane) != 0;
  state.contour_axes = together ? plane : AxisSet{0};
  state.shifted_axes = together ? without(shifted, plane) : shifted;
}

/// Entered: a contour with a way in the plane (COMP-005), G43 and G44 by each axis that moves (D-72), the length by a
/// way that names its axis (COMP-015). Left: by a way that names the axis, or one of the contour's (COMP-006).
void follow_compensation(ExecutionState& state, const Target& target) {
  if (!is_path_compensated(state)) return;
  const ModalState& modal = state.modal;
  const AxisSet plane = axes_that_span(modal.plane), named = target.named_axes;
  const auto moved_in_plane = static_cast<AxisSet>(moved_axes(state, target) & plane);
  const bool has_radius = modal.tool_radius.value != 0;
  if (follows_contour(modal.radius)) {
    if (has_radius && moved_in_plane != 0) state.contour_axes = plane;
  } else if ((named & state.contour_axes) != 0) {
    state.contour_axes = 0;
  }
  if (moves_each_axis(modal.radius)) {  // an axis that is named without a way keeps what it has
    state.shifted_axes = without(state.shifted_axes, without(named, plane) | moved_in_plane);
    if (has_radius) state.shifted_axes |= moved_in_plane;
  } else {
    state.shifted_axes = without(state.shifted_axes, named);
  }
  if (modal.tool_length.value != 0) state.shifted_axes |= without(named, plane);
}

Outcome take_radius(ModalState& modal, const ProgramSet& programs, geometry::SourceBlock source) {
  if (Outcome row = check_tool_row(programs, modal.tool, source); !row) return row;
  modal.tool_radius = programs.tool(modal.tool).value_or(ToolData{}).radius;
  return {};
}

Outcome take_length(ModalState& modal, const ProgramSet& programs, geometry::SourceBlock source) {
  if (Outcome row = check_tool_row(programs, modal.tool, source); !row) return row;
  modal.tool_length = programs.tool(modal.tool).value_or(ToolData{}).length;
  return {};
}

Outcome announce_compensation(BlockRun& run) {
  if (Outcome radius = check_radius(run); !radius) return radius;
  // The plane of what is left over is that of the start.
  if (run.state.modal.radius != RadiusCompensation::off || run.state.contour_axes != 0) order_radius(run);
  if (run.state.modal.length_compensation) order_length(run);
  return {};
}

Outcome cancel_radius_compensation(BlockRun& run) {
  ModalState& modal = run.state.modal;
  if (modal.radius == RadiusCompensation::off) return {};
  modal.radius = RadiusCompensation::off;
  modal.tool_radius = {};
  order_radius(run);
  return {};
}

Outcome compensate_left(BlockRun& run) { return begin_radius(run, RadiusCompensation::left); }
Outcome compensate_right(BlockRun& run) { return begin_radius(run, RadiusCompensation::right); }
Outcome lengthen_ways(BlockRun& run) { return begin_radius(run, RadiusCompensation::plus); }
Outcome shorten_ways(BlockRun& run) { return begin_radius(run, RadiusCompensation::minus); }

Outcome cancel_length_compensation(BlockRun& run) {
  ModalState& modal = run.state.modal;
  if (!modal.length_compensation) return {};
  modal.length_compensation = false;
  modal.tool_length = {};
  order_length(run);
  return {};
}

Outcome compensate_length(BlockRun& run) {
  if (Outcome unscaled = check_unscaled(run); !unscaled) return unscaled;
  if (Outcome taken = take_length(run.state.modal, run.programs, run.source); !taken) return taken;
  run.state.modal.length_compensation = true;
  order_length(run);
  return {};
}

}  // namespace cnclab::program
