// Every M function: what it does and when (M-000 to M-098), under M24 (D-42, DEC-38), without its I/O card (D-124).
#include <gmock/gmock.h>

#include "item_names.hpp"

namespace cnclab::program {
namespace {

using testing::ElementsAre;
using Names = std::vector<std::string>;

std::string with_m(int code) {
  return std::string("M") + static_cast<char>('0' + code / 10) + static_cast<char>('0' + code % 10);
}

/// What a function does, before ("start") or behind ("end") the way of its block.
struct MRow {
  int code;
  Names at_start, at_end;
  bool acts_in_test_run = false;
};

/// Section M of the manual, line by line.
std::vector<MRow> all_rows() {
  std::vector<MRow> rows{
      {0, {}, {"halt"}},
      {1, {}, {"halt signal"}},
      {2, {}, {}},  // the end follows in any case
      {3, {"spindle cw 0"}, {}},
      {4, {"spindle ccw 0"}, {}},
      {5, {}, {"spindle off"}, true},
      {8, {"coolant on"}, {}},
      {9, {}, {"coolant off"}, true},
      {12, {}, {"spindle off", "coolant off"}, true},
      {13, {"spindle cw 0", "coolant on"}, {}},
      {14, {"spindle ccw 0", "coolant on"}, {}},
      {15, {}, {"signal"}},
      {16, {}, {"wait 0.0"}},
      {20, {}, {}, true},
      {21, {}, {}, true},
      {22, {}, {}, true},
      {23, {}, {}, true},
      {24, {}, {}},
  };
  for (int line = 0; line <= 8; ++line) {
    const std::string number = std::to_string(line);
    rows.push_back({40 + line, {}, {"output 1." + number + " on"}});
    rows.push_back({50 + line, {}, {"output 1." + number + " off"}});
    rows.push_back({60 + line, {}, {"wait 1." + number}});
    rows.push_back({70 + line, {}, {"output 2." + number + " on"}});
    rows.push_back({80 + line, {}, {"output 2." + number + " off"}});
    rows.push_back({90 + line, {}, {"wait 2." + number}});
  }
  return rows;
}

Names joined(Names first, const Names& second, const Names& third) {
  first.insert(first.end(), second.begin(), second.end());
  first.insert(first.end(), third.begin(), third.end());
  return first;
}

class MFunctions : public testing::TestWithParam<MRow> {};

TEST_P(MFunctions, ActAtTheirMoment_M900) {
  const MRow& row = GetParam();
  const RunResult run = run_text("P0001N001G01X+1000F0100" + with_m(row.code) + "%");
  ASSERT_FALSE(run.error);
  EXPECT_EQ(names_of(run), joined(joined(row.at_start, {"line"}, row.at_end), {"end"}, {}));
  EXPECT_EQ(run.blocks.back().modal.m, row.code) << "the status line shows it";
}

TEST_P(MFunctions, UnderM24_D42_DEC38) {
  const MRow& row = GetParam();
  Start start;
  start.modal.test_run = true;
  start.modal.m = 24;
  const RunResult run = run_text("P0001N001G01X+1000F0100" + with_m(row.code) + "N002G91%", 9, start);
  ASSERT_FALSE(run.error);
  const Names nothing;
  const Names& at_start = row.acts_in_test_run ? row.at_start : nothing;
  const Names& at_end = row.acts_in_test_run ? row.at_end : nothing;
  EXPECT_EQ(names_of(run), joined(joined(at_start, {"line"}, at_end), {"end"}, {}));
  EXPECT_EQ(run.blocks.front().modal.m, row.acts_in_test_run ? row.code : 24);
}

TEST_P(MFunctions, WithoutTheirCardDoNothingAndWaitForNothing_D124) {
  const MRow& row = GetParam();
  Settings settings = wide_settings();
  settings.io_cards = {false, true, true};
  const std::string text = "P0001N001G01X+1000F0100" + with_m(row.code) + "%";
  const bool is_card_1 = row.code >= 40 && row.code < 70;
  const Names whole = joined(joined(row.at_start, {"line"}, row.at_end), {"end"}, {});
  const Names bare{"line", "end"};
  EXPECT_EQ(names_of(run_text(text, 9, {}, settings)), is_card_1 ? bare : whole);
  settings.io_cards = {true, false, true};
  EXPECT_EQ(names_of(run_text(text, 9, {}, settings)), row.code >= 70 ? bare : whole);
}

INSTANTIATE_TEST_SUITE_P(, MFunctions, testing::ValuesIn(all_rows()),
                         [](const auto& row) { return with_m(row.param.code); });

TEST(MList, HasNoOthers_D51) {
  std::vector<bool> is_listed(100);
  for (const MRow& row : all_rows()) is_listed[static_cast<std::size_t>(row.code)] = true;
  for (int code = 0; code < 100; ++code) {
    const RunResult run = run_text("P0001N001G11" + with_m(code) + "%");
    if (is_listed[static_cast<std::size_t>(code)]) {
      EXPECT_FALSE(run.error) << code;
    } else {
      EXPECT_EQ(run.code(), language::ErrorCode::m_unknown) << code;
    }
  }
}

TEST(SpindleDigits, NeedCard3_D124_FST004) {
  Settings settings = wide_settings();
  settings.io_cards = {true, true, false};
  EXPECT_THAT(names_of(run_text("P0001N001G11S0500M03%", 9, {}, settings)), ElementsAre("spindle cw 500", "end"));
}

TEST(SpecialFunctions, AreSwitchedOffTogetherByM20) {
  const RunResult run = run_text("P0001N001G11M21N002G11M22N003G11M23N004G11M24N005G11M20%");
  std::string flags;
  for (const ExecutedBlock& block : run.blocks) {
    const ModalState& modal = block.modal;
    flags += {modal.blocks_hidden ? '1' : '-', modal.subprogram_blocks_hidden ? '2' : '-',
              modal.potentiometer_off ? '3' : '-', modal.test_run ? '4' : '-', ' '};
  }
  EXPECT_EQ(flags, "1--- 12-- 123- 1234 ---- ");
}

TEST(TestRun, LeavesWaysSpeedsAndToolsAlone_D42) {
  const RunResult run = run_text("P0000T001R+1000L+0\nP0001N001G11S0500M03N002G11M24N003G01X+1000F0100S0800T01M04%");
  EXPECT_THAT(names_of(run), ElementsAre("digits 500", "spindle cw 500", "mark", "digits 800", "spindle cw 800",
                                         "tool 1 R1 L0", "line", "end"))
      << "the spindle goes on turning as it did";
}

}  // namespace
}  // namespace cnclab::program
