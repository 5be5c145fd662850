// Arcs by their radius, helices, corners to round, exact stops: what becomes of their words.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "geometry/path_math.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using geometry::Arc;
using geometry::Line;
using geometry::Plane;
using geometry::Point;
using geometry::Turn;
using language::ErrorCode;

constexpr double kHalf = std::numbers::pi;

/// One arc and what it must be; the program's last block is the arc's.
struct ArcRow {
  const char* name;
  const char* text;
  Point to, center;
  Turn turn;
  Plane plane;
  double sweep;  ///< size, radians
};

class RadiusArcs : public testing::TestWithParam<ArcRow> {};

TEST_P(RadiusArcs, HaveThisCentre) {
  const ArcRow& row = GetParam();
  const RunResult run = run_text(row.text);
  ASSERT_FALSE(run.error) << language::explain(*run.error, language::Tongue::english);
  const auto arcs = all_of<Arc>(run);
  ASSERT_EQ(arcs.size(), 1u);
  const Arc& arc = arcs[0];
  const geometry::PlaneAxes& axes = geometry::axes_of(row.plane);
  EXPECT_EQ(arc.plane, row.plane);
  EXPECT_EQ(arc.turn, row.turn);
  EXPECT_EQ(arc.to, row.to);
  EXPECT_NEAR(arc.center.*axes.first, row.center.*axes.first, 1e-9);
  EXPECT_NEAR(arc.center.*axes.second, row.center.*axes.second, 1e-9);
  const geometry::ArcShape shape = geometry::shape_of(arc);
  EXPECT_NEAR(std::abs(shape.sweep), row.sweep, 1e-9);
  EXPECT_NEAR(shape.start_radius, shape.end_radius, 1e-9);
}

constexpr auto kCw = Turn::clockwise;
constexpr auto kCcw = Turn::counterclockwise;

