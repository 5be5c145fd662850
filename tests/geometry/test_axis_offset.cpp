// G43, G44 and the tool's length (COMP-002, COMP-010, COMP-014, COMP-015, COMP-016; D-72, D-73, D-75, DEC-65).
#include "stage_rig.hpp"

namespace {

using namespace rig;
using Kind = StageFault::Kind;

constexpr unsigned kX = 1, kY = 2, kZ = 4;

Part square_of_30(Plane plane, OffsetSide side) {
  Part part(plane);
  part.radius(side, 5).line(30, 0).line(30, 30).line(0, 30).line(0, 0);
  return part;
}

TEST(AxisOffset, DEC65SquareOf30UnderG43) {
  for (const Plane plane : {Plane::xy, Plane::xz, Plane::yz}) {
    const Outcome outcome = run(square_of_30(plane, OffsetSide::plus));
    ASSERT_FALSE(outcome.fault);
    expect_ways(ways_of(outcome.items, plane),
                {{2, 'L', 35, 0, 0, 35}, {3, 'L', 35, 35, 0, 35}, {4, 'L', -5, 35, 0, 40}, {5, 'L', -5, -5, 0, 40}},
                "DEC-65");
    expect_sound(outcome, "DEC-65");
  }
}

TEST(AxisOffset, G44ShortensWhatG43Lengthens_COMP014) {
  const Outcome outcome = run(square_of_30(Plane::xy, OffsetSide::minus));
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 25, 0}, {3, 'L', 25, 25}, {4, 'L', 5, 25}, {5, 'L', 5, 5}},
              "G44");
  EXPECT_EQ(outcome.shift_mm, (std::array<double, 3>{5, 5, 0}));
}

struct BackwardsRow {
  std::string name;
  void (*program)(Part&);
  int block;  ///< 0: none is to blame
  double way, taken;
  double first, second;  ///< where the tool's centre stands then
};

std::vector<BackwardsRow> backwards_rows() {
  return {
      {"shorter than R", [](Part& p) { p.radius(OffsetSide::minus, 5).line(3, 0); }, 2, 3, 5, 0, 0},
      {"as long as R: nothing is left", [](Part& p) { p.radius(OffsetSide::minus, 5).line(5, 0).line(5, 20); }, 0, 0, 0,
       0, 15},
      {"back by less than 2 R", [](Part& p) { p.radius(OffsetSide::minus, 5).line(30, 0).line(27, 0); }, 3, 3, 10, 25,
       0},
      {"back by 2 R", [](Part& p) { p.radius(OffsetSide::minus, 5).line(30, 0).line(20, 0).line(0, 0); }, 0, 0, 0, 5,
       0},
      {"one axis of a slanted way",
       [](Part& p) { p.radius(OffsetSide::minus, 5).line(30, 30).line(60, 34).line(70, 33); }, 4, 1, 10, 55, 29},
      {"short on in the same direction", [](Part& p) { p.radius(OffsetSide::minus, 5).line(30, 0).line(31, 0); }, 0, 0,
       0, 26, 0},
      {"lengthened, back at once", [](Part& p) { p.radius(OffsetSide::plus, 5).line(30, 0).line(29, 0); }, 0, 0, 0, 24,
       0},
      {"lengthened, then shortened",
       [](Part& p) { p.radius(OffsetSide::plus, 5).line(30, 0).radius(OffsetSide::minus, 5).line(33, 0); }, 4, 3, 10,
       35, 0},
      {"a smaller tool",
       [](Part& p) { p.radius(OffsetSide::plus, 9).line(30, 0).radius(OffsetSide::plus, 5).line(33, 0); }, 4, 3, 4, 39,
       0},
      {"left at the programmed point, wherever that is",
       [](Part& p) { p.radius(OffsetSide::plus, 5).line(30, 0).off().line(31, 0); }, 0, 0, 0, 31, 0},
  };
}

