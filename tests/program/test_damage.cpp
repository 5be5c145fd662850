// Damaged rows of P0000 and damaged blocks: whoever needs what they say stops (ERR-004, ERR-010, STO-003, MOD-063).
#include <gmock/gmock.h>

#include "program/rebuild_modal.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using language::ErrorCode;

/// The set with one block damaged: its text was read, its check code did not fit.
ProgramSet damaged(const ProgramSet& sound, std::uint16_t program, std::uint16_t block) {
  ProgramSet programs = sound;
  language::Program copy = *programs.find(program);
  copy.blocks.at(copy.find(block).value()).is_damaged = true;
  programs.put(std::move(copy));
  return programs;
}

struct ToolRow {
  const char* name;
  const char* block;  ///< N001; N002 is a way
};

/// Every block that reads the row of the tool in force, or calls it.
constexpr ToolRow kReaders[] = {
    {"T", "G11T01"},
    {"G41", "G41"},
    {"G42", "G42"},
    {"G43", "G43"},
    {"G44", "G44"},
    {"G46", "G46"},
    {"word_67", "G01X#67"},
    {"word_68", "G11F#68"},
    {"operand_67", "\\10#01#67"},
    {"operand_68", "\\01#01#02#68"},
    {"G81", "G81Z-5000V002H0000"},
    {"G85", "G85X+40000Y+30000Z-5000Q-1000V002"},
};

class DamagedTool : public testing::TestWithParam<ToolRow> {};

TEST_P(DamagedTool, StopsTheBlockThatReadsItsRow_ERR_010_STO_003) {
  Start start;
  start.modal.feed_mm_per_min = 600;
  start.modal.tool = 1;
  const ProgramSet sound =
      programs_of(std::string("P0000T001R+5000L+1000P0001N001") + GetParam().block + "N002G01X+1000%");
  EXPECT_FALSE(run_programs(sound, wide_settings(), start).error) << "the row is sound";
  const RunResult run = run_programs(damaged(sound, 0, 1), wide_settings(), start);
  ASSERT_TRUE(run.error);
  EXPECT_EQ(run.code(), ErrorCode::checksum_wrong);
  EXPECT_EQ(run.error->block, 1);
  EXPECT_TRUE(run.items.empty()) << "nothing of the block acts";
  EXPECT_EQ(language::explain(*run.error, language::Tongue::german),
            "P0001 N001: P0000 T001 ist im Speicher beschädigt. Löschen und neu eingeben.");
}

TEST_P(DamagedTool, IsOfNoConcernToAnotherTool_ERR_010) {
  if (GetParam().name == std::string_view("T")) return;  // calls T01 itself
  Start start;
  start.modal.feed_mm_per_min = 600;
  start.modal.tool = 2;
  const ProgramSet sound =
      programs_of(std::string("P0000T001R+5000L+1000T002R+4000L+1000P0001N001") + GetParam().block + "N002G01X+1000%");
  EXPECT_FALSE(run_programs(damaged(sound, 0, 1), wide_settings(), start).error);
}

INSTANTIATE_TEST_SUITE_P(, DamagedTool, testing::ValuesIn(kReaders),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(DamagedRow, HasNoDataToComputeWith_ERR_010) {
  const ProgramSet programs = damaged(programs_of("P0000T001R+5000L+1000T002R+4000L+0%"), 0, 1);
  EXPECT_TRUE(programs.has_damaged_row(1));
  EXPECT_FALSE(programs.tool(1));
  EXPECT_FALSE(programs.has_damaged_row(2));
  EXPECT_EQ(programs.tool(2)->radius.value, 4000);
  EXPECT_FALSE(programs.has_damaged_row(3)) << "not listed at all";
}

TEST(DamagedBlock, BeforeTheStartNothingIsKnownOfWhatItLeaves_STO_003_MOD_063_DEC_26) {
  const ProgramSet sound = programs_of("P0044N001G90N002G11F0600N003G01X+5000N004G91%");
  const auto rebuilt = [&](std::uint16_t broken, std::uint16_t start) {
    const ProgramSet programs = damaged(sound, 44, broken);
    return rebuild_modal(programs, *programs.find(44), start, {});
  };
  for (const std::uint16_t broken : {std::uint16_t{1}, std::uint16_t{2}}) {
    const auto modal = rebuilt(broken, 3);
    ASSERT_FALSE(modal) << broken;
    EXPECT_EQ(modal.error().code, ErrorCode::checksum_wrong);
    EXPECT_EQ(modal.error().program, 44);
    EXPECT_EQ(modal.error().block, broken);
  }
  EXPECT_EQ(rebuilt(4, 3).value().dimension, Dimension::absolute) << "behind the start it is the run's concern";
}

TEST(DamagedBlock, ACompensationBeforeTheStartNeedsASoundRow_ERR_010_DEC_26) {
  const ProgramSet sound = programs_of("P0000T001R+5000L+1000P0001N001G11T01N002G41N003G40N004G46N005G17%");
  const ProgramSet programs = damaged(sound, 0, 1);
  EXPECT_TRUE(rebuild_modal(programs, *programs.find(1), 2, {})) << "T alone takes nothing of the row";
  const auto modal = rebuild_modal(programs, *programs.find(1), 3, {});
  ASSERT_FALSE(modal);
  EXPECT_EQ(modal.error().code, ErrorCode::checksum_wrong);
  EXPECT_EQ(modal.error().block, 2);
}

}  // namespace
}  // namespace cnclab::program
