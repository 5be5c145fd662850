// G10 against hand-worked corners (G-100; D-66).
#include <numbers>

#include "stage_rig.hpp"

namespace {

using namespace rig;
using std::numbers::pi;
using Kind = StageFault::Kind;

TEST(CornerRounding, ArcBetweenTwoLinesInEveryPlane_G100) {
  for (const Plane plane : kPlanes) {
    Part part(plane);
    part.line(20, 0).rounding(4).feed(500).line(20, 30).rounding(6).feed(250).line(50, 30);
    const Outcome outcome = run(part);
    ASSERT_FALSE(outcome.fault);
    expect_ways(ways_of(outcome.items, plane),
                {{1, 'L', 16, 0, 0, 16},
                 {2, 'R', 20, 4, 0, 2 * pi},
                 {3, 'L', 20, 24, 0, 20},
                 {4, 'A', 26, 30, 0, 3 * pi},
                 {5, 'L', 50, 30, 0, 24}},
                "rounded");
    expect_sound(outcome, "rounded");
    EXPECT_EQ(std::get<Arc>(outcome.items[1].what).feed_mm_per_min, 500);  // of the second line
    EXPECT_TRUE(outcome.items[1].ends_block);
  }
}

TEST(CornerRounding, SlantedCorners_G100) {
  Part part;
  part.line(20, 0).rounding(4).line(40, 20);
  const double trim = 4 * std::tan(pi / 8), diagonal = trim / std::numbers::sqrt2;
  expect_ways(ways_of(run(part).items, Plane::xy),
              {{1, 'L', 20 - trim, 0}, {2, 'R', 20 + diagonal, diagonal, 0, pi}, {3, 'L', 40, 20}}, "45°");
}

TEST(CornerRounding, SlopesAlongTheNormalStay_D66) {
  Part part;
  part.line(20, 0, 10).rounding(4).line(20, 20, 0);
  const Outcome outcome = run(part);
  expect_ways(ways_of(outcome.items, Plane::xy), {{1, 'L', 16, 0, 8}, {2, 'R', 20, 4, 8}, {3, 'L', 20, 20, 0}},
              "slopes");
  expect_sound(outcome, "slopes");
}

TEST(CornerRounding, StraightOnThereIsNothingToRound) {
  Part part;
  part.line(20, 0).rounding(4).line(40, 0);
  const Outcome outcome = run(part);
  expect_ways(ways_of(outcome.items, Plane::xy), {{1, 'L', 20, 0}, {3, 'L', 40, 0}}, "straight");
  EXPECT_TRUE(std::holds_alternative<Mark>(outcome.items[1].what));
}

TEST(CornerRounding, TwoRoundingsMayUseUpALine_D66) {
  Part part;
  part.line(20, 0).rounding(10).line(20, 20).rounding(10).line(0, 20);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy), {{1, 'L', 10, 0}, {2, 'R', 20, 10}, {4, 'R', 10, 20}, {5, 'L', 0, 20}},
              "used up");
  expect_sound(outcome, "used up");
  EXPECT_TRUE(std::holds_alternative<Mark>(outcome.items[2].what));  // block 3 has no way left, and still ends
}

TEST(CornerRounding, EventsKeepTheirPlaceAtTheCorner) {
  Part part;
  part.line(20, 0);
  part.newest().ends_block = false;
  part.add(Coolant{true});
  part.newest().sequence = part.items()[0].sequence;  // M word at the end of the line's block
  part.newest().source = part.items()[0].source;
  part.rounding(4).add(Dwell{1}).line(20, 30);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  ASSERT_EQ(outcome.items.size(), 5U);
  EXPECT_TRUE(std::holds_alternative<Coolant>(outcome.items[1].what));
  EXPECT_TRUE(std::holds_alternative<Arc>(outcome.items[2].what));
  EXPECT_TRUE(std::holds_alternative<Dwell>(outcome.items[3].what));
  expect_sound(outcome, "events");
}

