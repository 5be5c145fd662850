// Random contours under G41 and G42 against the slow picture (COMP-004, COMP-009, COMP-011; D-71, DEC-09).
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>

#include "seeded.hpp"
#include "slow_contour.hpp"
#include "stage_rig.hpp"

namespace {

using namespace rig;
using std::numbers::pi;

constexpr double kMicrometre = 0.001;

/// How the contour goes on: by how much it bends at the joint, then straight or round.
struct Step {
  double bend = 0;    ///< radians, > 0 left
  double length = 0;  ///< mm, of a line
  double radius = 0;  ///< mm, of an arc; 0: a line
  double sweep = 0;   ///< radians, > 0 left
};

void showValue(const Step& step, std::ostream& os) {
  os << "{" << step.bend << ", " << step.length << ", " << step.radius << ", " << step.sweep << "}";
}

struct Contour {
  double radius = 0;
  bool is_left = false;
  std::vector<Step> steps;
};

/// Bends of all sizes: none, tiny ones on either side of a nanometre, and real corners.
rc::Gen<double> any_bend() {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 10), rc::gen::inRange(-1000, 1001)), [](auto drawn) {
    const auto [kind, part] = drawn;
    const double share = part / 1000.0;
    if (kind < 3) return 0.0;
    if (kind < 4) return share * 1e-9;
    if (kind < 5) return share * 1e-6;
    if (kind < 6) return share * 1e-3;
    if (kind < 9) return share * 0.5 * pi;
    return share * pi;
  });
}

