// F, S, T, M and the other events: what they are, and in which order the machine gets them.
#include <gmock/gmock.h>

#include "item_names.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;
using testing::ElementsAre;

struct WordOrderRow {
  const char* name;
  const char* text;
  std::vector<std::string> items;
};

class WordOrder : public testing::TestWithParam<WordOrderRow> {};

TEST_P(WordOrder, IsThatOfTheManual) {
  const RunResult run = run_text(GetParam().text);
  EXPECT_FALSE(run.error) << language::explain(run.error.value_or(language::Error{}), language::Tongue::english);
  EXPECT_EQ(names_of(run), GetParam().items);
}

using Names = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(
    , WordOrder,
    testing::Values(
        WordOrderRow{"FST009_M03_before_the_way", "P0001N001G01X+1000F0100S0500M03%",
                     Names{"digits 500", "spindle cw 500", "line", "end"}},
        WordOrderRow{"FST010_M05_behind_the_way", "P0001N001G01X+1000F0100M05%", Names{"line", "spindle off", "end"}},
        WordOrderRow{"FST010_M09_behind_the_way", "P0001N001G01X+1000F0100M09%", Names{"line", "coolant off", "end"}},
        WordOrderRow{"M004_counterclockwise", "P0001N001G11S0100M04%", Names{"digits 100", "spindle ccw 100", "end"}},
        WordOrderRow{"M013_spindle_and_coolant_at_start", "P0001N001G01X+1000F0100M13%",
                     Names{"spindle cw 0", "coolant on", "line", "end"}},
        WordOrderRow{"M014_spindle_and_coolant_at_start", "P0001N001G11M14%",
                     Names{"spindle ccw 0", "coolant on", "end"}},
        WordOrderRow{"M012_both_off_at_end", "P0001N001G01X+1000F0100M12%",
                     Names{"line", "spindle off", "coolant off", "end"}},
        WordOrderRow{"M008_coolant_at_start", "P0001N001G01X+1000F0100M08%", Names{"coolant on", "line", "end"}},
        WordOrderRow{"M000_halt_at_end", "P0001N001G01X+1000F0100M00N002G17%", Names{"line", "halt", "end"}},
        WordOrderRow{"M001_halt_with_signal", "P0001N001G11M01%", Names{"halt signal", "end"}},
        WordOrderRow{"M002_ends_the_program", "P0001N001G01X+1000F0100M02N002G01X+1000%", Names{"line", "end"}},
        WordOrderRow{"M015_signal", "P0001N001G11M15N002G90%", Names{"signal", "end"}},
        WordOrderRow{"M016_waits_for_Input_1", "P0001N001G11M16%", Names{"wait 0.0", "end"}},
        WordOrderRow{"M040_all_outputs_of_card_1", "P0001N001G11M40N002G11M48N003G11M50N004G11M53%",
                     Names{"output 1.0 on", "output 1.8 on", "output 1.0 off", "output 1.3 off", "end"}},
        WordOrderRow{"M060_waits_on_card_1", "P0001N001G11M60N002G11M68%", Names{"wait 1.0", "wait 1.8", "end"}},
        WordOrderRow{"M070_card_2", "P0001N001G11M70N002G11M81N003G11M90N004G11M98%",
                     Names{"output 2.0 on", "output 2.1 off", "wait 2.0", "wait 2.8", "end"}},
        WordOrderRow{"FST004_S_with_the_spindle_on", "P0001N001G11S0500M03N002G01X+1000F0100S0800%",
                     Names{"digits 500", "spindle cw 500", "digits 800", "spindle cw 800", "line", "end"}},
        WordOrderRow{"FST004_S_with_the_spindle_off", "P0001N001G11S0500%", Names{"digits 500", "end"}},
        WordOrderRow{"FST011_T_at_block_start", "P0000T005R+5000L-1000\nP0001N001G01X+1000F0100T05%",
                     Names{"tool 5 R5 L-1", "line", "end"}},
        WordOrderRow{"COMP003_tool_without_row", "P0001N001G11T07%", Names{"tool 7 R0 L0", "end"}},
        WordOrderRow{"G040_dwell", "P0001N001G04H0010N002G04H9999%", Names{"dwell 1", "dwell 999.9", "end"}},
        WordOrderRow{"G111_run_up_of_the_spindle", "P0001N001G11S0500M03N002G04H0020N003G01X+1000F0100%",
                     Names{"digits 500", "spindle cw 500", "dwell 2", "line", "end"}},
        WordOrderRow{"FST012_what_a_way_needs_before_it_stands_in_G11", "P0001N001G11M41N002G01X+1000F0100M51%",
                     Names{"output 1.1 on", "line", "output 1.1 off", "end"}},
        WordOrderRow{"FST007_another_tool_by_its_word",
                     "P0000T001R+1000L+0T002R+2000L+0\nP0001N001G11T01N002G11T02N003G01X+1000F0100T01%",
                     Names{"tool 1 R1 L0", "tool 2 R2 L0", "tool 1 R1 L0", "line", "end"}},
        WordOrderRow{"G110_F_alone_has_no_effect_on_the_machine", "P0001N001G11F0100N002G91%", Names{"mark", "end"}},
        WordOrderRow{"D42_M24_suppresses_what_follows",
                     "P0001N001G11M24N002G01X+1000F0100M03N003G04H0010N004G11M00N005G11M40N006G11M16N007G11M02N008G17%",
                     Names{"mark", "line", "mark", "mark", "mark", "mark", "mark", "end"}},
        WordOrderRow{"D42_M24_acts_from_the_following_block", "P0001N001G11M08N002G11M24N003G11M08%",
                     Names{"coolant on", "mark", "end"}},
        WordOrderRow{"DEC38_M05_M09_M12_act_under_M24", "P0001N001G11M24N002G11M05N003G11M09N004G11M12%",
                     Names{"mark", "spindle off", "coolant off", "spindle off", "coolant off", "end"}},
        WordOrderRow{"M020_ends_the_test_run", "P0001N001G11M24N002G11M03N003G11M20N004G11M08%",
                     Names{"mark", "mark", "mark", "coolant on", "end"}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Words, EveryBlockHasOneItemThatEndsIt) {
  const RunResult run =
      run_text("P0001N001G11F1000S0100T01M03N002G01X+1000M05N003G90N004G22P0002N001W01N005G68X+0%\nP0002N001G04H0001%");
  ASSERT_FALSE(run.error);
  std::uint64_t ended = 0;
  for (std::size_t i = 0; i < run.items.size(); ++i) {
    const bool is_last = i + 1 == run.items.size() || run.items[i + 1].sequence != run.items[i].sequence;
    EXPECT_EQ(run.items[i].ends_block, is_last) << i;
    ended += run.items[i].ends_block ? 1 : 0;
  }
  EXPECT_EQ(ended, run.blocks.size());
  EXPECT_EQ(run.items.back().sequence, run.blocks.size());
}

TEST(Words, M23TakesThePotentiometerAwayFromTheNextBlock) {
  const RunResult run = run_text("P0001N001G01X+1000F0100M23N002G01X+1000N003G01X+1000M20N004G01X+1000%");
  std::vector<bool> off;
  for (const geometry::PathItem& item : run.items)
    if (std::holds_alternative<geometry::Line>(item.what)) off.push_back(item.override_off);
  EXPECT_THAT(off, ElementsAre(false, true, true, false));
}

TEST(Words, ModalStateKeepsWhatWasSet_FST013) {
  const RunResult run = run_text("P0001N001G11F0700S0300T04M03N002G90N003G18%");
  const ModalState& modal = run.blocks.back().modal;
  EXPECT_EQ(modal.feed_mm_per_min, 700);
  EXPECT_EQ(modal.spindle_rpm, 300);
  EXPECT_EQ(modal.tool, 4);
  EXPECT_EQ(modal.m, 3);
  EXPECT_EQ(modal.dimension, Dimension::absolute);
  EXPECT_EQ(modal.plane, geometry::Plane::xz);
}

TEST(Words, PowerOnState_FST014_G170_G910) {
  const ModalState modal = run_text("P0001N001G04H0001%").blocks.back().modal;
  EXPECT_EQ(modal.plane, geometry::Plane::xy);
  EXPECT_EQ(modal.radius, RadiusCompensation::off);
  EXPECT_FALSE(modal.length_compensation);
  EXPECT_FALSE(modal.scale_on);
  EXPECT_EQ(modal.dimension, Dimension::incremental);
  EXPECT_EQ(modal.feed_mm_per_min, 0);
  EXPECT_EQ(modal.spindle_rpm, 0);
  EXPECT_EQ(modal.tool, 0);
  EXPECT_EQ(modal.m, 12);
}

TEST(Words, G001_G00_leaves_F_alone) {
  const RunResult run = run_text("P0001N001G11F0700N002G00X+1000%");
  EXPECT_EQ(run.blocks.back().modal.feed_mm_per_min, 700);
}

TEST(Words, SuppressedMIsNotShown_D42) {
  const RunResult run = run_text("P0001N001G11M24N002G11M03%");
  EXPECT_EQ(run.blocks.back().modal.m, 24);
  EXPECT_EQ(run.blocks.back().modal.spindle, geometry::SpindleTurn::off);
}

TEST(Words, ParametersAreReadWhenTheBlockRuns_EX060) {
  Start start;
  start.parameters[4] = 25 * kParameterUnit;
  start.parameters[63] = 15 * kParameterUnit + 900'000;
  const RunResult run = run_text("P0001N001G01X#04Z+10000F1000N002G04H#63N003G01X#64%", 9, start);
  ASSERT_FALSE(run.error) << language::explain(*run.error, language::Tongue::english);
  const auto lines = all_of<geometry::Line>(run);
  EXPECT_EQ(lines.at(0).to, (geometry::Point{25, 0, 10}));
  EXPECT_EQ(all_of<geometry::Dwell>(run).at(0).seconds, 1.5);  // whole part of #63, D-94
  EXPECT_EQ(lines.at(1).to.x, 50) << "#64 is the Sollwert of X";
}

/// PAR-003, D-94: every word but M and T may be a parameter; those that count nothing but wholes take the whole part.
TEST(Words, ByParameterInEveryAddress_PAR003) {
  struct Row {
    const char* name;
    const char* text;  ///< #01 = -3.7, #02 = 2.9, #03 = 12.5, #04 = 1
    const char* same;  ///< the same with numbers
  };
  const Row rows[] = {
      {"X Y Z F S", "N001G01X#01Y#02Z#03F#03S#03", "N001G01X-3700Y+2900Z+12500F0012S0012"},
      {"I J under G02", "N001G11F0500N002G02X+0Y+0I#01J#02", "N001G11F0500N002G02X+0Y+0I-3700J+2900"},
      {"K under G18", "N001G11F0500N002G18N003G03X+0Z+0I#01K#03", "N001G11F0500N002G18N003G03X+0Z+0I-3700K+12500"},
      {"R", "N001G06X+1000Y+1000R#03F0100", "N001G06X+1000Y+1000R+12500F0100"},
      {"R of a corner", "N001G10R#02", "N001G10R+2900"},
      {"U", "N001G11F0100N002G12U#01", "N001G11F0100N002G12U-3700"},
      {"H", "N001G04H#03", "N001G04H0012"},
      {"P and N of a jump", "N001G20P#02N#03", "N001G20P0002N012"},
      {"P, N and W of a call", "N001G22P#02N#03W#04N002G17", "N001G22P0002N012W01N002G17"},
      {"values of G68", "N001G68X#01Z#02", "N001G68X-3700Z+2900"},
      {"values of G69", "N001G69X#01Z#02", "N001G69X-3700Z+2900"},
  };
  Start start;
  start.parameters[1] = -3'700'000;
  start.parameters[2] = 2'900'000;
  start.parameters[3] = 12'500'000;
  start.parameters[4] = kParameterUnit;
  constexpr auto kCalled = "\nP0002N012G01X+1F0700%";
  for (const Row& row : rows) {
    const RunResult by_parameter = run_text(std::string("P0001") + row.text + kCalled, 20, start);
    const RunResult by_number = run_text(std::string("P0001") + row.same + kCalled, 20);
    EXPECT_FALSE(by_number.error) << row.name;
    EXPECT_EQ(by_parameter.error, by_number.error) << row.name;
    EXPECT_EQ(by_parameter.order(), by_number.order()) << row.name;
    EXPECT_EQ(names_of(by_parameter), names_of(by_number)) << row.name;
    EXPECT_EQ(by_parameter.json(), by_number.json()) << row.name;
    EXPECT_EQ(by_parameter.blocks.back().modal, by_number.blocks.back().modal) << row.name;
  }
}

TEST(Words, ByParameterAreReadEachTimeTheBlockRuns_PAR004) {
  const RunResult run = run_text("P0001N001G00X+1000N002G00X#64N003G20P0001N002%", 7);
  EXPECT_EQ(run.blocks.back().programmed_um[0], 8000) << "1, doubled three times";
}

TEST(Words, ParametersAreRoundedToMicrometres_DEC52) {
  Start start;
  start.parameters[1] = 1'000'500;   // 1.0005 mm
  start.parameters[2] = -1'000'499;  // -1.000499 mm
  const RunResult run = run_text("P0001N001G01X#01Y#02F1000%", 9, start);
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{1001, -1000, 0}));
}

