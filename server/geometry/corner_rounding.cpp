// Lines shortened, an arc between them (G-100; D-66).
//
//            t   C                 t = R · tan(bend / 2), on both lines
//      ═════════╭ ─ ┐
//      line 1   ┊ ╲               1. The arc is tangent to both; its block is that of the G10, its feed that of line 2.
//               R  ╲ t            2. Each line keeps its slope along the normal; the arc climbs evenly between the
//               ┊   ║                heights that are left, as a helix.
//             centre║ line 2      3. t must fit into what an earlier rounding has left of line 1, and into line 2.
//                                 4. Between lines that go straight on there is nothing to round.
//
// Only the block directly behind the first line's can be its G10 (L714: between two linear blocks). Blocks without any
// way may stand behind the G10; they take effect behind the arc.
#include "geometry/corner_rounding.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/offset_element.hpp"

namespace cnclab::geometry {

namespace {

/// The point of a line at a way in the plane from its end (`from_end`) or start.
Point point_beside_corner(const Line& line, const PlaneAxes& axes, double way, bool from_end) {
  const double length = size(in_plane(line.to, axes) - in_plane(line.from, axes));
  if (std::abs(way - length) <= kSamePoint_mm) return from_end ? line.from : line.to;
  const double t = from_end ? 1 - way / length : way / length;
  Point point = line.from;
  set_in_plane(point, axes, between(in_plane(line.from, axes), in_plane(line.to, axes), t));
  point.*axes.normal = std::lerp(line.from.*axes.normal, line.to.*axes.normal, t);
  return point;
}

}  // namespace

std::expected<void, StageFault> CornerRounder::push(const PathItem& item, std::vector<PathItem>& ready) {
  ready.clear();
  if (order_) return take_behind_order(item, ready);
  if (const auto* order = std::get_if<CornerRounding>(&item.what)) {
    const bool has_line = !queue_.empty() && moves_in_plane(std::get<Line>(queue_.front().what), axes_of(order->plane));
    if (!has_line) {
      release(ready);  // what is no line of the plane is right as it is
      return fault_at(StageFault::Kind::rounding_without_lines, item);
    }
    order_ = queue_.size();
    queue_.push_back(item);
    return {};
  }
  const bool is_way = std::holds_alternative<Line>(item.what) || std::holds_alternative<Arc>(item.what);
  if (!queue_.empty() && (is_way || item.sequence != queue_.front().sequence)) release(ready);
  if (!queue_.empty() || can_be_rounded(item))
    queue_.push_back(item);
  else
    ready.push_back(item);
  return {};
}

std::expected<void, StageFault> CornerRounder::flush(std::vector<PathItem>& ready) {
  ready.clear();
  if (order_) return fault_at(StageFault::Kind::rounding_without_lines, queue_[*order_]);
  release(ready);
  return {};
}

void CornerRounder::release(std::vector<PathItem>& ready) {
  ready.swap(queue_);
  queue_.clear();
}

std::expected<void, StageFault> CornerRounder::take_behind_order(const PathItem& item, std::vector<PathItem>& ready) {
  const PathItem& rounding = queue_[*order_];
  const auto fault = [&] { return fault_at(StageFault::Kind::rounding_without_lines, rounding); };
  if (std::holds_alternative<CornerRounding>(item.what) || std::holds_alternative<RadiusOffset>(item.what) ||
      std::holds_alternative<Arc>(item.what))
    return fault();
  const auto* line = std::get_if<Line>(&item.what);
  if (line == nullptr || line->from == line->to) {
    queue_.push_back(item);
    return {};
  }
  const bool is_second_line =
      can_be_rounded(item) && moves_in_plane(*line, axes_of(std::get<CornerRounding>(rounding.what).plane));
  if (!is_second_line) return fault();
  return round(item, ready);
}

std::expected<void, StageFault> CornerRounder::round(const PathItem& item, std::vector<PathItem>& ready) {
  PathItem& rounding = queue_[*order_];
  const auto order = std::get<CornerRounding>(rounding.what);
  const PlaneAxes& axes = axes_of(order.plane);
  auto& first = std::get<Line>(queue_.front().what);
  PathItem second_item = item;
  auto& second = std::get<Line>(second_item.what);

  const PlaneVector first_way = in_plane(first.to, axes) - in_plane(first.from, axes);
  const PlaneVector second_way = in_plane(second.to, axes) - in_plane(second.from, axes);
  const double first_length = size(first_way), second_length = size(second_way);
  const double sine = cross(first_way, second_way), cosine = dot(first_way, second_way);
  const double trim =
      order.radius_mm * std::abs(sine) / (first_length * second_length + cosine);  // tan of half the bend
  const double shorter = std::min(first_length, second_length);
  if (!(trim <= shorter + kSamePoint_mm))
    return fault_at(StageFault::Kind::rounding_too_large, rounding, shorter, std::isfinite(trim) ? trim : 0);
  if (trim <= kSamePoint_mm) {  // rule 4
    rounding.what = Mark{};
  } else {
    first.to = point_beside_corner(first, axes, trim, true);
    second.from = point_beside_corner(second, axes, trim, false);
    const PlaneVector inward = left_of(first_way) * (std::copysign(order.radius_mm, sine) / first_length);
    Arc arc{.from = first.to,
            .to = second.from,
            .center = first.to,
            .turn = sine > 0 ? Turn::counterclockwise : Turn::clockwise,
            .plane = order.plane,
            .feed_mm_per_min = second.feed_mm_per_min};
    set_in_plane(arc.center, axes, in_plane(first.to, axes) + inward);
    rounding.what = arc;
  }
  release(ready);
  order_.reset();
  queue_.push_back(second_item);
  return {};
}

}  // namespace cnclab::geometry