INSTANTIATE_TEST_SUITE_P(, RadiusArcs,
                         testing::Values(ArcRow{"G050_quarter_clockwise",
                                                "P0001N001G05X+10000Y+10000R+10000F0500%",
                                                {10, 10},
                                                {10, 0},
                                                kCw,
                                                Plane::xy,
                                                kHalf / 2},
                                         ArcRow{"G060_quarter_counterclockwise",
                                                "P0001N001G06X+10000Y+10000R+10000F0500%",
                                                {10, 10},
                                                {0, 10},
                                                kCcw,
                                                Plane::xy,
                                                kHalf / 2},
                                         ArcRow{"D66_negative_R_is_the_longer_arc",
                                                "P0001N001G05X+10000Y+10000R-10000F0500%",
                                                {10, 10},
                                                {0, 10},
                                                kCw,
                                                Plane::xy,
                                                3 * kHalf / 2},
                                         ArcRow{"D66_negative_R_counterclockwise",
                                                "P0001N001G06X+10000Y+10000R-10000F0500%",
                                                {10, 10},
                                                {10, 0},
                                                kCcw,
                                                Plane::xy,
                                                3 * kHalf / 2},
                                         ArcRow{"D66_R_a_little_above_half_the_chord",
                                                "P0001N001G05X+10005Y+0R+5003F0500%",
                                                {10.005, 0},
                                                {5.0025, -std::sqrt(0.0005 * 10.0055)},
                                                kCw,
                                                Plane::xy,
                                                2 * std::asin(5.0025 / 5.003)},
                                         ArcRow{"D66_R_is_half_the_chord",
                                                "P0001N001G06X+30006Y-40008R+25005F0500%",
                                                {30.006, -40.008},
                                                {15.003, -20.004},
                                                kCcw,
                                                Plane::xy,
                                                kHalf},
                                         ArcRow{"BLK105_plane_XZ",
                                                "P0001N001G18N002G05X+10000R+10000Z+10000F0500%",
                                                {10, 0, 10},
                                                {0, 0, 10},
                                                kCw,
                                                Plane::xz,
                                                kHalf / 2},
                                         ArcRow{"BLK105_plane_YZ",
                                                "P0001N001G19N002G05R+10000Y+10000Z+10000F0500%",
                                                {0, 10, 10},
                                                {0, 10, 0},
                                                kCw,
                                                Plane::yz,
                                                kHalf / 2},
                                         ArcRow{"D68_R_is_scaled",
                                                "P0001N001G75X+2000Y+2000N002G05X+10000Y+10000R+10000F0500%",
                                                {20, 20},
                                                {20, 0},
                                                kCw,
                                                Plane::xy,
                                                kHalf / 2},
                                         ArcRow{"D68_R_is_scaled_and_mirrored",
                                                "P0001N001G75X-500Y+500N002G05X+10000Y+10000R+10000F0500%",
                                                {-5, 5},
                                                {-5, 0},
                                                kCcw,
                                                Plane::xy,
                                                kHalf / 2},
                                         ArcRow{"G022_end_point_under_G90",
                                                "P0001N001G90N002G00X+10000N003G06X+0Y+10000R+10000F0500%",
                                                {0, 10},
                                                {0, 0},
                                                kCcw,
                                                Plane::xy,
                                                kHalf / 2},
                                         ArcRow{"BLK106_F_in_the_block_before",
                                                "P0001N001G11F0300N002G06X+10000Y+10000R+10000%",
                                                {10, 10},
                                                {0, 10},
                                                kCcw,
                                                Plane::xy,
                                                kHalf / 2}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(RadiusArc, CarriesItsOwnWords_BLK105) {
  const RunResult run = run_text("P0001N001G05X+10000Y+10000R+10000F0700S0900T02M03%");
  ASSERT_FALSE(run.error);
  ASSERT_EQ(run.items.size(), 5u);  // digits, tool, spindle, arc, end
  EXPECT_EQ(std::get<Arc>(run.items[3].what).feed_mm_per_min, 700);
  const ModalState& modal = run.blocks.back().modal;
  EXPECT_EQ(modal.feed_mm_per_min, 700);
  EXPECT_EQ(modal.spindle_rpm, 900);
  EXPECT_EQ(modal.tool, 2);
  EXPECT_EQ(modal.spindle, geometry::SpindleTurn::clockwise);
}

TEST(RadiusArc, ReadsItsRadiusFromAParameter_PAR004) {
  Start start;
  start.parameters[7] = 10 * kParameterUnit;
  const RunResult run = run_text("P0001N001G05X+10000Y+10000R#07F0500%", 9, start);
  ASSERT_FALSE(run.error);
  EXPECT_NEAR(all_of<Arc>(run).at(0).center.x, 10, 1e-9);
}

TEST(Helix, IsAnArcThatMovesAlongZ_G070) {
  const RunResult run = run_text("P0001N001G11F0500N002G07X+10000Y+0I+5000J+0Z-4000N003G08X-10000Y+0I-5000J+0Z-1000%");
  ASSERT_FALSE(run.error);
  const auto arcs = all_of<Arc>(run);
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_EQ(arcs[0].to, (Point{10, 0, -4}));
  EXPECT_EQ(arcs[0].turn, kCw);
  EXPECT_NEAR(geometry::length_of(arcs[0]), std::hypot(5 * kHalf, 4), 1e-9);
  EXPECT_EQ(arcs[1].to, (Point{0, 0, -5}));
  EXPECT_EQ(arcs[1].turn, kCcw);
}

TEST(Helix, FullTurnInOneBlock_DEC04) {
  const RunResult run = run_text("P0001N001G11F0500N002G08X+0Y+0I-5000J+0Z+2000%");
  ASSERT_FALSE(run.error);
  EXPECT_NEAR(geometry::shape_of(all_of<Arc>(run).at(0)).sweep, 2 * kHalf, 1e-12);
}

TEST(Helix, ZIsScaledByItsOwnFactor_D68) {
  const RunResult run = run_text("P0001N001G75X+2000Y-2000Z+500N002G11F0500N003G07X+10000Y+0I+5000J+0Z-4000%");
  ASSERT_FALSE(run.error);
  const Arc arc = all_of<Arc>(run).at(0);
  EXPECT_EQ(arc.to, (Point{20, 0, -2}));
  EXPECT_EQ(arc.turn, kCcw) << "Y is mirrored";
}

/// Pulses of a circle of radius r: 4 r in each axis, so Z may have less than 8 r of them. 200 steps/mm.
struct PitchRow {
  const char* name;
  const char* words;
  bool is_allowed;
};

class HelixPitch : public testing::TestWithParam<PitchRow> {};

TEST_P(HelixPitch, ZPulsesMustBeFewerThanThoseOfXAndY_D65) {
  for (const char* function : {"G07", "G08"}) {
    const RunResult run = run_text(std::string("P0001N001G11F0500N002") + function + GetParam().words);
    if (GetParam().is_allowed) {
      EXPECT_FALSE(run.error) << function;
      continue;
    }
    EXPECT_EQ(run.code(), ErrorCode::helix_too_steep) << function;
    EXPECT_EQ(run.error->word, 'Z');
  }
}

INSTANTIATE_TEST_SUITE_P(
    , HelixPitch,
    testing::Values(PitchRow{"full_turn_of_40_mm", "X+0Y+0I+5000J+0Z+40000%", false},
                    PitchRow{"full_turn_one_pulse_less", "X+0Y+0I+5000J+0Z+39995%", true},
                    PitchRow{"downwards_counts_alike", "X+0Y+0I+5000J+0Z-40000%", false},
                    PitchRow{"half_turn_of_20_mm", "X+10000Y+0I+5000J+0Z+20000%", false},
                    PitchRow{"half_turn_one_pulse_less", "X+10000Y+0I+5000J+0Z+19995%", true},
                    PitchRow{"half_turn_from_a_slanting_start", "X-6000Y-8000I-3000J-4000Z+20000%", false},
                    PitchRow{"half_turn_from_a_slanting_start_less", "X-6000Y-8000I-3000J-4000Z+19990%", true},
                    PitchRow{"no_way_in_Z", "X+10000Y+0I+5000J+0Z+0%", true}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(HelixPitchSteps, CountInTheirOwnAxes_D65) {
  Settings settings = wide_settings();
  settings.steps_per_mm = {200, 200, 400, 200};  // Z needs twice the pulses
  constexpr auto kHalfTurn = "P0001N001G11F0500N002G07X+10000Y+0I+5000J+0Z+9995%";
  EXPECT_FALSE(run_text(kHalfTurn, 9, {}, settings).error);
  settings.steps_per_mm = {200, 200, 402, 200};
  EXPECT_EQ(run_text(kHalfTurn, 9, {}, settings).code(), ErrorCode::helix_too_steep);
}

struct ArcErrorRow {
  const char* name;
  const char* text;
  ErrorCode code;
  char word;
};

class ArcErrors : public testing::TestWithParam<ArcErrorRow> {};

TEST_P(ArcErrors, StopBeforeTheArcMoves) {
  const RunResult run = run_text(GetParam().text);
  ASSERT_EQ(run.code(), GetParam().code);
  EXPECT_EQ(run.error->word, GetParam().word);
  EXPECT_TRUE(all_of<Arc>(run).empty());
}

INSTANTIATE_TEST_SUITE_P(
    , ArcErrors,
    testing::Values(
        ArcErrorRow{"D66_R_below_half_the_chord", "P0001N001G05X+10005Y+0R+5002F0500%", ErrorCode::radius_too_small,
                    'R'},
        ArcErrorRow{"D66_size_of_negative_R_below_half_the_chord", "P0001N001G06X+10005Y+0R-5002F0500%",
                    ErrorCode::radius_too_small, 'R'},
        ArcErrorRow{"D66_scaled_alike_it_stays_too_small", "P0001N001G75X+3000Y-3000N002G06X+10005Y+0R+5002F0500%",
                    ErrorCode::radius_too_small, 'R'},
        ArcErrorRow{"D66_R_of_nothing", "P0001N001G05X+10000Y+0R+0F0500%", ErrorCode::radius_too_small, 'R'},
        ArcErrorRow{"DEC04_no_full_circle_without_centre", "P0001N001G05X+0Y+0R+5000F0500%", ErrorCode::arc_without_way,
                    'R'},
        ArcErrorRow{"D59_G05_without_F", "P0001N001G05X+10000Y+0R+5000%", ErrorCode::feed_missing, 'F'},
        ArcErrorRow{"D45_G06_without_R", "P0001N001G06X+10000Y+0F0500%", ErrorCode::word_missing, 'R'},
        ArcErrorRow{"D45_G05_without_Y", "P0001N001G05X+10000R+5000F0500%", ErrorCode::word_missing, 'Y'},
        ArcErrorRow{"D54_G05_of_another_plane", "P0001N001G19N002G05X+10000Y+0R+5000F0500%", ErrorCode::plane_wrong,
                    'G'},
        ArcErrorRow{"D68_G05_with_unequal_factors", "P0001N001G75X+2000N002G05X+10000Y+0R+5000F0500%",
                    ErrorCode::scale_unequal, 'G'},
        ArcErrorRow{"DEC64_G07_under_G18", "P0001N001G11F0500N002G18N003G07X+10000Y+0I+5000J+0Z+1000%",
                    ErrorCode::plane_wrong, 'G'},
        ArcErrorRow{"DEC64_G08_under_G19", "P0001N001G11F0500N002G19N003G08X+10000Y+0I+5000J+0Z+1000%",
                    ErrorCode::plane_wrong, 'G'},
        ArcErrorRow{"D55_helix_off_its_circle", "P0001N001G11F0500N002G07X+10021Y+0I+5000J+0Z+1000%",
                    ErrorCode::arc_wrong, 'I'},
        ArcErrorRow{"BLK107_helix_without_Z", "P0001N001G11F0500N002G07X+10000Y+0I+5000J+0%", ErrorCode::word_missing,
                    'Z'},
        ArcErrorRow{"D59_G07_without_F", "P0001N001G07X+10000Y+0I+5000J+0Z+1000%", ErrorCode::feed_missing, 'F'},
        ArcErrorRow{"D68_helix_with_unequal_factors", "P0001N001G11F0500N002G75X+2000N003G07X+10000Y+0I+5000J+0Z+1000%",
                    ErrorCode::scale_unequal, 'G'},
        ArcErrorRow{"D66_rounding_without_radius", "P0001N001G10R+0%", ErrorCode::word_out_of_range, 'R'},
        ArcErrorRow{"D66_rounding_with_negative_radius", "P0001N001G10R-1000%", ErrorCode::word_out_of_range, 'R'},
        ArcErrorRow{"D68_rounding_with_unequal_factors", "P0001N001G75X+2000N002G10R+1000%", ErrorCode::scale_unequal,
                    'G'}),
    [](const auto& row) { return std::string(row.param.name); });

struct SentenceRow {
  const char* text;
  const char* sentence;
};

TEST(ArcSentences, NameWordValueAndLimit_DEC01) {
  constexpr SentenceRow kRows[] = {
      {"P0001N001G05X+10000Y+0R+4999F0500%", "R 4.999 does not reach the end point, right: R >= 5.000."},
      {"P0001N001G06X+10001Y+0R-5000F0500%", "R -5.000 does not reach the end point, right: R <= -5.001."},
      {"P0001N001G05X+0Y+0R+5000F0500%", "R 5.000: end point is the start point. Full circle by G02 or G03."},
      {"P0001N001G11F0500N002G75X+2000Y+1000N003G02X+10000Y+0I+5000J+0%",
       "G75 X 2.000 Y 1.000: an arc needs equal scale factors. Change G75."},
  };
  for (const SentenceRow& row : kRows) {
    const RunResult run = run_text(row.text);
    ASSERT_TRUE(run.error) << row.text;
    EXPECT_THAT(language::message_of(*run.error, language::Tongue::english), testing::StartsWith(row.sentence));
  }
}

TEST(Corner, IsAnOrderBetweenItsTwoWays_G100) {
  const RunResult run =
      run_text("P0001N001G18N002G75X+2000Z-2000N003G01X+10000F0500N004G10R+1500N005G01Z+10000N006G74N007G10R+1500%");
  ASSERT_FALSE(run.error);
  const auto corners = all_of<geometry::CornerRounding>(run);
  ASSERT_EQ(corners.size(), 2u);
  EXPECT_EQ(corners[0].radius_mm, 3) << "D-68: R is scaled too";
  EXPECT_EQ(corners[0].plane, Plane::xz);
  EXPECT_EQ(corners[1].radius_mm, 1.5);
  const auto at = [&](std::size_t i) { return run.items.at(i).source.block; };
  EXPECT_EQ(at(2), 3);
  EXPECT_EQ(at(3), 4);
  EXPECT_TRUE(std::holds_alternative<geometry::CornerRounding>(run.items[3].what));
  EXPECT_TRUE(run.items[3].ends_block);
  EXPECT_EQ(at(4), 5);
}

TEST(ExactStop, MarksTheWaysOfG61ToG66_G610) {
  const RunResult run = run_text(
      "P0001N001G61X+10000F0500M05N002G62X+10000Y+0I+5000J+0N003G63X+10000Y+0I+5000J+0N004G64H0010"
      "N005G65X+10000Y+0R+5000N006G66X+10000Y+0R+5000N007G01X+1000%");
  ASSERT_FALSE(run.error) << language::explain(*run.error, language::Tongue::english);
  std::string text;
  for (const geometry::PathItem& item : run.items)
    if (std::holds_alternative<Line>(item.what) || std::holds_alternative<Arc>(item.what))
      text += item.exact_stop ? 'e' : '-';
    else
      EXPECT_FALSE(item.exact_stop);
  EXPECT_EQ(text, "eeeee-");
  EXPECT_EQ(all_of<geometry::Dwell>(run).size(), 1u) << "G64 dwells as G04 does";
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{51'000, 0, 0}));
}

TEST(ExactStop, IsOtherwiseTheSameWay_D03) {
  const auto path = [](const char* numbers) {
    std::string text = "P0001N001G11F0500";
    int block = 2;
    for (const char* words :
         {"1X+10000Y+3000", "2X+10000Y+0I+5000J+0", "3X+10000Y+0I+5000J+0", "5X+1Y+9R+500", "6X+10Y+99R-7000"})
      text += "N00" + std::to_string(block++) + "G" + numbers + words;
    return run_text(text + "%").json();
  };
  EXPECT_EQ(path("0"), path("6"));
}

}  // namespace
}  // namespace cnclab::program
