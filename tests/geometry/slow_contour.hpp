// A slow and obvious picture of contours in the XY plane: the oracle for compensation. Nothing of the server is in it
// but the plain values of path_item.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/path_item.hpp"

namespace slow {

using cnclab::geometry::Arc;
using cnclab::geometry::Line;
using cnclab::geometry::PathElement;
using cnclab::geometry::Point;
using cnclab::geometry::Turn;

struct Spot {
  double x = 0, y = 0;
};

inline double distance(Spot a, Spot b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The angle turned through, always > 0; equal ends are a full circle.
inline double swept(const Arc& arc) {
  if (arc.from.x == arc.to.x && arc.from.y == arc.to.y) return 2 * std::numbers::pi;
  const double begin = std::atan2(arc.from.y - arc.center.y, arc.from.x - arc.center.x);
  const double end = std::atan2(arc.to.y - arc.center.y, arc.to.x - arc.center.x);
  double angle = arc.turn == Turn::counterclockwise ? end - begin : begin - end;
  if (angle <= 0) angle += 2 * std::numbers::pi;
  return angle;
}

/// The point at 0 <= t <= 1 of an element, shifted to the left of the direction of travel.
inline Spot spot_at(const PathElement& element, double t, double to_left = 0) {
  if (const auto* line = std::get_if<Line>(&element)) {
    const double x = line->to.x - line->from.x, y = line->to.y - line->from.y, length = std::hypot(x, y);
    return {line->from.x + x * t - y / length * to_left, line->from.y + y * t + x / length * to_left};
  }
  const auto& arc = std::get<Arc>(element);
  const double sense = arc.turn == Turn::counterclockwise ? 1 : -1;
  const double begin = std::atan2(arc.from.y - arc.center.y, arc.from.x - arc.center.x);
  const double first = std::hypot(arc.from.x - arc.center.x, arc.from.y - arc.center.y);
  const double last = std::hypot(arc.to.x - arc.center.x, arc.to.y - arc.center.y);
  const double angle = begin + sense * swept(arc) * t;
  const double radius = first + (last - first) * t - sense * to_left;
  return {arc.center.x + radius * std::cos(angle), arc.center.y + radius * std::sin(angle)};
}

/// Distance of a spot from a line or a true arc.
inline double distance(Spot spot, const PathElement& element) {
  const double at_ends = std::min(distance(spot, spot_at(element, 0)), distance(spot, spot_at(element, 1)));
  if (const auto* line = std::get_if<Line>(&element)) {
    const double x = line->to.x - line->from.x, y = line->to.y - line->from.y, length = std::hypot(x, y);
    const double along = ((spot.x - line->from.x) * x + (spot.y - line->from.y) * y) / length;
    if (along < 0 || along > length) return at_ends;
    return std::abs((spot.x - line->from.x) * y - (spot.y - line->from.y) * x) / length;
  }
  const auto& arc = std::get<Arc>(element);
  Arc to_spot = arc;
  to_spot.to.x = spot.x;
  to_spot.to.y = spot.y;
  if (swept(to_spot) > swept(arc)) return at_ends;
  const double radius = std::hypot(arc.from.x - arc.center.x, arc.from.y - arc.center.y);
  return std::min(at_ends, std::abs(distance(spot, {arc.center.x, arc.center.y}) - radius));
}

inline double length(const PathElement& element) {
  if (const auto* line = std::get_if<Line>(&element))
    return distance({line->from.x, line->from.y}, {line->to.x, line->to.y});
  const auto& arc = std::get<Arc>(element);
  return swept(arc) * distance({arc.from.x, arc.from.y}, {arc.center.x, arc.center.y});
}

/// The smallest distance of a way from an element, if it is below `limit`; else some greater one.
///
/// The distance cannot change faster than the way goes on, so a stretch whose middle is far away is no place to look;
/// every other stretch is halved until it is shorter than a fifth of a micrometre.
inline double distance(const PathElement& way, const PathElement& element, double limit) {
  constexpr double kShortest_mm = 1e-4;
  const double whole = length(way);
  double smallest = std::min(distance(spot_at(way, 0), element), distance(spot_at(way, 1), element));
  std::vector<std::pair<double, double>> pending{{0.0, 1.0}};
  while (!pending.empty()) {
    const auto [from, to] = pending.back();
    pending.pop_back();
    const double middle = (from + to) / 2, half_mm = (to - from) / 2 * whole;
    const double found = distance(spot_at(way, middle), element);
    smallest = std::min(smallest, found);
    if (found - half_mm > std::min(limit, smallest - kShortest_mm) || half_mm < kShortest_mm) continue;
    pending.emplace_back(from, middle);
    pending.emplace_back(middle, to);
  }
  return smallest;
}

/// Where the ways beside two elements cross: shares of the first way's and of the second way's length.
struct Crossing {
  double before = 1, after = 0;
};

/// Crossings of the two ways as chains of chords.
inline std::vector<Crossing> crossings(const PathElement& before, const PathElement& after, double to_left) {
  constexpr int kChords = 400;
  const auto chain = [&](const PathElement& element) {
    std::vector<Spot> spots;
    for (int i = 0; i <= kChords; ++i) spots.push_back(spot_at(element, static_cast<double>(i) / kChords, to_left));
    return spots;
  };
  const auto side = [](Spot a, Spot b, Spot c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
  const auto first = chain(before), second = chain(after);
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < kChords; ++i) {
    for (std::size_t j = 0; j < kChords; ++j) {
      const Spot a = first[i], b = first[i + 1], c = second[j], d = second[j + 1];
      if (side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0)
        found.push_back({static_cast<double>(i) / kChords, static_cast<double>(j) / kChords});
    }
  }
  return found;
}

}  // namespace slow
