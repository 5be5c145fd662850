// Ways and arcs as the interpreter makes them from words: the manual's examples and the decisions about limits.
#include <gmock/gmock.h>

#include <cmath>

#include "geometry/path_math.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using geometry::Arc;
using geometry::Line;
using geometry::Point;
using language::ErrorCode;

constexpr std::string_view kPicture7 =
    "P0001N001G00X+50000Y+50000Z+50000N002G04H0010N003G01X+25000Y+10000Z+4000F1000M03"
    "N004G02X+10000Y+0I+5000J+0N005G20P0001N001%";

double path_mm(const RunResult& result) {
  double sum = 0;
  for (const Line& line : all_of<Line>(result)) sum += geometry::length_of(line);
  for (const Arc& arc : all_of<Arc>(result)) sum += geometry::length_of(arc);
  return sum;
}

TEST(Motion, EX010OnePassOfPicture7) {
  const RunResult run = run_text(kPicture7, 5);
  EXPECT_EQ(run.order(), "P1N1 P1N2 P1N3 P1N4 P1N5");
  const auto lines = all_of<Line>(run);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].to, (Point{50, 50, 50}));  // EX-011
  EXPECT_TRUE(lines[0].is_rapid);
  EXPECT_EQ(lines[0].feed_mm_per_min, 3000);    // F MAX, G-000
  EXPECT_EQ(lines[1].to, (Point{75, 60, 54}));  // EX-013
  EXPECT_EQ(lines[1].feed_mm_per_min, 1000);
  const auto arcs = all_of<Arc>(run);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].to, (Point{85, 60, 54}));  // EX-014
  EXPECT_EQ(arcs[0].center.x, 80);
  EXPECT_EQ(arcs[0].center.y, 60);
  EXPECT_EQ(all_of<geometry::Dwell>(run).at(0).seconds, 1.0);  // EX-012
  EXPECT_NEAR(path_mm(run), 129.531819, 1e-6);                 // EX-015
}

TEST(Motion, EX016StateAfterTheHalfCircleIsThatOfPicture5) {
  const RunResult run = run_text(kPicture7, 4);
  const ExecutedBlock& last = run.blocks.back();
  EXPECT_EQ(last.programmed_um, (std::array<std::int64_t, 3>{85'000, 60'000, 54'000}));
  EXPECT_EQ(last.modal.feed_mm_per_min, 1000);
  EXPECT_EQ(last.modal.spindle_rpm, 0);
  EXPECT_EQ(last.modal.tool, 0);
  EXPECT_EQ(last.modal.m, 3);
}

TEST(Motion, EX017SecondPassGoesOnFromTheFirst) {
  const RunResult run = run_text(kPicture7, 10);
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{170'000, 120'000, 108'000}));
}

TEST(Motion, EX040FullCircleInTwoBlocksEndsExactlyAtItsStart) {
  const RunResult run = run_text("P0001N001G11F1000N002G02X+5Y-5I+20000J+0N003G01X-5Y+5%");
  const auto arcs = all_of<Arc>(run);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].to, (Point{0.005, -0.005}));              // EX-041
  EXPECT_NEAR(geometry::length_of(arcs[0]), 125.6430, 5e-5);  // EX-042
  EXPECT_NEAR(path_mm(run), 125.6501, 5e-5);                  // EX-043
  EXPECT_EQ(all_of<Line>(run).at(0).to, Point{});
}

TEST(Motion, DEC04EqualEndPointIsAFullCircle) {
  const RunResult run = run_text("P0001N001G11F1000N002G03X+0Y+0I+20000J+0%", 9, {.position = {0.1, 0.2, 0.3}});
  const auto arcs = all_of<Arc>(run);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].from, arcs[0].to);
  EXPECT_NEAR(geometry::shape_of(arcs[0]).sweep, 2 * M_PI, 1e-12);
  EXPECT_NEAR(geometry::length_of(arcs[0]), 40 * M_PI, 1e-9);
}

