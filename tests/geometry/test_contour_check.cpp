// The gouge check of whole chains: what is one, and what is none (DEC-09).
#include <algorithm>
#include <numbers>

#include "stage_rig.hpp"

namespace {

using namespace rig;

struct Gouge {
  int block, other;
  double found_mm;
};

struct CheckRow {
  std::string name;
  void (*program)(Part&);
  std::vector<Gouge> expected;
};

/// A pocket entered between two walls that are no neighbours; `gap` is its mouth. Blocks 3 to 7.
void pocket(Part& p, double gap) {
  p.from(-20, 5).left(5).line(0, 0).line(40, 0).line(40, 20).line(10, 20).line(10, gap).line(0, gap);
}

void square_from_corner(Part& p) { p.line(40, 0).line(40, 40).line(0, 40).line(0, 0); }

std::vector<CheckRow> check_rows() {
  return {
      {"mouth too narrow", [](Part& p) { pocket(p, 8); }, {{2, 7, 3}, {3, 6, 3}, {3, 7, 3}, {7, 3, 3}}},
      {"mouth just wide enough", [](Part& p) { pocket(p, 10); }, {}},
      {"mouth a hundredth too narrow",
       [](Part& p) { pocket(p, 9.99); },
       {{2, 7, 4.99}, {3, 6, 4.99}, {3, 7, 4.99}, {7, 3, 4.99}}},
      {"way back beside an earlier wall, at another depth",
       [](Part& p) {
         p.from(-20, 5).left(5).line(0, 0).line(40, 0).line(40, 20).line(10, 20).normal(-10).line(10, 8).line(0, 8);
       },
       {}},
      {"depths that overlap on a ramp",
       [](Part& p) {
         p.from(-20, 5).left(5).line(0, 0).line(40, 0, -10).line(40, 20).line(10, 20).line(10, 8).line(0, 8, 0);
       },
       {{2, 7, 3}, {3, 6, 3}, {3, 7, 3}, {7, 3, 3}}},
      {"way across an earlier wall",
       [](Part& p) { p.from(-20, 0).left(5).line(0, 0).line(40, 0).line(60, 20).line(20, 60).line(20, -30); },
       {{3, 6, 0}, {6, 3, 0}}},
      {"closed contour twice at one depth",
       [](Part& p) {
         p.from(-20, -20).right(5).line(0, 0);
         square_from_corner(p);
         square_from_corner(p);
       },
       {}},
      {"closed contour again at another depth",
       [](Part& p) {
         p.from(-20, -20).right(5).line(0, 0);
         square_from_corner(p);
         p.normal(-5);
         square_from_corner(p);
       },
       {}},
      {"run-in and run-out on arcs",
       [](Part& p) {
         p.from(12, -20).right(3).line(12, -8).cw(20, 0, 20, -8);
         p.line(40, 0).line(40, 40).line(0, 40).line(0, 0).line(20, 0).cw(28, -8, 20, -8);
       },
       {}},
      {"run-out that cuts into the contour",
       [](Part& p) {
         p.from(12, -20).right(3).line(0, 0);
         square_from_corner(p);
         p.line(-30, -30).line(60, 50);  // the second line leads right across two of its sides
       },
       {{8, 3, 0}, {8, 4, 0}}},
      {"corner arc before an arc that returns to the corner",
       [](Part& p) {
         const double angle = -std::numbers::pi / 9;
         p.from(-20, -20).right(2).line(0, 0).line(20, 0).ccw(10 + 10 * std::cos(angle), 10 * std::sin(angle), 10, 0);
       },
       {{2, 4, std::hypot(10, 2) - 10},
        {3, 4, 0},
        {4, 4, std::hypot(10 - 10 * std::cos(std::numbers::pi / 9), 10 * std::sin(std::numbers::pi / 9) - 2)}}},
  };
}

TEST(ContourCheck, NamesBlockOtherAndDistanceInEveryPlane_DEC09) {
  for (const Plane plane : {Plane::xy, Plane::xz, Plane::yz}) {
    for (const CheckRow& row : check_rows()) {
      Part part(plane);
      row.program(part);
      const Outcome outcome = run(part);
      ASSERT_FALSE(outcome.fault) << row.name;
      EXPECT_EQ(outcome.gouges.size(), row.expected.size()) << row.name;
      for (const Gouge& expected : row.expected) {
        const auto found = std::ranges::find_if(outcome.gouges, [&](const StageFault& fault) {
          return fault.block.block == expected.block && fault.other.block == expected.other;
        });
        ASSERT_NE(found, outcome.gouges.end()) << row.name << ": " << expected.block << " into " << expected.other;
        const bool is_entry = expected.block == kEntryBlock;
        EXPECT_EQ(found->kind, is_entry ? StageFault::Kind::entry_too_close : StageFault::Kind::too_close) << row.name;
        EXPECT_NEAR(found->found_mm, expected.found_mm, 1e-9) << row.name << ": " << expected.block;
        EXPECT_EQ(found->needed_mm, std::get<RadiusOffset>(part.items()[0].what).radius_mm);
      }
    }
  }
}

TEST(ContourCheck, KeepsAStatedNumberForEachChain) {
  Part part;
  part.from(-20, -20).right(3).line(0, 0);
  for (int zigzag = 0; zigzag < 40; ++zigzag) part.line(10.0 * zigzag + 5, 30).line(10.0 * zigzag + 10, 0);
  part.line(440, 0).line(440, 10).line(0, 10).off().line(-20, -20);
  const std::size_t items = part.items().size();
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault) << outcome.fault->block.block << " of " << items;
  EXPECT_EQ(outcome.gouges.size(), ContourCheck::kMostFindings);
}

TEST(ContourCheck, WhatHasLeftBeforeAFaultIsCheckedToo_DEC09) {
  Part part;
  pocket(part, 8);
  part.line(0, 4).line(-30, 4).line(-30, 5);  // does not fit
  const Outcome outcome = run(part);
  ASSERT_TRUE(outcome.fault);
  EXPECT_GT(outcome.gouges.size(), 0U);
}

TEST(ContourCheck, BeginsAnewWithEachChain) {
  Part part;  // the second chain runs where the first one had its wall
  part.from(-20, 0).left(5).line(0, 0).line(40, 0).line(40, 30).off().line(60, 60);
  part.left(5).line(0, 20).line(20, 20).line(20, -30).off().line(60, -30);
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  EXPECT_EQ(outcome.gouges.size(), 0U);
}

/// Two rooms with a neck that is too narrow, again and again: every pass beside every other would be millions of pairs.
TEST(ContourCheck, PassesOfALoopCountOnce) {
  Part part;
  part.from(-20, 10).left(5).line(-30, 0);
  for (int pass = 0; pass < 500; ++pass) {
    part.line(40, 0).line(40, 20).line(10, 20).line(10, 8).line(0, 8).line(0, 20).line(-30, 20).line(-30, 0);
  }
  const Outcome outcome = run(part);
  ASSERT_FALSE(outcome.fault);
  EXPECT_GT(outcome.gouges.size(), 0U);
}

TEST(ContourCheck, AnEndWithoutAChainFindsNothing) {
  ContourCheck check;
  check.end();
  EXPECT_EQ(check.findings().size(), 0U);
}

}  // namespace
