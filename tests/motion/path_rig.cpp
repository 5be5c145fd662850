// The rules of motion, checked on what came out of the ticks.
#include "path_rig.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cnclab::motion {

namespace {

using geometry::Arc;
using geometry::Line;
using geometry::Point;

double distance(const Point& a, const Point& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z) +
                   (a.u - b.u) * (a.u - b.u));
}

/// Directions by differences of points, so that the library's own directions are not their own judge.
Point heading(const Segment& segment, bool at_end) {
  const double h = std::min(1e-5, segment.length_mm / 2);
  const double way = at_end ? segment.length_mm - h : 0;
  Point a, b;
  if (const auto* line = std::get_if<Line>(&segment.item.what)) {
    a = line->from;
    b = line->to;
  } else {
    const auto& arc = std::get<Arc>(segment.item.what);
    a = geometry::point_at(arc, segment.arc, way);
    b = geometry::point_at(arc, segment.arc, way + h);
  }
  const double d = distance(a, b);
  return {(b.x - a.x) / d, (b.y - a.y) / d, (b.z - a.z) / d, (b.u - a.u) / d};
}

/// How far the point is from the segment's curve (lines: from the infinite line; arcs: from circle and plane).
double off_path(const Segment& segment, const Point& p) {
  if (const auto* line = std::get_if<Line>(&segment.item.what)) {
    const double length = distance(line->from, line->to);
    const double along = distance(line->from, p);
    const double back = distance(p, line->to);
    return along + back - length;
  }
  const auto& arc = std::get<Arc>(segment.item.what);
  const auto& axes = geometry::axes_of(arc.plane);
  const double radius = std::hypot(p.*axes.first - arc.center.*axes.first, p.*axes.second - arc.center.*axes.second);
  const double low = std::min(segment.arc.start_radius, segment.arc.end_radius);
  const double high = std::max(segment.arc.start_radius, segment.arc.end_radius);
  return std::max({low - radius, radius - high, 0.0});
}

std::string speed_rule(const PathRig& rig, std::size_t i) {
  const Sample& now = rig.samples()[i];
  const double before = i == 0 ? 0 : rig.samples()[i - 1].speed;
  const double ramp = rig.limits().acceleration_mm_per_s2 * rig.tick_s() * (1 + 1e-6) + 1e-9;
  const double jump = rig.limits().start_stop_mm_per_s * (1 + 1e-6);
  const bool from_rest = before == 0, to_rest = now.speed == 0;
  if (from_rest && now.speed > jump + ramp) return fmt::format("starts with {} mm/s", now.speed);
  if (to_rest && before > jump + ramp) return fmt::format("stops from {} mm/s", before);
  if (!from_rest && !to_rest && std::abs(now.speed - before) > ramp) {
    return fmt::format("accelerates from {} to {} mm/s in a tick", before, now.speed);
  }
  if (to_rest || now.front >= rig.segments().size()) return {};
  const Segment& segment = rig.segments()[now.front];
  if (!segment.is_motion) return {};
  const double ratio = segment.item.override_off ? 1 : now.demand.override_ratio;
  const double cap = std::min(ratio * segment.feed_mm_per_s, segment.speed_mm_per_s) * (1 + 1e-6) + 1e-9;
  // Above the potentiometer's speed only on the ramp down to it.
  if (now.speed > cap && now.speed > before - ramp * (1 - 1e-5) && !now.demand.stop) {
    return fmt::format("{} mm/s where {} are allowed", now.speed, cap);
  }
  if (now.speed > segment.speed_mm_per_s * (1 + 1e-6) + 1e-9)
    return fmt::format("{} mm/s above the segment's", now.speed);
  return {};
}

