// Distances of lines and arcs.
//
// The smallest distance is found among few candidates, all of them true distances of true points:
//   1. where the pieces cross: 0;
//   2. from each end of one to the other piece;
//   3. on the common normal: the foot of a circle's centre on a line, or the line through two centres.
#include "geometry/plane_piece.hpp"

#include <limits>
#include <numbers>
#include <utility>

namespace cnclab::geometry {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
/// How far a spiral's radius may change within one piece, mm.
constexpr double kSpiralStep_mm = 0.0005;

/// Does the arc pass through the direction `v` as seen from its centre?
bool has_direction(const PlanePiece& arc, PlaneVector v) {
  if (arc.is_circle) return true;
  const PlaneVector start = arc.from - arc.center, end = arc.to - arc.center;
  const bool behind_start = cross(start, v) >= 0, before_end = cross(v, end) >= 0;
  const bool is_wide = cross(start, end) < 0;  // more than half a turn
  return is_wide ? behind_start || before_end : behind_start && before_end;
}

double distance_to_line(PlaneVector point, const PlanePiece& line) {
  const PlaneVector way = line.to - line.from;
  const double length_sq = dot(way, way);
  if (length_sq == 0) return size(point - line.from);
  const double t = std::clamp(dot(point - line.from, way) / length_sq, 0.0, 1.0);
  return size(point - line.from - way * t);
}

double distance_to_arc(PlaneVector point, const PlanePiece& arc) {
  const PlaneVector v = point - arc.center;
  if (has_direction(arc, v)) return std::abs(size(v) - arc.radius);
  return std::min(size(point - arc.from), size(point - arc.to));
}

double distance_to(PlaneVector point, const PlanePiece& piece) {
  return piece.radius == 0 ? distance_to_line(point, piece) : distance_to_arc(point, piece);
}

bool lines_cross(const PlanePiece& a, const PlanePiece& b) {
  const PlaneVector way_a = a.to - a.from, way_b = b.to - b.from;
  return cross(way_a, b.from - a.from) * cross(way_a, b.to - a.from) < 0 &&
         cross(way_b, a.from - b.from) * cross(way_b, a.to - b.from) < 0;
}

/// Candidates 1 and 3 of a line and an arc.
double line_to_arc(const PlanePiece& line, const PlanePiece& arc) {
  const PlaneVector way = line.to - line.from;
  const double length_sq = dot(way, way);
  if (length_sq == 0) return kFar;
  const double foot = dot(arc.center - line.from, way) / length_sq;
  const PlaneVector v = line.from + way * foot - arc.center;
  const double distance = size(v);
  if (distance > arc.radius) return foot >= 0 && foot <= 1 && has_direction(arc, v) ? distance - arc.radius : kFar;
  const double half_chord = std::sqrt((arc.radius * arc.radius - distance * distance) / length_sq);
  for (const double t : {foot - half_chord, foot + half_chord})
    if (t >= 0 && t <= 1 && has_direction(arc, line.from + way * t - arc.center)) return 0;
  return kFar;
}

/// Candidates 1 and 3 of two arcs.
double arc_to_arc(const PlanePiece& a, const PlanePiece& b) {
  const PlaneVector between_centers = b.center - a.center;
  const double distance = size(between_centers);
  if (distance < 1e-9)  // common centre: the radii decide, where the arcs face each other
    return has_direction(a, b.from - b.center) || has_direction(b, a.from - a.center) ? std::abs(a.radius - b.radius)
                                                                                      : kFar;
  const PlaneVector unit = between_centers * (1 / distance);
  const double along = (distance * distance + a.radius * a.radius - b.radius * b.radius) / (2 * distance);
  const double across_sq = a.radius * a.radius - along * along;
  if (across_sq >= 0) {
    for (const double across : {std::sqrt(across_sq), -std::sqrt(across_sq)}) {
      const PlaneVector v = unit * along + left_of(unit) * across;
      if (has_direction(a, v) && has_direction(b, v - between_centers)) return 0;
    }
  }
  double nearest = kFar;
  for (const double side_a : {1.0, -1.0}) {
    if (!has_direction(a, unit * side_a)) continue;
    for (const double side_b : {1.0, -1.0})
      if (has_direction(b, unit * side_b))
        nearest = std::min(nearest, std::abs(distance + side_b * b.radius - side_a * a.radius));
  }
  return nearest;
}

/// The point of a piece that is no circle, at 0 <= t <= 1.
PlaneVector point_on(const PlanePiece& piece, double t) {
  if (piece.radius == 0) return between(piece.from, piece.to, t);
  const PlaneVector start = piece.from - piece.center, end = piece.to - piece.center;
  double sweep = std::atan2(cross(start, end), dot(start, end));
  if (sweep < 0) sweep += 2 * std::numbers::pi;
  return piece.center + start * std::cos(sweep * t) + left_of(start) * std::sin(sweep * t);
}

PlanePiece piece_of(const Arc& arc, const PlaneAxes& axes, PlaneVector from, PlaneVector to, double radius) {
  PlanePiece piece{.from = from, .to = to, .center = in_plane(arc.center, axes), .radius = radius};
  if (arc.turn == Turn::clockwise) std::swap(piece.from, piece.to);
  piece.lowest = std::min(arc.from.*axes.normal, arc.to.*axes.normal);
  piece.highest = std::max(arc.from.*axes.normal, arc.to.*axes.normal);
  return piece;
}

void append_arc(const Arc& arc, const PlaneAxes& axes, std::vector<PlanePiece>& pieces) {
  const PlaneVector from = in_plane(arc.from, axes), to = in_plane(arc.to, axes), center = in_plane(arc.center, axes);
  const double start_radius = size(from - center), end_radius = size(to - center);
  const auto steps = static_cast<int>(std::ceil(std::abs(end_radius - start_radius) / kSpiralStep_mm));
  if (steps <= 1) {
    pieces.push_back(piece_of(arc, axes, from, to, (start_radius + end_radius) / 2));
    pieces.back().is_circle = from == to;
    return;
  }
  const ArcShape shape = shape_of(arc);
  PlaneVector begin = from;
  for (int step = 1; step <= steps; ++step) {
    const Point at = point_at(arc, shape, shape.length * step / steps);
    const double radius = std::lerp(start_radius, end_radius, (step - 0.5) / steps);
    const PlaneVector end = in_plane(at, axes);
    pieces.push_back(piece_of(arc, axes, begin, end, radius));
    begin = end;
  }
}

}  // namespace

