// Lines and circles of a drawing.
#include "drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cnclab::lesson {

namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

struct PlaneAxes {
  int first, second;
};

PlaneAxes axes_of(Plane plane) {
  switch (plane) {
    case Plane::xy:
      return {0, 1};
    case Plane::xz:
      return {2, 0};
    case Plane::yz:
      return {1, 2};
  }
  return {0, 1};
}

}  // namespace

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

Element::Element(const Point& from, const Curve& curve) : from_(from) {
  if (const auto* line = std::get_if<Line>(&curve)) {
    to_ = line->to;
    length_ = distance(from_, to_);
  } else {
    make_round(std::get<Arc>(curve));
  }
}

void Element::make_round(const Arc& arc) {
  const auto [first, second] = axes_of(arc.plane);
  const auto u = static_cast<std::size_t>(first);
  const auto v = static_cast<std::size_t>(second);
  to_ = arc.to;
  Round round{.first = first, .second = second, .centre = arc.centre};
  const double from_u = from_[u] - arc.centre[u], from_v = from_[v] - arc.centre[v];
  const double to_u = to_[u] - arc.centre[u], to_v = to_[v] - arc.centre[v];
  round.radius_from = std::hypot(from_u, from_v);
  round.radius_to = std::hypot(to_u, to_v);
  round.angle_from = std::atan2(from_v, from_u);
  double sweep = std::atan2(to_v, to_u) - round.angle_from;
  const bool full = distance(from_, to_) < 1e-9;
  if (arc.turn == Turn::ccw) {
    while (sweep <= 1e-12) sweep += kFullTurn;
    round.sweep = full ? kFullTurn : sweep;
  } else {
    while (sweep >= -1e-12) sweep -= kFullTurn;
    round.sweep = full ? -kFullTurn : sweep;
  }
  length_ = std::abs(round.sweep) * (round.radius_from + round.radius_to) / 2;
  round_ = round;
}

Point Element::at(double way_mm) const {
  const double part = length_ > 0 ? std::clamp(way_mm / length_, 0.0, 1.0) : 1.0;
  Point point{};
  for (std::size_t i = 0; i < 3; ++i) point[i] = from_[i] + part * (to_[i] - from_[i]);
  if (const auto* round = std::get_if<Round>(&round_)) {
    const double angle = round->angle_from + part * round->sweep;
    const double radius = round->radius_from + part * (round->radius_to - round->radius_from);
    const auto u = static_cast<std::size_t>(round->first);
    const auto v = static_cast<std::size_t>(round->second);
    point[u] = round->centre[u] + radius * std::cos(angle);
    point[v] = round->centre[v] + radius * std::sin(angle);
  }
  return point;
}

double Element::nearest(const Point& p, double low, double high) const {
  low = std::clamp(low, 0.0, length_);
  high = std::clamp(high, low, length_);
  if (std::holds_alternative<Round>(round_)) return nearest_on_arc(p, low, high);
  if (length_ <= 0) return 0;
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) along += (p[i] - from_[i]) * (to_[i] - from_[i]) / length_;
  return std::clamp(along, low, high);
}

// The angle of `p` about the centre gives the way; the radius changes so little with the angle (one step in a turn)
// that the foot of the perpendicular lies there to 1e-6 mm.
double Element::nearest_on_arc(const Point& p, double low, double high) const {
  const auto& round = std::get<Round>(round_);
  const auto u = static_cast<std::size_t>(round.first);
  const auto v = static_cast<std::size_t>(round.second);
  const double angle = std::atan2(p[v] - round.centre[v], p[u] - round.centre[u]);
  const double turned = (angle - round.angle_from) * (round.sweep < 0 ? -1 : 1);
  const double radius = length_ / std::abs(round.sweep);
  double best = low;
  double best_gap = distance(p, at(low));
  for (const double full_turns : {-1.0, 0.0, 1.0, 2.0}) {
    const double way = std::clamp((turned + full_turns * kFullTurn) * radius, low, high);
    if (const double gap = distance(p, at(way)); gap < best_gap) {
      best = way;
      best_gap = gap;
    }
  }
  return best;
}

Drawing::Drawing(const std::vector<Curve>& curves) {
  std::array<bool, 3> moves{};
  for (const Curve& curve : curves) {
    const Element& element = elements_.emplace_back(end_, curve);
    length_ += element.length_mm();
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      const Point point = element.at(part * element.length_mm());
      for (std::size_t i = 0; i < 3; ++i) moves[i] = moves[i] || std::abs(point[i] - end_[i]) > 1e-9;
    }
    end_ = element.at(element.length_mm());
  }
  moving_axes_ = static_cast<int>(std::ranges::count(moves, true));
}

}  // namespace cnclab::lesson
