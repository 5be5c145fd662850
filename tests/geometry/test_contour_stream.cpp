// G41 and G42 as a stream: events and normal ways at corners, flags, changes of side, full circles, spirals (COMP-002,
// COMP-003, COMP-006; D-55, D-71, D-75, G-024).
#include <map>
#include <numbers>

#include "stage_rig.hpp"

namespace {

using namespace rig;
using std::numbers::pi;

TEST(ContourStream, WhatDoesNotMoveInThePlaneHappensAtTheCorner_D71_COMP002) {
  for (const Plane plane : kPlanes) {
    Part part(plane);
    part.from(0, -20).right(5).line(0, 0).add(Coolant{true}).line(20, 0);
    part.normal(-3).add(Dwell{1}).line(20, 20);               // outer corner: ahead of the corner arc
    part.add(Line{part.at(), part.at(), 1000}).line(40, 20);  // inner corner, a block without any way
    part.normal(0).add(Halt{}).off().line(60, 60);
    const Outcome outcome = run(part);
    ASSERT_FALSE(outcome.fault);
    expect_ways(ways_of(outcome.items, plane),
                {{2, 'L', 0, -5, 0},
                 {4, 'L', 20, -5, 0},
                 {5, 'L', 20, -5, -3, 3},
                 {7, 'R', 25, 0, -3},
                 {7, 'L', 25, 15, -3},
                 {9, 'L', 40, 15, -3},
                 {10, 'L', 40, 15, 0, 3},
                 {13, 'L', 60, 60, 0}},
                "events " + name_of(plane));
    expect_sound(outcome, "events");
    std::vector<int> blocks;
    for (const PathItem& item : outcome.items) blocks.push_back(item.source.block);
    EXPECT_EQ(blocks, (std::vector{1, 2, 3, 4, 5, 6, 7, 7, 8, 9, 10, 11, 12, 13}));
    EXPECT_TRUE(std::holds_alternative<Mark>(outcome.items[8].what));
  }
}

TEST(ContourStream, EachBlockEndsOnceAndStopsOnlyAtItsEnd) {
  Part part;
  part.from(0, -20).right(5).line(0, 0).line(20, 0).line(20, 20);
  part.newest().exact_stop = true;
  part.newest().passes_single_block = true;
  part.newest().override_off = true;
  part.off().line(60, 60);
  const Outcome outcome = run(part);
  std::map<std::uint64_t, int> ends;
  for (const PathItem& item : outcome.items) ends[item.sequence] += item.ends_block ? 1 : 0;
  for (std::uint64_t sequence = 1; sequence <= part.items().size(); ++sequence)
    EXPECT_EQ(ends[sequence], 1) << sequence;
  const PathItem& corner = outcome.items[3];
  const PathItem& element = outcome.items[4];
  ASSERT_TRUE(std::holds_alternative<Arc>(corner.what));
  EXPECT_FALSE(corner.exact_stop);
  EXPECT_FALSE(corner.ends_block);
  EXPECT_TRUE(corner.passes_single_block && corner.override_off);
  EXPECT_TRUE(element.exact_stop && element.ends_block);
}

TEST(ContourStream, FeedIsThatOfTheBlockAndRapidStaysRapid) {
  Part part;
  part.from(0, -20).right(5).line(0, 0).feed(300).line(20, 0).feed(600).line(20, 20);
  part.rapid(true).feed(5000).line(0, 20).rapid(false).feed(300).line(0, 0);
  const Outcome outcome = run(part);
  std::vector<double> feeds;
  std::vector<bool> rapid;
  for (const PathItem& item : outcome.items) {
    if (const auto* line = std::get_if<Line>(&item.what)) {
      feeds.push_back(line->feed_mm_per_min);
      rapid.push_back(line->is_rapid);
    } else if (const auto* arc = std::get_if<Arc>(&item.what)) {
      feeds.push_back(arc->feed_mm_per_min);
      rapid.push_back(false);
    }
  }
  EXPECT_EQ(feeds, (std::vector<double>{1000, 300, 600, 600, 5000, 5000, 300, 300}));
  EXPECT_EQ(rapid, (std::vector<bool>{false, false, false, false, false, true, false, false}));
}

TEST(ContourStream, TheFourthAxisTurnsAtTheCorner_G120) {
  Part part;
  part.from(0, -20).right(5).line(0, 0).line(20, 0);
  Point turned = part.at();
  turned.u = 90;
  part.add(Line{part.at(), turned, 1000});
  part.newest().is_fourth_axis = true;
  part.line(20, 20);
  const Outcome outcome = run(part);
  const auto* turn = std::get_if<Line>(&outcome.items[3].what);
  ASSERT_TRUE(turn != nullptr && outcome.items[3].is_fourth_axis);
  EXPECT_EQ(turn->from, (Point{20, -5, 0, 0}));
  EXPECT_EQ(turn->to, (Point{20, -5, 0, 90}));
}

TEST(ContourStream, TrimmedWaysReachTheFullHeight) {
  for (const Plane plane : kPlanes) {
    Part part(plane);
    part.from(0, -20, 10).left(5).line(0, 0, 9).line(20, 0, 5).line(20, 40, 2);
    part.arc(Turn::clockwise, -20, 40, 0, 40, -4);  // a helix outwards: tangent at its start
    const Outcome outcome = run(part);
    const std::vector<Way> ways = ways_of(outcome.items, plane);
    ASSERT_FALSE(outcome.fault) << name_of(plane);
    expect_sound(outcome, "height");
    EXPECT_EQ(ways.back().normal, -4);
    EXPECT_EQ(ways[0].normal, 9);
    EXPECT_EQ(ways[1].normal, 5);
    EXPECT_NEAR(ways[1].length, std::hypot(15, 4), 1e-9);
  }
}

TEST(ContourStream, TheRunGoesOnOverG40WithoutMotion_COMP006) {
  Part part;  // G90: the program is already where the exit leads
  part.from(0, -20).left(5).line(0, 0).line(20, 0).off();
  part.line(20, 0).named(4);      // Z is none of the plane's
  part.line(20, 0).named(1 | 2);  // X and Y are
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 0, 5}, {3, 'L', 20, 5}, {6, 'L', 20, 0, 0, 5}},
              "exit without way");
  EXPECT_EQ(outcome.shift_mm, (std::array<double, 3>{}));
}

