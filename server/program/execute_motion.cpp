// Ways and arcs: G00, G01, G02, G03, G12 (G-000 to G-030, G-120; D-55, D-59, D-68, DEC-04, DEC-05, DEC-22).
//
//   word (µm) × factor (1/1000) = way or target (nm) ──▶ Sollwert (nm) ──▶ + offset of G68 ──▶ path (mm)
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/path_math.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

using language::Address;
using language::ErrorCode;

constexpr std::array kAxisWords{Address::X, Address::Y, Address::Z};
constexpr std::array kCenterWords{Address::I, Address::J, Address::K};
constexpr std::array<double geometry::Point::*, 3> kPathAxes{&geometry::Point::x, &geometry::Point::y,
                                                             &geometry::Point::z};
constexpr double kNanometresPerMm = 1e6;
/// Sums beyond 100 km leave the exact range of a path coordinate; no machine is that long.
constexpr std::int64_t kFarthest_nm = 100'000'000'000'000;
/// Smallest radius error that is accepted, mm (D-55).
constexpr double kArcTolerance_mm = 0.020;

/// The two axes of a plane as indices of X, Y, Z.
std::array<std::size_t, 2> plane_indices(geometry::Plane plane) {
  switch (plane) {
    case geometry::Plane::xy:
      return {0, 1};
    case geometry::Plane::xz:
      return {0, 2};
    case geometry::Plane::yz:
      return {1, 2};
  }
  return {0, 1};
}

std::string in_mm(double value_mm) { return fmt::format("{:.3f}", value_mm); }

/// Where the block leads.
struct Target {
  Nanometres programmed_nm{};
  std::array<std::int64_t, 3> unscaled_um{};
  geometry::Point path;
  bool has_axis_word = false;
};

/// Takes a word of one axis into the target. In a ROM program an absolute word counts from where the program would be
/// without scale, so that its way is scaled and not its place: #55..#57 always lead back (DEC-51).
void take_word(const BlockRun& run, std::size_t axis, std::int64_t word_um, Target& target) {
  const ModalState& modal = run.state.modal;
  const bool is_absolute = modal.dimension == Dimension::absolute;
  if (language::is_reserved_for_cycles(run.source.program)) {
    const std::int64_t way_um = is_absolute ? word_um - target.unscaled_um[axis] : word_um;
    target.unscaled_um[axis] += way_um;
    target.programmed_nm[axis] += way_um * modal.scale[axis];
    return;
  }
  const std::int64_t scaled_nm = word_um * modal.scale[axis];
  target.programmed_nm[axis] = is_absolute ? scaled_nm : target.programmed_nm[axis] + scaled_nm;
}

std::expected<Target, language::Error> target_of(const BlockRun& run) {
  const ExecutionState& state = run.state;
  Target target{.programmed_nm = state.programmed_nm,
                .unscaled_um = state.unscaled_um,
                .path = state.path,
                .has_axis_word = false};
  for (std::size_t axis = 0; axis < kAxisWords.size(); ++axis) {
    const language::Word* word = run.block.find(kAxisWords[axis]);
    if (word == nullptr) continue;
    target.has_axis_word = true;
    take_word(run, axis, word->number, target);
    const std::int64_t before_nm = state.programmed_nm[axis];
    const std::int64_t after_nm = target.programmed_nm[axis];
    const std::int64_t path_nm = after_nm + state.offset_nm[axis];
    if (std::max(std::abs(after_nm), std::abs(path_nm)) > kFarthest_nm)
      return error_at(ErrorCode::word_out_of_range, run.source, language::letter(kAxisWords[axis]),
                      in_mm(static_cast<double>(after_nm) / kNanometresPerMm));
    if (after_nm != before_nm) target.path.*kPathAxes[axis] = static_cast<double>(path_nm) / kNanometresPerMm;
  }
  return target;
}

void arrive(BlockRun& run, const Target& target) {
  run.state.programmed_nm = target.programmed_nm;
  run.state.unscaled_um = target.unscaled_um;
  run.state.path = target.path;
}

/// An odd number of mirrored axes in the plane turns the sense round (G-751, EX-108).
geometry::Turn mirrored(geometry::Turn turn, const std::array<std::int64_t, 3>& scale,
                        const std::array<std::size_t, 2>& axes) {
  if ((scale[axes[0]] < 0) == (scale[axes[1]] < 0)) return turn;
  return turn == geometry::Turn::clockwise ? geometry::Turn::counterclockwise : geometry::Turn::clockwise;
}

