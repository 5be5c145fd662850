// Compensation: G40 to G46 become orders to the stages that move the path (G-400 to G-461; D-64, D-72, D-74).
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

Outcome begin_radius(BlockRun& run, RadiusCompensation radius) {
  if (Outcome unscaled = check_unscaled(run); !unscaled) return unscaled;
  run.state.modal.radius = radius;
  take_radius(run.state.modal, run.programs);
  order_radius(run);
  return {};
}

bool follows_contour(RadiusCompensation radius) {
  return radius == RadiusCompensation::left || radius == RadiusCompensation::right;
}

AxisSet moved_axes(const ExecutionState& state, const Target& target) {
  AxisSet moved = 0;
  for (std::size_t axis = 0; axis < target.programmed_nm.size(); ++axis)
    if (target.programmed_nm[axis] != state.programmed_nm[axis]) moved |= axis_bit(axis);
  return moved;
}

/// `touched` axes get the compensation that is on, or lose the one that is off.
void shift(AxisSet& shifted, AxisSet touched, bool is_on) {
  shifted = static_cast<AxisSet>(is_on ? shifted | touched : shifted & ~touched);
}

}  // namespace

bool is_compensating(const ModalState& modal) {
  return modal.radius != RadiusCompensation::off || modal.length_compensation;
}

bool is_path_compensated(const ExecutionState& state) {
  return is_compensating(state.modal) || state.shifted_axes != 0;
}

Outcome check_uncompensated(const BlockRun& run) {
  if (!is_path_compensated(run.state)) return {};
  return error_at(language::ErrorCode::compensation_impossible, run.source, 'G',
                  "G" + std::to_string(run.block.function.code), "G40, G45");
}

/// Length: each way that names the perpendicular axis (COMP-015). G43, G44: each axis with a way that names it (D-72).
/// G41, G42: both axes together, with a way in the plane (COMP-005, COMP-006).
void follow_compensation(ExecutionState& state, const Target& target) {
  const ModalState& modal = state.modal;
  if (!is_path_compensated(state)) return;
  const PlaneIndices axes = indices_of(modal.plane);
  const AxisSet normal = axis_bit(axes.normal);
  const auto plane = static_cast<AxisSet>(axis_bit(axes.in_plane[0]) | axis_bit(axes.in_plane[1]));
  shift(state.shifted_axes, target.named_axes & normal, modal.length_compensation && modal.tool_length.value != 0);
  const bool is_on = modal.radius != RadiusCompensation::off;
  if (is_on) state.is_contour_shifted = follows_contour(modal.radius);
  const AxisSet touched = !state.is_contour_shifted                  ? target.named_axes & plane
                          : (moved_axes(state, target) & plane) != 0 ? plane
                                                                     : AxisSet{0};
  shift(state.shifted_axes, touched, is_on && modal.tool_radius.value != 0);
}

void take_radius(ModalState& modal, const ProgramSet& programs) {
  modal.tool_radius = programs.tool(modal.tool).value_or(ToolData{}).radius;
}

void take_length(ModalState& modal, const ProgramSet& programs) {
  modal.tool_length = programs.tool(modal.tool).value_or(ToolData{}).length;
}

void announce_compensation(BlockRun& run) {
  if (run.state.modal.radius != RadiusCompensation::off) order_radius(run);
  if (run.state.modal.length_compensation) order_length(run);
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
  run.state.modal.length_compensation = true;
  take_length(run.state.modal, run.programs);
  order_length(run);
  return {};
}

}  // namespace cnclab::program
