// G68 and G69: positions get new names, the path goes on without a jump (G-680 to G-694, D-63, D-64, EX-070).
#include <gmock/gmock.h>

#include <cmath>

#include "item_names.hpp"

namespace cnclab::program {
namespace {

using geometry::Line;
using geometry::Point;
using geometry::Reference;
using geometry::SetActual;
using testing::ElementsAre;

using Position = std::array<std::int64_t, 3>;

TEST(ReferenceRun, EX070ZeroingOnTheNegativeSwitch) {
  const RunResult run = run_text("P0001N001G69X-1000N002G68X+0%", 9, {.position = {12, 34, 56}});
  ASSERT_FALSE(run.error);
  const Reference reference = all_of<Reference>(run).at(0);
  EXPECT_EQ(reference.axes, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(reference.value[0], -1) << "its sign is the direction, and it is the Istwert there";
  EXPECT_EQ(run.blocks.at(0).programmed_um, (Position{-1000, 34'000, 56'000}));
  const SetActual set = all_of<SetActual>(run).at(0);
  EXPECT_EQ(set.axes, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(set.value[0], 0);
  EXPECT_EQ(run.blocks.at(1).programmed_um, (Position{0, 34'000, 56'000})) << "EX-071";
}

TEST(ReferenceRun, ThePathGoesOnFromItsEnd_G691) {
  const RunResult run =
      run_text("P0001N001G01X+10000F1000N002G69X-1000Z+250000N003G01X+2000Y+3000N004G90N005G01X+5000Z+251000%");
  ASSERT_FALSE(run.error);
  const auto lines = all_of<Line>(run);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[1].from, lines[0].to) << "elements leave joined; only the machine knows where the switch is";
  EXPECT_EQ(lines[1].to, (Point{12, 3, 0}));
  EXPECT_EQ(lines[2].to, (Point{16, 3, 1}));
  EXPECT_EQ(run.blocks.back().programmed_um, (Position{5000, 3000, 251'000}));
}

TEST(ReferenceRun, AZeroHasNoSign_G693) {
  const Reference reference = all_of<Reference>(run_text("P0001N001G69Y-0%")).at(0);
  EXPECT_EQ(reference.axes, (std::array<bool, 3>{false, true, false}));
  EXPECT_FALSE(std::signbit(reference.value[1]));
}

TEST(ReferenceRun, IsAlsoOneInATestRun_M024) {
  EXPECT_THAT(names_of(run_text("P0001N001G11M24N002G69X+1000%")), ElementsAre("mark", "reference", "end"));
}

TEST(ReferenceRun, ReadsParameters_PAR003) {
  Start start;
  start.parameters[1] = -7 * kParameterUnit;
  const RunResult run = run_text("P0001N001G69X#01N002G68Y#64%", 9, start);
  EXPECT_EQ(run.blocks.back().programmed_um, (Position{-7000, -7000, 0})) << "#64 follows (D-95)";
}

TEST(ReferenceRun, NeedsAnAxis_D45) {
  EXPECT_EQ(run_text("P0001N001G91N002G69%").code(), language::ErrorCode::word_missing);
}

TEST(SetPosition, NamesOnlyTheAxesOfItsWords_G680) {
  const RunResult run = run_text("P0001N001G00X+1000Y+2000Z+3000N002G68Y+0N003G90N004G00X+0Y+1000Z+0%");
  ASSERT_FALSE(run.error);
  EXPECT_EQ(run.blocks.at(1).programmed_um, (Position{1000, 0, 3000}));
  EXPECT_EQ(all_of<Line>(run).back().to, (Point{0, 3, 0}));
}

}  // namespace
}  // namespace cnclab::program
