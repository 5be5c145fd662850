// G41 and G42 against the manual's square and hand-worked joints (COMP-001 to COMP-011; D-70, D-71, D-75, D-128,
// DEC-09).
#include <algorithm>
#include <iterator>
#include <numbers>

#include "stage_rig.hpp"

namespace {

using namespace rig;
using std::numbers::pi;
using std::numbers::sqrt2;
using Kind = StageFault::Kind;

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
std::vector<JointRow> joints_of_lines() {
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
  };
}

/// As above, at least one of the two is an arc.
std::vector<JointRow> joints_with_arcs() {
  const auto left = OffsetSide::left, right = OffsetSide::right;
  return {
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
      {"line-arc of the tool's radius-line: the tool turns on the point",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).ccw(25, 5, 20, 5).line(25, 30); },
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {6, 'L', 20, 30, 0, 25}}},
      {"the same, rounded between two lines",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(25, 0).rounding(5).line(25, 30); },
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {6, 'L', 20, 30, 0, 25}}},
      {"half circle of the tool's radius: back beside itself",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).ccw(20, 10, 20, 5).line(0, 10); },
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {6, 'L', 0, 5}}},
      {"two quarters of the tool's radius",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).ccw(25, 5, 20, 5).ccw(20, 10, 20, 5).line(0, 10); },
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {7, 'L', 0, 5}}},
      {"arc of the tool's radius behind an outside corner",
       left,
       5,
       [](Part& p) { p.line(0, 0).line(20, 0).ccw(25, -5, 25, 0).line(40, -5); },
       // down at (20,0), the centre (25,0) is the way; (40,-5) is 5 below it
       {{3, 'L', 0, 5}, {4, 'L', 20, 5}, {5, 'A', 25, 0, 0, 2.5 * pi}, {6, 'L', 40, 0}}},
      {"full circle of the tool's radius",
       left,
       5,
       [](Part& p) { p.line(0, 0).ccw(0, 0, 5, 0).line(0, -30); },
       {{3, 'L', 5, 0}, {5, 'L', 5, -30}}},
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
  std::vector<JointRow> rows = joints_of_lines();
  std::ranges::move(joints_with_arcs(), std::back_inserter(rows));
  for (const Plane plane : kPlanes) {
    for (const JointRow& row : rows) {
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
      {"arc two micrometres smaller than the tool", Kind::inside_arc_too_small, 5,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).ccw(24.998, 4.998, 20, 4.998).line(24.998, 30); }, 0, 5},
      {"arc of the tool's radius behind an inside corner", Kind::no_intersection, 5,
       [](Part& p) { p.left(5).line(0, 0).line(20, 0).ccw(16, 8, 16, 3); }, 0, 5},
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

}  // namespace
