// The cycles G81 to G86 as their descriptions list them: every step, and everything that they refuse.
#include <gmock/gmock.h>

#include "cycle_run.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;
using testing::IsEmpty;

using Texts = std::vector<std::string>;

struct StepRow {
  const char* name;
  const char* block;
  int safety_mm;  ///< V: the height of the call over the surface, Z 0
  Texts steps;
};

class CycleSteps : public testing::TestWithParam<StepRow> {};

TEST_P(CycleSteps, AreThoseOfTheDescription) {
  const Start start = start_at(0, 0, GetParam().safety_mm);
  const RunResult run = run_cycle(GetParam().block, start);
  EXPECT_FALSE(run.error) << language::explain(run.error.value_or(language::Error{}), language::Tongue::english);
  EXPECT_EQ(texts_of(cycle_steps(run, start)), GetParam().steps);
}

INSTANTIATE_TEST_SUITE_P(
    , CycleSteps,
    testing::Values(
        StepRow{"CYC081_CYC094_G81", "G81Z-10000V002H0005", 2,
                Texts{"N101 rapid 0 0 0.5", "N121 feed 0 0 -10", "N122 dwell 5", "N125 rapid 0 0 2"}},
        StepRow{"CYC006_G81_disregards_Q_X_Y", "G81X+5000Y-5000Z-10000Q-4000V002H0000", 2,
                Texts{"N101 rapid 0 0 0.5", "N121 feed 0 0 -10", "N125 rapid 0 0 2"}},
        StepRow{"CYC082_CYC093_EX062_G82", "G82Z-10000Q-4000V002H0005", 2,
                Texts{"N101 rapid 0 0 0.5", "N104 feed 0 0 -4", "N106 rapid 0 0 2", "N101 rapid 0 0 -3.5",
                      "N104 feed 0 0 -8", "N106 rapid 0 0 2", "N101 rapid 0 0 -7.5", "N121 feed 0 0 -10",
                      "N122 dwell 5", "N125 rapid 0 0 2"}},
        StepRow{"CYC082_G82_Q_divides_Z", "G82Z-8000Q-4000V002H0000", 2,
                Texts{"N101 rapid 0 0 0.5", "N104 feed 0 0 -4", "N106 rapid 0 0 2", "N101 rapid 0 0 -3.5",
                      "N121 feed 0 0 -8", "N125 rapid 0 0 2"}},
        StepRow{"CYC082_G82_Q_beyond_Z", "G82Z-3000Q-4000V010H0000", 10,
                Texts{"N101 rapid 0 0 0.5", "N121 feed 0 0 -3", "N125 rapid 0 0 10"}},
        StepRow{"CYC083_D86_G83", "G83Z-12000V003H0010", 3,
                Texts{"N100 cw", "N101 rapid 0 0 0.5", "N102 feed 0 0 -12", "N103 off", "N104 dwell 10", "N105 ccw",
                      "N107 feed 0 0 3", "N108 off"}},
        StepRow{"CYC084_CYC092_CYC096_D84_G84", "G84X+40000Y+0Z-10000Q-4000V002", 2,
                Texts{"N100 rapid -15 0 2", "N102 rapid -15 0 0.5", "N105 feed -15 0 -4", "N106 feed 15 0 -4",
                      "N108 rapid 15 0 2", "N102 rapid 15 0 -3.5", "N105 feed 15 0 -8", "N106 feed -15 0 -8",
                      "N108 rapid -15 0 2", "N102 rapid -15 0 -7.5", "N121 feed -15 0 -10", "N122 feed 15 0 -10",
                      "N124 rapid 15 0 2", "N125 rapid 0 0 2"}},
        StepRow{"CYC084_G84_along_Y", "G84X+0Y+40000Z-4000Q-4000V002H0099", 2,
                Texts{"N100 rapid 0 -15 2", "N102 rapid 0 -15 0.5", "N121 feed 0 -15 -4", "N122 feed 0 15 -4",
                      "N124 rapid 0 15 2", "N125 rapid 0 0 2"}},
        StepRow{"DEC53_G84_as_long_as_the_cutter_is_wide", "G84X+10000Y+0Z-4000Q-4000V002", 2,
                Texts{"N102 rapid 0 0 0.5", "N121 feed 0 0 -4", "N124 rapid 0 0 2"}},
        StepRow{"CYC085_CYC091_CYC092_D85_G85", "G85X+40000Y+30000Z-5000Q-3000V002", 2,
                Texts{"N103 rapid -15 -10 2",   "N106 rapid -15 -10 0.5",  "N109 feed -15 -10 -3",
                      "N113 feed 15 -10 -3",    "N114 feed 15 10 -3",      "N117 feed -15 10 -3",
                      "N118 feed -15 -10 -3",   "N129 feed -14.5 -9.5 -3", "N130 feed 14.5 -9.5 -3",
                      "N140 feed 14.5 -1.5 -3", "N130 feed -14.5 -1.5 -3", "N140 feed -14.5 6.5 -3",
                      "N130 feed 14.5 6.5 -3",  "N135 feed 14.5 9.5 -3",   "N136 feed -14.5 9.5 -3",
                      "N151 rapid -14.5 9.5 2", "N103 rapid -15 -10 2",    "N106 rapid -15 -10 -2.5",
                      "N112 feed -15 -10 -5",   "N113 feed 15 -10 -5",     "N114 feed 15 10 -5",
                      "N117 feed -15 10 -5",    "N118 feed -15 -10 -5",    "N129 feed -14.5 -9.5 -5",
                      "N130 feed 14.5 -9.5 -5", "N140 feed 14.5 -1.5 -5",  "N130 feed -14.5 -1.5 -5",
                      "N140 feed -14.5 6.5 -5", "N130 feed 14.5 6.5 -5",   "N135 feed 14.5 9.5 -5",
                      "N136 feed -14.5 9.5 -5", "N151 rapid -14.5 9.5 2",  "N157 rapid 0 0 2"}},
        StepRow{"CYC095_G85_one_layer", "G85X+40000Y+30000Z-5000Q-5000V002", 2,
                Texts{"N103 rapid -15 -10 2", "N106 rapid -15 -10 0.5", "N112 feed -15 -10 -5", "N113 feed 15 -10 -5",
                      "N114 feed 15 10 -5", "N117 feed -15 10 -5", "N118 feed -15 -10 -5", "N129 feed -14.5 -9.5 -5",
                      "N130 feed 14.5 -9.5 -5", "N140 feed 14.5 -1.5 -5", "N130 feed -14.5 -1.5 -5",
                      "N140 feed -14.5 6.5 -5", "N130 feed 14.5 6.5 -5", "N135 feed 14.5 9.5 -5",
                      "N136 feed -14.5 9.5 -5", "N151 rapid -14.5 9.5 2", "N157 rapid 0 0 2"}},
        StepRow{"DEC53_G85_without_rows", "G85X+10400Y+30000Z-5000Q-5000V002", 2,
                Texts{"N103 rapid -0.2 -10 2", "N106 rapid -0.2 -10 0.5", "N112 feed -0.2 -10 -5",
                      "N113 feed 0.2 -10 -5", "N114 feed 0.2 10 -5", "N117 feed -0.2 10 -5", "N118 feed -0.2 -10 -5",
                      "N151 rapid -0.2 -10 2", "N157 rapid 0 0 2"}},
        // Exactly 1 mm of frame: the frame clears it (DEC-53).
        StepRow{"DEC53_G85_frame_of_1_mm_in_X", "G85X+11000Y+30000Z-5000Q-5000V002", 2,
                Texts{"N103 rapid -0.5 -10 2", "N106 rapid -0.5 -10 0.5", "N112 feed -0.5 -10 -5",
                      "N113 feed 0.5 -10 -5", "N114 feed 0.5 10 -5", "N117 feed -0.5 10 -5", "N118 feed -0.5 -10 -5",
                      "N151 rapid -0.5 -10 2", "N157 rapid 0 0 2"}},
        StepRow{"DEC53_G85_frame_of_1_mm_in_Y", "G85X+30000Y+11000Z-5000Q-5000V002", 2,
                Texts{"N103 rapid -10 -0.5 2", "N106 rapid -10 -0.5 0.5", "N112 feed -10 -0.5 -5",
                      "N113 feed 10 -0.5 -5", "N114 feed 10 0.5 -5", "N117 feed -10 0.5 -5", "N118 feed -10 -0.5 -5",
                      "N151 rapid -10 -0.5 2", "N157 rapid 0 0 2"}},
        StepRow{"CYC086_DEC03_G86", "G86R+25000D000W04Z-10000Q-4000V002H0005", 2,
                Texts{"N109 rapid 25 0 2",     "N121 rapid 25 0 0.5",   "N124 feed 25 0 -4",     "N126 rapid 25 0 2",
                      "N121 rapid 25 0 -3.5",  "N124 feed 25 0 -8",     "N126 rapid 25 0 2",     "N121 rapid 25 0 -7.5",
                      "N131 feed 25 0 -10",    "N132 dwell 5",          "N134 rapid 25 0 2",     "N109 rapid 0 25 2",
                      "N121 rapid 0 25 0.5",   "N124 feed 0 25 -4",     "N126 rapid 0 25 2",     "N121 rapid 0 25 -3.5",
                      "N124 feed 0 25 -8",     "N126 rapid 0 25 2",     "N121 rapid 0 25 -7.5",  "N131 feed 0 25 -10",
                      "N132 dwell 5",          "N134 rapid 0 25 2",     "N109 rapid -25 0 2",    "N121 rapid -25 0 0.5",
                      "N124 feed -25 0 -4",    "N126 rapid -25 0 2",    "N121 rapid -25 0 -3.5", "N124 feed -25 0 -8",
                      "N126 rapid -25 0 2",    "N121 rapid -25 0 -7.5", "N131 feed -25 0 -10",   "N132 dwell 5",
                      "N134 rapid -25 0 2",    "N109 rapid 0 -25 2",    "N121 rapid 0 -25 0.5",  "N124 feed 0 -25 -4",
                      "N126 rapid 0 -25 2",    "N121 rapid 0 -25 -3.5", "N124 feed 0 -25 -8",    "N126 rapid 0 -25 2",
                      "N121 rapid 0 -25 -7.5", "N131 feed 0 -25 -10",   "N132 dwell 5",          "N134 rapid 0 -25 2",
                      "N144 rapid 0 0 2"}},
        StepRow{"DEC03_G86_without_Q", "G86R+25000D180W02Z-10000V002H0005", 2,
                Texts{"N109 rapid -25 0 2", "N121 rapid -25 0 0.5", "N131 feed -25 0 -10", "N132 dwell 5",
                      "N134 rapid -25 0 2", "N109 rapid 25 0 2", "N121 rapid 25 0 0.5", "N131 feed 25 0 -10",
                      "N132 dwell 5", "N134 rapid 25 0 2", "N144 rapid 0 0 2"}},
        StepRow{"DEC03_G86_one_hole", "G86R+1000D090W01Z-1000V002H0000", 2,
                Texts{"N109 rapid 0 1 2", "N121 rapid 0 1 0.5", "N131 feed 0 1 -1", "N134 rapid 0 1 2",
                      "N144 rapid 0 0 2"}}),
    [](const auto& row) { return std::string(row.param.name); });