/// D-72 (a) says where ways end, DEC-09 that none is run against its direction.
TEST(AxisOffset, AWayThatWouldRunBackwardsIsRefused_DEC09_G431) {
  for (const Plane plane : {Plane::xy, Plane::xz, Plane::yz}) {
    for (const BackwardsRow& row : backwards_rows()) {
      Part part(plane);
      row.program(part);
      const Outcome outcome = run(part);
      ASSERT_EQ(outcome.fault.has_value(), row.block != 0) << row.name;
      expect_sound(outcome, row.name);
      if (outcome.fault) {
        EXPECT_EQ(outcome.fault->kind, Kind::runs_backwards) << row.name;
        EXPECT_EQ(outcome.fault->block.block, row.block) << row.name;
        EXPECT_NEAR(outcome.fault->found_mm, row.way, 1e-9) << row.name;
        EXPECT_NEAR(outcome.fault->needed_mm, row.taken, 1e-9) << row.name;
      }
      const auto ways = ways_of(outcome.items, plane);
      const Way last = ways.empty() ? Way{} : ways.back();
      EXPECT_NEAR(last.first, row.first, 1e-9) << row.name;
      EXPECT_NEAR(last.second, row.second, 1e-9) << row.name;
    }
  }
}

TEST(AxisOffset, CornersAreNotRounded_COMP010) {
  for (const PathItem& item : run(square_of_30(Plane::xy, OffsetSide::plus)).items)
    EXPECT_FALSE(std::holds_alternative<Arc>(item.what));
}

TEST(AxisOffset, WithoutToolNothingIsShifted_COMP003) {
  Part part;
  part.radius(OffsetSide::plus, 0).line(30, 0).line(30, 30).ccw(50, 30, 40, 30);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy), {{2, 'L', 30, 0}, {3, 'L', 30, 30}, {4, 'R', 50, 30}}, "R 0");
}

TEST(AxisOffset, G40TakesEachAxisBackWithItsNextMove_D72) {
  Part part;
  part.radius(OffsetSide::plus, 5).line(30, 0).line(30, 30).off();
  part.line(10, 30);            // X moves: its shift goes, Y's stays
  part.line(10, 30).named(kY);  // G90, Y already there: the word takes the shift back
  part.line(0, 0);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy),
              {{2, 'L', 35, 0}, {3, 'L', 35, 35}, {5, 'L', 10, 35}, {6, 'L', 10, 30}, {7, 'L', 0, 0}}, "G40");
  EXPECT_EQ(outcome.shift_mm, (std::array<double, 3>{}));
}

TEST(AxisOffset, DiagonalWaysAreShiftedAlongBothAxes_D72) {
  Part part;
  part.radius(OffsetSide::plus, 5).line(30, 20).line(10, 40);
  expect_ways(ways_of(run(part).items, Plane::xy), {{2, 'L', 35, 25}, {3, 'L', 5, 45}}, "diagonal");
}

TEST(AxisOffset, AnArcWhoseShapeWouldChangeIsRefused_D72) {
  Part under;
  under.radius(OffsetSide::plus, 5).line(30, 0).ccw(50, 0, 40, 0);
  Part behind;
  behind.radius(OffsetSide::plus, 5).line(30, 0).off().ccw(50, 0, 40, 0);
  for (const auto& [part, block] : {std::pair{under, 3}, std::pair{behind, 4}}) {
    const Outcome outcome = run(part);
    ASSERT_TRUE(outcome.fault);
    EXPECT_EQ(outcome.fault->kind, Kind::arc_under_axis_offset);
    EXPECT_EQ(outcome.fault->block.block, block);
    EXPECT_EQ(ways_of(outcome.items, Plane::xy).size(), 1U);
  }
}

TEST(AxisOffset, FromAxesToContourAndBack_COMP005) {
  Part part;
  part.radius(OffsetSide::plus, 5).line(30, 0);         // stands at (35,0)
  part.left(5).line(30, 20).line(60, 20).line(80, 20);  // the entry ends on the contour's offset
  part.radius(OffsetSide::plus, 5).line(80, 60);        // leaves the contour, its end lengthened
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy),
              {{2, 'L', 35, 0}, {4, 'L', 30, 25}, {5, 'L', 60, 25}, {6, 'L', 80, 25}, {8, 'L', 80, 65}},
              "G43, G41, G43");
  expect_sound(outcome, "G43, G41, G43");
}