Outcome check_radii(const BlockRun& run, const geometry::Arc& arc, const std::array<std::size_t, 2>& axes) {
  const geometry::ArcShape shape = geometry::shape_of(arc);
  const double finest = std::min(run.settings.steps_per_mm[axes[0]], run.settings.steps_per_mm[axes[1]]);
  const double tolerance = std::max(kArcTolerance_mm, 2 / finest);
  constexpr double kNoise_mm = 1e-9;  // of the square roots
  const bool has_radius = shape.start_radius > kNoise_mm && shape.end_radius > kNoise_mm;
  if (has_radius && std::abs(shape.end_radius - shape.start_radius) <= tolerance + kNoise_mm) return {};
  return error_at(ErrorCode::arc_wrong, run.source, language::letter(kCenterWords[axes[0]]),
                  "r " + in_mm(shape.start_radius) + " / " + in_mm(shape.end_radius), "+-" + in_mm(tolerance));
}

Outcome execute_arc(BlockRun& run, geometry::Turn turn) {
  const ModalState& modal = run.state.modal;
  const auto axes = plane_indices(modal.plane);
  if (std::abs(modal.scale[axes[0]]) != std::abs(modal.scale[axes[1]]))  // D-68
    return error_at(ErrorCode::scale_not_allowed, run.source, 'G', "G75");
  if (Outcome feed = check_feed(run); !feed) return feed;
  const auto target = target_of(run);
  if (!target) return std::unexpected(target.error());

  geometry::Arc arc{.from = run.state.path,
                    .to = target->path,
                    .center = run.state.path,
                    .turn = mirrored(turn, modal.scale, axes),
                    .plane = modal.plane,
                    .feed_mm_per_min = static_cast<double>(modal.feed_mm_per_min)};
  for (const std::size_t axis : axes) {  // the centre counts from the start point, under G90 too (G-021)
    const std::int64_t way_nm = value_of(run.block, kCenterWords[axis], 0) * modal.scale[axis];
    arc.center.*kPathAxes[axis] += static_cast<double>(way_nm) / kNanometresPerMm;
  }
  if (Outcome radii = check_radii(run, arc, axes); !radii) return radii;
  run.emit(arc);
  arrive(run, *target);
  return {};
}

/// A way of no length is no element: nothing moves and nothing has to stop for it.
Outcome execute_way(BlockRun& run, const Target& target, double feed_mm_per_min, bool is_rapid) {
  if (target.path != run.state.path)
    run.emit(geometry::Line{
        .from = run.state.path, .to = target.path, .feed_mm_per_min = feed_mm_per_min, .is_rapid = is_rapid});
  arrive(run, target);
  return {};
}

}  // namespace

Outcome check_feed(const BlockRun& run) {
  const int feed = run.state.modal.feed_mm_per_min;
  if (feed <= 0) return error_at(ErrorCode::feed_missing, run.source, 'F');
  if (feed > run.settings.f_max_mm_per_min) return feed_above_limit(run.source, feed, run.settings);
  return {};
}

Outcome execute_rapid(BlockRun& run) {
  const auto target = target_of(run);
  if (!target) return std::unexpected(target.error());
  return execute_way(run, *target, run.settings.f_max_mm_per_min, true);
}

Outcome execute_line(BlockRun& run) {
  const auto target = target_of(run);
  if (!target) return std::unexpected(target.error());
  if (!target->has_axis_word) return {};
  if (Outcome feed = check_feed(run); !feed) return feed;
  return execute_way(run, *target, run.state.modal.feed_mm_per_min, false);
}

Outcome execute_clockwise_arc(BlockRun& run) { return execute_arc(run, geometry::Turn::clockwise); }
Outcome execute_counterclockwise_arc(BlockRun& run) { return execute_arc(run, geometry::Turn::counterclockwise); }

/// Always incremental, untouched by scale and compensation, with the modal F (G-120 to G-122, D-62).
Outcome execute_fourth_axis(BlockRun& run) {
  if (Outcome feed = check_feed(run); !feed) return feed;
  const std::int64_t way_nm = value_of(run.block, Address::U, 0) * 1000;
  if (way_nm == 0) return {};
  ExecutionState& state = run.state;
  const geometry::Point from = state.path;
  state.fourth_axis_nm += way_nm;
  state.path.u = static_cast<double>(state.fourth_axis_nm) / kNanometresPerMm;
  run.pattern.is_fourth_axis = true;
  run.emit(geometry::Line{
      .from = from, .to = state.path, .feed_mm_per_min = static_cast<double>(state.modal.feed_mm_per_min)});
  run.pattern.is_fourth_axis = false;
  return {};
}

}  // namespace cnclab::program
