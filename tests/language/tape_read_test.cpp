// Tapes and files: program ends, comments, line numbers, ignored characters, reserved numbers, the check code.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "language/tape.hpp"
#include "tape_block.hpp"
#include "tape_text.hpp"

namespace cnclab::language {
namespace {

using std::string_literals::operator""s;

struct TapeRow {
  std::string id, text, programs;
};

TEST(Tape, ReadsProgramsToTheirEnds_EXT_049_to_055) {
  const TapeRow rows[] = {
      {"EX-050 to EX-053", "P0001N001G00X+12Y-1500000Z+4150N999G01Z+500\nM05"s + "\0\0\0\0\0\0"s + "P0002N003G17%",
       "P0001\nN001G00X+12Y-1500000Z+4150\nN999G01Z+500M05\n|P0002\nN003G17\n"},
      {"nothing", "", ""},
      {"line breaks anywhere", "P00\r\n01\nN0\n01G\n00X+\n1\n2", "P0001\nN001G00X+12\n"},
      {"next P ends a program", "P0001N001G17P0002N001G18", "P0001\nN001G17\n|P0002\nN001G18\n"},
      {"P and N of G20 are words", "P0001N001G20P0002N003N002G17P0003N001G17",
       "P0001\nN001G20P0002N003\nN002G17\n|P0003\nN001G17\n"},
      {"order of the words is put right", "P0001N001G00Z+3X+1Y+2N002G20N001P0001",
       "P0001\nN001G00X+1Y+2Z+3\nN002G20P0001N001\n"},
      {"blocks are put in order", "P0001N003G17N001G18N002G19", "P0001\nN001G18\nN002G19\nN003G17\n"},
      {"later program replaces the earlier", "P0001N001G17P0002N001G18P0001N005G19",
       "P0001\nN005G19\n|P0002\nN001G18\n"},
      {"% between programs of a file", "P0001\nN001G17\n%\nP0002\nN001G18\n%\n", "P0001\nN001G17\n|P0002\nN001G18\n"},
      {"DEC-58 goes on behind a separator", "P0001N001G17"s + "\0\0\0\0\0\0"s + "N002G18%",
       "P0001\nN001G17\nN002G18\n"},
      {"fewer than six NUL are ignored", "P0001N001G17"s + "\0\0\0\0\0"s + "N002G18", "P0001\nN001G17\nN002G18\n"},
      {"EXT-052 five NUL end no word", "P0001N001G00X+1"s + "\0\0\0\0\0"s + "2%", "P0001\nN001G00X+12\n"},
      {"a separator ends a word", "P0001N001G20P0001N001"s + "\0\0\0\0\0\0\0"s + "N002G18",
       "P0001\nN001G20P0001N001\nN002G18\n"},
      {"leading NUL", "\0\0\0\0\0\0\0\0"s + "P0001N001G17", "P0001\nN001G17\n"},
      {"DEC-30 comments", "(a) P0001 (QUADRAT, klein)\nN001 (N009 G99\n%) G1(x)7 ()", "P0001\nN001G17\n"},
      {"DEC-31 arrow", "P0001N002↓01#01#02#03N003\\53N002", "P0001\nN002\\01#01#02#03\nN003\\53N002\n"},
      {"P0000", "P0000T001R+5000L+1000T002L-5R+3%P0001N001G11T01",
       "P0000\nT001R+5000L+1000\nT002R+3L-5\n|P0001\nN001G11T01\n"},
      {"fewer digits where they are clear", "P0001N001G11F500S60T1M3", "P0001\nN001G11F0500S0060T01M03\n"},
      {"CYC-205 to CYC-234", "P0001N005\\00#00+0N007\\10#55#64N033\\51N040N034\\00#58+0.8",
       "P0001\nN005\\00#00+0\nN007\\10#55#64\nN033\\51N040\nN034\\00#58+800\n"},
  };
  for (const TapeRow& row : rows) {
    const Tape tape = read_tape(row.text, Reading::file);
    EXPECT_EQ(programs_of(tape, "|"), row.programs) << row.id;
    EXPECT_EQ(messages_of(tape), "") << row.id;
    EXPECT_TRUE(tape.notices.empty()) << row.id;
  }
}

TEST(Tape, ControlIgnoresSmallLettersAndStopsAtPercent_EXT_049_EXT_055_DEC_30) {
  const Tape tape = read_tape("pP0001xn N001hello G00 X+12~N002G17%P0002N001G18", Reading::strict);
  EXPECT_EQ(programs_of(tape, "|"), "P0001\nN001G00X+12\nN002G17\n");
  EXPECT_EQ(messages_of(tape), "");
}

TEST(Tape, ControlKnowsNoComments_D_101) {
  const Tape tape = read_tape("P0001N001G17(X)", Reading::strict);
  EXPECT_TRUE(tape.programs.empty());
  ASSERT_EQ(tape.errors.size(), 1U);
  EXPECT_EQ(tape.errors[0].code, ErrorCode::text_malformed);
}

TEST(Tape, ReservedProgramsAreLeftOutWithANotice_DEC_06) {
  const Tape tape = read_tape("P9981N001G99X+1P9980N001G17P9990N001G17P9989N001G17", Reading::file);
  EXPECT_EQ(programs_of(tape, "|"), "P9980\nN001G17\n|P9990\nN001G17\n");
  EXPECT_EQ(messages_of(tape), "");
  ASSERT_EQ(tape.notices.size(), 2U);
  EXPECT_THAT(tape.notices[0], testing::HasSubstr("P9981"));
  EXPECT_THAT(tape.notices[1], testing::HasSubstr("P9989"));
}

TEST(Tape, KeepsTheLineOfEachBlock) {
  const Tape tape = read_tape("(1)\nP0001\nN003G17\n\nN001\nG18 (\n\n) N002G19", Reading::file);
  ASSERT_EQ(tape.programs.size(), 1U);
  EXPECT_THAT(tape.programs[0].lines, testing::ElementsAre(5, 8, 3));
}

TEST(Tape, AllErrorsNotOnlyTheFirst) {
  const Tape tape =
      read_tape("P0001\nN001G99\nN002G17\nN003G01X+\nN004G20P0001\nP0002\nN001G01F0\nP0003\nN001G17", Reading::file);
  EXPECT_EQ(programs_of(tape, "|"), "P0003\nN001G17\n");
  ASSERT_EQ(tape.errors.size(), 4U) << messages_of(tape);
  const Error expected[] = {
      {.code = ErrorCode::function_unknown, .program = 1, .block = 1, .word = 'G', .detail = "G99", .line = 2},
      {.code = ErrorCode::text_malformed, .program = 1, .block = 3, .word = 'X', .line = 4},
      {.code = ErrorCode::word_missing, .program = 1, .block = 4, .word = 'N', .line = 5},
      {.code = ErrorCode::word_out_of_range,
       .program = 2,
       .block = 1,
       .word = 'F',
       .detail = "0000",
       .expected = "0001..9999",
       .line = 7},
  };
  EXPECT_THAT(tape.errors, testing::ElementsAreArray(expected)) << messages_of(tape);
}

TEST(Tape, OpenCommentIsAnErrorOfItsLine) {
  const Tape tape = read_tape("P0001\nN001G17\nN002G18 (to the\nend\n", Reading::file);
  EXPECT_THAT(tape.errors,
              testing::ElementsAre(Error{.code = ErrorCode::text_malformed, .word = '(', .expected = ")", .line = 3}));
}

TEST(Tape, FileWithSmallLettersGivesNoProgramAtAll_DEC_30) {
  const Tape tape = read_tape("P0001N001G17\nP0002n001g17\nN002g18\n", Reading::file);
  EXPECT_TRUE(tape.programs.empty());
  ASSERT_EQ(tape.errors.size(), 2U) << messages_of(tape);
  EXPECT_EQ(tape.errors[0], (Error{.code = ErrorCode::lower_case, .detail = "n", .line = 2}));
  EXPECT_EQ(tape.errors[1], (Error{.code = ErrorCode::lower_case, .detail = "g", .line = 3}));
}

TEST(Tape, RowsBehindAnErrorAreCheckedAsWell_D_50) {
  const Tape tape = read_tape("P12 P0000T801R+1000P0001N001G17", Reading::file);
  EXPECT_EQ(programs_of(tape, "|"), "P0001\nN001G17\n");
}

TEST(Tape, ErrorsAreBounded) {
  std::string text = "P0001";
  for (int i = 0; i < 5000; ++i) text += "N001G99";
  const Tape tape = read_tape(text, Reading::file);
  EXPECT_EQ(tape.errors.size(), 1000U);
  ASSERT_EQ(tape.notices.size(), 1U);
  EXPECT_EQ(tape.notices[0], "4000 weitere Fehler sind nicht aufgeführt.");
  EXPECT_EQ(read_tape(text, Reading::file, Tongue::english).notices.at(0), "4000 more errors are not listed.");
}

TEST(Tape, NumbersOfAnyLengthDoNotOverflow) {
  const std::string nines(100'000, '9');
  const Tape tape =
      read_tape("P0001N001G00X-" + nines + "N002G00X" + nines + "." + nines + "N003G11F" + nines, Reading::file);
  EXPECT_EQ(tape.errors.size(), 3U) << messages_of(tape);
}

TEST(Tape, StoredBlocksRefuseWhatIsBehindThem) {
  for (const std::string_view text :
       {"N001G17N002G18", "N001G17%", "N001G17P0001", "P0001N001G17", "", "N001", "G17", "N001g17"})
    EXPECT_FALSE(read_block(text, 1).has_value()) << text;
}

// The values are zlib's crc32 of b"P0001N003G01X+25000Y+10000Z+4000F1000M03" and so on.
TEST(Tape, CheckCodeIsCrc32OfProgramNumberAndBlock_SYS_018) {
  EXPECT_EQ(check_code(1, "N003G01X+25000Y+10000Z+4000F1000M03"), 0xEBA35EE1U);
  EXPECT_EQ(check_code(2, "N003G01X+25000Y+10000Z+4000F1000M03"), 0x8F43251FU);
  EXPECT_EQ(check_code(0, "T001R+5000L+1000"), 0x794C2DADU);
}

}  // namespace
}  // namespace cnclab::language
