// G21 and G23: jumps and calls that depend on Input 1 as it was two blocks before (G-210, G-211, G-230; D-56).
#include <gmock/gmock.h>

#include "run_text.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;
using testing::ElementsAre;

struct InputRow {
  const char* name;
  const char* text;
  bool input;
  const char* order;
};

class InputFlow : public testing::TestWithParam<InputRow> {};

TEST_P(InputFlow, RunsBlocksInThisOrder) {
  const InputRow& row = GetParam();
  const RunResult run =
      run_programs(programs_of(row.text), wide_settings(), {}, 20, [&row](std::uint64_t) { return row.input; });
  EXPECT_FALSE(run.error);
  EXPECT_EQ(run.order(), row.order);
}

constexpr auto kJump = "P0001N001G17N002G21P0001N004N003G18N004G19%";
constexpr auto kCall = "P0001N001G17N002G23P0002N001W01N003G18\nP0002N001G19%";

INSTANTIATE_TEST_SUITE_P(
    , InputFlow,
    testing::Values(
        InputRow{"G210_jumps_with_the_input", kJump, true, "P1N1 P1N2 P1N4"},
        InputRow{"G210_goes_on_without_it", kJump, false, "P1N1 P1N2 P1N3 P1N4"},
        InputRow{"G230_calls_with_the_input_and_repeats", kCall, true, "P1N1 P1N2 P2N1 P2N1 P1N3"},
        InputRow{"G230_goes_on_without_it", kCall, false, "P1N1 P1N2 P1N3"},
        InputRow{"G210_into_another_program", "P0001N001G21P0002N002\nP0002N001G17N002G18%", true, "P1N1 P2N2"},
        InputRow{"G210_a_missing_target_does_not_matter_without_it", "P0001N001G21P0009N001N002G17%", false,
                 "P1N1 P1N2"},
        InputRow{"D58_G21_keeps_the_way_back", "P0001N001G22P0002N001W00N002G17\nP0002N001G21P0003N001\nP0003N001G18%",
                 true, "P1N1 P2N1 P3N1 P1N2"}),
    [](const auto& row) { return std::string(row.param.name); });

/// When each question counts, as "sequence of the block that asks: sequence at whose start Input 1 is read".
std::vector<std::string> questions(std::string_view text, bool input) {
  std::vector<std::string> asked;
  auto interpreter = Interpreter::begin(programs_of(text), wide_settings(), {});
  if (!interpreter) return {"no interpreter"};
  std::vector<geometry::PathItem> items;
  std::uint64_t next = 1;
  while (!interpreter->ended() && next < 20) {
    if (const auto sequence = interpreter->awaited_input()) {
      asked.push_back(std::to_string(next) + ": " + std::to_string(*sequence));
      interpreter->answer_input(input);
      EXPECT_FALSE(interpreter->awaited_input()) << "it is answered";
    }
    if (!interpreter->step(items)) break;
    ++next;
  }
  return asked;
}

TEST(InputMoment, IsTheStartOfTheSecondBlockBefore_D56) {
  EXPECT_THAT(questions("P0001N001G17N002G17N003G17N004G21P0001N001N005G17%", false), ElementsAre("4: 2"));
}

TEST(InputMoment, IsSTARTWithFewerBlocksBefore_D56) {
  EXPECT_THAT(questions("P0001N001G21P0001N002N002G21P0001N003N003G23P0002N001W00\nP0002N001G17%", false),
              ElementsAre("1: 0", "2: 0", "3: 1"));
}

TEST(InputMoment, CountsExecutedBlocksNotNumbers_D56) {
  EXPECT_THAT(questions("P0001N001G22P0002N007W01N900G21P0001N950N950G17\nP0002N007G17%", true), ElementsAre("4: 2"));
}

TEST(InputMoment, EachQuestionIsAskedAnew_G211) {
  std::vector<std::uint64_t> asked;
  const auto input = [&asked](std::uint64_t sequence) {
    asked.push_back(sequence);
    return sequence < 4;
  };
  const RunResult run =
      run_programs(programs_of("P0001N001G17N002G17N003G21P0001N001N004G18%"), wide_settings(), {}, 20, input);
  EXPECT_EQ(run.order(), "P1N1 P1N2 P1N3 P1N1 P1N2 P1N3 P1N4");
  EXPECT_THAT(asked, ElementsAre(1u, 4u));
}

TEST(InputAnswer, MissingIsInactive) { EXPECT_EQ(run_text(kJump).order(), "P1N1 P1N2 P1N3 P1N4"); }

TEST(InputErrors, AreThoseOfG20AndG22) {
  const auto code_of = [](std::string_view text) {
    return run_programs(programs_of(text), wide_settings(), {}, 100, [](std::uint64_t) { return true; }).code();
  };
  EXPECT_EQ(code_of("P0001N001G21P0009N001%"), ErrorCode::program_missing);
  EXPECT_EQ(code_of("P0001N001G23P0001N009W00%"), ErrorCode::block_missing);
  EXPECT_EQ(code_of("P0001N001G21P9989N001%"), ErrorCode::reserved_for_cycles) << "DEC-64";
  EXPECT_EQ(code_of("P0001N001G23P9981N001W00%"), ErrorCode::reserved_for_cycles) << "DEC-64";
  EXPECT_EQ(code_of("P0001N001G23P0002N001W00\nP0002N001G23P0002N001W00%"), ErrorCode::nesting_too_deep);
}

}  // namespace
}  // namespace cnclab::program