/// Axes without a word stand still, whatever place they stand at.
TEST(Motion, LinesRunInOneTwoOrThreeAxes_SYS002_G000_G010) {
  struct Row {
    const char* words;
    Point to;
  };
  const Row rows[] = {{"X+10000", {11, 2, 3}},
                      {"Y-20000", {1, -18, 3}},
                      {"Z+30000", {1, 2, 33}},
                      {"X+10000Y-20000", {11, -18, 3}},
                      {"X+10000Z+30000", {11, 2, 33}},
                      {"Y-20000Z+30000", {1, -18, 33}},
                      {"X+10000Y-20000Z+30000", {11, -18, 33}}};
  for (const Row& row : rows) {
    for (const char* function : {"G00", "G01", "G61"}) {
      const RunResult run =
          run_text(std::string("P0001N001G11F0400N002") + function + row.words + "%", 9, {.position = {1, 2, 3}});
      ASSERT_FALSE(run.error) << row.words;
      const auto lines = all_of<Line>(run);
      ASSERT_EQ(lines.size(), 1u) << row.words << ": all axes move together";
      EXPECT_EQ(lines[0].from, (Point{1, 2, 3})) << row.words;
      EXPECT_EQ(lines[0].to, row.to) << row.words;
      EXPECT_EQ(lines[0].feed_mm_per_min, function == std::string("G00") ? 3000 : 400) << "G-011, FST-001";
    }
  }
}

TEST(Motion, WordsOfALineStayModal_G012_FST013) {
  const RunResult run = run_text(
      "P0000T007R+1000L+0\nP0001N001G01X+1000F0400S0600T07M03N002G01X+1000N003G02X+1000Y+0I+500J+0N004G00Y+1%");
  ASSERT_FALSE(run.error);
  for (const ExecutedBlock& block : run.blocks) {
    EXPECT_EQ(block.modal.feed_mm_per_min, 400);
    EXPECT_EQ(block.modal.spindle_rpm, 600);
    EXPECT_EQ(block.modal.tool, 7);
    EXPECT_EQ(block.modal.m, 3);
    EXPECT_EQ(block.modal.spindle, geometry::SpindleTurn::clockwise);
  }
  EXPECT_EQ(all_of<Line>(run).at(1).feed_mm_per_min, 400);
  EXPECT_EQ(all_of<Arc>(run).at(0).feed_mm_per_min, 400) << "G-023";
}

TEST(Motion, EX030FeedIsThatOfThePath) {
  const RunResult run = run_text("P0001N001G01X+100000Y+100000F1000%");
  EXPECT_NEAR(path_mm(run), 141.421356, 1e-6);
  EXPECT_EQ(all_of<Line>(run).at(0).feed_mm_per_min, 1000);
}

TEST(Motion, EX100FourMirroredCirclesOnePerQuadrant) {
  const RunResult run = run_text(
      "P0002N001G75X-1000Y+1000N002G22P0001N001W00N003G75X+1000Y-1000N004G22P0001N001W00"
      "N005G75X-1000Y-1000N006G22P0001N001W00N007G74N008G22P0001N001W00\n"
      "P0001N001G11F1000N002G01X+20000Y+20000N003G02X+5Y-5I+10000J+10000N004G01X-5Y+5N005G01X-20000Y-20000%",
      100, {.program = 2});
  ASSERT_FALSE(run.error);
  struct Row {
    const char* name;
    Point center, end;
    geometry::Turn turn;
  };
  constexpr auto kCw = geometry::Turn::clockwise;
  constexpr auto kCcw = geometry::Turn::counterclockwise;
  const Row rows[] = {{"EX-101", {-30, 30}, {-20.005, 19.995}, kCcw},
                      {"EX-102", {30, -30}, {20.005, -19.995}, kCcw},
                      {"EX-103", {-30, -30}, {-20.005, -19.995}, kCw},
                      {"EX-104", {30, 30}, {20.005, 19.995}, kCw}};
  const auto arcs = all_of<Arc>(run);
  ASSERT_EQ(arcs.size(), 4u);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    EXPECT_EQ(arcs[i].center.x, rows[i].center.x) << rows[i].name;
    EXPECT_EQ(arcs[i].center.y, rows[i].center.y) << rows[i].name;
    EXPECT_EQ(arcs[i].to, rows[i].end) << rows[i].name;
    EXPECT_EQ(arcs[i].turn, rows[i].turn) << rows[i].name;
    EXPECT_NEAR(geometry::length_of(arcs[i]), 88.850593, 5e-7) << "EX-105, EX-108 " << rows[i].name;
  }
  const auto lines = all_of<Line>(run);
  for (std::size_t call = 0; call < 4; ++call) EXPECT_EQ(lines.at(call * 3 + 2).to, Point{}) << "EX-106";
  EXPECT_NEAR(path_mm(run), 581.704827, 1e-6);  // EX-107
}

