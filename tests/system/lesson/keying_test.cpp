// Key presses and tape texts against the manual's own examples.
#include "keying.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "parts.hpp"

namespace cnclab::lesson {
namespace {

TEST(Keying, EX_010_BlockN003IsKeyedWordByWord) {
  const auto commands = key_commands(parse_block("G01 X25 Y10 Z4 F1000 M03"), 17);
  const std::vector<std::string> expected = {"key ENTER", "type 01",   "key ENTER", "type 25",   "key ENTER",
                                             "type 10",   "key ENTER", "type 4",    "key ENTER", "type 1000",
                                             "key ENTER", "key ENTER", "key ENTER", "type 03",   "key EINGABE"};
  EXPECT_EQ(commands, expected);
}

TEST(Keying, BlocksWithoutWordsEndWithEingabe) {
  const std::vector<std::string> expected = {"key ENTER", "type 90", "key ENTER", "key EINGABE"};
  EXPECT_EQ(key_commands(parse_block("G90"), 17), expected);
}

TEST(Keying, ArcsAskForTheWordsOfThePlane) {
  EXPECT_EQ(word_order("02", 17), "XYIJ");
  EXPECT_EQ(word_order("02", 18), "XZIK");
  EXPECT_EQ(word_order("03", 19), "YZJK");
  EXPECT_EQ(plane_after(parse_block("G18"), 17), 18);
  EXPECT_THROW(static_cast<void>(key_commands(parse_block("G02 X1 Z0 I1 K0"), 17)), std::invalid_argument);
}

struct TapeRow {
  const char* block;
  int number;
  const char* tape;
};

TEST(Keying, TapeTextIsThatOfTheTransferFormat) {
  for (const TapeRow& row : {
           TapeRow{"G00 X0.012 Y-1500 Z4.15", 1, "N001G00X+12Y-1500000Z+4150"},  // EX-050
           TapeRow{"G01 Z0.5", 999, "N999G01Z+500"},                             // EX-051
           TapeRow{"G04 H0010", 2, "N002G04H0010"},
           TapeRow{"G20 P0001 N001", 5, "N005G20P0001N001"},
           TapeRow{"G22 P0010 N001 W02", 4, "N004G22P0010N001W02"},
           TapeRow{"G02 X10 Y0 I5 J0", 4, "N004G02X+10000Y+0I+5000J+0"},
           TapeRow{"G11 F500 T01 M03", 1, "N001G11F0500T01M03"},
       }) {
    EXPECT_EQ(tape_text(parse_block(row.block), row.number, 17), row.tape);
  }
}

TEST(Keying, BareTapeDropsWhatTheTapeFormIgnores) {
  EXPECT_EQ(bare_tape("P0001\nN001 G90\r\nN002G91\n%\n"), "P0001N001G90N002G91");
}

TEST(Keying, EveryProgramOfTheLessonCanBeKeyedIn) {
  for (const Part& part : parts()) {
    for (const WrittenProgram& program : part.programs) {
      SCOPED_TRACE(part.student + " P" + std::to_string(program.number));
      EXPECT_NO_THROW(static_cast<void>(tape_text(program)));
      int plane = 17;
      for (const std::string& line : program.blocks) {
        const WrittenBlock block = parse_block(line);
        plane = plane_after(block, plane);
        EXPECT_EQ(key_commands(block, plane).back(), "key EINGABE");
      }
    }
  }
}

}  // namespace
}  // namespace cnclab::lesson