TEST(ContourStream, AnotherSideOrRadiusIsAnEntryFromWhereTheToolStands) {
  Part part;
  part.from(0, -20).left(5).line(0, 0).line(20, 0);
  part.right(5).line(20, 20).line(60, 20);
  part.right(3).line(60, 40).line(90, 40);
  part.right(3).line(120, 40);  // a repetition changes nothing
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy),
              {{2, 'L', 0, 5},
               {3, 'L', 20, 5},
               {5, 'L', 20, 15, 0, 10},
               {6, 'L', 60, 15},
               {8, 'L', 60, 37, 0, 22},
               {9, 'L', 90, 37},
               {11, 'L', 120, 37}},
              "sides");
  expect_sound(outcome, "sides");
}

TEST(ContourStream, RadiusZeroWhileOnLeavesAsG40Does_COMP003) {
  Part part;
  part.from(0, -20).left(5).line(0, 0).line(20, 0).left(0).line(40, 0).ccw(60, 0, 50, 0);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 0, 5}, {3, 'L', 20, 5}, {5, 'L', 40, 0}, {6, 'R', 60, 0}},
              "radius 0");
}

TEST(ContourStream, AnEntryWithoutSuccessorGoesToItsOwnOffset_D75) {
  Part part;
  part.left(5).line(20, 0);
  Outcome outcome = run(part);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 20, 5}}, "end");
  EXPECT_EQ(outcome.shift_mm, (std::array<double, 3>{0, 5, 0}));
  part.off().line(40, 0);
  outcome = run(part);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 20, 5}, {4, 'L', 40, 0}}, "G40");
}

TEST(ContourStream, EX040TheManualsFullCircleOnBothSides_G024) {
  for (const OffsetSide side : {OffsetSide::left, OffsetSide::right}) {
    Part part;
    part.from(-30, 0).radius(side, 5).line(0, 0).cw(0.005, -0.005, 20, 0).line(0, 0).off().line(-30, 0);
    const Outcome outcome = run(part);
    ASSERT_FALSE(outcome.fault);
    expect_sound(outcome, "EX-040");
    const auto ways = ways_of(outcome.items, Plane::xy);
    const bool is_outside = side == OffsetSide::left;
    const double entry = is_outside ? -5 : 5;
    EXPECT_NEAR(ways[0].first, entry, 1e-9);
    double round = 0;
    for (const Way& way : ways)
      if (way.form == 'A' && way.block == 3) round = way.length;
    EXPECT_NEAR(round, 2 * pi * (is_outside ? 25 : 15), 0.02);
    EXPECT_EQ(ways.back().block, 6);
    EXPECT_NEAR(ways.back().first, -30, 1e-9);
  }
}