void append_pieces(const PathElement& element, const PlaneAxes& axes, std::vector<PlanePiece>& pieces) {
  if (const auto* arc = std::get_if<Arc>(&element)) return append_arc(*arc, axes, pieces);
  const auto& line = std::get<Line>(element);
  pieces.push_back({.from = in_plane(line.from, axes),
                    .to = in_plane(line.to, axes),
                    .lowest = std::min(line.from.*axes.normal, line.to.*axes.normal),
                    .highest = std::max(line.from.*axes.normal, line.to.*axes.normal)});
}

double distance_between(const PlanePiece& a, const PlanePiece& b) {
  double nearest = kFar;
  if (a.radius == 0 && b.radius == 0) {
    if (lines_cross(a, b)) return 0;
  } else if (a.radius == 0 || b.radius == 0) {
    nearest = a.radius == 0 ? line_to_arc(a, b) : line_to_arc(b, a);
  } else {
    nearest = arc_to_arc(a, b);
  }
  for (const PlaneVector end : {a.from, a.to}) nearest = std::min(nearest, distance_to(end, b));
  for (const PlaneVector end : {b.from, b.to}) nearest = std::min(nearest, distance_to(end, a));
  return nearest;
}

std::optional<PlanePiece> part_outside(const PlanePiece& piece, PlaneVector center, double radius_mm) {
  const auto is_inside = [&](PlaneVector point) { return size(point - center) < radius_mm; };
  const bool begins_inside = is_inside(piece.from), ends_inside = is_inside(piece.to);
  if (!begins_inside && !ends_inside) return piece;
  if (begins_inside && ends_inside) return std::nullopt;
  double inside = begins_inside ? 0 : 1, outside = 1 - inside;
  constexpr int kHalvings = 50;  // of ten metres: below a picometre
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = (inside + outside) / 2;
    (is_inside(point_on(piece, middle)) ? inside : outside) = middle;
  }
  PlanePiece part = piece;
  (begins_inside ? part.from : part.to) = point_on(piece, outside);
  return part;
}