/// Every joint passed in motion within this tick.
std::string joint_rule(const PathRig& rig, std::size_t i) {
  const Sample& now = rig.samples()[i];
  if (i == 0 || now.front == now.front_before) return {};
  const double entered = rig.samples()[i - 1].speed, ramp = rig.limits().acceleration_mm_per_s2 * rig.tick_s();
  const Segment* before = nullptr;
  for (std::uint64_t number = now.front_before; number <= now.front && number < rig.segments().size(); ++number) {
    const Segment& segment = rig.segments()[number];
    if (!segment.is_motion) continue;
    if (before != nullptr && now.speed > 0) {
      const double allowed = allowed_at_joint(*before, segment, rig.limits()) + ramp * (1 + 1e-6) + 1e-6;
      if (now.speed > allowed && entered > allowed) {
        return fmt::format("joint before segment {} passed with {} to {} mm/s, allowed are {}", number, entered,
                           now.speed, allowed);
      }
    }
    before = &segment;
  }
  return {};
}

/// The axes' own velocities, from positions alone: between two ticks none steps by more than F START/STOP and what the
/// ramp and the bend of an arc add. Only where at most one joint lies in these ticks.
std::string axis_rule(const PathRig& rig, std::size_t i) {
  if (i < 2 || rig.samples()[i].front > rig.samples()[i - 1].front_before + 1) return {};
  const Point b = rig.samples()[i - 2].position, c = rig.samples()[i - 1].position, d = rig.samples()[i].position;
  const double ramp = rig.limits().acceleration_mm_per_s2 * rig.tick_s();
  const double allowed = rig.limits().start_stop_mm_per_s * (1 + 1e-6) + 2 * ramp + 1e-6;
  for (const double step : {(d.x - c.x) - (c.x - b.x), (d.y - c.y) - (c.y - b.y), (d.z - c.z) - (c.z - b.z)}) {
    const double change = std::abs(step) / rig.tick_s();
    if (change > allowed) return fmt::format("an axis steps by {} mm/s, allowed are {}", change, allowed);
  }
  return {};
}

std::string place_rule(const PathRig& rig, std::size_t i, const Point& previous) {
  const Sample& now = rig.samples()[i];
  const double fastest = std::max(rig.limits().f_max_mm_per_s, 0.0) * rig.tick_s() * (1 + 1e-6) + 1e-9;
  if (distance(previous, now.position) > fastest) return "moved further than F MAX allows";
  if (now.speed > 0 && now.front < rig.segments().size() && rig.segments()[now.front].is_motion) {
    const double off = off_path(rig.segments()[now.front], now.position);
    if (off > 1e-7) return fmt::format("{} mm off the path", off);
  }
  const double before = i == 0 ? 0 : rig.samples()[i - 1].speed;
  const bool turns = i > 0 && before == 0 && now.speed == 0 && distance(previous, now.position) > 1e-9;
  const double jump_way = rig.limits().start_stop_mm_per_s * rig.tick_s() * (1 + 1e-3) + 1e-9;
  if (turns && distance(previous, now.position) > jump_way * 2) return "jumped between two rests";
  return {};
}

}  // namespace

double allowed_at_joint(const Segment& before, const Segment& after, const Limits& limits) {
  const Point in = heading(before, true), out = heading(after, false);
  double allowed = std::min(before.speed_mm_per_s, after.speed_mm_per_s);
  for (const double step : {out.x - in.x, out.y - in.y, out.z - in.z, out.u - in.u}) {
    if (std::abs(step) > 1e-12) allowed = std::min(allowed, limits.start_stop_mm_per_s / std::abs(step));
  }
  return allowed;
}

std::string broken_rule(const PathRig& rig, Point start) {
  Point previous = start;
  for (std::size_t i = 0; i < rig.samples().size(); ++i) {
    std::string broken = speed_rule(rig, i);
    if (broken.empty()) broken = joint_rule(rig, i);
    if (broken.empty()) broken = axis_rule(rig, i);
    if (broken.empty()) broken = place_rule(rig, i, previous);
    if (!broken.empty()) return fmt::format("tick {}: {}", i, broken);
    previous = rig.samples()[i].position;
  }
  return {};
}

}  // namespace cnclab::motion
