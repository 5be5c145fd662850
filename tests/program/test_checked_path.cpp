// CheckedPath: contours come out when they are right as a whole, and as far as they are right (DEC-09).
#include <gmock/gmock.h>

#include "item_names.hpp"
#include "program/checked_path.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;
using testing::ElementsAre;
using testing::IsEmpty;

/// A tool of radius 5, and a program whose blocks begin with N003.
ProgramSet with_tool(std::string_view blocks) {
  return programs_of(std::string("P0000T001R+5000L+0\nP0001N001G11F1000T01N002G17") + std::string(blocks) + "%");
}

/// A square run from outside.
constexpr std::string_view kSquare = "N003G42N004G01X+20000N005G01X+30000N006G01Y+30000N007G40N008G01X+9000";
/// A pocket whose last wall (N008) ends 3 mm before its first (N005).
constexpr std::string_view kPocket =
    "N003G42N004G01X+10000N005G01Y+50000N006G01X+60000N007G01Y-30000N008G01X-57000N009G40N010G01Y+10000";

struct Checked {
  std::vector<std::string> by_step;  ///< the ways that each step let go: "N4 N5"
  std::vector<geometry::PathItem> items;
  std::optional<language::Error> error;
};

Checked run(const ProgramSet& programs, std::size_t most_steps = 1000) {
  Checked result;
  auto path = CheckedPath::begin(programs, wide_settings(), {});
  EXPECT_TRUE(path);
  std::size_t told = 0;
  const auto tell = [&] {
    std::string ways;
    for (; told < result.items.size(); ++told) {
      const geometry::PathItem& item = result.items[told];
      if (!std::holds_alternative<geometry::Line>(item.what) && !std::holds_alternative<geometry::Arc>(item.what))
        continue;
      ways += (ways.empty() ? "N" : " N") + std::to_string(item.source.block);
    }
    result.by_step.push_back(ways);
  };
  while (!path->ended() && result.by_step.size() < most_steps) {
    if (const auto stepped = path->step(result.items); !stepped) result.error = stepped.error();
    tell();
  }
  if (!path->ended())
    if (const auto flushed = path->flush(result.items); !flushed) result.error = flushed.error();
  tell();
  return result;
}

TEST(CheckedPath, OfAGoodContourIsThatOfItsSource_DEC09) {
  const ProgramSet programs = with_tool(kSquare);
  auto source = PathSource::begin(programs, wide_settings(), {});
  ASSERT_TRUE(source);
  RunResult unchecked, checked;
  while (!source->ended()) ASSERT_TRUE(source->step(unchecked.items));
  checked.items = run(programs).items;
  EXPECT_EQ(checked.json(), unchecked.json());
}

TEST(CheckedPath, HoldsAContourUntilItsLastWallIsKnown_DEC09) {
  EXPECT_THAT(run(with_tool(kSquare)).by_step, ElementsAre("", "", "", "", "", "", "N4 N5 N6 N6", "N8", ""));
}

TEST(CheckedPath, HoldsNothingWithoutAContour) {
  EXPECT_THAT(run(with_tool("N003G12U+1000N004G00X+1N005G04H0001N006G01X+1M03")).by_step,
              ElementsAre("", "", "N3", "N4", "", "N6", ""));
}

TEST(CheckedPath, EndsBeforeTheFirstBlockThatCutsIntoAnother_DEC09) {
  const Checked checked = run(with_tool(kPocket));
  ASSERT_TRUE(checked.error);
  EXPECT_EQ(checked.error->code, ErrorCode::too_close);
  EXPECT_EQ(checked.error->block, 5);
  EXPECT_EQ(checked.error->detail, "P0001 N008");
  EXPECT_EQ(checked.items.back().source.block, 4);
  EXPECT_TRUE(checked.items.back().ends_block);
}

TEST(CheckedPath, SaysTheSameEverAfter) {
  auto path = CheckedPath::begin(with_tool(kPocket), wide_settings(), {});
  ASSERT_TRUE(path);
  std::vector<geometry::PathItem> items;
  while (!path->ended()) static_cast<void>(path->step(items));
  const std::size_t count = items.size();
  EXPECT_EQ(path->step(items).error().block, 5);
  EXPECT_EQ(path->flush(items).error().block, 5);
  EXPECT_EQ(items.size(), count);
}

TEST(CheckedPath, AGoodContourBeforeABadOneIsRun) {
  const Checked checked = run(
      with_tool("N003G42N004G01X+20000N005G01X+30000N006G40N007G01Y+9000"
                "N013G42N014G01X+10000N015G01Y+50000N016G01X+60000N017G01Y-30000N018G01X-57000N019G40N020G01Y+10000"));
  ASSERT_TRUE(checked.error);
  EXPECT_EQ(checked.error->block, 15);
  EXPECT_EQ(checked.items.back().source.block, 14);
}

