// The cycles as subprograms: what a call loads, how it is shown, what it leaves, where it leads under scale factors.
#include <gmock/gmock.h>

#include "cycle_run.hpp"
#include "program/path_source.hpp"
#include "program/rebuild_modal.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;

using Texts = std::vector<std::string>;
constexpr std::int64_t kOneUm = 1000, kOneMm = kParameterUnit;

/// The parameters right after the call, before the ROM program's first block.
Parameters after_call(const std::string& block) {
  const ProgramSet programs = programs_of("P0000T001R+5000L+0\nP0001N001" + block + "%");
  auto interpreter = Interpreter::begin(programs, wide_settings(), start_at(0, 0, 2));
  std::vector<geometry::PathItem> items;
  EXPECT_TRUE(interpreter && interpreter->step(items)) << block;
  return interpreter ? interpreter->parameters() : Parameters{};
}

TEST(CycleCall, LoadsItsParameters_CYC003) {
  Parameters expected{};
  expected[60] = expected[61] = -5 * kOneMm;  // D-76: Q is Z
  expected[62] = 2 * kOneMm;
  expected[63] = 15 * kOneMm;
  EXPECT_EQ(after_call("G81Z-5000V002H0015"), expected);
  expected[61] = -1 * kOneMm;
  EXPECT_EQ(after_call("G82Z-5000Q-1000V002H0015"), expected);
  expected[61] = 0;
  EXPECT_EQ(after_call("G83Z-5000V002H0015"), expected);
  expected[58] = 40 * kOneMm;
  expected[59] = 30 * kOneMm;
  expected[61] = -1 * kOneMm;
  EXPECT_EQ(after_call("G85X+40000Y+30000Z-5000Q-1000V002H0015"), expected);
  expected[59] = 0;
  EXPECT_EQ(after_call("G84X+40000Y+0Z-5000Q-1000V002H0015"), expected);
  expected[46] = 7 * kOneMm;
  expected[58] = 25 * kOneMm;
  expected[59] = 90 * kOneMm;
  EXPECT_EQ(after_call("G86R+25000D090W07Z-5000Q-1000V002H0015"), expected);
  expected[61] = -5 * kOneMm;
  EXPECT_EQ(after_call("G86R+25000D090W07Z-5000V002H0015"), expected);
}

