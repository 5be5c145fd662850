// Parametric functions: values, the result register, jumps, words by parameter (section PAR; D-91 to D-96).
#include <gmock/gmock.h>

#include <map>

#include "run_text.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;
using testing::IsEmpty;

constexpr std::int64_t kParameterUm = 1'000;  // parameters count 1/1 000 000 mm
constexpr std::int64_t kMm = kParameterUnit;

using Values = std::map<std::size_t, std::int64_t>;

Parameters parameters_of(const Values& values) {
  Parameters parameters{};
  for (const auto& [number, value] : values) parameters.at(number) = value;
  return parameters;
}

/// Behind the blocks under test: which of the four jumps ↓50 ↓51 ↓52 ↓54 would be taken, noted in #30 to #33.
constexpr std::string_view kNoteFlags =
    "N900\\50N902N901\\53N903N902\\00#30+1000N903\\51N905N904\\53N906N905\\00#31+1000"
    "N906\\52N908N907\\53N909N908\\00#32+1000N909\\54N911N910\\53N912N911\\00#33+1000N912G17%";

std::string flags_of(const RunResult& run) {
  std::string flags;
  for (std::size_t i = 0; i < 4; ++i)
    if (run.parameters[30 + i] != 0) flags += "ZPNC"[i];
  return flags;
}

RunResult run_with(const Values& before, const std::string& blocks) {
  Start start;
  start.parameters = parameters_of(before);
  return run_text("P0001" + blocks + std::string(kNoteFlags), 100, start);
}

struct CalculationRow {
  const char* name;
  Values before;
  const char* block;
  std::int64_t result;  ///< #01
  const char* flags;    ///< of the result register, Z P N C
};

class Calculations : public testing::TestWithParam<CalculationRow> {};

TEST_P(Calculations, SetParameterAndResultRegister) {
  const CalculationRow& row = GetParam();
  const RunResult run = run_with(row.before, std::string("N001") + row.block);
  EXPECT_FALSE(run.error);
  EXPECT_EQ(run.parameters[1], row.result);
  EXPECT_EQ(flags_of(run), row.flags);
}

constexpr std::int64_t kMost = 9'999'999'000;

