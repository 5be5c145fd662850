// The order of blocks: stored order, jumps, calls with repeats, nesting, ends, starts in the middle.
#include <gmock/gmock.h>

#include <iomanip>
#include <sstream>

#include "program/functions.hpp"
#include "program/reachable.hpp"
#include "program/rebuild_modal.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;
using testing::ElementsAre;
using testing::IsEmpty;

struct FlowRow {
  const char* name;
  const char* text;
  const char* order;
};

class Flow : public testing::TestWithParam<FlowRow> {};

TEST_P(Flow, RunsBlocksInThisOrder) {
  const RunResult run = run_text(GetParam().text, 20);
  EXPECT_FALSE(run.error);
  EXPECT_EQ(run.order(), GetParam().order);
}

INSTANTIATE_TEST_SUITE_P(
    , Flow,
    testing::Values(
        FlowRow{"EDIT032_gaps", "P0001N001G17N010G18N900G19%", "P1N1 P1N10 P1N900"},
        FlowRow{"BLK006_BLK007_first_and_last_numbers",
                "P0001N001G17N999G20P9999N001\nP9999N001G22P9980N999W00N999G17\nP9980N999G18%",
                "P1N1 P1N999 P9999N1 P9980N999 P9999N999"},
        FlowRow{"G200_jump_within_the_program", "P0001N001G20P0001N003N002G17N003G18%", "P1N1 P1N3"},
        FlowRow{"G200_jump_into_another_program", "P0001N001G20P0002N002\nP0002N001G17N002G18N003G19%",
                "P1N1 P2N2 P2N3"},
        FlowRow{"G220_call_and_return", "P0001N001G22P0002N001W00N002G17\nP0002N001G18N002G19%", "P1N1 P2N1 P2N2 P1N2"},
        FlowRow{"G221_W00_once", "P0001N001G22P0002N001W00\nP0002N001G18%", "P1N1 P2N1"},
        FlowRow{"D57_W02_three_times", "P0001N001G22P0002N001W02N002G17\nP0002N001G18%", "P1N1 P2N1 P2N1 P2N1 P1N2"},
        FlowRow{"G220_repeats_from_the_called_block", "P0001N001G22P0002N002W01N002G17\nP0002N001G18N002G19N003G17%",
                "P1N1 P2N2 P2N3 P2N2 P2N3 P1N2"},
        FlowRow{"SYS006_calls_in_calls", "P0001N001G22P0002N001W01\nP0002N001G22P0003N001W01\nP0003N001G17%",
                "P1N1 P2N1 P3N1 P3N1 P2N1 P3N1 P3N1"},
        FlowRow{"D58_G20_keeps_the_way_back", "P0001N001G22P0002N001W00N002G17\nP0002N001G20P0003N001\nP0003N001G18%",
                "P1N1 P2N1 P3N1 P1N2"},
        FlowRow{"D57_repeat_after_G20_begins_at_the_called_program",
                "P0001N001G22P0002N001W01N002G17\nP0002N001G20P0003N001\nP0003N001G18%",
                "P1N1 P2N1 P3N1 P2N1 P3N1 P1N2"},
        FlowRow{"D40_M02_in_a_subprogram_ends_all", "P0001N001G22P0002N001W05N002G17\nP0002N001G11M02N002G18%",
                "P1N1 P2N1"},
        FlowRow{"SYS006_part_of_the_own_program", "P0001N001G22P0001N003W00N002G20P0001N004N003G17N004G18%",
                "P1N1 P1N3 P1N4 P1N2 P1N4"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(FlowStart, BeginsAtAnyStoredBlock_EX053) {
  const RunResult run = run_text("P0002N003G17N010G18N900G19%", 9, {.program = 2, .block = 10});
  EXPECT_EQ(run.order(), "P2N10 P2N900");
}

TEST(FlowUpcoming, FollowsJumpsWithoutConditionOnly_DEC63) {
  const ProgramSet programs = programs_of(
      "P0001N001\\53N005N002\\50N005N003G21P0001N005N004G20P#01N005N005G17N006G20P0009N001N007G20P0002N001\n"
      "P0002N001G17%");
  const language::Program& program = *programs.find(1);
  std::vector<int> targets;
  for (const language::Block& block : program.blocks) {
    const auto target = unconditional_target(programs, program, block);
    targets.push_back(target ? target->program->blocks[target->index].number + 1000 * target->program->number : 0);
  }
  EXPECT_THAT(targets, ElementsAre(1005, 0, 0, 0, 0, 0, 2001)) << "missing and unknown targets are not followed";
}

TEST(FlowStart, SaysWhatIsMissing) {
  EXPECT_EQ(run_text("P0001N001G17%", 9, {.program = 2}).code(), ErrorCode::program_missing);
  const RunResult run = run_text("P0001N001G17%", 9, {.block = 2});
  ASSERT_EQ(run.code(), ErrorCode::block_missing);
  EXPECT_EQ(language::place_of(*run.error), "P0001 N002");
  EXPECT_EQ(run_text("P0000T001R+1L+1%", 9, {.program = 0}).code(), ErrorCode::program_missing);
  EXPECT_EQ(run_text("P0001N001G17%", 9, {.program = 9985}).code(), ErrorCode::reserved_for_cycles);
}

struct FlowErrorRow {
  const char* name;
  const char* text;
  ErrorCode code;
  int program, block;
};

class FlowErrors : public testing::TestWithParam<FlowErrorRow> {};

TEST_P(FlowErrors, NameTheBlock) {
  const RunResult run = run_text(GetParam().text, 5000);
  ASSERT_EQ(run.code(), GetParam().code);
  EXPECT_EQ(run.error->program, GetParam().program);
  EXPECT_EQ(run.error->block, GetParam().block);
}

INSTANTIATE_TEST_SUITE_P(
    , FlowErrors,
    testing::Values(
        FlowErrorRow{"D58_G20_to_a_missing_program", "P0001N001G20P0002N001%", ErrorCode::program_missing, 1, 1},
        FlowErrorRow{"D58_G22_to_a_missing_block", "P0001N001G17N002G22P0002N009W00\nP0002N001G17%",
                     ErrorCode::block_missing, 1, 2},
        FlowErrorRow{"DEC64_G22_to_a_cycle", "P0001N001G22P9981N001W00%", ErrorCode::reserved_for_cycles, 1, 1},
        FlowErrorRow{"DEC64_G20_to_a_cycle", "P0001N001G17N002G20P9989N001%", ErrorCode::reserved_for_cycles, 1, 2},
        FlowErrorRow{"D58_G20_to_a_missing_block", "P0001N001G20P0001N002%", ErrorCode::block_missing, 1, 1},
        FlowErrorRow{"D58_G20_to_the_tool_table", "P0000T001R+1L+1\nP0001N001G20P0000N001%", ErrorCode::program_missing,
                     1, 1},
        FlowErrorRow{"D58_after_G20_the_caller_is_still_active",
                     "P0001N001G22P0002N001W00\nP0002N001G20P0003N001\nP0003N001G22P0002N001W00%",
                     ErrorCode::nesting_too_deep, 3, 1},
        FlowErrorRow{"D58_call_of_itself", "P0001N001G22P0001N001W00%", ErrorCode::nesting_too_deep, 1, 1},
        FlowErrorRow{"D58_two_that_call_each_other",
                     "P0001N001G22P0002N001W00\nP0002N001G22P0003N001W00\nP0003N001G17N002G22P0002N001W00%",
                     ErrorCode::nesting_too_deep, 3, 2},
        FlowErrorRow{"G22_of_the_tool_table", "P0000T001R+1L+1\nP0001N001G22P0000N001W00%", ErrorCode::program_missing,
                     1, 1}),
    [](const auto& row) { return std::string(row.param.name); });

/// P0001 calls P0002 calls … `calls` levels deep.
std::string staircase(int calls) {
  std::ostringstream text;
  text << std::setfill('0');
  for (int i = 1; i <= calls; ++i)
    text << 'P' << std::setw(4) << i << "N001G22P" << std::setw(4) << i + 1 << "N001W00\n";
  text << 'P' << std::setw(4) << calls + 1 << "N001G17%";
  return text.str();
}

TEST(FlowDepth, SixteenLevelsAreAllowedSeventeenAreNot_D58) {
  const RunResult allowed = run_text(staircase(16));
  EXPECT_FALSE(allowed.error);
  EXPECT_EQ(allowed.blocks.size(), 17u);
  EXPECT_EQ(allowed.blocks.back().depth, 16);
  EXPECT_EQ(allowed.blocks.back().main_program, 1);
  const RunResult refused = run_text(staircase(17));
  EXPECT_EQ(refused.code(), ErrorCode::nesting_too_deep);
  EXPECT_EQ(refused.error->program, 17);
}

/// A program that counts #01 down and calls itself until it is 0.
std::string countdown(int calls) {
  return "P0001N001\\00#01+" + std::to_string(calls * 1000) +
         "N002G22P0002N001W00N003G18\nP0002N001\\12#01#01N002\\50N004N003G22P0002N001W00N004G17%";
}

TEST(FlowDepth, AProgramMayCallItselfAsDeepAsAnyOther_D58_SYS006) {
  EXPECT_EQ(run_text(countdown(3)).order(), "P1N1 P1N2 P2N1 P2N2 P2N3 P2N1 P2N2 P2N3 P2N1 P2N2 P2N4 P2N4 P2N4 P1N3");
  EXPECT_FALSE(run_text(countdown(16)).error);
  const RunResult refused = run_text(countdown(17));
  ASSERT_EQ(refused.code(), ErrorCode::nesting_too_deep);
  EXPECT_EQ(language::place_of(*refused.error), "P0002 N003");
}

TEST(FlowLoop, AJumpToItselfReturnsFromEveryStep_DEC63) {
  const RunResult run = run_text("P0001N001G20P0001N001%", 100'000);
  EXPECT_EQ(run.blocks.size(), 100'000u);
}

TEST(FlowDisplay, M21AndM22HideBlocks_MOD059_MOD060) {
  const auto shown = [](const RunResult& run) {
    std::string text;
    for (const ExecutedBlock& block : run.blocks) text += block.is_shown ? '+' : '-';
    return text;
  };
  constexpr auto kSubprogram = "\nP0002N001G17N002G18%";
  EXPECT_EQ(shown(run_text(std::string("P0001N001G11M21N002G22P0002N001W00N003G11M20N004G17") + kSubprogram)),
            "+----+");
  const RunResult run = run_text(std::string("P0001N001G11M22N002G22P0002N001W00N003G19") + kSubprogram);
  EXPECT_EQ(shown(run), "++--+");
  std::string passed;
  for (const geometry::PathItem& item : run.items)
    if (item.ends_block) passed += item.passes_single_block ? 'p' : 's';
  EXPECT_EQ(passed, "sppss") << "KEY-046: EINZELSATZ stops before blocks of the main program only";
}

TEST(FlowUpcoming, FollowsStoredOrderAndG20Only_DEC63) {
  const ProgramSet programs = programs_of(
      "P0001N001G17N002G22P0002N001W00N003G20P0003N002\nP0002N001G18\nP0003N001G19N002G90N003G20P0001N001%");
  auto interpreter = Interpreter::begin(programs, wide_settings(), {});
  ASSERT_TRUE(interpreter);
  const auto names = [&interpreter](std::size_t count) {
    std::ostringstream text;
    for (const auto& [source, block] : interpreter->upcoming(count)) {
      EXPECT_EQ(block->number, source.block);
      text << 'P' << source.program << 'N' << source.block << ' ';
    }
    return text.str();
  };
  EXPECT_EQ(names(7), "P1N1 P1N2 P1N3 P3N2 P3N3 P1N1 P1N2 ");
  std::vector<geometry::PathItem> items;
  ASSERT_TRUE(interpreter->step(items));
  ASSERT_TRUE(interpreter->step(items));
  EXPECT_EQ(names(5), "P2N1 ") << "the subprogram's stored order ends here";
}

TEST(FlowEnd, FurtherStepsRepeatTheLastAnswer) {
  auto interpreter = Interpreter::begin(programs_of("P0001N001G17%"), wide_settings(), {});
  ASSERT_TRUE(interpreter);
  std::vector<geometry::PathItem> items;
  ASSERT_TRUE(interpreter->step(items)->ended);
  const std::size_t count = items.size();
  EXPECT_TRUE(interpreter->step(items)->ended);
  EXPECT_EQ(items.size(), count);
  EXPECT_THAT(interpreter->upcoming(5), IsEmpty());
}

TEST(FlowEnd, AnErrorLeavesTheStateBeforeTheBlock) {
  auto interpreter =
      Interpreter::begin(programs_of("P0001N001G11F0500M03N002G02X+10000Y+0I+1000J+0%"), wide_settings(), {});
  ASSERT_TRUE(interpreter);
  std::vector<geometry::PathItem> items;
  ASSERT_TRUE(interpreter->step(items));
  const ModalState before = interpreter->modal();
  const std::size_t count = items.size();
  const auto first = interpreter->step(items);
  ASSERT_FALSE(first);
  EXPECT_EQ(first.error().code, ErrorCode::arc_wrong);
  EXPECT_EQ(items.size(), count);
  EXPECT_EQ(interpreter->modal(), before);
  EXPECT_EQ(interpreter->step(items).error(), first.error());
}

struct UnknownRow {
  const char* name;
  const char* text;
  const char* detail;
  int block;
};

class UnknownFunctions : public testing::TestWithParam<UnknownRow> {};

/// Without the functions that the manual marks as planned (BLK-200, DEC-08).
RunResult run_without_planned(const char* text) {
  Settings settings = wide_settings();
  settings.vocabulary.planned_functions = false;
  return run_text(text, 1000, {}, settings);
}

TEST_P(UnknownFunctions, AreSaidBeforeAnythingMoves) {
  const RunResult run = run_without_planned(GetParam().text);
  ASSERT_EQ(run.code(), ErrorCode::function_unknown);
  EXPECT_EQ(run.error->detail, GetParam().detail);
  EXPECT_EQ(run.error->block, GetParam().block);
  EXPECT_THAT(run.items, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    , UnknownFunctions,
    testing::Values(UnknownRow{"in_a_called_program", "P0001N001G22P0002N001W00\nP0002N001G17N007G81Z-5000V002H0010%",
                               "G81", 7},
                    UnknownRow{"parametric_function", "P0001N001G00X+1000N002\\15#01#02%", "↓15", 2},
                    UnknownRow{"rounding", "P0001N001G00X+1000N002G10R+1000%", "G10", 2}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(UnknownReach, BlocksThatCannotBeReachedDoNotMatter) {
  EXPECT_FALSE(run_without_planned("P0001N001G20P0001N003N002G81Z-5000V002H0010N003G17%").error);
  EXPECT_FALSE(run_without_planned("P0001N001G11M02N002G81Z-5000V002H0010%").error);
}

TEST(Functions, ThatCanBeKeyedInCanBeExecuted_BLK201) {
  for (const language::BlockForm& form : language::all_forms())
    EXPECT_EQ(handler_of(form.function) == nullptr, form.function.kind == language::Function::Kind::tool)
        << int{form.function.code};
}

TEST(RebuildModal, TakesGroupsAndWordsBeforeTheStartBlock_DEC26) {
  const ProgramSet programs = programs_of(
      "P0001N001G11F0800S0900T03M03N002G90N003G18N004G20P0001N009N005G11M23N006G11F#05N007G00X+1000"
      "N008G11M24N009G91N010G11F0100M20%");
  ModalState before;
  before.coolant = true;
  const ModalState modal = rebuild_modal(programs, *programs.find(1), 9, before).value();
  EXPECT_EQ(modal.feed_mm_per_min, 800);
  EXPECT_EQ(modal.spindle_rpm, 900);
  EXPECT_EQ(modal.tool, 3);
  EXPECT_EQ(modal.plane, geometry::Plane::xz);
  EXPECT_EQ(modal.dimension, Dimension::absolute);
  EXPECT_TRUE(modal.potentiometer_off);
  EXPECT_TRUE(modal.test_run);
  EXPECT_EQ(modal.spindle, geometry::SpindleTurn::off) << "nothing is switched";
  EXPECT_TRUE(modal.coolant);
  EXPECT_EQ(rebuild_modal(programs, *programs.find(1), 1, before).value(), before);
  EXPECT_FALSE(rebuild_modal(programs, *programs.find(1), 999, before).value().test_run);
}

TEST(RebuildModal, TakesTheScale_DEC26) {
  const ProgramSet programs = programs_of("P0001N001G75X-1000N002G22P0002N001W00N003G74N004G17%\nP0002N001G17%");
  const ModalState scaled = rebuild_modal(programs, *programs.find(1), 2, {}).value();
  EXPECT_TRUE(scaled.scale_on);
  EXPECT_EQ(scaled.scale, (std::array<std::int64_t, 3>{-1000, 1000, 1000}));
  EXPECT_EQ(rebuild_modal(programs, *programs.find(1), 4, {}).value(), ModalState{});
}

}  // namespace
}  // namespace cnclab::program
