// G41 and G42 against the manual's square and hand-worked joints (COMP-001 to COMP-011; D-70, D-71, D-75, D-128,
// DEC-09).
#include <map>
#include <numbers>

#include "stage_rig.hpp"

namespace {

using namespace rig;
using std::numbers::pi;
using std::numbers::sqrt2;
using Kind = StageFault::Kind;

constexpr std::array kPlanes{Plane::xy, Plane::xz, Plane::yz};

std::string name_of(Plane plane) { return plane == Plane::xy ? "XY" : plane == Plane::xz ? "XZ" : "YZ"; }

/// QUADRAT MIT RADIUS KORREKTUR, block numbers as printed.
Part square(Plane plane, double radius_mm) {
  Part part(plane);
  part.add(SetActual{}).add(ToolChange{1, 5, 1}).line(20, 0).right(radius_mm);
  part.line(20, 30).line(50, 30).line(50, 60).line(20, 60).line(20, 30).line(20, 0);
  part.off().line(0, 0);
  return part;
}

TEST(ContourOffset, EX080SquareWithRadiusCompensationInEveryPlane) {
  const double corner = 2.5 * pi;
  const std::vector<Way> expected{
      {3, 'L', 20, 0, 0, 20},       // EX-081
      {5, 'L', 20, 25, 0, 25},      // EX-082: the entry
      {6, 'L', 50, 25, 0, 30},      // EX-083
      {7, 'R', 55, 30, 0, corner},  // EX-084: belongs to the block behind the corner
      {7, 'L', 55, 60, 0, 30},      // EX-085
      {8, 'R', 50, 65, 0, corner},  // EX-086
      {8, 'L', 20, 65, 0, 30},      // EX-087
      {9, 'R', 15, 60, 0, corner},  // EX-088
      {9, 'L', 15, 30, 0, 30},      // EX-089
      {10, 'L', 15, 0, 0, 30},      // EX-090
      {12, 'L', 0, 0, 0, 15},       // EX-091
  };
  for (const Plane plane : kPlanes) {
    const Outcome outcome = run(square(plane, 5));
    ASSERT_FALSE(outcome.fault) << name_of(plane);
    const auto ways = ways_of(outcome.items, plane);
    expect_ways(ways, expected, "EX-080 " + name_of(plane));
    expect_sound(outcome, "EX-080");
    double total = 0;
    for (const Way& way : ways) total += way.length;
    EXPECT_NEAR(total, 233.561945, 5e-7);                    // EX-092
    EXPECT_NEAR(total / 1000 * 60, 14.014, 5e-4);            // EX-093
    EXPECT_EQ(outcome.gouges.size(), 0U) << name_of(plane);  // N010 runs on past the corner: no gouge
    EXPECT_EQ(outcome.shift_mm, (std::array<double, 3>{}));
  }
}

TEST(ContourOffset, EX094WithoutToolTheSquareIsRunAsItIs_COMP003) {
  const Part part = square(Plane::xy, 0);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  double total = 0;
  for (const Way& way : ways_of(outcome.items, Plane::xy)) total += way.length;
  EXPECT_NEAR(total, 220, 1e-9);
  ASSERT_EQ(outcome.items.size(), part.items().size());
  for (std::size_t i = 0; i < part.items().size(); ++i) {
    const auto* programmed = std::get_if<Line>(&part.items()[i].what);
    const auto* line = std::get_if<Line>(&outcome.items[i].what);
    ASSERT_EQ(programmed == nullptr, line == nullptr);
    if (line == nullptr) continue;
    EXPECT_EQ(line->from, programmed->from);
    EXPECT_EQ(line->to, programmed->to);
  }
}

struct JointRow {
  std::string name;
  OffsetSide side;
  double radius;
  void (*program)(Part&);     ///< blocks from 3 on: entry, elements; the stream ends with them
  std::vector<Way> expected;  ///< from the entry (block 3) on
};

/// Entry from (0,-20); the first element begins at (0,0) and runs along the first axis to (20,0).
std::vector<JointRow> joint_rows() {
  const auto left = OffsetSide::left, right = OffsetSide::right;
  return {
      {"line-line inner 90°",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).line(20, 20); },
       {{3, 'L', 0, 5}, {4, 'L', 15, 5, 0, 15}, {5, 'L', 15, 20, 0, 15}}},
      {"line-line outer 90°",
       right,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).line(20, 20); },
       {{3, 'L', 0, -5}, {4, 'L', 20, -5}, {5, 'R', 25, 0, 0, 2.5 * pi}, {5, 'L', 25, 20}}},
      {"line-line outer to the other side",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).line(20, -20); },
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {5, 'A', 25, 0, 0, 2.5 * pi}, {5, 'L', 25, -20}}},
      {"line-line inner 45°",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).line(40, 20); },
       {{3, 'L', 0, 5}, {4, 'L', 20 - 5 * std::tan(pi / 8), 5}, {5, 'L', 40 - 2.5 * sqrt2, 20 + 2.5 * sqrt2}}},
      {"line-line straight on",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).line(40, 0); },
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {5, 'L', 40, 5}}},
      {"line-line back along itself",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).line(0, 0); },
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {5, 'A', 20, -5, 0, 5 * pi}, {5, 'L', 0, -5}}},
      {"line-arc tangent, tool inside",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).ccw(30, 10, 20, 10); },
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {5, 'R', 25, 10, 0, 2.5 * pi}}},
      {"line-arc tangent, tool outside",
       right,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).ccw(30, 10, 20, 10); },
       {{3, 'L', 0, -5}, {4, 'L', 20, -5}, {5, 'R', 35, 10, 0, 7.5 * pi}}},
      {"line-arc inner: half circle upwards",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(40, 0).ccw(0, 0, 20, 0); },
       // the arc's way has radius 15 about (20,0): it meets second = 5 at 20 + sqrt(200)
       {{3, 'L', 0, 5}, {4, 'L', 20 + std::sqrt(200), 5}, {5, 'R', 5, 0}}},
      {"line-arc inner: clockwise round a boss",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).cw(40, 0, 30, 0); },
       // radius 15 about (30,0) meets second = 5 at 30 - sqrt(200)
       {{3, 'L', 0, 5}, {4, 'L', 30 - std::sqrt(200), 5}, {5, 'A', 45, 0}}},
      {"line-arc outer",
       right,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).ccw(0, 0, 10, 0); },
       {{3, 'L', 0, -5}, {4, 'L', 20, -5}, {5, 'R', 25, 0, 0, 2.5 * pi}, {5, 'R', -5, 0, 0, 15 * pi}}},
      {"arc-line inner",
       left,
       5,
       [](Part& p) { p.line(0, 0).cw(20, 0, 10, 0).line(60, 0); },
       // starts at (-5,0) on radius 15 about (10,0); leaves it at second = 5
       {{3, 'L', -5, 0}, {4, 'A', 10 + std::sqrt(200), 5}, {5, 'L', 60, 5}}},
      {"arc-line outer",
       right,
       5,
       [](Part& p) { p.line(0, 0).cw(20, 0, 10, 0).line(20, 30); },
       // a turn back of half a circle, from (15,0) about (20,0); 180°: the line starts at (25,0)
       {{3, 'L', 5, 0}, {4, 'A', 15, 0, 0, 5 * pi}, {5, 'R', 25, 0, 0, 5 * pi}, {5, 'L', 25, 30}}},
      {"arc-arc inner",
       left,
       5,
       [](Part& p) { p.line(0, 0).cw(20, 0, 10, 0).cw(40, 0, 30, 0); },
       // two circles of radius 15 about (10,0) and (30,0) meet above the cusp at (20, sqrt(125))
       {{3, 'L', -5, 0}, {4, 'A', 20, std::sqrt(125)}, {5, 'A', 45, 0}}},
      {"arc-arc outer",
       right,
       5,
       [](Part& p) { p.line(0, 0).cw(20, 0, 10, 0).cw(40, 0, 30, 0); },
       {{3, 'L', 5, 0}, {4, 'A', 15, 0}, {5, 'R', 25, 0, 0, 5 * pi}, {5, 'A', 35, 0}}},
      {"arc-arc tangent",
       left,
       5,
       [](Part& p) { p.line(0, 0).ccw(20, 0, 10, 0).cw(60, 0, 40, 0); },
       {{3, 'L', 5, 0}, {4, 'R', 15, 0}, {5, 'A', 65, 0}}},
      {"full circle, tool inside, in one block",
       left,
       5,
       [](Part& p) { p.line(0, 0).ccw(0, 0, 20, 0).line(0, -30); },
       {{3, 'L', 5, 0}, {4, 'R', 5, 0, 0, 30 * pi}, {5, 'L', 5, -30}}},
      {"full circle, tool outside",
       right,
       5,
       [](Part& p) { p.line(0, 0).ccw(0, 0, 20, 0).line(0, -30); },
       {{3, 'L', -5, 0}, {4, 'R', -5, 0, 0, 50 * pi}, {5, 'L', -5, -30}}},
  };
}