INSTANTIATE_TEST_SUITE_P(
    , Calculations,
    testing::Values(
        CalculationRow{"PAR010_assign", {}, "\\00#01-12345", -12'345 * kParameterUm, ""},
        CalculationRow{"PAR010_largest", {}, "\\00#01+9999999", kMost, ""},
        CalculationRow{"PAR011_add", {{2, 3}, {3, 4}}, "\\01#01#02#03", 7, "P"},
        CalculationRow{"EX061",
                       {{2, 1'500 * kParameterUm}, {3, -2'000 * kParameterUm}},
                       "\\01#01#02#03",
                       -500 * kParameterUm,
                       "N"},
        CalculationRow{"PAR011_zero", {{2, 5}, {3, -5}}, "\\01#01#02#03", 0, "Z"},
        CalculationRow{"PAR011_into_itself", {{1, 5}}, "\\01#01#01#01", 10, "P"},
        CalculationRow{"D91_add_above", {{2, kMost}, {3, 1}}, "\\01#01#02#03", kMost, "PC"},
        CalculationRow{"PAR012_subtract", {{2, 3}, {3, 4}}, "\\02#01#02#03", -1, "N"},
        CalculationRow{"D91_subtract_below", {{2, -kMost}, {3, 1}}, "\\02#01#02#03", -kMost, "NC"},
        CalculationRow{"PAR013_multiply", {{2, 3 * kMm}, {3, -4 * kMm}}, "\\03#01#02#03", -12 * kMm, "N"},
        CalculationRow{"DEC52_six_decimals",
                       {{2, 800 * kParameterUm}, {3, 12'346 * kParameterUm}},
                       "\\03#01#02#03",
                       9'876'800,
                       "P"},
        CalculationRow{"D91_multiply_above", {{2, 100 * kMm}, {3, -100 * kMm}}, "\\03#01#02#03", -kMost, "NC"},
        CalculationRow{"PAR013_too_small", {{2, 1}, {3, 1}}, "\\03#01#02#03", 0, "Z"},
        CalculationRow{"PAR014_divide", {{2, 1 * kMm}, {3, 3 * kMm}}, "\\04#01#02#03", 333'333, "P"},
        CalculationRow{"D91_divide_by_zero", {{1, -7}, {2, 5}}, "\\04#01#02#03", -7, "NC"},
        CalculationRow{"D91_divide_above", {{2, 5 * kMm}, {3, 1}}, "\\04#01#02#03", kMost, "PC"},
        CalculationRow{"PAR015_copy", {{2, -5}}, "\\10#01#02", -5, ""},
        CalculationRow{"PAR016_increase", {{2, 500 * kParameterUm}}, "\\11#01#02", 1'500 * kParameterUm, "P"},
        CalculationRow{"PAR016_to_zero", {{2, -1 * kMm}}, "\\11#01#02", 0, "Z"},
        CalculationRow{"D91_increase_above", {{2, kMost - 1}}, "\\11#01#02", kMost, "PC"},
        CalculationRow{"PAR017_decrease", {{2, 500 * kParameterUm}}, "\\12#01#02", -500 * kParameterUm, "N"},
        CalculationRow{"D91_decrease_below", {{2, -kMost}}, "\\12#01#02", -kMost, "NC"},
        CalculationRow{"PAR018_complement", {{2, 5}}, "\\13#01#02", -5, ""},
        CalculationRow{"PAR019_absolute", {{2, -5}}, "\\14#01#02", 5, ""},
        CalculationRow{"PAR019_absolute_of_positive", {{2, 5}}, "\\14#01#02", 5, ""},
        CalculationRow{"PAR020_root", {{2, 2 * kMm}}, "\\15#01#02", 1'414'214, ""},
        CalculationRow{"D91_root_of_negative", {{1, 9}, {2, -4 * kMm}}, "\\15#01#02", 0, ""},
        CalculationRow{"PAR021_sine", {{2, 30 * kMm}}, "\\16#01#02", 500 * kParameterUm, ""},
        CalculationRow{"PAR022_cosine", {{2, 120 * kMm}}, "\\17#01#02", -500 * kParameterUm, ""}),
    [](const auto& row) { return std::string(row.param.name); });

/// Functions without a star keep what the register said before (PAR-030, PAR-031).
TEST(ResultRegister, IsKeptByAllOtherFunctions_PAR031) {
  for (const char* block : {"\\00#01+0", "\\10#01#02", "\\13#01#02", "\\14#01#02", "\\15#01#02", "\\16#01#02",
                            "\\17#01#02", "G91", "G04H0001", "G00X+1000", "\\53N003"}) {
    const Values before{{2, 5}, {4, -9'999 * kMm}, {5, -1 * kMm}};
    const RunResult run = run_with(before, std::string("N001\\01#03#04#05N002") + block + "N003G17");
    EXPECT_EQ(flags_of(run), "NC") << block;
  }
}

TEST(ResultRegister, IsClearedAtStart_D92) { EXPECT_EQ(flags_of(run_with({{1, 5}}, "N001G17")), ""); }

TEST(ResultRegister, LosesCarryWithTheNextCalculation_D92) {
  const RunResult run = run_with({{4, kMost}, {5, 1}}, "N001\\01#03#04#05N002\\11#03#05");
  EXPECT_EQ(flags_of(run), "P");
}

struct JumpRow {
  const char* name;
  const char* text;
  const char* order;
};

class ParametricJumps : public testing::TestWithParam<JumpRow> {};

TEST_P(ParametricJumps, LeadHere) {
  const RunResult run = run_text(GetParam().text, 20);
  EXPECT_FALSE(run.error);
  EXPECT_EQ(run.order(), GetParam().order);
}

INSTANTIATE_TEST_SUITE_P(
    , ParametricJumps,
    testing::Values(
        JumpRow{"PAR023_zero", "P0001N001\\01#01#02#03N002\\50N004N003G17N004G18%", "P1N1 P1N2 P1N4"},
        JumpRow{"PAR023_not_zero", "P0001N001\\11#01#02N002\\50N004N003G17N004G18%", "P1N1 P1N2 P1N3 P1N4"},
        JumpRow{"PAR024_positive", "P0001N001\\11#01#02N002\\51N004N003G17N004G18%", "P1N1 P1N2 P1N4"},
        JumpRow{"D92_zero_is_not_positive", "P0001N001\\01#01#02#03N002\\51N004N003G17N004G18%", "P1N1 P1N2 P1N3 P1N4"},
        JumpRow{"PAR025_negative", "P0001N001\\12#01#02N002\\52N004N003G17N004G18%", "P1N1 P1N2 P1N4"},
        JumpRow{"PAR026_always", "P0001N001\\53N004N003G17N004G18%", "P1N1 P1N4"},
        JumpRow{"PAR027_carry", "P0001N001\\04#01#02#03N002\\54N004N003G17N004G18%", "P1N1 P1N2 P1N4"},
        JumpRow{"PAR027_no_carry", "P0001N001\\01#01#02#03N002\\54N004N003G17N004G18%", "P1N1 P1N2 P1N3 P1N4"},
        JumpRow{"PAR026_back", "P0001N001\\00#01+3000N002\\12#01#01N003\\51N002%",
                "P1N1 P1N2 P1N3 P1N2 P1N3 P1N2 P1N3"},
        JumpRow{"D94_target_by_parameter", "P0001N001\\00#05+4900N002\\53N#05N003G17N004G18%", "P1N1 P1N2 P1N4"},
        JumpRow{"PAR032_in_a_subprogram", "P0001N001G22P0002N001W00N002G17\nP0002N001\\53N003N002G17N003G18%",
                "P1N1 P2N1 P2N3 P1N2"},
        JumpRow{"PAR032_after_G20", "P0001N001G20P0002N001N003G17\nP0002N001\\53N003N002G17N003G18%", "P1N1 P2N1 P2N3"},
        JumpRow{"D96_missing_target_of_a_jump_not_taken", "P0001N001\\50N099N002G17%", "P1N1 P1N2"}),
    [](const auto& row) { return std::string(row.param.name); });

struct FaultRow {
  const char* name;
  Values parameters;
  const char* text;
  ErrorCode code;
  int block;
  const char* detail;
};

class ParametricFaults : public testing::TestWithParam<FaultRow> {};

TEST_P(ParametricFaults, NameBlockParameterAndValue) {
  const FaultRow& row = GetParam();
  Settings settings = wide_settings();
  settings.travel_mm = {500, 500, 500};
  Start start;
  start.parameters = parameters_of(row.parameters);
  const RunResult run = run_text(row.text, 20, start, settings);
  ASSERT_EQ(run.code(), row.code);
  EXPECT_EQ(run.error->block, row.block);
  EXPECT_EQ(run.error->detail, row.detail);
  EXPECT_EQ(run.parameters, start.parameters);  // a block that fails changes nothing
}

INSTANTIATE_TEST_SUITE_P(
    , ParametricFaults,
    testing::Values(
        FaultRow{"D93_64", {}, "P0001N001\\00#64+1000%", ErrorCode::parameter_read_only, 1, "#64"},
        FaultRow{"D93_68", {}, "P0001N001G17N002\\01#68#01#02%", ErrorCode::parameter_read_only, 2, "#68"},
        FaultRow{"D96", {}, "P0001N001\\53N099%", ErrorCode::block_missing, 1, "N099 in P0001"},
        FaultRow{"D96_by_parameter",
                 {{5, 99 * kMm}},
                 "P0001N001\\53N#05%",
                 ErrorCode::block_missing,
                 1,
                 "#05 = N099 in P0001"},
        FaultRow{"D94_no_block_number",
                 {{5, -1 * kMm}},
                 "P0001N001\\53N#05%",
                 ErrorCode::word_out_of_range,
                 1,
                 "#05 = -001"},
        FaultRow{"D46_above_travel",
                 {{4, 500'001 * kParameterUm}},
                 "P0001N001G00X#04%",
                 ErrorCode::word_out_of_range,
                 1,
                 "#04 = 500.001"},
        FaultRow{
            "D46_above_F_MAX", {{4, 3'001 * kMm}}, "P0001N001G11F#04%", ErrorCode::feed_above_limit, 1, "#04 = 3001"},
        FaultRow{"D46_no_feed", {}, "P0001N001G11F#04%", ErrorCode::word_out_of_range, 1, "#04 = 0000"},
        FaultRow{"DEC64_cycle",
                 {{7, 9'981 * kMm}},
                 "P0001N001G22P#07N001W00%",
                 ErrorCode::reserved_for_cycles,
                 1,
                 "#07 = P9981"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(ReadOnlyParameters, FollowTheState_PAR035_PAR036) {
  Start start;
  start.position = {.x = 1, .y = -2, .z = 3.5};
  const RunResult run = run_text(
      "P0000T007R+5125L-1500\nP0001N001\\10#10#67N002G00X+10000Z-250N003G11T07"
      "N004\\10#11#64N005\\10#12#65N006\\10#13#66N007\\10#14#67N008\\10#15#68N009G68X+0N010\\10#16#64%",
      100, start);
  ASSERT_FALSE(run.error);
  const Parameters& values = run.parameters;
  EXPECT_EQ(values[10], 0);  // D-95: no tool
  EXPECT_EQ(values[11], 11 * kMm);
  EXPECT_EQ(values[12], -2 * kMm);
  EXPECT_EQ(values[13], 3'250 * kParameterUm);
  EXPECT_EQ(values[14], 5'125 * kParameterUm);
  EXPECT_EQ(values[15], -1'500 * kParameterUm);
  EXPECT_EQ(values[16], 0);
}

TEST(ReadOnlyParameters, GiveWordsToo_D94) {
  const RunResult run = run_text("P0001N001G90N002G00X+10000Y+500N003G00X#65Y#64%");
  ASSERT_FALSE(run.error);
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{500, 10'000, 0}));
}

TEST(ReadOnlyParameters, BeyondTheRangeAreCutOffOnCopying_D91) {
  const RunResult run = run_text("P0001N001G00X+9999999N002G00X+9999999N003\\10#01#64N004\\01#02#64#03%");
  ASSERT_FALSE(run.error);
  EXPECT_EQ(run.parameters[1], kMost);
  EXPECT_EQ(run.parameters[2], kMost);
  EXPECT_EQ(run_text("P0001N001G00X+9999999N002G00X+9999999N003G00Y#64%").code(), ErrorCode::word_out_of_range);
}

TEST(WordsByParameter, UseTheMomentaryContent_EX060) {
  const RunResult run = run_text("P0001N001\\00#04+25000N002G01X#04Z+10000F1000N003\\00#04-25000N004G01X#04%");
  ASSERT_FALSE(run.error);
  const auto lines = all_of<geometry::Line>(run);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].to, (geometry::Point{.x = 25, .y = 0, .z = 10}));
  EXPECT_EQ(lines[1].to, (geometry::Point{.x = 0, .y = 0, .z = 10}));
}

/// Every word but M and T; whole numbers take the whole part (PAR-003, D-94).
TEST(WordsByParameter, GoWithEveryFunction_PAR003) {
  Start start;
  start.parameters = parameters_of(
      {{1, 10 * kMm}, {2, 5'000'400}, {3, 200 * kMm + 900'000}, {4, 7 * kMm}, {5, 1'999'999}, {6, 2 * kMm}});
  const RunResult run = run_text(
      "P0001N001G11F#03S#03N002G02X#01Y#07I#02J#07N003G04H#04N004G12U#02N005G22P#06N#05W#05"
      "\nP0002N001G01X#02Y#02Z#02F#04%",
      20, start);
  ASSERT_FALSE(run.error) << language::explain(*run.error, language::Tongue::english);
  EXPECT_EQ(run.order(), "P1N1 P1N2 P1N3 P1N4 P1N5 P2N1 P2N1");
  EXPECT_EQ(run.blocks[0].modal.feed_mm_per_min, 200);
  EXPECT_EQ(run.blocks[0].modal.spindle_rpm, 200);
  EXPECT_EQ(all_of<geometry::Arc>(run).front().center.x, 5);  // rounded to 1/1000 (DEC-52)
  EXPECT_EQ(all_of<geometry::Dwell>(run).front().seconds, 0.7);
  EXPECT_EQ(all_of<geometry::Line>(run).front().to.u, 5);
  EXPECT_EQ(run.blocks.back().modal.feed_mm_per_min, 7);
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{20'000, 10'000, 10'000}));
}

TEST(WordsByParameter, AreRoundedToThousandths_DEC52) {
  for (const auto& [value, um] : {std::pair{1'499, 1}, {1'500, 2}, {-1'499, -1}, {-1'500, -2}}) {
    Start start;
    start.parameters[1] = value;
    EXPECT_EQ(run_text("P0001N001G00X#01%", 5, start).blocks.back().programmed_um[0], um) << value;
  }
}

TEST(Parameters, StayAfterTheRun_D93) {
  Start start;
  start.parameters = parameters_of({{0, 1}, {45, 2}, {69, 3}});
  const RunResult run = run_text("P0001N001\\11#69#69N002\\11#00#00%", 10, start);
  EXPECT_EQ(run.parameters, parameters_of({{0, 1 + kMm}, {45, 2}, {69, 3 + kMm}}));
}

TEST(Parameters, UnknownFunctionsAreSaidBeforeAnythingMoves_PAR033) {
  ProgramSet programs;
  using language::Function;
  programs.put({.number = 1, .blocks = {{.number = 1, .function = {Function::Kind::parametric, 18}}}});
  const RunResult run = run_programs(programs, {}, {});
  EXPECT_EQ(run.code(), ErrorCode::function_unknown);
  EXPECT_THAT(run.items, IsEmpty());
}

}  // namespace
}  // namespace cnclab::program
