// Entry and exit of a contour: what cuts into a wall is told, what does not is not (COMP-007, DEC-09).
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <numbers>
#include <string>

#include "geometry/plane_vector.hpp"
#include "seeded.hpp"
#include "stage_rig.hpp"

namespace {

using namespace rig;
using Kind = StageFault::Kind;

/// A square room of 40 mm, entered in the middle of its lower side; blocks 3 to 7, G40 is 8, the exit 9.
void room(Part& part) { part.line(40, 0).line(40, 40).line(0, 40).line(0, 0).line(20, 0).off(); }

/// A square of 40 mm, from its corner round it to the same; blocks 3 to 6.
Part& square(Part& part) { return part.line(0, 0).line(40, 0).line(40, 40).line(0, 40).line(0, 0); }

struct Row {
  std::string name;
  void (*program)(Part&);
  std::optional<Kind> kind;  ///< of the first finding; nothing: none at all
  int block = 0, other = 0;
};

std::vector<Row> closed_rows() {
  return {
      {"inside, from inside", [](Part& p) { room(p.from(20, 20).left(5).line(20, 0)); }, {}},
      {"inside, from outside", [](Part& p) { room(p.from(20, -20).left(5).line(20, 0)); }, Kind::entry_too_close, 2, 7},
      {"inside, from outside through the far wall", [](Part& p) { room(p.from(20, 60).left(5).line(20, 0)); },
       Kind::entry_too_close, 2, 5},
      {"inside, from outside, set down too near", [](Part& p) { room(p.from(36, 20).left(5).line(20, 0)); },
       Kind::entry_too_close, 2, 4},
      {"inside, from outside, above the walls",
       [](Part& p) { room(p.from(20, -20, 3).left(5).line(20, 0).normal(0)); },
       {}},
      {"inside, from outside, falling all the way",
       [](Part& p) { room(p.from(20, -20, 3).left(5).line(20, 0, 0)); },
       {}},
      {"inside, from outside, below the walls",
       [](Part& p) { room(p.from(20, -20, -3).left(5).line(20, 0).normal(0)); }, Kind::entry_too_close, 2, 8},
      {"outside, from outside", [](Part& p) { room(p.from(20, -20).right(5).line(20, 0)); }, {}},
      {"outside, from inside", [](Part& p) { room(p.from(20, 20).right(5).line(20, 0)); }, Kind::entry_too_close, 2, 7},
      {"outside, along the first wall's own line: its corner is brushed",
       [](Part& p) { square(p.from(-20, 0).right(5)); }, Kind::entry_too_close, 2, 3},
      {"outside, along the tool's own line", [](Part& p) { square(p.from(-20, -5).right(5)); }, {}},
      {"outside, slanted towards the corner", [](Part& p) { square(p.from(-20, -20).right(5)); }, {}},
      {"outside, from behind the first wall across the corner", [](Part& p) { square(p.from(-20, 20).right(5)); },
       Kind::entry_too_close, 2, 3},
      {"the same from nearer", [](Part& p) { square(p.from(-8, 8).right(5)); }, Kind::entry_too_close, 2, 6},
      {"outside, left beside the last wall", [](Part& p) { square(p.from(0, -20).right(5)).off().line(-5, -20); }, {}},
      {"outside, left across the corner", [](Part& p) { square(p.from(0, -20).right(5)).off().line(25, -20); },
       Kind::exit_too_close, 8, 6},
      {"outside, along the last wall: it is cut",
       [](Part& p) { p.from(0, 20).right(5).line(0, 0).line(40, 0).line(40, 40).line(0, 40).line(0, 0); },
       Kind::entry_too_close, 2, 6},
      {"outside, square to the wall at a corner", [](Part& p) { square(p.from(0, -20).right(5)); }, {}},
  };
}

std::vector<Row> open_rows() {
  return {
      {"open, across its own beginning",
       [](Part& p) { p.from(0, 0).right(5).line(20, 0).line(20, 30).off().line(0, 30); },
       {}},
      {"open, across its first wall",
       [](Part& p) { p.from(0, 20).right(5).line(20, 0).line(20, 30).off().line(40, 30); }, Kind::entry_too_close, 2,
       3},
      {"open, the same in more blocks",
       [](Part& p) { p.from(0, 0).right(5).line(20, 0).line(20, 2).line(20, 4).line(20, 30).off().line(0, 30); },
       {}},
      {"open, along its first wall's own line", [](Part& p) { p.from(0, 0).right(5).line(20, 0).line(50, 0); }, {}},
      {"open, slanted over its beginning",
       [](Part& p) { p.from(0, 3).right(5).line(20, 0).line(20, 30).off().line(40, 30); }, Kind::entry_too_close, 2, 3},
      {"open, the same in more blocks",
       [](Part& p) { p.from(0, 3).right(5).line(20, 0).line(20, 4).line(20, 30).off().line(40, 30); },
       Kind::entry_too_close, 2, 4},
      {"open, slanted away from its beginning",
       [](Part& p) { p.from(0, -3).right(5).line(20, 0).line(20, 30).off().line(40, 30); },
       {}},
      {"open, its first wall round, across its beginning",
       [](Part& p) { p.from(-10, 0).right(5).line(0, 0).ccw(-20, 20, -20, 0); }, Kind::entry_too_close, 2, 3},
      {"open, across its end", [](Part& p) { p.from(40, 0).right(5).line(20, 0).line(20, 30).off().line(0, 30); }, {}},
      {"open, slanted over its end",
       [](Part& p) { p.from(40, 0).right(5).line(20, 0).line(20, 26).line(20, 30).off().line(0, 27); },
       Kind::exit_too_close, 6, 3},
  };
}

std::vector<Row> exit_rows() {
  return {
      {"left to the inside", [](Part& p) { room(p.from(20, 20).left(5).line(20, 0)), p.line(20, 20); }, {}},
      {"left through a wall", [](Part& p) { room(p.from(20, 20).left(5).line(20, 0)), p.line(20, -20); },
       Kind::exit_too_close, 9, 3},
      {"left above the walls",
       [](Part& p) { room(p.from(20, 20).left(5).line(20, 0)), p.normal(3).line(20, -20); },
       {}},
      {"left rising all the way", [](Part& p) { room(p.from(20, 20).left(5).line(20, 0)), p.line(20, -20, 3); }, {}},
      {"left onto the contour itself",
       [](Part& p) { room(p.from(20, 20).left(5).line(20, 0)), p.line(20, 0).named(3); }, Kind::exit_too_close, 9, 3},
  };
}

std::vector<Row> round_rows() {
  return {
      {"round pocket, from its middle",
       [](Part& p) { p.from(0, 0).left(5).line(20, 0).ccw(20, 0, 0, 0).off().line(0, 0); },
       {}},
      {"round pocket, from outside",
       [](Part& p) { p.from(40, 0).left(5).line(20, 0).ccw(20, 0, 0, 0).off().line(0, 0); }, Kind::entry_too_close, 2,
       3},
      {"round pocket, left to the outside",
       [](Part& p) { p.from(0, 0).left(5).line(20, 0).ccw(20, 0, 0, 0).off().line(40, 0); }, Kind::exit_too_close, 5,
       3},
      {"round boss, from outside",
       [](Part& p) { p.from(40, 0).right(5).line(20, 0).ccw(20, 0, 0, 0).off().line(40, 0); },
       {}},
      {"another contour's wall is no matter of this exit",
       [](Part& p) {
         room(p.from(20, 20).left(5).line(20, 0)), p.line(20, 20);
         p.normal(9).line(100, 20).normal(0).left(5).line(100, 0).off().line(20, 0);
       },
       {}},
  };
}

TEST(Entries, AreToldWhereTheyCutIntoAWallInEveryPlane_COMP007) {
  for (const Plane plane : {Plane::xy, Plane::xz, Plane::yz}) {
    std::vector<Row> rows = closed_rows();
    std::ranges::copy(open_rows(), std::back_inserter(rows));
    std::ranges::copy(exit_rows(), std::back_inserter(rows));
    std::ranges::copy(round_rows(), std::back_inserter(rows));
    for (const Row& row : rows) {
      Part part(plane);
      row.program(part);
      const Outcome outcome = run(part);
      ASSERT_FALSE(outcome.fault) << row.name;
      ASSERT_EQ(outcome.gouges.empty(), !row.kind) << row.name;
      if (!row.kind) continue;
      EXPECT_EQ(outcome.gouges.front().kind, *row.kind) << row.name;
      EXPECT_EQ(outcome.gouges.front().block.block, row.block) << row.name;
      EXPECT_TRUE(std::ranges::any_of(outcome.gouges, [&](const StageFault& fault) {
        return fault.kind == *row.kind && fault.other.block == row.other;
      })) << row.name;
    }
  }
}

/// The chain's first part has the entry's walls; the last, those of its end.
TEST(Entries, OfAContourCheckedInPartsAreLookedAtInEach_COMP007) {
  ContourCheck check;
  check.begin(Plane::xy, 5, {1, 2}, {.from = {20, 60}, .to = {20, 5}});
  check.add_contour({1, 3}, Line{.from = {20, 0}, .to = {40, 0}});
  check.split();
  EXPECT_TRUE(check.findings().empty());
  check.add_contour({1, 4}, Line{.from = {40, 40}, .to = {0, 40}});
  check.end();
  ASSERT_EQ(check.findings().size(), 1U);
  EXPECT_EQ(check.findings()[0].other.block, 4);
  EXPECT_EQ(check.findings()[0].found_mm, 0);
  check.add_exit({1, 6}, {.from = {0, 35}, .to = {20, 60}});
  EXPECT_EQ(check.findings().back().kind, Kind::exit_too_close);
}

// ---- any polygon, any start -------------------------------------------------------------------------------------

/// Corners by their angle about the middle, counterclockwise: convex or not, but never crossing itself.
struct Case {
  std::vector<PlaneVector> corners;
  PlaneVector start, leave;
  double radius = 0;
  bool is_inside = false;  ///< compensation
};

std::string words_of(const Case& c) {
  const auto place = [](PlaneVector at) {
    return "(" + std::to_string(at.first) + ", " + std::to_string(at.second) + ")";
  };
  std::string words = std::string(c.is_inside ? "inside" : "outside") + ", R " + std::to_string(c.radius) + ", from " +
                      place(c.start) + " to " + place(c.leave) + ", corners";
  for (const PlaneVector& corner : c.corners) words += " " + place(corner);
  return words;
}

PlaneVector at_angle(double turns, double distance) {
  return {distance * std::cos(2 * std::numbers::pi * turns), distance * std::sin(2 * std::numbers::pi * turns)};
}

Case any_case() {
  const auto number = [](int least, int most) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
  };
  Case made;
  const int count = number(3, 9);
  for (int i = 0; i < count; ++i)
    made.corners.push_back(at_angle((i + number(-300, 300) / 1000.0) / count, number(25'000, 60'000) / 1000.0));
  made.start = at_angle(number(0, 1000) / 1000.0, number(0, 90'000) / 1000.0);
  made.leave = at_angle(number(0, 1000) / 1000.0, number(0, 90'000) / 1000.0);
  made.radius = number(300, 5'000) / 1000.0;
  made.is_inside = *rc::gen::arbitrary<bool>();
  return made;
}

/// The corners, with the middle of the first side as beginning and end.
std::vector<PlaneVector> outline_of(const Case& c) {
  const PlaneVector middle = between(c.corners[0], c.corners[1], 0.5);
  std::vector<PlaneVector> outline{middle};
  outline.insert(outline.end(), c.corners.begin() + 1, c.corners.end());
  outline.push_back(c.corners[0]);
  outline.push_back(middle);
  return outline;
}

double distance_to_side(PlaneVector point, PlaneVector a, PlaneVector b) {
  const PlaneVector way = b - a;
  const double t = std::clamp(dot(point - a, way) / dot(way, way), 0.0, 1.0);
  return size(point - a - way * t);
}

/// How near the cutter's centre comes to any side, by many steps along its way.
double nearest(PlaneVector from, PlaneVector to, const std::vector<PlaneVector>& outline) {
  constexpr int kSteps = 4000;
  double least = 1e9;
  for (std::size_t side = 1; side < outline.size(); ++side)
    for (int step = 0; step <= kSteps; ++step)
      least = std::min(least, distance_to_side(between(from, to, static_cast<double>(step) / kSteps), outline[side - 1],
                                               outline[side]));
  return least;
}

bool is_within(PlaneVector point, const std::vector<PlaneVector>& outline) {
  bool inside = false;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const PlaneVector a = outline[i - 1], b = outline[i];
    if ((a.second > point.second) == (b.second > point.second)) continue;
    if (point.first < a.first + (b.first - a.first) * (point.second - a.second) / (b.second - a.second))
      inside = !inside;
  }
  return inside;
}

/// Told where the cutter cuts by more than the steps of the slow look hide, and nowhere else; `hidden_mm`: by so much
/// its distance may be too large.
void assert_told(bool is_told, double found, double radius, double hidden_mm = 0) {
  constexpr double kStep = 0.05, kRounding = 0.0015;
  if (found < radius - kStep) RC_ASSERT(is_told);
  if (found - hidden_mm > radius - kRounding / 2) RC_ASSERT(!is_told);
}

RC_GTEST_PROP(Entries, OfAnyPolygonAreToldExactlyWhereTheyCut_COMP007, ()) {
  RC_PRE(kSeeded);
  const Case c = any_case();
  RC_LOG(words_of(c));
  const std::vector<PlaneVector> outline = outline_of(c);
  Part part;
  part.from(c.start.first, c.start.second).radius(c.is_inside ? OffsetSide::left : OffsetSide::right, c.radius);
  for (const PlaneVector& place : outline) part.line(place.first, place.second);
  part.off().line(c.leave.first, c.leave.second);
  const Outcome outcome = run(part);
  RC_PRE(!outcome.fault);  // a corner too narrow for the tool ends it earlier

  const PlaneVector along = outline[1] - outline[0];
  const PlaneVector side = (c.is_inside ? left_of(along) : right_of(along)) * (c.radius / size(along));
  const PlaneVector beside = outline[0] + side;
  const auto is_told = [&](Kind kind) { return std::ranges::count(outcome.gouges, kind, &StageFault::kind) > 0; };
  const bool is_free = outcome.gouges.size() < ContourCheck::kMostFindings;  // else some were left off
  RC_PRE(is_free);
  assert_told(is_told(Kind::entry_too_close), nearest(c.start, beside, outline), c.radius);
  assert_told(is_told(Kind::exit_too_close), nearest(beside, c.leave, outline), c.radius);
  const bool is_through = is_within(c.start, outline) != is_within(beside, outline);
  if (is_through) RC_ASSERT(is_told(Kind::entry_too_close));
  RC_TAG(std::string(is_through ? "through a wall" : is_told(Kind::entry_too_close) ? "brushed" : "free"));
  for (const StageFault& fault : outcome.gouges)
    if (fault.kind == Kind::entry_too_close) RC_ASSERT(fault.block.block == kEntryBlock);
}

/// How near the cutter's centre comes to what counts of an open outline: from where that first leaves the circle about
/// its beginning on, in steps.
constexpr double kStep_mm = 0.02;
double nearest_to_open(PlaneVector from, PlaneVector to, const std::vector<PlaneVector>& outline, double radius) {
  bool counts = false;
  double least = 1e9;
  for (std::size_t side = 1; side < outline.size(); ++side) {
    const int steps = static_cast<int>(std::ceil(size(outline[side] - outline[side - 1]) / kStep_mm));
    for (int step = 0; step < steps; ++step) {
      const PlaneVector spot = between(outline[side - 1], outline[side], static_cast<double>(step) / steps);
      counts = counts || size(spot - outline.front()) > radius;
      if (counts) least = std::min(least, distance_to_side(spot, from, to));
    }
  }
  return least;
}

RC_GTEST_PROP(Entries, OfAnyOpenContourAreToldExactlyWhereTheyCutBeyondItsEnds_COMP007, ()) {
  const Case c = any_case();
  RC_LOG(words_of(c));
  const std::vector<PlaneVector> outline(c.corners.begin(), c.corners.end());
  Part part;
  part.from(c.start.first, c.start.second).radius(c.is_inside ? OffsetSide::left : OffsetSide::right, c.radius);
  for (const PlaneVector& place : outline) part.line(place.first, place.second);
  part.off().line(c.leave.first, c.leave.second);
  const Outcome outcome = run(part);
  RC_PRE(!outcome.fault && outcome.gouges.size() < ContourCheck::kMostFindings);
  const auto beside = [&](PlaneVector place, PlaneVector along) {
    return place + (c.is_inside ? left_of(along) : right_of(along)) * (c.radius / size(along));
  };
  const std::vector<PlaneVector> reversed(outline.rbegin(), outline.rend());
  const PlaneVector begin = beside(outline[0], outline[1] - outline[0]);
  const PlaneVector end = beside(reversed[0], reversed[0] - reversed[1]);
  const auto is_told = [&](Kind kind) { return std::ranges::count(outcome.gouges, kind, &StageFault::kind) > 0; };
  assert_told(is_told(Kind::entry_too_close), nearest_to_open(c.start, begin, outline, c.radius), c.radius, kStep_mm);
  assert_told(is_told(Kind::exit_too_close), nearest_to_open(end, c.leave, reversed, c.radius), c.radius, kStep_mm);
  RC_TAG(std::string(is_told(Kind::entry_too_close) ? "told" : "free"));
}

}  // namespace