TEST(ContourOffset, JointsOfLinesAndArcsInEveryPlane_COMP004_COMP009_COMP011_D71_D128) {
  for (const Plane plane : kPlanes) {
    for (const JointRow& row : joint_rows()) {
      Part part(plane);
      part.from(0, -20).add(Mark{}).radius(row.side, row.radius);
      row.program(part);
      const Outcome outcome = run(part);
      const std::string name = row.name + " " + name_of(plane);
      ASSERT_FALSE(outcome.fault) << name;
      expect_ways(ways_of(outcome.items, plane), row.expected, name);
      expect_sound(outcome, name);
    }
  }
}

struct FaultRow {
  std::string name;
  Kind kind;
  int block;
  void (*program)(Part&);
  double first, second;  ///< where the tool's centre stands then
};

std::vector<FaultRow> fault_rows() {
  return {
      {"entry with an arc", Kind::arc_at_entry_or_exit, 3, [](Part& p) { p.left(5).ccw(20, -20, 10, -20); }, 0, -20},
      {"exit with an arc", Kind::arc_at_entry_or_exit, 6,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).off().ccw(0, 0, 10, 0); }, 20, 5},
      {"new side with an arc", Kind::arc_at_entry_or_exit, 6,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).right(5).ccw(0, 0, 10, 0); }, 20, 5},
      {"arc smaller than the tool", Kind::inside_arc_too_small, 5,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).ccw(24, 4, 20, 4).line(24, 30); }, 0, 5},
      {"arc as small as the tool", Kind::inside_arc_too_small, 5,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).ccw(25, 5, 20, 5).line(25, 30); }, 0, 5},
      {"first arc too small", Kind::inside_arc_too_small, 4, [](Part& p) { p.left(5).line(0, 0).ccw(8, 0, 4, 0); }, 0,
       -20},
      {"slot narrower than the tool", Kind::runs_backwards, 5,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).line(20, 9).line(0, 9); }, 15, 5},
      {"element shorter than its first corner", Kind::runs_backwards, 5,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).line(20, 3).line(40, 3); }, 0, 5},
      {"first element shorter than its corner", Kind::runs_backwards, 4,
       [](Part& p) { p.left(5).line(0, 0).line(4, 0).line(4, 40); }, 0, 5},
      {"line past a far smaller circle", Kind::no_intersection, 5,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).ccw(14, 0, 17, 0 - 5); }, 0, 5},
      {"both corners do not fit into one element: the ones before are right", Kind::runs_backwards, 6,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).line(20, 30).line(12, 30).line(12, 10); }, 15, 25},
  };
}

