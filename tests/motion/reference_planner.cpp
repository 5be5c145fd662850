// Pieces with constant limits, then the two passes.
#include "reference_planner.hpp"

#include <algorithm>
#include <cmath>

#include "path_rig.hpp"

namespace cnclab::motion {

namespace {

/// A way along which one speed limit holds, and how it may be left.
struct Way {
  double length = 0, cap = 0;
  double joint = 0;  ///< greatest speed at its end in motion
  bool stops = false;
};

bool is_rapid(const Segment& segment) {
  const auto* line = std::get_if<geometry::Line>(&segment.item.what);
  return line != nullptr && line->is_rapid;
}

/// Exact stop: the ramp ends where creeping begins.
void add_way(std::vector<Way>& ways, const Segment& segment, const Limits& limits) {
  const double creep_mm = segment.item.exact_stop ? std::min(limits.creep_way_mm, segment.length_mm) : 0;
  const double creep = std::min(limits.start_stop_mm_per_s / 2, segment.speed_mm_per_s);
  if (segment.length_mm > creep_mm) ways.push_back({segment.length_mm - creep_mm, segment.speed_mm_per_s, 0, false});
  if (creep_mm <= 0) return;
  if (segment.length_mm > creep_mm) ways.back().joint = creep;
  ways.push_back({creep_mm, creep, 0, false});
}

std::vector<Way> ways_of(const std::vector<Segment>& segments, const Limits& limits, double& dwell_s) {
  std::vector<Way> ways;
  const Segment* before = nullptr;
  for (const Segment& segment : segments) {
    if (const auto* dwell = std::get_if<geometry::Dwell>(&segment.item.what)) dwell_s += dwell->seconds;
    if (segment.stops_before && !ways.empty()) ways.back().stops = true;
    if (!segment.is_motion) continue;
    if (before != nullptr) {
      ways.back().joint = allowed_at_joint(*before, segment, limits);
      if (is_rapid(*before) || is_rapid(segment) || before->item.exact_stop) ways.back().stops = true;
    }
    add_way(ways, segment, limits);
    before = &segment;
  }
  if (!ways.empty()) ways.back().stops = true;
  return ways;
}

/// Entered with `in`, left with `out`, never above `cap`: up the ramp, along, down the ramp.
double time_of(const Way& way, double in, double out, double a) {
  const double peak = std::min(way.cap, std::sqrt((2 * a * way.length + in * in + out * out) / 2));
  const double ramps = (2 * peak * peak - in * in - out * out) / (2 * a);
  return (2 * peak - in - out) / a + std::max(0.0, way.length - ramps) / peak;
}

}  // namespace

ReferenceTime reference_time(const std::vector<Segment>& segments, const Limits& limits) {
  const double a = limits.acceleration_mm_per_s2, jump = limits.start_stop_mm_per_s;
  ReferenceTime sum;
  const std::vector<Way> ways = ways_of(segments, limits, sum.seconds);
  std::vector<double> out(ways.size());
  double next_entry = 0;  // backward: how fast the way behind may be entered
  for (std::size_t i = ways.size(); i-- > 0;) {
    out[i] = ways[i].stops ? std::min(jump, ways[i].cap) : std::min(ways[i].joint, next_entry);
    next_entry = std::min(ways[i].cap, std::sqrt(out[i] * out[i] + 2 * a * ways[i].length));
  }
  double in = ways.empty() ? 0 : std::min({jump, ways[0].cap, next_entry});
  for (std::size_t i = 0; i < ways.size(); ++i) {  // forward: what the ramp reaches
    const double reached = std::min(out[i], std::sqrt(in * in + 2 * a * ways[i].length));
    sum.seconds += time_of(ways[i], in, reached, a);
    sum.rests += ways[i].stops ? 1 : 0;
    const bool is_last = i + 1 == ways.size();
    if (is_last) break;
    const Way& next = ways[i + 1];
    const double entry = std::sqrt(out[i + 1] * out[i + 1] + 2 * a * next.length);
    in = ways[i].stops ? std::min({jump, next.cap, entry}) : reached;
  }
  return sum;
}

}  // namespace cnclab::motion