rc::Gen<Step> any_step() {
  return rc::gen::map(rc::gen::tuple(any_bend(), rc::gen::inRange(0, 2), rc::gen::inRange(1, 40'000),
                                     rc::gen::inRange(500, 40'000), rc::gen::inRange(5, 360), rc::gen::inRange(0, 2)),
                      [](const auto& drawn) {
                        const auto& [bend, is_arc, length_um, radius_um, degrees, is_left] = drawn;
                        Step step{.bend = bend, .length = length_um / 1000.0};
                        if (is_arc != 0) {
                          step.radius = radius_um / 1000.0;
                          step.sweep = degrees / 180.0 * pi * (is_left != 0 ? 1 : -1);
                        }
                        return step;
                      });
}

/// Of the whole range from the first case on.
template <typename T>
T full(const rc::Gen<T>& gen) {
  return *rc::gen::resize(rc::kNominalSize, gen);
}

Contour any_contour() {
  Contour contour;
  contour.radius = full(rc::gen::inRange(100, 10'000)) / 1000.0;
  contour.is_left = *rc::gen::arbitrary<bool>();
  const auto count = static_cast<std::size_t>(full(rc::gen::inRange(1, 9)));
  contour.steps = full(rc::gen::container<std::vector<Step>>(count, any_step()));
  return contour;
}

/// The contour's elements from (0,0), first heading along X.
std::vector<PathElement> elements_of(const Contour& contour) {
  std::vector<PathElement> elements;
  Point at;
  double heading = 0;
  for (const Step& step : contour.steps) {
    heading += step.bend;
    Point to = at;
    if (step.radius == 0) {
      to.x += step.length * std::cos(heading);
      to.y += step.length * std::sin(heading);
      elements.emplace_back(Line{at, to, 1000});
    } else {
      const double sense = step.sweep > 0 ? 1 : -1;
      const double outward = heading - sense * pi / 2;  // from the centre to the start
      const Point center{at.x - step.radius * std::cos(outward), at.y - step.radius * std::sin(outward)};
      to.x = center.x + step.radius * std::cos(outward + step.sweep);
      to.y = center.y + step.radius * std::sin(outward + step.sweep);
      elements.emplace_back(Arc{at, to, center, sense > 0 ? Turn::counterclockwise : Turn::clockwise, Plane::xy, 1000});
      heading += step.sweep;
    }
    at = to;
  }
  return elements;
}

/// Entry from afar, the contour (blocks from 3 on), nothing behind it.
Part part_of(const Contour& contour, const std::vector<PathElement>& elements) {
  Part part;
  part.from(-50, -30).radius(contour.is_left ? OffsetSide::left : OffsetSide::right, contour.radius).line(0, 0);
  for (const PathElement& element : elements) std::visit([&](const auto& way) { part.add(way); }, element);
  return part;
}

/// A way of the tool's centre, and the index of the element that it belongs to.
struct WayBeside {
  std::size_t index = 0;
  PathElement way;
  bool is_corner = false;  ///< an arc about the element's start
};

/// The ways beside the contour, without the entry.
std::vector<WayBeside> ways_beside(const Outcome& outcome) {
  std::vector<WayBeside> ways;
  for (const PathItem& item : outcome.items) {
    if (item.source.block < kFirstBlock) continue;
    const std::size_t index = item.source.block - kFirstBlock;
    if (!ways.empty() && ways.back().index == index) ways.back().is_corner = true;
    if (const auto* line = std::get_if<Line>(&item.what)) ways.push_back({index, *line, false});
    if (const auto* arc = std::get_if<Arc>(&item.what)) ways.push_back({index, *arc, false});
  }
  return ways;
}

double gap_between(const PathElement& before, const PathElement& after) {
  return slow::distance(slow::spot_at(before, 1), slow::spot_at(after, 0));
}

/// Each way keeps the radius from its element, a corner arc from its corner, and the ways are joined.
void assert_beside(const std::vector<WayBeside>& ways, const std::vector<PathElement>& contour, double radius) {
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const WayBeside& beside = ways[i];
    for (const double t : {0.0, 0.37, 0.81, 1.0}) {
      const slow::Spot spot = slow::spot_at(beside.way, t);
      const double found = beside.is_corner ? slow::distance(spot, slow::spot_at(contour[beside.index], 0))
                                            : slow::distance(spot, contour[beside.index]);
      RC_ASSERT(std::abs(found - radius) < 1e-6);
    }
    if (i > 0) RC_ASSERT(gap_between(ways[i - 1].way, beside.way) <= 1e-6);
  }
}

/// No way comes too close to any element unless the check says so, and it says nothing else.
void assert_gouges(const std::vector<WayBeside>& ways, const std::vector<PathElement>& contour, double radius,
                   const std::vector<StageFault>& gouges) {
  std::map<std::pair<std::size_t, std::size_t>, double> nearest;
  for (const auto& [index, way, is_corner] : ways) {
    for (std::size_t wall = 0; wall < contour.size(); ++wall) {
      if (wall == index && !is_corner) continue;  // `assert_beside` has seen it
      const double found = slow::distance(way, contour[wall], radius - kMicrometre / 2);
      const auto [place, is_new] = nearest.try_emplace({index, wall}, found);
      if (!is_new) place->second = std::min(place->second, found);
    }
  }
  for (const auto& [pair, found] : nearest) {
    const auto reported = std::ranges::find_if(gouges, [&, &where = pair](const StageFault& fault) {
      return fault.block.block == where.first + kFirstBlock && fault.other.block == where.second + kFirstBlock;
    });
    if (reported != gouges.end())
      RC_ASSERT(std::abs(reported->found_mm - found) < kMicrometre);
    else if (gouges.size() < ContourCheck::kMostFindings)
      RC_ASSERT(found > radius - 1.6 * kMicrometre);  // rounding to 1/1000 is no cut
  }
}

/// Where the ways beside element `index` - 1 and `index` may join: at the corner, or where they cross at an inside one.
std::vector<slow::Crossing> joints_before(const Contour& contour, const std::vector<PathElement>& elements,
                                          std::size_t index) {
  if (index == 0 || index >= elements.size()) return {{}};
  const double bend = contour.steps[index].bend;
  const bool is_inside = std::abs(bend) > 1e-5 && (bend > 0) == contour.is_left;
  if (!is_inside) return {{}};
  return slow::crossings(elements[index - 1], elements[index], contour.is_left ? contour.radius : -contour.radius);
}

/// Do no joints at both ends of the element leave a way between them?
bool is_impossible(const Contour& contour, const std::vector<PathElement>& elements, std::size_t index) {
  const auto at_start = joints_before(contour, elements, index), at_end = joints_before(contour, elements, index + 1);
  if (at_start.empty() || at_end.empty()) return true;
  double first = 1, last = 0;
  for (const slow::Crossing& joint : at_start) first = std::min(first, joint.after);
  for (const slow::Crossing& joint : at_end) last = std::max(last, joint.before);
  constexpr double kChord = 0.005;  // two of the chords that crossings are found by
  return first > last - kChord;
}

bool is_closed(const std::vector<PathElement>& contour) {
  for (std::size_t first = 0; first < std::min<std::size_t>(3, contour.size()); ++first)
    for (std::size_t last = first; last < contour.size(); ++last)
      if (slow::distance(slow::spot_at(contour[first], 0), slow::spot_at(contour[last], 1)) < 1e-3) return true;
  return false;
}

RC_GTEST_PROP(RandomContours, RunBesideTheContourOrNameAnElementThatCannotBe, ()) {
  const Contour contour = any_contour();
  const std::vector<PathElement> elements = elements_of(contour);
  const Outcome outcome = run(part_of(contour, elements));
  expect_sound(outcome, "random");
  const auto ways = ways_beside(outcome);
  assert_beside(ways, elements, contour.radius);
  std::vector<PathElement> known = elements;
  if (outcome.fault) {
    RC_ASSERT(outcome.fault->block.block >= kFirstBlock);
    const std::size_t blamed = outcome.fault->block.block - kFirstBlock;
    RC_TAG(std::string("fault"));
    if (outcome.fault->kind == StageFault::Kind::inside_arc_too_small) {
      RC_ASSERT(contour.steps[blamed].radius < contour.radius);
      RC_ASSERT((contour.steps[blamed].sweep > 0) == contour.is_left);
    } else {
      RC_ASSERT(is_impossible(contour, elements, blamed));
    }
    std::size_t complete = 0;  // elements whose way has left
    for (const WayBeside& beside : ways) complete = std::max(complete, beside.index + 1);
    known.resize(complete);
  } else {
    RC_TAG(std::string("followed"));
    const double to_left = contour.is_left ? contour.radius : -contour.radius;
    const slow::Spot begin = slow::spot_at(elements.front(), 0, to_left);
    const slow::Spot end = slow::spot_at(elements.back(), 1, to_left);
    RC_ASSERT(slow::distance(slow::spot_at(ways.front().way, 0), begin) < 1e-6);
    RC_ASSERT(slow::distance(slow::spot_at(ways.back().way, 1), end) < 1e-6);
  }
  if (!is_closed(known)) assert_gouges(ways, known, contour.radius, outcome.gouges);
}

/// Long contours with gentle bends and a small tool, which wander and come near themselves.
rc::Gen<Step> gentle_step() {
  return rc::gen::map(rc::gen::tuple(rc::gen::inRange(-1000, 1001), rc::gen::inRange(0, 3),
                                     rc::gen::inRange(3'000, 15'000), rc::gen::inRange(-120, 121)),
                      [](const auto& drawn) {
                        const auto& [bend, kind, length_um, degrees] = drawn;
                        Step step{.bend = bend / 1000.0 * 0.4, .length = length_um / 1000.0};
                        if (kind == 0 && degrees != 0) {
                          step.radius = step.length;
                          step.sweep = degrees / 180.0 * pi;
                        }
                        return step;
                      });
}

RC_GTEST_PROP(RandomContours, GougesOfLongContoursAreAllFound, ()) {
  Contour contour;
  contour.radius = full(rc::gen::inRange(200, 2'000)) / 1000.0;
  contour.is_left = *rc::gen::arbitrary<bool>();
  contour.steps = full(rc::gen::container<std::vector<Step>>(std::size_t{30}, gentle_step()));
  const std::vector<PathElement> elements = elements_of(contour);
  const Outcome outcome = run(part_of(contour, elements));
  RC_TAG(std::string(outcome.fault ? "fault" : outcome.gouges.empty() ? "clean" : "gouges"));
  if (outcome.fault || is_closed(elements)) return;
  assert_gouges(ways_beside(outcome), elements, contour.radius, outcome.gouges);
}

}  // namespace