PieceBox box_of(const PlanePiece& piece) {
  PieceBox box{.first_low = std::min(piece.from.first, piece.to.first),
               .first_high = std::max(piece.from.first, piece.to.first),
               .second_low = std::min(piece.from.second, piece.to.second),
               .second_high = std::max(piece.from.second, piece.to.second),
               .normal_low = piece.lowest,
               .normal_high = piece.highest};
  if (piece.radius == 0) return box;
  if (has_direction(piece, {1, 0})) box.first_high = piece.center.first + piece.radius;
  if (has_direction(piece, {-1, 0})) box.first_low = piece.center.first - piece.radius;
  if (has_direction(piece, {0, 1})) box.second_high = piece.center.second + piece.radius;
  if (has_direction(piece, {0, -1})) box.second_low = piece.center.second - piece.radius;
  return box;
}

namespace {

/// Every third bit of the result is one of the lowest 21 of `value`.
std::uint64_t spread(std::uint64_t value) {
  value &= 0x1fffff;
  value = (value | value << 32) & 0x001f00000000ffff;
  value = (value | value << 16) & 0x001f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  value = (value | value << 2) & 0x1249249249249249;
  return value;
}

void include(PieceBox& whole, const PieceBox& part) {
  whole.first_low = std::min(whole.first_low, part.first_low);
  whole.first_high = std::max(whole.first_high, part.first_high);
  whole.second_low = std::min(whole.second_low, part.second_low);
  whole.second_high = std::max(whole.second_high, part.second_high);
  whole.normal_low = std::min(whole.normal_low, part.normal_low);
  whole.normal_high = std::max(whole.normal_high, part.normal_high);
}

constexpr PieceBox kNowhere{kFar, -kFar, kFar, -kFar, kFar, -kFar};

}  // namespace

std::vector<std::uint32_t> order_in_space(const std::vector<PieceBox>& boxes) {
  constexpr double kSteps = 0x1fffff;
  PieceBox whole = kNowhere;
  for (const PieceBox& box : boxes) include(whole, box);
  const double widest = std::max({whole.first_high - whole.first_low, whole.second_high - whole.second_low,
                                  whole.normal_high - whole.normal_low, 1e-6});
  const auto step = [&](double low, double high, double origin) {
    return spread(static_cast<std::uint64_t>(((low + high) / 2 - origin) / widest * kSteps));
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(boxes.size());
  for (const PieceBox& box : boxes) {
    const std::uint64_t key = step(box.first_low, box.first_high, whole.first_low) |
                              step(box.second_low, box.second_high, whole.second_low) << 1 |
                              step(box.normal_low, box.normal_high, whole.normal_low) << 2;
    keys.emplace_back(key, static_cast<std::uint32_t>(keys.size()));
  }
  std::ranges::sort(keys);
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& [key, index] : keys) order.push_back(index);
  return order;
}

void PieceTree::plant(const std::vector<PieceBox>& boxes) {
  pieces_ = boxes.size();
  leaves_ = 1;
  while (leaves_ * kPiecesPerLeaf < pieces_) leaves_ *= 2;
  boxes_.assign(2 * leaves_, kNowhere);
  for (std::size_t piece = 0; piece < pieces_; ++piece) include(boxes_[leaves_ + piece / kPiecesPerLeaf], boxes[piece]);
  for (std::size_t node = leaves_; node-- > 1;) {
    boxes_[node] = boxes_[2 * node];
    include(boxes_[node], boxes_[2 * node + 1]);
  }
}

}  // namespace cnclab::geometry