TEST(CheckedPath, ACutIsFoundInAContourThatNeverCloses) {
  const std::string_view open = kPocket.substr(0, kPocket.find("N009"));
  EXPECT_EQ(run(with_tool(open)).error->block, 5) << "the program's end ends it";
  const Checked flushed = run(with_tool(std::string(open) + "N009G20P0001N009"), 50);
  ASSERT_TRUE(flushed.error) << "the block limit ends it";
  EXPECT_EQ(flushed.error->block, 5);
}

/// The wall that is hit comes first in the contour, then an error of a block: the run never comes to that.
TEST(CheckedPath, ACutBeforeAnErrorOfABlockCounts) {
  const std::string_view open = kPocket.substr(0, kPocket.find("N009"));
  EXPECT_EQ(run(with_tool(std::string(open) + "N009G18")).error->block, 5);
  const std::string good(kSquare.substr(0, kSquare.find("N007")));
  const Checked checked = run(with_tool(good + "N007G18"));
  ASSERT_TRUE(checked.error);
  EXPECT_EQ(checked.error->code, ErrorCode::plane_locked);
  EXPECT_EQ(checked.items.back().source.block, 6) << "what came before is right";
}

TEST(CheckedPath, ACornerThatCannotBeFollowedEndsItAsBefore_D71) {
  const Checked checked = run(with_tool("N003G41N004G01X+10000N005G01X+20000N006G03X+0Y+6000I+0J+3000N007G01X-20000"));
  ASSERT_TRUE(checked.error);
  EXPECT_EQ(checked.error->code, ErrorCode::inside_arc_too_small);
  EXPECT_EQ(checked.items.back().source.block, 4) << "where N005 may end nobody knows";
}

/// A contour without end may not be kept without end: it is checked in parts.
TEST(CheckedPath, LetsALongContourGoInParts) {
  const ProgramSet programs = with_tool("N003G42N004G01X+20000N005G01X+1N006G20P0001N005");
  auto path = CheckedPath::begin(programs, wide_settings(), {});
  ASSERT_TRUE(path);
  std::vector<geometry::PathItem> items;
  for (std::size_t i = 0; i < CheckedPath::kMostHeld + 10; ++i) ASSERT_TRUE(path->step(items));
  EXPECT_GE(items.size(), CheckedPath::kMostHeld);
  EXPECT_LE(items.size(), CheckedPath::kMostHeld + 10);
}

/// The cut lies in the part that is known by then, and the contour goes on without end.
TEST(CheckedPath, FindsTheCutInEachPart_DEC09) {
  const std::string open(kPocket.substr(0, kPocket.find("N009")));
  auto path = CheckedPath::begin(with_tool(open + "N009G01X-1N010G20P0001N009"), wide_settings(), {});
  ASSERT_TRUE(path);
  std::vector<geometry::PathItem> items;
  std::size_t steps = 0;
  while (steps < CheckedPath::kMostHeld + 20 && path->step(items)) ++steps;
  ASSERT_TRUE(path->ended());
  EXPECT_LT(steps, CheckedPath::kMostHeld + 10);
  EXPECT_EQ(path->step(items).error().block, 5);
  EXPECT_EQ(items.back().source.block, 4);
}

TEST(CheckedPath, TellsOfAProgramThatGoesRoundInAnOpenContour) {
  auto path = CheckedPath::begin(with_tool("N003G42N004G01X+20000N005G01X+1000N006G20P0001N006"), wide_settings(), {});
  ASSERT_TRUE(path);
  std::vector<geometry::PathItem> items;
  for (std::size_t i = 0; i < CheckedPath::kMostHeld; ++i) ASSERT_TRUE(path->step(items));
  EXPECT_FALSE(path->waits_in_vain());
  for (std::size_t i = 0; i < CheckedPath::kMostHeld + 10; ++i) ASSERT_TRUE(path->step(items));
  EXPECT_TRUE(path->waits_in_vain());
  EXPECT_TRUE(path->flush(items));
  EXPECT_EQ(items.back().source.block, 6);
}

TEST(CheckedPath, CannotBeginWhatIsNotThere) {
  EXPECT_EQ(CheckedPath::begin(programs_of("P0001N001G17%"), {}, {.program = 2}).error().code,
            ErrorCode::program_missing);
}

}  // namespace
}  // namespace cnclab::program