TEST(ContourOffset, FaultsNameTheBlockAndLeaveWhatIsRight_DEC09_D71) {
  for (const Plane plane : kPlanes) {
    for (const FaultRow& row : fault_rows()) {
      Part part(plane);
      part.from(0, -20).add(Mark{});
      row.program(part);
      const Outcome outcome = run(part);
      const std::string name = row.name + " " + name_of(plane);
      ASSERT_TRUE(outcome.fault) << name;
      EXPECT_EQ(static_cast<int>(outcome.fault->kind), static_cast<int>(row.kind)) << name;
      EXPECT_EQ(outcome.fault->block.block, row.block) << name;
      expect_sound(outcome, name);
      const auto ways = ways_of(outcome.items, plane);
      const Way last = ways.empty() ? Way{.first = 0, .second = -20} : ways.back();
      EXPECT_NEAR(last.first, row.first, 1e-9) << name;
      EXPECT_NEAR(last.second, row.second, 1e-9) << name;
    }
  }
}

TEST(ContourOffset, WhatDoesNotMoveInThePlaneHappensAtTheCorner_D71_COMP002) {
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

TEST(ContourOffset, EachBlockEndsOnceAndStopsOnlyAtItsEnd) {
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

TEST(ContourOffset, FeedIsThatOfTheBlockAndRapidStaysRapid) {
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

TEST(ContourOffset, TheFourthAxisTurnsAtTheCorner_G120) {
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

TEST(ContourOffset, TrimmedWaysReachTheFullHeight) {
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

TEST(ContourOffset, TheRunGoesOnOverG40WithoutMotion_COMP006) {
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

TEST(ContourOffset, AnotherSideOrRadiusIsAnEntryFromWhereTheToolStands) {
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

TEST(ContourOffset, RadiusZeroWhileOnLeavesAsG40Does_COMP003) {
  Part part;
  part.from(0, -20).left(5).line(0, 0).line(20, 0).left(0).line(40, 0).ccw(60, 0, 50, 0);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 0, 5}, {3, 'L', 20, 5}, {5, 'L', 40, 0}, {6, 'R', 60, 0}},
              "radius 0");
}

TEST(ContourOffset, AnEntryWithoutSuccessorGoesToItsOwnOffset_D75) {
  Part part;
  part.left(5).line(20, 0);
  Outcome outcome = run(part);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 20, 5}}, "end");
  EXPECT_EQ(outcome.shift_mm, (std::array<double, 3>{0, 5, 0}));
  part.off().line(40, 0);
  outcome = run(part);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 20, 5}, {4, 'L', 40, 0}}, "G40");
}

TEST(ContourOffset, EX040TheManualsFullCircleOnBothSides_G024) {
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

TEST(ContourOffset, SpiralsKeepTheirTwoRadii_D55) {
  Part part;
  part.from(20, -30).right(5).line(20, 0).ccw(-20.02, 0, 0, 0).off().line(-60, 0);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy),
              {{2, 'L', 25, 0}, {3, 'R', -25.02, 0, 0, 25.01 * pi}, {5, 'L', -60, 0}}, "spiral");
}

TEST(ContourOffset, TrimmedSpiralsMeetExactly_D55) {
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

TEST(ContourOffset, ACopyGoesOnFromTheSameState) {
  const Part part = square(Plane::xy, 5);
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
