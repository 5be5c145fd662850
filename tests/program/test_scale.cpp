// Scale factors: G74, G75 (G-740 to G-755; D-67, D-68).
#include <gmock/gmock.h>

#include "item_names.hpp"
#include "program/rebuild_modal.hpp"

namespace cnclab::program {
namespace {

using geometry::Arc;
using geometry::Line;
using geometry::Point;
using geometry::Turn;
using language::ErrorCode;

struct EndRow {
  const char* name;
  const char* text;
  std::array<std::int64_t, 3> end_um;
};

class Scale : public testing::TestWithParam<EndRow> {};

TEST_P(Scale, LeadsTo) {
  const RunResult run = run_text(GetParam().text);
  ASSERT_FALSE(run.error) << language::explain(*run.error, language::Tongue::english);
  EXPECT_EQ(run.blocks.back().programmed_um, GetParam().end_um);
}

INSTANTIATE_TEST_SUITE_P(
    , Scale,
    testing::Values(
        EndRow{"G750_multiplies_ways", "P0001N001G75X+2000Y-500Z+1500N002G00X+1000Y+1000Z+1000%", {2000, -500, 1500}},
        EndRow{"G754_an_axis_without_factor_has_1", "P0001N001G75Y+3000N002G00X+1000Y+1000Z+1000%", {1000, 3000, 1000}},
        EndRow{
            "G753_new_factors_replace", "P0001N001G75X+2000Y+2000N002G75X+3000N003G00X+1000Y+1000%", {3000, 1000, 0}},
        EndRow{"G740_off", "P0001N001G75X+2000N002G74N003G00X+1000%", {1000, 0, 0}},
        EndRow{
            "G752_acts_in_called_programs", "P0001N001G75X+2000N002G22P0002N001W01\nP0002N001G00X+1000%", {4000, 0, 0}},
        EndRow{"D68_factor_of_nothing", "P0001N001G75X+0N002G00X+1000Y+1000%", {0, 1000, 0}},
        EndRow{"D68_multiplies_targets_under_G90",
               "P0001N001G00X+5000N002G75X+2000N003G90N004G00X+1000Y+7000%",
               {2000, 7000, 0}},
        EndRow{"D68_G90_target_does_not_depend_on_the_place",
               "P0001N001G75X-1000N002G90N003G00X+1000N004G00X+1000%",
               {-1000, 0, 0}},
        EndRow{"D68_not_on_G68", "P0001N001G75X+2000N002G68X+1000%", {1000, 0, 0}},
        EndRow{"D68_not_on_G69", "P0001N001G75X+2000N002G69X+1000%", {1000, 0, 0}},
        EndRow{"DEC05_products_are_not_rounded", "P0001N001G75X+333N002G00X+1N003G00X+1N004G00X+1%", {1, 0, 0}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(ScaleWords, FActsAsModalF_D67) {
  const RunResult run = run_text("P0001N001G75X+2000F0700N002G01X+1000%");
  ASSERT_FALSE(run.error);
  EXPECT_EQ(all_of<Line>(run).at(0).feed_mm_per_min, 700) << "unscaled";
  EXPECT_EQ(run.blocks.front().modal.feed_mm_per_min, 700);
}

TEST(ScaleWords, ReadParameters_PAR003) {
  Start start;
  start.parameters[3] = -2 * kParameterUnit;
  const RunResult run = run_text("P0001N001G75X#03N002G00X+1000%", 9, start);
  EXPECT_EQ(run.blocks.back().programmed_um[0], -2000);
}

TEST(ScaleWords, NeedAnAxis_D45) { EXPECT_EQ(run_text("P0001N001G75F0100%").code(), ErrorCode::word_missing); }

/// In each plane an odd number of mirrored axes turns the sense round.
TEST(ScaledArcs, AreMirrored_G751) {
  struct Row {
    const char* name;
    const char* factors;
    const char* arc;
    Point to;
    Turn turn;
  };
  constexpr auto kCw = Turn::clockwise, kCcw = Turn::counterclockwise;
  const Row rows[] = {
      {"none", "X+2000Y+2000", "N003G02X+10000Y+0I+5000J+0", {20, 0, 0}, kCw},
      {"X", "X-1000", "N003G02X+10000Y+0I+5000J+0", {-10, 0, 0}, kCcw},
      {"Y", "Y-1000", "N003G03X+10000Y+2000I+5000J+1000", {10, -2, 0}, kCw},
      {"X and Y", "X-1000Y-1000", "N003G02X+10000Y+2000I+5000J+1000", {-10, -2, 0}, kCw},
      {"Z does not matter in XY", "Z-3000", "N003G02X+10000Y+0I+5000J+0", {10, 0, 0}, kCw},
      {"Z in XZ", "Z-1000", "N003G18N004G02X+10000Z+2000I+5000K+1000", {10, 0, -2}, kCcw},
      {"X in YZ does not matter", "X-1000", "N003G19N004G02Y+10000Z+2000J+5000K+1000", {0, 10, 2}, kCw},
      {"Y in YZ", "Y-1000", "N003G19N004G03Y+10000Z+2000J+5000K+1000", {0, -10, 2}, kCw},
  };
  for (const Row& row : rows) {
    const RunResult run = run_text(std::string("P0001N001G11F0500N002G75") + row.factors + row.arc + "%");
    ASSERT_FALSE(run.error) << row.name;
    const Arc arc = all_of<Arc>(run).at(0);
    EXPECT_EQ(arc.to, row.to) << row.name;
    EXPECT_EQ(arc.turn, row.turn) << row.name;
    EXPECT_EQ(arc.center.x, row.to.x / 2) << row.name;
    EXPECT_EQ(arc.center.y, row.to.y / 2) << row.name;
    EXPECT_EQ(arc.center.z, row.to.z / 2) << row.name;
  }
}

TEST(ScaledArcs, OfFactorsOfNothingAreNone_D68) {
  const RunResult run =
      run_text("P0001N001G75X+0Y+0F0500N002G02X+10000Y+0I+5000J+0N003G05X+10000Y+0R+5000N004G01Z+1000X+1000%");
  ASSERT_FALSE(run.error);
  EXPECT_TRUE(all_of<Arc>(run).empty());
  EXPECT_EQ(all_of<Line>(run).at(0).to, (Point{0, 0, 1}));
}

TEST(ScaledArcs, KeepTheirCentreRelativeUnderG90_D68) {
  const RunResult run = run_text("P0001N001G75X+2000Y+2000F0500N002G90N003G00X+5000N004G03X+15000Y+0I+5000J+0%");
  ASSERT_FALSE(run.error);
  const Arc arc = all_of<Arc>(run).at(0);
  EXPECT_EQ(arc.from.x, 10);
  EXPECT_EQ(arc.to.x, 30);
  EXPECT_EQ(arc.center.x, 20);
}

TEST(ScaleStart, IsThatOfTheBlocksBefore_DEC26) {
  const ProgramSet programs = programs_of("P0001N001G75X+2000N002G75Y+3000F0700N003G17%");
  const ModalState modal = rebuild_modal(programs, *programs.find(1), 3, {}).value();
  EXPECT_EQ(modal.scale, (std::array<std::int64_t, 3>{1000, 3000, 1000}));
  EXPECT_EQ(modal.feed_mm_per_min, 700);
}

}  // namespace
}  // namespace cnclab::program