TEST(Motion, DEC05RestsBelowAStepDoNotAccumulate) {
  std::string text = "P0001N001G11F1000";
  for (int i = 2; i <= 11; ++i) text += (i < 10 ? "N00" : "N0") + std::to_string(i) + "G01X+10003";
  const RunResult run = run_text(text + "%");  // EX-130 with exact rests
  EXPECT_EQ(run.blocks.back().programmed_um[0], 100'030);
  EXPECT_EQ(all_of<Line>(run).back().to.x, 100.03);
}

TEST(Motion, G90EndPointsAreAbsoluteAndCentresStayRelative_G021_G022) {
  const RunResult run = run_text("P0001N001G90N002G01X+10000Y+10000F0500N003G03X+20000Y+10000I+5000J+0%");
  const auto arcs = all_of<Arc>(run);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_EQ(arcs[0].to, (Point{20, 10}));
  EXPECT_EQ(arcs[0].center.x, 15);
  EXPECT_EQ(arcs[0].center.y, 10);
}

/// Seen against the third axis (D-128): clockwise over (5, 5) of the first two axes in XY and YZ, under it in XZ.
TEST(Motion, ArcsInAllPlanesTakeTheirOwnWords_BLK102_SYS003_G020_G030) {
  struct Row {
    const char* name;
    const char* text;
    Point to;
    geometry::Plane plane;
    geometry::Turn turn;
    Point middle;
  };
  constexpr auto kCw = geometry::Turn::clockwise;
  constexpr auto kCcw = geometry::Turn::counterclockwise;
  const Row rows[] = {
      {"G02 G17", "N002G17N003G02X+10000Y+0I+5000J+0%", {10, 0, 0}, geometry::Plane::xy, kCw, {5, 5, 0}},
      {"G02 G18", "N002G18N003G02X+10000Z+0I+5000K+0%", {10, 0, 0}, geometry::Plane::xz, kCw, {5, 0, -5}},
      {"G02 G19", "N002G19N003G02Y+10000Z+0J+5000K+0%", {0, 10, 0}, geometry::Plane::yz, kCw, {0, 5, 5}},
      {"G03 G17", "N002G17N003G03X+10000Y+0I+5000J+0%", {10, 0, 0}, geometry::Plane::xy, kCcw, {5, -5, 0}},
      {"G03 G18", "N002G18N003G03X+10000Z+0I+5000K+0%", {10, 0, 0}, geometry::Plane::xz, kCcw, {5, 0, 5}},
      {"G03 G19", "N002G19N003G03Y+10000Z+0J+5000K+0%", {0, 10, 0}, geometry::Plane::yz, kCcw, {0, 5, -5}},
  };
  for (const Row& row : rows) {
    const RunResult run = run_text(std::string("P0001N001G11F1000") + row.text);
    ASSERT_FALSE(run.error) << row.name;
    const auto arcs = all_of<Arc>(run);
    ASSERT_EQ(arcs.size(), 1u) << row.name;
    EXPECT_EQ(arcs[0].to, row.to) << row.name;
    EXPECT_EQ(arcs[0].plane, row.plane) << row.name;
    EXPECT_EQ(arcs[0].turn, row.turn) << row.name;
    EXPECT_EQ(arcs[0].feed_mm_per_min, 1000) << row.name;
    EXPECT_NEAR(geometry::length_of(arcs[0]), 5 * M_PI, 1e-9) << row.name;
    const Point middle = geometry::point_at(arcs[0], geometry::shape_of(arcs[0]), 2.5 * M_PI);
    EXPECT_NEAR(std::hypot(middle.x - row.middle.x, middle.y - row.middle.y, middle.z - row.middle.z), 0, 1e-9)
        << row.name;
  }
}

TEST(Motion, G68RenamesThePositionAndThePathGoesOnWithoutAJump) {
  const RunResult run =
      run_text("P0001N001G01X+10000F1000N002G68X+0Z+5000N003G90N004G01X+3000Z+6000N005G91N006G01X+1000%");
  ASSERT_FALSE(run.error);
  const auto lines = all_of<Line>(run);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[1].from, (Point{10, 0, 0}));
  EXPECT_EQ(lines[1].to, (Point{13, 0, 1}));
  EXPECT_EQ(lines[2].to, (Point{14, 0, 1}));
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{4000, 0, 6000}));
  const auto set = all_of<geometry::SetActual>(run).at(0);
  EXPECT_EQ(set.axes, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(set.value, (std::array<double, 3>{0, 0, 5}));
}