TEST(Words, ToolParametersComeFromP0000_PAR036) {
  const RunResult run = run_text("P0000T003R+4500L-250\nP0001N001G11F1000T03N002G01X#67Y#68%");
  EXPECT_EQ(run.blocks.back().programmed_um, (std::array<std::int64_t, 3>{4500, -250, 0}));
}

TEST(Words, ParametersAreCheckedAtExecution_DEC13) {
  Start start;
  start.parameters[1] = 600 * kParameterUnit;
  Settings settings;
  EXPECT_EQ(run_text("P0001N001G00X#01%", 9, start, settings).code(), ErrorCode::word_out_of_range);
  start.parameters[1] = 3001 * kParameterUnit;
  EXPECT_EQ(run_text("P0001N001G11F#01%", 9, start, settings).code(), ErrorCode::feed_above_limit);
  EXPECT_EQ(run_text("P0001N001G11S#01%", 9, start, settings).code(), ErrorCode::word_out_of_range);
  EXPECT_EQ(run_text("P0001N001G20P0001N#01%", 9, start, settings).code(), ErrorCode::word_out_of_range);
  EXPECT_EQ(run_text("P0001N001G22P0001N001W#01%", 9, start, settings).code(), ErrorCode::word_out_of_range);
  start.parameters[1] = -kParameterUnit;
  EXPECT_EQ(run_text("P0001N001G20P#01N001%", 9, start, settings).code(), ErrorCode::word_out_of_range);
  EXPECT_EQ(run_text("P0001N001G04H#01%", 9, start, settings).code(), ErrorCode::word_out_of_range);
}

TEST(Words, DwellByAParameterOfZeroIsNone_DEC53) {
  const RunResult run = run_text("P0001N001G04H#05N002G64H#05N003G17%");
  EXPECT_FALSE(run.error);
  EXPECT_TRUE(all_of<geometry::Dwell>(run).empty());
}

TEST(Words, DEC38OutputsGoOffAtTheEndOnTheLabMachine) {
  Settings settings = wide_settings();
  settings.outputs_at_end_off = true;
  const RunResult run = run_text("P0001N001G11M13%", 9, {}, settings);
  EXPECT_THAT(names_of(run), ElementsAre("spindle cw 0", "coolant on", "spindle off", "coolant off", "end"));
  EXPECT_EQ(run.blocks.back().modal.spindle, geometry::SpindleTurn::off);
  EXPECT_FALSE(run.blocks.back().modal.coolant);
}

TEST(Words, UnknownMStops_D51) {
  EXPECT_EQ(run_text("P0001N001G11M06%").code(), ErrorCode::m_unknown);
  EXPECT_EQ(run_text("P0001N001G11M49%").code(), ErrorCode::m_unknown);
}

}  // namespace
}  // namespace cnclab::program
