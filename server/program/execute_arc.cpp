// Arcs: G02, G03 by their centre, G05, G06 by their radius, G07, G08 helices, G10 rounded corners
// (G-020 to G-031, G-050 to G-100; D-55, D-65, D-66, D-68, DEC-04, DEC-64).
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/path_math.hpp"
#include "geometry/tolerances.hpp"
#include "program/ways.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

using geometry::Turn;
using language::Address;
using language::ErrorCode;

constexpr std::array kCenterWords{Address::I, Address::J, Address::K};

/// An odd number of mirrored axes in the plane turns the sense round (G-751, EX-108).
Turn mirrored(Turn turn, const ModalState& modal) {
  const auto [first, second] = indices_of(modal.plane).in_plane;
  if ((modal.scale[first] < 0) == (modal.scale[second] < 0)) return turn;
  return turn == Turn::clockwise ? Turn::counterclockwise : Turn::clockwise;
}

/// The size of the factor that both axes of the plane share, in 1/1000 (D-68).
/// errors: scale_unequal where they differ, since a circle would become an ellipse
std::expected<std::int64_t, language::Error> factor_of_plane(const BlockRun& run) {
  const auto [first, second] = indices_of(run.state.modal.plane).in_plane;
  const auto& scale = run.state.modal.scale;
  if (std::abs(scale[first]) == std::abs(scale[second])) return std::abs(scale[first]);
  constexpr std::array kNames{'X', 'Y', 'Z'};
  const auto factor = [&](std::size_t axis) { return in_mm(static_cast<double>(scale[axis]) / 1000); };
  return error_at(ErrorCode::scale_unequal, run.source, 'G',
                  fmt::format("G75 {} {} {} {}", kNames[first], factor(first), kNames[second], factor(second)));
}

/// What every arc needs before its centre is known.
struct Begun {
  Target target;
  geometry::Arc arc;        ///< without centre
  std::int64_t factor = 0;  ///< of both axes, 1/1000
};

std::expected<Begun, language::Error> begin_arc(const BlockRun& run, Turn turn) {
  const ModalState& modal = run.state.modal;
  const auto factor = factor_of_plane(run);
  if (!factor) return std::unexpected(factor.error());
  if (Outcome feed = check_feed(run); !feed) return std::unexpected(feed.error());
  const auto target = target_of(run);
  if (!target) return std::unexpected(target.error());
  return Begun{.target = *target,
               .arc = {.from = run.state.path,
                       .to = target->path,
                       .center = run.state.path,
                       .turn = mirrored(turn, modal),
                       .plane = modal.plane,
                       .feed_mm_per_min = static_cast<double>(modal.feed_mm_per_min)},
               .factor = *factor};
}

/// The centre counts from the start point, under G90 too (G-021).
void set_center(const BlockRun& run, geometry::Arc& arc) {
  for (const std::size_t axis : indices_of(arc.plane).in_plane) {
    const std::int64_t way_nm = value_of(run.block, kCenterWords[axis], 0) * run.state.modal.scale[axis];
    arc.center.*kPathAxes[axis] += static_cast<double>(way_nm) / kNanometresPerMm;
  }
}

Outcome check_radii(const BlockRun& run, const geometry::Arc& arc) {
  const auto [first, second] = indices_of(arc.plane).in_plane;
  const geometry::ArcShape shape = geometry::shape_of(arc);
  const double tolerance = std::max(geometry::kArcTolerance_mm,
                                    2 / std::min(run.settings.steps_per_mm[first], run.settings.steps_per_mm[second]));
  constexpr double kNoise_mm = 1e-9;  // of the square roots
  const bool has_radius = shape.start_radius > kNoise_mm && shape.end_radius > kNoise_mm;
  if (has_radius && std::abs(shape.end_radius - shape.start_radius) <= tolerance + kNoise_mm) return {};
  return error_at(ErrorCode::arc_wrong, run.source, language::letter(kCenterWords[first]),
                  "r " + in_mm(shape.start_radius) + " / " + in_mm(shape.end_radius), "+-" + in_mm(tolerance));
}