TEST(Motion, G12MovesTheFourthAxisAloneIncrementallyAndUnscaled_G120) {
  const RunResult run = run_text("P0001N001G11F0600N002G75X+2000N003G12U+1500N004G12U+1500%");
  ASSERT_FALSE(run.error);
  const auto lines = all_of<Line>(run);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].to, (Point{0, 0, 0, 3}));
  EXPECT_EQ(lines[1].feed_mm_per_min, 600);
}

/// Of nothing that is modal but the feed: not of G90, the plane, compensation or length.
TEST(Motion, G12DisregardsEveryModalFunction_G120_G121_G122) {
  struct Row {
    const char* name;
    const char* before;
  };
  const Row rows[] = {{"G90", "N002G90"},
                      {"G18", "N002G18"},
                      {"G19 and G90", "N002G19N003G90"},
                      {"G41", "N002G41"},
                      {"G44 and G46", "N002G44N003G46"},
                      {"G75", "N002G75X-2000Y-2000Z-2000"}};
  for (const Row& row : rows) {
    const RunResult run = run_text(std::string("P0000T001R+5000L+1000\nP0001N001G11F0600T01") + row.before +
                                       "N010G12U+1500N011G12U-4000N012G11F0200N013G12U+1000%",
                                   20, {.position = {1, 2, 3, 10}});
    ASSERT_FALSE(run.error) << row.name;
    const auto lines = all_of<Line>(run);
    ASSERT_EQ(lines.size(), 3u) << row.name;
    EXPECT_EQ(lines[0].to, (Point{1, 2, 3, 11.5})) << row.name;
    EXPECT_EQ(lines[1].to, (Point{1, 2, 3, 7.5})) << row.name;
    EXPECT_EQ(lines[2].to, (Point{1, 2, 3, 8.5})) << row.name;
    EXPECT_EQ(lines[1].feed_mm_per_min, 600) << row.name;
    EXPECT_EQ(lines[2].feed_mm_per_min, 200) << row.name;
    EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{1000, 2000, 3000})) << row.name;
  }
}

TEST(Motion, AnyStartPositionIsKeptToTheLastDigit) {
  const double third = 1.0 / 3;
  const RunResult run = run_text("P0001N001G90N002G01X+10000F1000%", 9, {.position = {third, third, third}});
  const Line line = all_of<Line>(run).at(0);
  EXPECT_EQ(line.from, (Point{third, third, third}));
  EXPECT_EQ(line.to, (Point{10, third, third}));
}

struct ErrorRow {
  const char* name;
  const char* text;
  ErrorCode code;
  int block;
  char word;
};

class MotionErrors : public testing::TestWithParam<ErrorRow> {};

TEST_P(MotionErrors, StopBeforeTheBlockMovesAndNameIt) {
  const ErrorRow& row = GetParam();
  Settings settings;
  const RunResult run = run_text(row.text, 100, {}, settings);
  ASSERT_EQ(run.code(), row.code);
  EXPECT_EQ(run.error->block, row.block);
  EXPECT_EQ(run.error->program, 1);
  EXPECT_EQ(run.error->word, row.word);
  for (const geometry::PathItem& item : run.items) EXPECT_LT(item.source.block, row.block);
}