/// After the pocket of the example (rom-programs "Call").
TEST(CycleCall, FillsTheReservedParametersOnly_CYC100_to_CYC110_ROM01) {
  Start start = start_at(7, 8, 2);
  start.parameters.fill(-1);
  const RunResult run = run_cycle("G85X+40000Y+30000Z-5000Q-3000V002", start);
  ASSERT_FALSE(run.error);
  constexpr std::pair<std::size_t, std::int64_t> kRows[] = {
      {0, 0},                 // CYC-100
      {48, -8 * kOneMm},      // CYC-101: the start point as a position
      {49, -2 * kOneMm},      // CYC-101
      {51, -3'500 * kOneUm},  // CYC-103
      {52, -7'500 * kOneUm},  // CYC-104: −V + 0.5 and two layers of Q
      {53, 8 * kOneMm},       // CYC-105
      {54, 500 * kOneUm},     // CYC-106
      {55, 7 * kOneMm},       // CYC-107
      {56, 8 * kOneMm},       // CYC-107
      {57, 2 * kOneMm},       // CYC-107
      {58, 30 * kOneMm},      // CYC-108
      {59, 20 * kOneMm},      // CYC-108
      {61, -3 * kOneMm},      // CYC-109
      {62, -2 * kOneMm},      // CYC-109
  };
  for (const auto& [number, value] : kRows) EXPECT_EQ(run.parameters[number], value) << '#' << number;
  for (std::size_t number = 1; number < run.parameters.size(); ++number)
    if (number < 46 || number > 63) {
      EXPECT_EQ(run.parameters[number], -1) << '#' << number;
    }
}

/// Z − 0.5 and the rest of the common part, where the program does not change it later (CYC-102).
TEST(CycleCall, ComputesTheWayToTheDepth_CYC102) {
  EXPECT_EQ(run_cycle("G83Z-12000V003H0010", start_at(0, 0, 3)).parameters[50], -12'500 * kOneUm);
}

TEST(CycleCall, IsASubprogram_CYC001_CYC012) {
  const RunResult run = run_text("P0001N001G11F0300N002G83Z-5000V002H0001N003G17%");
  ASSERT_FALSE(run.error);
  EXPECT_EQ(run.order().substr(0, 27), "P1N1 P1N2 P9983N5 P9983N6 P");
  EXPECT_EQ(run.blocks.back().source.block, 3);
  for (const ExecutedBlock& block : run.blocks) {
    EXPECT_EQ(block.depth, block.source.program == 9983 ? 1 : 0);
    EXPECT_EQ(block.main_program, 1);
    EXPECT_TRUE(block.is_shown);
  }
  for (const geometry::PathItem& item : run.items) EXPECT_FALSE(item.passes_single_block);
}

TEST(CycleCall, IsHiddenByM21AndM22_CYC010) {
  for (const char* hide : {"M21", "M22"}) {
    const RunResult run = run_text(std::string("P0001N001G11F0300") + hide + "N002G81Z-5000V002H0001N003G17%");
    ASSERT_FALSE(run.error);
    for (const ExecutedBlock& block : run.blocks)
      EXPECT_EQ(block.is_shown, block.sequence == 1 || (hide == std::string("M22") && block.depth == 0));
  }
  const RunResult run = run_text("P0001N001G11F0300M22N002G81Z-5000V002H0001N003G17%");
  for (const geometry::PathItem& item :
       run.items)  // the call runs on into the cycle, which rests behind its last block
    EXPECT_EQ(item.passes_single_block, item.sequence > 1 && item.sequence + 1 < run.blocks.size());
}

/// P0001 calls P0002 calls …, the last of them drills: `calls` levels and the cycle's.
std::string stairs(int calls) {
  const auto name = [](int number) { return "P00" + std::string(number < 10 ? "0" : "") + std::to_string(number); };
  std::string text;
  for (int i = 1; i <= calls; ++i) text += name(i) + "N001G11F0300N002G22" + name(i + 1) + "N001W00\n";
  return text + name(calls + 1) + "N001G81Z-1000V001H0000%";
}

TEST(CycleCall, CountsAsALevel_D58) {
  EXPECT_FALSE(run_text(stairs(15)).error);
  const RunResult run = run_text(stairs(16));
  EXPECT_EQ(run.code(), ErrorCode::nesting_too_deep);
  EXPECT_EQ(run.error->program, 17);
}

TEST(CycleCall, IsRepeatedInASubprogram) {
  const RunResult run = run_text("P0001N001G11F0300N002G22P0002N001W02\nP0002N001G81Z-5000V002H0000N002G00X+15000%",
                                 1000, start_at(0, 0, 2));
  ASSERT_FALSE(run.error);
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{45'000, 0, 2'000}));
  EXPECT_EQ(all_of<geometry::Line>(run).size(), 3u * 4);
}

struct EndRow {
  const char* name;
  const char* block;
  bool cancels_length;
};

class CycleEnd : public testing::TestWithParam<EndRow> {};

/// ROM-06, ROM-08; a start behind the cycle finds the same (DEC-26).
TEST_P(CycleEnd, LeavesG91AndAfterDrillingG45_CYC007_D82) {
  Start start = start_at(0, 0, 2);
  start.modal.dimension = Dimension::absolute;
  start.modal.length_compensation = true;
  const RunResult run = run_cycle(GetParam().block, start);
  ASSERT_FALSE(run.error);
  const ModalState& after = run.blocks.back().modal;
  EXPECT_EQ(after.dimension, Dimension::incremental);
  EXPECT_EQ(after.length_compensation, !GetParam().cancels_length);
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{0, 0, 2000}));
  const ProgramSet programs = programs_of(std::string("P0001N001") + GetParam().block + "N002G17%");
  const ModalState rebuilt = rebuild_modal(programs, *programs.find(1), 2, start.modal).value();
  EXPECT_EQ(rebuilt.dimension, after.dimension);
  EXPECT_EQ(rebuilt.length_compensation, after.length_compensation);
}

