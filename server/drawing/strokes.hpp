// A path as strokes of the pen: what every picture of it is drawn from.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/path_item.hpp"

namespace cnclab::drawing {

/// A point in path coordinates, mm. Single precision: 0.03 µm at 500 mm, and a long path is many of them.
struct Spot {
  float x = 0, y = 0, z = 0;
  friend bool operator==(const Spot&, const Spot&) = default;
};

[[nodiscard]] Spot spot_of(const geometry::Point& point);
[[nodiscard]] geometry::Point point_of(const Spot& spot);

/// Points that belong together and are drawn alike.
struct Stroke {
  bool is_rapid = false;
  std::vector<Spot> spots;
};

/// Appends the item's way, arcs as chords that keep within 0.01 mm of it; events and the fourth axis leave no stroke.
/// returns   the spots that were added
std::size_t append_strokes(const geometry::PathItem& item, std::vector<Stroke>& strokes);

[[nodiscard]] std::vector<Stroke> strokes_of(std::span<const geometry::PathItem> path);

}  // namespace cnclab::drawing