INSTANTIATE_TEST_SUITE_P(
    , MotionErrors,
    testing::Values(
        ErrorRow{"D59_G01_without_F", "P0001N001G00X+1000N002G01X+1000%", ErrorCode::feed_missing, 2, 'F'},
        ErrorRow{"D59_DEC55_G02_without_F", "P0001N001G02X+1000Y+0I+500J+0%", ErrorCode::feed_missing, 1, 'F'},
        ErrorRow{"D59_G12_without_F", "P0001N001G12U+1000%", ErrorCode::feed_missing, 1, 'F'},
        ErrorRow{"DEC13_F_above_F_MAX", "P0001N001G00X+1N002G01X+1000F3001%", ErrorCode::feed_above_limit, 2, 'F'},
        ErrorRow{"DEC56_word_above_travel", "P0001N001G00X+500000N002G00Y-1500000%", ErrorCode::word_out_of_range, 2,
                 'Y'},
        ErrorRow{"FST003_S_above_S_MAX", "P0001N001G11S3001%", ErrorCode::word_out_of_range, 1, 'S'},
        ErrorRow{"D54_G18_words_under_G17", "P0001N001G11F1000N002G02X+10000Z+0I+5000K+0%", ErrorCode::plane_wrong, 2,
                 'G'},
        ErrorRow{"D54_G17_words_under_G19", "P0001N001G11F1000N002G19N003G03X+10000Y+0I+5000J+0%",
                 ErrorCode::plane_wrong, 3, 'G'},
        ErrorRow{"D55_radius_error_above_20_um", "P0001N001G11F1000N002G02X+10021Y+0I+5000J+0%", ErrorCode::arc_wrong,
                 2, 'I'},
        ErrorRow{"D55_no_radius", "P0001N001G11F1000N002G02X+10000Y+0I+0J+0%", ErrorCode::arc_wrong, 2, 'I'},
        ErrorRow{"D55_end_point_on_the_centre", "P0001N001G11F1000N002G02X+10Y+0I+10J+0%", ErrorCode::arc_wrong, 2,
                 'I'},
        ErrorRow{"D68_G75_under_G90", "P0001N001G90N002G75X+2000%", ErrorCode::scale_not_allowed, 2, 'G'},
        ErrorRow{"D68_arc_with_unequal_factors", "P0001N001G11F1000N002G75X+2000Y+1000N003G02X+10000Y+0I+5000J+0%",
                 ErrorCode::scale_unequal, 3, 'G'},
        ErrorRow{"D45_arc_without_J", "P0001N001G11F1000N002G02X+10000Y+0I+5000%", ErrorCode::word_missing, 2, 'J'},
        ErrorRow{"D45_G00_without_axis", "P0001N001G90N002G00%", ErrorCode::word_missing, 2, 'X'}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Motion, D55ToleranceGrowsWithTheStep) {
  Settings coarse = wide_settings();
  coarse.steps_per_mm = {20, 20, 20, 20};  // two steps are 0.1 mm
  EXPECT_FALSE(run_text("P0001N001G11F1000N002G02X+10100Y+0I+5000J+0%", 9, {}, coarse).error);
  EXPECT_EQ(run_text("P0001N001G11F1000N002G02X+10101Y+0I+5000J+0%", 9, {}, coarse).code(), ErrorCode::arc_wrong);
  EXPECT_FALSE(run_text("P0001N001G11F1000N002G02X+10020Y+0I+5000J+0%").error);
}

TEST(Motion, AWayOfNothingIsNoElement) {
  const RunResult run = run_text("P0001N001G01X+0Y+0F1000N002G00Z+0%");
  ASSERT_FALSE(run.error);
  EXPECT_TRUE(all_of<Line>(run).empty());
}

TEST(Motion, ALoopThatRunsAwayIsStoppedByRange) {
  const RunResult run = run_text("P0001N001G11F1000N002G75X+9999999N003G01X+9999999N004G20P0001N003%", 2'000'000);
  EXPECT_EQ(run.code(), ErrorCode::word_out_of_range);
}

}  // namespace
}  // namespace cnclab::program