Outcome execute_arc(BlockRun& run, Turn turn) {
  auto begun = begin_arc(run, turn);
  if (!begun) return std::unexpected(begun.error());
  if (begun->factor == 0) {  // a factor of 0 leaves nothing of the arc (D-68)
    go_straight(run, begun->target, begun->arc.feed_mm_per_min, false);
    return {};
  }
  set_center(run, begun->arc);
  if (Outcome radii = check_radii(run, begun->arc); !radii) return radii;
  go_round(run, begun->target, begun->arc);
  return {};
}

/// The radius is at least half the way between the ends. Whole nanometres, so that a half circle is one exactly; long
/// double, since squares of such ways need more than 64 bits.
Outcome check_radius(const BlockRun& run, const Target& target, std::int64_t radius_nm) {
  long double chord_squared = 0;
  for (const std::size_t axis : indices_of(run.state.modal.plane).in_plane) {
    const auto way = static_cast<long double>(target.programmed_nm[axis] - run.state.programmed_nm[axis]);
    chord_squared += way * way;
  }
  const std::string found = in_mm(static_cast<double>(radius_nm) / kNanometresPerMm);
  if (chord_squared == 0) return error_at(ErrorCode::arc_without_way, run.source, 'R', found);
  const long double diameter = 2 * static_cast<long double>(std::abs(radius_nm));
  if (diameter * diameter >= chord_squared) return {};
  const double least_um = std::ceil(static_cast<double>(std::sqrt(chord_squared) / 2 / 1000));
  return error_at(ErrorCode::radius_too_small, run.source, 'R', found,
                  radius_nm < 0 ? "R <= -" + in_mm(least_um / 1000) : "R >= " + in_mm(least_um / 1000));
}

/// The centre lies on the chord's perpendicular bisector, as far from its middle as the radius says. Going round
/// counterclockwise it is to the left of the chord for the shorter arc, to the right for the longer one; clockwise the
/// other way about.
///
///        to
///        |\.           R > 0: arc of at most 180°
///   left | center      R < 0: the rest of the circle
///        |/
///       from
void set_center_by_radius(geometry::Arc& arc, double radius_mm) {
  const geometry::PlaneAxes& axes = geometry::axes_of(arc.plane);
  const double first = arc.to.*axes.first - arc.from.*axes.first;
  const double second = arc.to.*axes.second - arc.from.*axes.second;
  const double chord = std::hypot(first, second);
  const double size = std::abs(radius_mm);
  const double height = std::sqrt(std::max(0.0, (size - chord / 2) * (size + chord / 2)));
  const bool is_left = (arc.turn == Turn::counterclockwise) == (radius_mm > 0);
  const double to_left = (is_left ? height : -height) / chord;
  arc.center.*axes.first = std::midpoint(arc.from.*axes.first, arc.to.*axes.first) - second * to_left;
  arc.center.*axes.second = std::midpoint(arc.from.*axes.second, arc.to.*axes.second) + first * to_left;
}

Outcome execute_arc_by_radius(BlockRun& run, Turn turn) {
  auto begun = begin_arc(run, turn);
  if (!begun) return std::unexpected(begun.error());
  if (begun->factor == 0) {
    go_straight(run, begun->target, begun->arc.feed_mm_per_min, false);
    return {};
  }
  const std::int64_t radius_nm = value_of(run.block, Address::R, 0) * begun->factor;
  const double radius_mm = static_cast<double>(radius_nm) / kNanometresPerMm;
  if (Outcome radius = check_radius(run, begun->target, radius_nm); !radius) return radius;
  set_center_by_radius(begun->arc, radius_mm);
  go_round(run, begun->target, begun->arc);
  return {};
}