TEST(CornerRounding, ComesBeforeTheOffset) {
  Part part;
  part.from(0, -20).left(3).line(0, 0).line(20, 0).rounding(5).line(20, 20);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  expect_ways(ways_of(outcome.items, Plane::xy),
              {{2, 'L', 0, 3}, {3, 'L', 15, 3}, {4, 'R', 17, 5, 0, pi}, {5, 'L', 17, 20}}, "rounded, then offset");
}

TEST(CornerRounding, OrdinaryLinesLeaveWithTheNextBlock) {
  PathStages stages;
  std::vector<PathItem> out;
  Part part;
  part.line(20, 0).add(Mark{}).line(20, 20);
  ASSERT_TRUE(stages.push(part.items()[0], out));
  EXPECT_TRUE(stages.holds());
  EXPECT_EQ(out.size(), 0U);
  ASSERT_TRUE(stages.push(part.items()[1], out));
  EXPECT_FALSE(stages.holds());
  EXPECT_EQ(out.size(), 2U);
  ASSERT_TRUE(stages.push(part.items()[2], out));
  ASSERT_TRUE(stages.flush(out));
  EXPECT_EQ(out.size(), 3U);
}

struct RoundingFault {
  std::string name;
  Kind kind;
  int block;
  void (*program)(Part&);
  std::size_t ways;  ///< that are right before it
};

std::vector<RoundingFault> rounding_faults() {
  const auto without = Kind::rounding_without_lines, large = Kind::rounding_too_large;
  return {
      {"nothing before", without, 1, [](Part& p) { p.rounding(4).line(20, 0); }, 0},
      {"nothing behind", without, 2, [](Part& p) { p.line(20, 0).rounding(4); }, 0},
      {"arc before", without, 2, [](Part& p) { p.ccw(20, 0, 10, 0).rounding(4).line(20, 20); }, 1},
      {"arc behind", without, 2, [](Part& p) { p.line(20, 0).rounding(4).ccw(40, 0, 30, 0); }, 0},
      {"rapid before", without, 2, [](Part& p) { p.rapid(true).line(20, 0).rapid(false).rounding(4).line(20, 20); }, 1},
      {"rapid behind", without, 2, [](Part& p) { p.line(20, 0).rounding(4).rapid(true).line(20, 20); }, 0},
      {"normal way before", without, 2, [](Part& p) { p.normal(5).rounding(4).line(20, 20); }, 1},
      {"normal way behind", without, 2, [](Part& p) { p.line(20, 0).rounding(4).normal(5); }, 0},
      {"a block between", without, 3, [](Part& p) { p.line(20, 0).add(Mark{}).rounding(4).line(20, 20); }, 1},
      {"two of them", without, 2, [](Part& p) { p.line(20, 0).rounding(4).rounding(4).line(20, 20); }, 0},
      {"compensation between", without, 2, [](Part& p) { p.line(20, 0).rounding(4).left(1).line(20, 20); }, 0},
      {"first line too short", large, 2, [](Part& p) { p.line(3.999, 0).rounding(4).line(4, 20); }, 0},
      {"second line too short", large, 2, [](Part& p) { p.line(20, 0).rounding(4).line(20, 3.999); }, 0},
      {"no room left by the rounding before", large, 4,
       [](Part& p) { p.line(20, 0).rounding(10).line(20, 20).rounding(10.001).line(0, 20); }, 2},
      {"back along itself", large, 2, [](Part& p) { p.line(20, 0).rounding(4).line(0, 0); }, 0},
  };
}

TEST(CornerRounding, FaultsNameTheBlockOfTheG10_D66) {
  for (const Plane plane : kPlanes) {
    for (const RoundingFault& row : rounding_faults()) {
      Part part(plane);
      row.program(part);
      const Outcome outcome = run(part);
      ASSERT_TRUE(outcome.fault) << row.name;
      EXPECT_EQ(static_cast<int>(outcome.fault->kind), static_cast<int>(row.kind)) << row.name;
      EXPECT_EQ(outcome.fault->block.block, row.block) << row.name;
      EXPECT_EQ(ways_of(outcome.items, plane).size(), row.ways) << row.name;
      expect_sound(outcome, row.name);
    }
  }
}

}  // namespace