/// Entered from its middle; ends beside the start on the circle's inside, its outside and on it, both senses.
TEST(ContourStream, EX040InsideIsEnteredAndLeftWithoutACut_G024_COMP007) {
  for (const double radius : {0.25, 5.0, 10.0}) {
    for (const auto& [first, second] : {std::pair{0.005, -0.005}, {-0.005, -0.005}, {0.0, -0.005}, {0.01, -0.01}}) {
      Part clockwise;
      clockwise.from(20, 0).right(radius).line(0, 0).cw(first, second, 20, 0).line(0, 0).off().line(20, 0);
      Part counter;
      counter.from(20, 0).left(radius).line(0, 0).ccw(first, -second, 20, 0).line(0, 0).off().line(20, 0);
      for (const Part& part : {clockwise, counter}) {
        const Outcome outcome = run(part);
        ASSERT_FALSE(outcome.fault);
        EXPECT_TRUE(outcome.gouges.empty()) << radius << ", " << first << ", " << second;
        expect_sound(outcome, "EX-040 inside");
        double round = 0;
        for (const Way& way : ways_of(outcome.items, Plane::xy)) round += way.block == 3 ? way.length : 0;
        EXPECT_NEAR(round, 2 * pi * (20 - radius), 0.04);
      }
    }
  }
}

/// The radius error of an arc (D-55) is all that its chain is given: a hundredth more is told.
TEST(ContourStream, ACutDeeperThanTheRadiusErrorIsTold_D55_DEC09) {
  const auto gouges_at = [](double mouth) {
    Part part;  // an arc that ends 0.01 inside its circle, then past its own beginning
    part.from(-20, 5).left(5).line(0, 0).line(40, 0).ccw(40, 19.99, 40, 10).line(10, 19.99).line(10, mouth);
    return run(part.line(0, mouth)).gouges.size();
  };
  EXPECT_EQ(gouges_at(10), 0U);
  EXPECT_EQ(gouges_at(9.99), 0U);
  EXPECT_GT(gouges_at(9.98), 0U);
}

TEST(ContourStream, SpiralsKeepTheirTwoRadii_D55) {
  Part part;
  part.from(20, -30).right(5).line(20, 0).ccw(-20.02, 0, 0, 0).off().line(-60, 0);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy),
              {{2, 'L', 25, 0}, {3, 'R', -25.02, 0, 0, 25.01 * pi}, {5, 'L', -60, 0}}, "spiral");
}

TEST(ContourStream, TrimmedSpiralsMeetExactly_D55) {
  Part part;  // inside corners at both ends of a spiral: line, spiral, line
  part.from(40, 0).left(5).line(40, 10).line(-40, 10).ccw(-40.01, -10, -20, 0).line(40, -10);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_sound(outcome, "spirals");
  const auto& arc = std::get<Arc>(outcome.items[3].what);
  const ArcShape way = shape_of(arc), contour = shape_of(std::get<Arc>(part.items()[3].what));
  EXPECT_NEAR(arc.from.y, 5, 1e-9);
  EXPECT_NEAR(arc.to.y, -5, 1e-9);
  // at its own angle the way lies 5 inside the spiral
  const auto radius_at = [&](double angle) {
    const double share = std::remainder(angle - contour.start_angle, 2 * pi) / contour.sweep;
    return std::lerp(contour.start_radius, contour.end_radius, share) - 5;
  };
  EXPECT_NEAR(way.start_radius, radius_at(way.start_angle), 1e-9);
  EXPECT_NEAR(way.end_radius, radius_at(way.start_angle + way.sweep), 1e-9);
}

TEST(ContourStream, ACopyGoesOnFromTheSameState) {
  Part part;
  part.left(5).line(20, 0).line(20, 30).add(Dwell{1}).line(50, 30).line(50, 60).rounding(8).line(20, 60);
  part.ccw(10, 50, 20, 50).off().line(0, 0);
  for (std::size_t cut = 0; cut < part.items().size(); ++cut) {
    PathStages stages;
    std::vector<PathItem> whole;
    std::optional<PathStages> copy;
    std::vector<PathItem> parted;
    for (std::size_t i = 0; i < part.items().size(); ++i) {
      if (i == cut) {
        copy = stages;
        parted = whole;
      }
      ASSERT_TRUE(stages.push(part.items()[i], whole));
      if (copy) {
        ASSERT_TRUE(copy->push(part.items()[i], parted));
      }
    }
    ASSERT_TRUE(stages.flush(whole));
    ASSERT_TRUE(copy->flush(parted));
    ASSERT_EQ(parted.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(parted[i].sequence, whole[i].sequence);
    EXPECT_EQ(copy->shift_mm(), stages.shift_mm());
  }
}

}  // namespace