/// Pulses of the plane's two axes along the arc. Between two crossings of an axis through the centre both axes run in
/// one direction, so the pulses of such a piece are those between its ends.
std::int64_t pulses_in_plane(const geometry::Arc& arc, const std::array<double, 4>& steps_per_mm) {
  constexpr double kQuarter_rad = std::numbers::pi / 2;
  const geometry::ArcShape shape = geometry::shape_of(arc);
  const double length_per_rad = shape.length / std::abs(shape.sweep);
  const double sign = shape.sweep > 0 ? 1 : -1;
  std::int64_t pulses = 0;
  std::array<std::int64_t, 2> before{};
  const auto count_to = [&](const geometry::Point& point) {
    std::size_t i = 0;
    for (const std::size_t axis : indices_of(arc.plane).in_plane) {
      const double way = point.*kPathAxes[axis] - arc.from.*kPathAxes[axis];
      const std::int64_t now = std::llround(way * steps_per_mm[axis]);
      pulses += std::abs(now - before[i]);
      before[i++] = now;
    }
  };
  for (double quarter = std::ceil(sign * shape.start_angle / kQuarter_rad) * kQuarter_rad;; quarter += kQuarter_rad) {
    const double turned = quarter - sign * shape.start_angle;  // never negative
    if (turned >= std::abs(shape.sweep)) break;
    count_to(geometry::point_at(arc, shape, turned * length_per_rad));
  }
  count_to(arc.to);
  return pulses;
}

/// The interpolator steps Z between the pulses of X and Y, so there must be fewer of them (G-071, D-65).
Outcome check_pitch(const BlockRun& run, const geometry::Arc& arc) {
  const std::size_t normal = indices_of(arc.plane).normal;
  const double way = arc.to.*kPathAxes[normal] - arc.from.*kPathAxes[normal];
  const std::int64_t along = std::llround(std::abs(way) * run.settings.steps_per_mm[normal]);
  if (along == 0) return {};
  const std::int64_t around = pulses_in_plane(arc, run.settings.steps_per_mm);
  if (along < around) return {};
  return error_at(ErrorCode::helix_too_steep, run.source, 'Z', std::to_string(along), "< " + std::to_string(around));
}

Outcome execute_helix(BlockRun& run, Turn turn) {
  if (run.state.modal.plane != geometry::Plane::xy) return error_at(ErrorCode::plane_wrong, run.source, 'G', {}, "G17");
  auto begun = begin_arc(run, turn);
  if (!begun) return std::unexpected(begun.error());
  set_center(run, begun->arc);
  if (Outcome radii = check_radii(run, begun->arc); !radii) return radii;
  if (Outcome pitch = check_pitch(run, begun->arc); !pitch) return pitch;
  go_round(run, begun->target, begun->arc);
  return {};
}

}  // namespace

Outcome execute_clockwise_arc(BlockRun& run) { return execute_arc(run, Turn::clockwise); }
Outcome execute_counterclockwise_arc(BlockRun& run) { return execute_arc(run, Turn::counterclockwise); }
Outcome execute_clockwise_by_radius(BlockRun& run) { return execute_arc_by_radius(run, Turn::clockwise); }
Outcome execute_counterclockwise_by_radius(BlockRun& run) { return execute_arc_by_radius(run, Turn::counterclockwise); }
Outcome execute_clockwise_helix(BlockRun& run) { return execute_helix(run, Turn::clockwise); }
Outcome execute_counterclockwise_helix(BlockRun& run) { return execute_helix(run, Turn::counterclockwise); }

/// The stages find the two lines; here only the radius is known (G-100, D-66).
Outcome round_corner(BlockRun& run) {
  const auto factor = factor_of_plane(run);
  if (!factor) return std::unexpected(factor.error());
  const std::int64_t radius_um = value_of(run.block, Address::R, 0);
  if (radius_um <= 0)
    return error_at(ErrorCode::word_out_of_range, run.source, 'R', in_mm(static_cast<double>(radius_um) / 1000), "> 0");
  const double radius_mm = static_cast<double>(radius_um * *factor) / kNanometresPerMm;
  if (radius_mm > 0) run.emit(geometry::CornerRounding{.radius_mm = radius_mm, .plane = run.state.modal.plane});
  return {};
}

}  // namespace cnclab::program