struct RefusalRow {
  const char* name;
  const char* block;
  ErrorCode code;
  char word;
  std::int64_t radius_um = 5000;
};

class CycleRefusals : public testing::TestWithParam<RefusalRow> {};

TEST_P(CycleRefusals, MoveNothing_ROM03) {
  const RefusalRow& row = GetParam();
  const RunResult run = run_cycle(row.block, start_at(0, 0, 2), row.radius_um);
  ASSERT_EQ(run.code(), row.code);
  EXPECT_EQ(run.error->program, 1);
  EXPECT_EQ(run.error->block, 1);
  EXPECT_EQ(run.error->word, row.word);
  EXPECT_THAT(run.items, IsEmpty());
  EXPECT_EQ(run.parameters, Parameters{});
}

constexpr auto kWrong = ErrorCode::cycle_value_wrong;
INSTANTIATE_TEST_SUITE_P(
    , CycleRefusals,
    testing::Values(RefusalRow{"D89_Z_0", "G81Z+0V002H0000", kWrong, 'Z'},
                    RefusalRow{"CYC011_Z_positive", "G83Z+5000V002H0000", kWrong, 'Z'},
                    RefusalRow{"D89_Q_0_in_G82", "G82Z-5000Q+0V002H0000", kWrong, 'Q'},
                    RefusalRow{"D89_Q_positive_in_G84", "G84X+40000Y+0Z-5000Q+1000V002", kWrong, 'Q'},
                    RefusalRow{"D89_Q_0_by_parameter", "G82Z-5000Q#01V002H0000", kWrong, 'Q'},
                    RefusalRow{"ROM03_Q_positive_in_G86", "G86R+25000D000W04Z-5000Q+1V002H0000", kWrong, 'Q'},
                    RefusalRow{"DEC53_G84_with_X_and_Y", "G84X+40000Y+40000Z-5000Q-1000V002", kWrong, 'Y'},
                    RefusalRow{"DEC53_G84_with_neither", "G84X+0Y+0Z-5000Q-1000V002", kWrong, 'Y'},
                    RefusalRow{"DEC53_G84_shorter_than_2R", "G84X+9999Y+0Z-5000Q-1000V002", kWrong, 'X'},
                    RefusalRow{"DEC53_G84_in_Y_shorter_than_2R", "G84X+0Y+9999Z-5000Q-1000V002", kWrong, 'Y'},
                    RefusalRow{"DEC53_G84_negative", "G84X-40000Y+0Z-5000Q-1000V002", kWrong, 'X'},
                    RefusalRow{"CYC090_G85_X_is_2R", "G85X+10000Y+30000Z-5000Q-1000V002", kWrong, 'X'},
                    RefusalRow{"CYC090_G85_Y_is_2R", "G85X+30000Y+10000Z-5000Q-1000V002", kWrong, 'Y'},
                    RefusalRow{"CYC090_G85_R_is_half_a_millimetre", "G85X+30000Y+30000Z-5000Q-1000V002", kWrong, 'T',
                               500},
                    RefusalRow{"D85_G85_X_0_by_parameter", "G85X#01Y+30000Z-5000Q-1000V002", kWrong, 'X'},
                    RefusalRow{"ROM03_G86_R_0", "G86R+0D000W04Z-5000V002H0000", kWrong, 'R'},
                    RefusalRow{"ROM03_G86_W_00", "G86R+25000D000W00Z-5000V002H0000", kWrong, 'W'},
                    RefusalRow{"D88_V_0_by_parameter", "G81Z-5000V#01H0000", ErrorCode::word_out_of_range, 'V'},
                    RefusalRow{"D91_Z_too_near_the_range", "G81Z-9999000V002H0000", kWrong, 'Z'},
                    RefusalRow{"D91_circle_beyond_the_range", "G86R+9999000D000W04Z-5000V002H0000", kWrong, 'R'},
                    RefusalRow{"D45_incomplete", "G82Z-5000V002H0000", ErrorCode::word_missing, 'Q'}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(CycleRefusal, SayWhichParameterWasWrong) {
  Start start = start_at(0, 0, 2);
  start.parameters[1] = 9 * kParameterUnit;
  const RunResult run = run_cycle("G84X#01Y+0Z-5000Q-1000V002", start);
  ASSERT_EQ(run.code(), kWrong);
  EXPECT_EQ(run.error->detail, "#01 = 9.000");
  EXPECT_EQ(run.error->expected, "X >= 10.000 (2R)");
}

TEST(CycleRefusal, OfAToolThatIsNotThere_D85) {
  Start start = start_at(0, 0, 2);
  start.modal.tool = 0;
  EXPECT_EQ(run_cycle("G85X+40000Y+30000Z-5000Q-1000V002", start).code(), kWrong);
  // D-84: a slot without tool runs from end to end.
  const RunResult slot = run_cycle("G84X+40000Y+0Z-1000Q-1000V002", start);
  EXPECT_EQ(texts_of(cycle_steps(slot, start)).front(), "N100 rapid -20 0 2");
}

TEST(CycleRefusal, OfAPlaceThatNoParameterHolds_D91) {
  const RunResult run = run_cycle("G81Z-1000V002H0000", start_at(0, 0, 10'000));
  EXPECT_EQ(run.code(), ErrorCode::word_out_of_range);
  EXPECT_THAT(run.items, IsEmpty());
}

TEST(CycleRefusal, OfMissingFeedAndOfCompensation_DEC53) {
  for (const char* block :
       {"G81Z-5000V002H0000", "G82Z-5000Q-1000V002H0000", "G83Z-5000V002H0000", "G84X+40000Y+0Z-5000Q-1000V002",
        "G85X+40000Y+30000Z-5000Q-1000V002", "G86R+25000D000W04Z-5000V002H0000"}) {
    Start start = start_at(0, 0, 2);
    start.modal.feed_mm_per_min = 0;
    const RunResult without_feed = run_cycle(block, start);
    EXPECT_EQ(without_feed.code(), ErrorCode::feed_missing) << block;
    EXPECT_THAT(without_feed.items, IsEmpty());
    start.modal.feed_mm_per_min = 3001;
    EXPECT_EQ(run_cycle(block, start).code(), ErrorCode::feed_above_limit) << block;
    start.modal.feed_mm_per_min = 300;
    using enum RadiusCompensation;
    for (const RadiusCompensation radius : {left, right, plus, minus}) {
      start.modal.radius = radius;
      const RunResult compensated = run_cycle(block, start);
      EXPECT_EQ(compensated.code(), ErrorCode::compensation_impossible) << block;
      EXPECT_THAT(compensated.items, IsEmpty());
    }
  }
}

TEST(CycleRefusal, OfACutterThatHasNotLeftItsContour_DEC53) {
  const std::string contour =
      "P0000T001R+5000L+0\nP0001N001G11F0300T01N002G41N003G01X+20000N004G01X+20000Y+20000N005G40";
  const RunResult beside = run_text(contour + "N006G81Z-1000V001H0000%");
  ASSERT_EQ(beside.code(), ErrorCode::compensation_impossible);
  EXPECT_EQ(beside.error->block, 6);
  EXPECT_FALSE(run_text(contour + "N006G00X+1000Y+1000N007G81Z-1000V001H0000%").error);
}

}  // namespace
}  // namespace cnclab::program
