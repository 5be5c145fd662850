// A circle in steps, cut into chords.
#include "geometry/step_grid.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/path_math.hpp"

namespace cnclab::geometry {

namespace {

constexpr double kChordError_steps = 0.25;
constexpr int kMostChords = 100'000;  ///< a radius of a billion steps; no machine has it

std::array<double, 2> scales(Plane plane, const std::array<double, 4>& steps_per_mm) {
  switch (plane) {
    case Plane::xy:
      return {steps_per_mm[0], steps_per_mm[1]};
    case Plane::xz:  // counterclockwise from Z to X (D-128)
      return {steps_per_mm[2], steps_per_mm[0]};
    case Plane::yz:
      return {steps_per_mm[1], steps_per_mm[2]};
  }
  return {1, 1};
}

Point in_grid(Point point, const PlaneAxes& axes, const std::array<double, 2>& scale) {
  point.*axes.first *= scale[0];
  point.*axes.second *= scale[1];
  return point;
}

int chords_for(const ArcShape& shape) {
  const double radius = std::max(shape.start_radius, shape.end_radius);
  if (radius <= kChordError_steps) return 1;
  const double angle = 2 * std::acos(1 - kChordError_steps / radius);
  return static_cast<int>(std::clamp(std::ceil(std::abs(shape.sweep) / angle), 1.0, double{kMostChords}));
}

}  // namespace

void append_in_step_grid(const PathItem& item, const std::array<double, 4>& steps_per_mm, std::vector<PathItem>& out) {
  const auto* arc = std::get_if<Arc>(&item.what);
  if (arc == nullptr) return out.push_back(item);
  const std::array<double, 2> scale = scales(arc->plane, steps_per_mm);
  if (scale[0] == scale[1]) return out.push_back(item);
  const PlaneAxes& axes = axes_of(arc->plane);
  Arc round = *arc;
  round.from = in_grid(arc->from, axes, scale);
  round.to = in_grid(arc->to, axes, scale);
  round.center = in_grid(arc->center, axes, scale);
  ArcShape shape = shape_of(round);
  shape.length = 1;  // the parameter runs from 0 to 1: equal angles
  const int chords = chords_for(shape);
  Point from = arc->from;
  for (int i = 1; i <= chords; ++i) {
    const bool is_last = i == chords;
    const Point there = point_at(round, shape, static_cast<double>(i) / chords);
    const Point to = is_last ? arc->to : in_grid(there, axes, {1 / scale[0], 1 / scale[1]});
    PathItem chord = item;
    chord.what = Line{from, to, arc->feed_mm_per_min, false};
    chord.ends_block = item.ends_block && is_last;
    chord.exact_stop = item.exact_stop && is_last;
    out.push_back(chord);
    from = to;
  }
}

void run_in_step_grid(std::vector<PathItem>& items, const std::array<double, 4>& steps_per_mm) {
  const bool are_equal = steps_per_mm[0] == steps_per_mm[1] && steps_per_mm[1] == steps_per_mm[2];
  if (are_equal || items.empty()) return;
  std::vector<PathItem> run;
  run.reserve(items.size());
  for (const PathItem& item : items) append_in_step_grid(item, steps_per_mm, run);
  items = std::move(run);
}

}  // namespace cnclab::geometry