TEST(ToolLength, EntersAndLeavesWithTheAxisPerpendicularToThePlane_COMP015_COMP016_G461) {
  for (const Plane plane : {Plane::xy, Plane::xz, Plane::yz}) {
    Part part(plane);
    part.from(0, 0, 50).length(-1.5);  // a shorter tool
    part.line(10, 0);                  // the axis is not named: not entered
    part.normal(0);                    // 50 down, 1.5 further than programmed
    part.ccw(30, 0, 20, 0);            // arcs run at the shifted height
    part.length(0).line(40, 0).normal(50);
    const Outcome outcome = run(part);
    ASSERT_FALSE(outcome.fault);
    expect_ways(ways_of(outcome.items, plane),
                {{2, 'L', 10, 0, 50, 10},
                 {3, 'L', 10, 0, -1.5, 51.5},
                 {4, 'R', 30, 0, -1.5},
                 {6, 'L', 40, 0, -1.5, 10},
                 {7, 'L', 40, 0, 50, 51.5}},
                "length");
    expect_sound(outcome, "length");
  }
}

TEST(ToolLength, AWordWithoutWayEntersAndLeaves_COMP015) {
  Part part;
  part.length(2).line(0, 0).named(kX).line(0, 0).named(kZ).length(0).line(0, 0).named(kX | kZ);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy), {{3, 'L', 0, 0, 2, 2}, {5, 'L', 0, 0, 0, 2}}, "named");
  ASSERT_EQ(outcome.items.size(), 5U);
  EXPECT_TRUE(std::holds_alternative<Mark>(outcome.items[1].what));  // a line without way
  EXPECT_TRUE(outcome.items[1].ends_block);
}

TEST(ToolLength, WorksTogetherWithTheRadius_COMP002) {
  Part part;
  part.from(0, -20, 10).right(5).length(3);
  part.line(0, 0).line(20, 0, 5).named(kX | kZ).line(20, 20, 5).normal(0).line(0, 20).off().line(0, 60, 10);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy),
              {{3, 'L', 0, -5, 10},
               {4, 'L', 20, -5, 8},  // 5 + 3: entered with the line that names Z
               {5, 'R', 25, 0, 8},
               {5, 'L', 25, 20, 8},
               {6, 'L', 25, 20, 3},  // at the corner
               {7, 'R', 20, 25, 3},
               {7, 'L', 0, 25, 3},
               {9, 'L', 0, 60, 13}},
              "radius and length");
  expect_sound(outcome, "radius and length");
  EXPECT_EQ(outcome.shift_mm, (std::array<double, 3>{0, 0, 3}));
}

TEST(AxisOffset, ARunGoesOnWhereTheLastOneEnded_D75) {
  Part first;  // HANDEINGABE: one line, then nothing follows
  first.left(5).length(2).line(20, 0, 1);
  const Outcome one = run(first);
  expect_ways(ways_of(one.items, Plane::xy), {{3, 'L', 20, 5, 3}}, "first");
  EXPECT_EQ(one.shift_mm, (std::array<double, 3>{0, 5, 2}));

  Part second;  // the orders in force come first
  second.from(20, 0, 1).left(5).length(2).line(20, 30);
  const Outcome two = run(second, one.shift_mm);
  ASSERT_FALSE(two.fault);
  expect_ways(ways_of(two.items, Plane::xy), {{3, 'L', 15, 30, 3, std::hypot(5, 25)}}, "second");
  EXPECT_EQ(two.shift_mm, (std::array<double, 3>{-5, 0, 2}));

  Part third;  // all off: the next ways go back to the program
  third.from(20, 30, 1).line(30, 30).normal(0);
  const Outcome three = run(third, two.shift_mm);
  ASSERT_FALSE(three.fault);
  expect_ways(ways_of(three.items, Plane::xy), {{1, 'L', 30, 30, 3}, {2, 'L', 30, 30, 0}}, "third");

  Part fourth;  // G43 keeps the other axis' shift over the runs
  fourth.from(30, 0).radius(OffsetSide::plus, 5).line(30, 30);
  const Outcome four = run(fourth, {5, 0, 0});
  expect_ways(ways_of(four.items, Plane::xy), {{2, 'L', 35, 35}}, "fourth");
}

}  // namespace
