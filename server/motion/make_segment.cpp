// What motion must know of a path item: its length, its own speed limits, whether it needs standstill.
#include <algorithm>
#include <cmath>

#include "motion/planner.hpp"

namespace cnclab::motion {

namespace {

/// Ways below this are passed like a mark: 1/100 000 of the finest usual step.
constexpr double kShortestWay_mm = 1e-8;

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

bool needs_standstill(const geometry::PathItem& item) {
  using namespace geometry;
  return std::visit(Overloaded{
                        [](const Dwell&) { return true; },
                        [](const Wait&) { return true; },
                        [](const Reference&) { return true; },
                        [](const Halt&) { return true; },
                        [](const End&) { return true; },
                        [](const Line&) { return false; },
                        [](const Arc&) { return false; },
                        [](const Spindle&) { return false; },
                        [](const Coolant&) { return false; },
                        [](const ToolChange&) { return false; },
                        [](const Output&) { return false; },
                        [](const SetActual&) { return false; },
                        [](const Signal&) { return false; },
                        [](const SpindleDigits&) { return false; },
                        [](const Mark&) { return false; },
                        [](const RadiusOffset&) { return false; },
                        [](const LengthOffset&) { return false; },
                        [](const CornerRounding&) { return false; },
                    },
                    item.what);
}

/// Where the radii of both ends differ (D-55) equal angles are unequal ways: mean way over the longest.
double evenness(const geometry::ArcShape& arc) {
  if (arc.start_radius == arc.end_radius) return 1;
  const double longest = std::hypot(std::max(arc.start_radius, arc.end_radius) * arc.sweep,
                                    arc.end_radius - arc.start_radius, arc.normal_way);
  return arc.length / longest;
}

void set_way(Segment& segment, double length_mm, double feed_mm_per_min, const Limits& limits) {
  segment.is_motion = length_mm >= kShortestWay_mm;
  segment.length_mm = segment.is_motion ? length_mm : 0;
  segment.feed_mm_per_s = std::min(feed_mm_per_min / 60, limits.f_max_mm_per_s);
  segment.speed_mm_per_s = segment.feed_mm_per_s;
  const bool creeps = segment.item.exact_stop && limits.creep_way_mm > 0;
  segment.creep_from_mm = creeps ? std::max(0.0, segment.length_mm - limits.creep_way_mm) : segment.length_mm;
}

}  // namespace

Segment make_segment(const geometry::PathItem& item, std::uint64_t run, const Limits& limits) {
  Segment segment;
  segment.item = item;
  segment.run = run;
  segment.stops_before = needs_standstill(item);
  if (const auto* line = std::get_if<geometry::Line>(&item.what)) {
    set_way(segment, geometry::length_of(*line), line->feed_mm_per_min, limits);
  } else if (const auto* arc = std::get_if<geometry::Arc>(&item.what)) {
    segment.arc = geometry::shape_of(*arc);
    set_way(segment, segment.arc.length, arc->feed_mm_per_min, limits);
    segment.feed_mm_per_s *= evenness(segment.arc);
    // Centripetal acceleration v²/r within the ramp's; the smaller radius where both ends differ (D-55).
    const double radius_mm = std::min(segment.arc.start_radius, segment.arc.end_radius);
    const double bend = std::sqrt(limits.acceleration_mm_per_s2 * radius_mm);
    segment.speed_mm_per_s = std::min(segment.feed_mm_per_s, bend);
  }
  return segment;
}

}  // namespace cnclab::motion
