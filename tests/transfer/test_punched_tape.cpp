// Tapes: holes, leader, separators, and the way back.
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <cstdlib>

#include "language/tape.hpp"
#include "transfer/iso_code.hpp"
#include "transfer/punched_tape.hpp"

namespace cnclab::transfer {
namespace {

using testing::HasSubstr;

std::vector<language::Program> programs_of(std::string_view text) {
  std::vector<language::Program> programs;
  for (language::ReadProgram& read : language::read_tape(text, language::Reading::strict).programs)
    programs.push_back(std::move(read.program));
  return programs;
}

const std::string kTwoPrograms = "P0001N001G00X+12Y-1500000Z+4150N999G01Z+500M05P0002N003G11F1000%";

TEST(IsoCode, ParityIsEven_EXT_044_D_103) {
  EXPECT_EQ(with_even_parity('\x11'), '\x11');  // DC1: two ones
  EXPECT_EQ(with_even_parity('\x13'), '\x93');  // DC3: three
  EXPECT_EQ(with_even_parity('P'), 'P');        // 50H
  EXPECT_EQ(with_even_parity('N'), 'N');        // 4EH
  EXPECT_EQ(with_even_parity('1'), '\xB1');
  EXPECT_EQ(with_even_parity('%'), '\xA5');
  for (int code = 0; code < 128; ++code) {
    const char c = static_cast<char>(code);
    EXPECT_EQ(std::popcount(static_cast<unsigned char>(with_even_parity(c))) % 2, 0);
    EXPECT_EQ(without_parity(with_even_parity(c)), c);
  }
}

TEST(PunchedTape, TextHasSeparatorsAndAnEnd_EXT_052) {
  const std::string text = line_text(programs_of(kTwoPrograms));
  EXPECT_EQ(text, std::string("P0001\r\nN001G00X+12Y-1500000Z+4150\r\nN999G01Z+500M05\r\n") + std::string(6, '\0') +
                      "P0002\r\nN003G11F1000\r\n%");
}

TEST(PunchedTape, HasLeaderAndTrailerOfFeedHoles) {
  const std::string rows = punch("P0001N001G04H0010%");
  ASSERT_EQ(rows.size(), 218u);
  EXPECT_EQ(rows.substr(0, 100), std::string(100, '\0'));
  EXPECT_EQ(rows.substr(118), std::string(100, '\0'));
  EXPECT_EQ(rows.substr(100, 9), "P000\xB1N00\xB1");  // 30H has two ones, 31H three
}

TEST(PunchedTape, ReadingMasksBitEight_D_103) {
  EXPECT_EQ(read_punched("\xD0\xB0"), "P0");
  EXPECT_EQ(read_punched(std::string(9, '\0')), "");
  EXPECT_EQ(read_punched("\x80\x80P\x80N"), std::string("P\0N", 3));  // a NUL row is one whatever its bit 8
  EXPECT_EQ(read_punched(std::string(kLargestFile + 10, 'P')).size(), kLargestFile);
}

TEST(PunchedTape, DisketteIsPlainText_EXT_030_DEC_34) {
  EXPECT_EQ(disk_text(programs_of(kTwoPrograms), "MD\nN03=500000\n"),
            "P0001\nN001G00X+12Y-1500000Z+4150\nN999G01Z+500M05\nP0002\nN003G11F1000\nMD\nN03=500000\n%\n");
}

TEST(PunchedTape, TheTwinCanBeReadByPeopleAndByTheControl) {
  const std::string rows = punch(line_text(programs_of(kTwoPrograms)));
  const std::string twin = twin_text(rows);
  EXPECT_THAT(twin, HasSubstr("N999G01Z+500M05\n\nP0002\n"));
  EXPECT_EQ(programs_of(twin), programs_of(kTwoPrograms));
}

/// Whatever bytes a file holds, reading gives 7-bit text, and what was punched comes back.
TEST(PunchedTape, ComesBack) {
  setenv("RC_PARAMS", "seed=3300 max_success=300", 0);
  EXPECT_TRUE(rc::check([](const std::string& bytes) {
    for (const char c : read_punched(bytes)) RC_ASSERT((static_cast<unsigned char>(c) & 0x80U) == 0);
    const std::string text = read_punched(bytes);
    RC_ASSERT(read_punched(punch(text)) == text);
  }));
}

}  // namespace
}  // namespace cnclab::transfer
