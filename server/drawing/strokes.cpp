// Ways to strokes, arcs to chords.
#include "drawing/strokes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/path_math.hpp"

namespace cnclab::drawing {

namespace {

/// So many chords that none leaves the arc by more than 0.01 mm or spans more than 5°.
int chords_of(const geometry::ArcShape& shape) {
  constexpr double kSagitta_mm = 0.01, kWidest_rad = std::numbers::pi / 36;
  constexpr int kMost = 4000;
  const double radius = std::max(shape.start_radius, shape.end_radius);
  const double by_sagitta = radius > kSagitta_mm ? 2 * std::acos(1 - kSagitta_mm / radius) : kWidest_rad;
  return std::clamp(static_cast<int>(std::ceil(std::abs(shape.sweep) / std::min(by_sagitta, kWidest_rad))), 1, kMost);
}

/// The stroke that goes on from here; a new one where the pen must be lifted.
std::size_t begin_stroke(std::vector<Stroke>& strokes, bool is_rapid, const Spot& from) {
  if (!strokes.empty() && strokes.back().is_rapid == is_rapid && strokes.back().spots.back() == from) return 0;
  strokes.push_back({.is_rapid = is_rapid, .spots = {from}});
  return 1;
}

}  // namespace

Spot spot_of(const geometry::Point& point) {
  return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
}

geometry::Point point_of(const Spot& spot) { return {.x = spot.x, .y = spot.y, .z = spot.z}; }

std::size_t append_strokes(const geometry::PathItem& item, std::vector<Stroke>& strokes) {
  if (item.is_fourth_axis) return 0;
  if (const auto* line = std::get_if<geometry::Line>(&item.what)) {
    const std::size_t begun = begin_stroke(strokes, line->is_rapid, spot_of(line->from));
    strokes.back().spots.push_back(spot_of(line->to));
    return begun + 1;
  }
  const auto* arc = std::get_if<geometry::Arc>(&item.what);
  if (arc == nullptr) return 0;
  const geometry::ArcShape shape = geometry::shape_of(*arc);
  const int chords = chords_of(shape);
  const std::size_t begun = begin_stroke(strokes, false, spot_of(arc->from));
  for (int chord = 1; chord <= chords; ++chord)
    strokes.back().spots.push_back(spot_of(geometry::point_at(*arc, shape, shape.length * chord / chords)));
  return begun + static_cast<std::size_t>(chords);
}

std::vector<Stroke> strokes_of(std::span<const geometry::PathItem> path) {
  std::vector<Stroke> strokes;
  for (const geometry::PathItem& item : path) append_strokes(item, strokes);
  return strokes;
}

}  // namespace cnclab::drawing
