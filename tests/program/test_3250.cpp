// The CNC 3250: fewer functions, no parameters (MODEL-001, MODEL-002, MODEL-006, MODEL-010); and a CNC 3300 without the
// functions that its manual only plans (DEC-08, BLK-200).
#include <gmock/gmock.h>

#include <set>

#include "program/check_programs.hpp"
#include "program/rebuild_modal.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;

Settings settings_of(language::Vocabulary vocabulary) {
  Settings settings = wide_settings();
  settings.vocabulary = vocabulary;
  return settings;
}

const Settings kCnc3250 = settings_of({.model = language::Model::cnc3250, .planned_functions = true});

/// A block of each G function of the CNC 3300 that is complete and runs in the power-on state with F1000.
struct FunctionRow {
  int code;
  const char* words;
  bool on_3250 = false;
  bool is_planned = false;
};

constexpr FunctionRow kFunctions[] = {
    {0, "X+1000", true},
    {1, "X+1000", true},
    {2, "X+1000Y+0I+500J+0"},
    {3, "X+1000Y+0I+500J+0"},
    {4, "H0010", true},
    {5, "X+1000Y+0R+500", false, true},
    {6, "X+1000Y+0R+500", false, true},
    {7, "X+1000Y+0I+500J+0Z+100"},
    {8, "X+1000Y+0I+500J+0Z+100"},
    {10, "R+1000", false, true},
    {11, "F0500", true},
    {12, "U+1000", true},
    {17, ""},
    {18, ""},
    {19, ""},
    {20, "P0001N003", true},
    {21, "P0001N003"},
    {22, "P0002N001W00", true},
    {23, "P0002N001W00"},
    {40, ""},
    {41, ""},
    {42, ""},
    {43, ""},
    {44, ""},
    {45, ""},
    {46, ""},
    {61, "X+1000", false, true},
    {62, "X+1000Y+0I+500J+0", false, true},
    {63, "X+1000Y+0I+500J+0", false, true},
    {64, "H0010", false, true},
    {65, "X+1000Y+0R+500", false, true},
    {66, "X+1000Y+0R+500", false, true},
    {68, "X+1000", true},
    {69, "X+1000", true},
    {74, "", true},
    {75, "X+1000", true},
    {90, ""},
    {91, "", true},
};

std::string program_with(const FunctionRow& row) {
  const std::string code{static_cast<char>('0' + row.code / 10), static_cast<char>('0' + row.code % 10)};
  return "P0001N001G11F1000N002G" + code + row.words + "N003G11M09\nP0002N001G11M09%";
}

class Vocabulary : public testing::TestWithParam<FunctionRow> {};

TEST_P(Vocabulary, OfTheCnc3300HasIt_BLK201) {
  const RunResult run = run_text(program_with(GetParam()));
  EXPECT_FALSE(run.error) << language::explain(run.error.value_or(language::Error{}), language::Tongue::english);
}

TEST_P(Vocabulary, OfTheCnc3250_MODEL001_MODEL002) {
  const RunResult run = run_text(program_with(GetParam()), 100, {}, kCnc3250);
  if (GetParam().on_3250) {
    EXPECT_FALSE(run.error);
    return;
  }
  ASSERT_EQ(run.code(), ErrorCode::function_unknown);
  EXPECT_EQ(run.error->block, 2);
  EXPECT_EQ(language::monitor_text(run.error->code, language::Tongue::german), "Funktion nicht vorgesehen");
  EXPECT_TRUE(run.items.empty()) << "said before anything moves";
}

TEST_P(Vocabulary, WithoutPlannedFunctions_BLK200) {
  const RunResult run = run_text(program_with(GetParam()), 100, {},
                                 settings_of({.model = language::Model::cnc3300, .planned_functions = false}));
  if (GetParam().is_planned) {
    EXPECT_EQ(run.code(), ErrorCode::function_unknown);
  } else {
    EXPECT_FALSE(run.error);
  }
}

INSTANTIATE_TEST_SUITE_P(, Vocabulary, testing::ValuesIn(kFunctions),
                         [](const auto& row) { return "G" + std::to_string(row.param.code); });

TEST(VocabularyList, IsThatOfTheForms) {
  std::set<int> listed;
  for (const FunctionRow& row : kFunctions) listed.insert(row.code);
  for (const language::BlockForm& form : language::all_forms()) {
    const bool is_cycle = form.function.code > 80 && form.function.code < 87;
    if (form.function.kind != language::Function::Kind::g || is_cycle) continue;
    EXPECT_TRUE(listed.contains(form.function.code)) << int{form.function.code};
  }
}

TEST(Cnc3250, HasNoParameters_MODEL006) {
  Start start;
  start.parameters[1] = kParameterUnit;
  EXPECT_FALSE(run_text("P0001N001G00X#01%", 9, start).error);
  const RunResult run = run_text("P0001N001G00X#01%", 9, start, kCnc3250);
  ASSERT_EQ(run.code(), ErrorCode::word_not_allowed);
  EXPECT_EQ(run.error->word, 'X');
  EXPECT_EQ(run_text("P0001N001\\00#01+5000%", 9, {}, kCnc3250).code(), ErrorCode::function_unknown);
}

TEST(Cnc3250, IsAlwaysIncremental_MODEL010) {
  const RunResult run = run_text("P0001N001G91N002G00X+1000N003G00X+1000%", 9, {}, kCnc3250);
  EXPECT_EQ(run.blocks.back().programmed_um[0], 2000);
}

TEST(Cnc3250, IsCheckedWithItsOwnVocabulary_MODEL002) {
  const auto errors = check_blocks(programs_of("P0001N001G17N002G00X+1000N003G90N004G81Z-5000V002H0010%"), kCnc3250);
  std::vector<int> blocks;
  for (const language::Error& error : errors) {
    EXPECT_EQ(error.code, ErrorCode::function_unknown);
    blocks.push_back(error.block);
  }
  EXPECT_THAT(blocks, testing::ElementsAre(1, 3, 4));
}

/// Kept by a control that was a CNC 3300 until the instructor changed its model.
TEST(Model3250, MODEL_007_MODEL_009_MODEL_010_AStateOfThe3300LosesWhatNothingCouldSwitchOff) {
  ModalState kept;
  kept.plane = geometry::Plane::yz;
  kept.radius = RadiusCompensation::plus;
  kept.tool_radius = {5000};
  kept.length_compensation = true;
  kept.tool_length = {1000};
  kept.scale_on = true;
  kept.scale = {2000, 1000, 1000};
  kept.dimension = Dimension::absolute;
  kept.feed_mm_per_min = 600;
  kept.tool = 1;
  EXPECT_EQ(within(kept, {}), kept) << "the CNC 3300 has it all";
  ModalState left;
  left.scale_on = true;  // G75 is there
  left.scale = kept.scale;
  left.feed_mm_per_min = 600;
  left.tool = 1;
  EXPECT_EQ(within(kept, kCnc3250.vocabulary), left);
}

}  // namespace
}  // namespace cnclab::program