INSTANTIATE_TEST_SUITE_P(, CycleEnd,
                         testing::Values(EndRow{"G81", "G81Z-5000V002H0000", true},
                                         EndRow{"G82", "G82Z-5000Q-1000V002H0000", true},
                                         EndRow{"G83", "G83Z-5000V002H0000", false},
                                         EndRow{"G84", "G84X+40000Y+0Z-5000Q-1000V002", false},
                                         EndRow{"G85", "G85X+40000Y+30000Z-5000Q-1000V002", false},
                                         EndRow{"G86", "G86R+25000D000W04Z-5000V002H0000", false}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(CycleModes, DrillAlongZInEveryPlane_D90) {
  for (const geometry::Plane plane : {geometry::Plane::xz, geometry::Plane::yz}) {
    Start start = start_at(0, 0, 2);
    start.modal.plane = plane;
    const RunResult run = run_cycle("G81Z-10000V002H0000", start);
    EXPECT_EQ(texts_of(cycle_steps(run, start)),
              (Texts{"N101 rapid 0 0 0.5", "N121 feed 0 0 -10", "N125 rapid 0 0 2"}));
    EXPECT_EQ(run.blocks.back().modal.plane, plane);
  }
}

/// M24 leaves dwell and spindle out, but M05 always acts (DEC-38).
TEST(CycleModes, TestRunKeepsTheWays_G041) {
  Start start = start_at(0, 0, 3);
  start.modal.test_run = true;
  EXPECT_EQ(texts_of(cycle_steps(run_cycle("G83Z-12000V003H0010", start), start)),
            (Texts{"N101 rapid 0 0 0.5", "N102 feed 0 0 -12", "N103 off", "N107 feed 0 0 3", "N108 off"}));
}

/// With G46 the tool's end does what the words say, until N124 (D-82): a tool 3 mm short goes 3 mm further down.
TEST(CycleModes, DrillWithLengthCompensation_D82) {
  const ProgramSet programs = programs_of("P0000T001R+5000L-3000\nP0001N001G46N002G81Z-10000V002H0000%");
  auto source = PathSource::begin(programs, wide_settings(), start_at(0, 0, 2));
  ASSERT_TRUE(source);
  std::vector<geometry::PathItem> items;
  while (!source->ended()) ASSERT_TRUE(source->step(items));
  EXPECT_EQ(texts_of(steps_of(items, {0, 0, 2'000'000})),
            (Texts{"N101 rapid 0 0 -2.5", "N121 feed 0 0 -13", "N125 rapid 0 0 2"}));
}

/// The two examples of ROM-05, which scaled places would lead astray.
TEST(CycleUnderScale, LeadsBackToThePlaceOfTheCall_DEC51_ROM05) {
  Start drilling = start_at(0, 0, 12);
  drilling.modal.scale_on = true;
  drilling.modal.scale = {1000, 1000, 500};
  const RunResult hole = run_cycle("G82Z-10000Q-4000V002H0000", drilling);
  EXPECT_EQ(
      texts_of(cycle_steps(hole, drilling)),
      (Texts{"N101 rapid 0 0 11.25", "N104 feed 0 0 9", "N106 rapid 0 0 12", "N101 rapid 0 0 9.25", "N104 feed 0 0 7",
             "N106 rapid 0 0 12", "N101 rapid 0 0 7.25", "N121 feed 0 0 6", "N125 rapid 0 0 12"}));
  Start slot = start_at(50, 0, 2);
  slot.modal.scale_on = true;
  slot.modal.scale = {-1000, 1000, 1000};
  const RunResult milled = run_cycle("G84X+40000Y+0Z-4000Q-4000V002", slot);
  EXPECT_EQ(texts_of(cycle_steps(milled, slot)),
            (Texts{"N100 rapid 65 0 2", "N102 rapid 65 0 0.5", "N121 feed 65 0 -4", "N122 feed 35 0 -4",
                   "N124 rapid 35 0 2", "N125 rapid 50 0 2"}));
}

/// A place between two thousandths, which factors leave, is the place that a cycle comes back to.
TEST(CycleUnderScale, KeepsAPlaceBetweenThousandths_DEC51) {
  const RunResult run = run_text(
      "P0001N001G11F0300N002G75X+333Y+333Z+333N003G00X+10001Y+10001Z+10001N004G86R+9000D000W03Z-3000V003H0000%", 1000);
  ASSERT_FALSE(run.error);
  const std::vector<geometry::Line> lines = all_of<geometry::Line>(run);
  EXPECT_EQ(lines.back().to, lines.front().to);
  EXPECT_EQ(lines.back().to.x, 3.330333);
}

/// Places lie as far from zero as the operator has set it; the machine's limits are for ways (D-46).
TEST(CycleUnderScale, HasNoLimitsForPlaces) {
  Settings settings;
  settings.travel_mm = {100, 100, 100};
  const RunResult run = run_text("P0001N001G81Z-10000V002H0000%", 1000, start_at(3000, -3000, 700), settings);
  ASSERT_FALSE(run.error);
  EXPECT_EQ(all_of<geometry::Line>(run).back().to, (geometry::Point{.x = 3000, .y = -3000, .z = 700}));
  EXPECT_EQ(run_text("P0001N001G81Z-100001V002H0000%", 1000, start_at(0, 0, 2), settings).code(),
            ErrorCode::word_out_of_range);
}

}  // namespace
}  // namespace cnclab::program
