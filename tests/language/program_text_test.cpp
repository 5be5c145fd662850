// Tape or listing, told apart by content.
#include "language/program_text.hpp"

#include <gtest/gtest.h>

namespace cnclab::language {
namespace {

struct TextRow {
  std::string_view id, text;
  TextForm form;
};

TEST(ProgramText, FormIsToldByContent_DEC_30_EXT_005) {
  constexpr TextRow kRows[] = {
      {"EX-050", "P0001N001G00X+12Y-1500000Z+4150N999G01Z+500\nM05%", TextForm::tape},
      {"tape with blanks and points", "P0001\nN001 G00 X+1.5 Y.5 Z-3.\n%", TextForm::tape},
      {"tape with comments like a listing", "P0001\nN001 G00 X+1 (Y.....,... F....)\nN002 G17 (#01 = #02)",
       TextForm::tape},
      {"tape with a comment over lines", "P0001 (\nN001 G00 X+...5,000\n)\nN001G17", TextForm::tape},
      {"machine data are no assignment", "P0001\nN001G17\nMD\nN03=500000\nN04=400000\n%", TextForm::tape},
      {"machine data behind a block", "P0001\nN001\\10#01#02MDN03=500000%", TextForm::tape},
      {"tape calculation", "P0001\nN001\\01#01#02#03\nN002\\00#01+1.5", TextForm::tape},
      {"a tape in one line with a slip", "P0001N001G00X1..5N002G17", TextForm::tape},
      {"nothing", "", TextForm::tape},
      {"no sign of either", "P0001\n\n(09:00:00 16/06/83)\n\nN001 G17 (KREISEBENE XY)\n%\n", TextForm::tape},
      {"empty words", "P0001\nN001 G11 (ZUSATZFUNKTION) F1000 S.... T.. M..", TextForm::listing},
      {"dots before digits", "P0001\nN001 G12 (VIERTE ACHSE) U+...5.000", TextForm::listing},
      {"one dot before digits", "P0001\nN001 G01 X.100.000 Y.100.000 F1000", TextForm::listing},
      {"comma", "P0001\nN001 G12 U+5,000", TextForm::listing},
      {"narrow parameter", "P0001\nN001 G04 H.#63", TextForm::listing},
      {"assignment", "P0001\nN001 ↓00          #54 = +1000.000", TextForm::listing},
      {"assignment of nothing yet", "P0001\nN001 ↓01 #.. = #.. + #..", TextForm::listing},
      {"damaged", "P0001\nN003!G17", TextForm::listing},
      {"tool table", "P0000\nT001 R+...5,000 L+...1,000\n%", TextForm::listing},
      {"CRLF and indented", "P0001\r\n  N001 G01 X.....\r\n", TextForm::listing},
      {"small letters", "P0001\nn001 g01 x+...5,000", TextForm::listing},
      {"caption before it", "BEISPIEL\nP0001\nN001 G01 X+...5,000", TextForm::listing},
  };
  for (const TextRow& row : kRows) EXPECT_EQ(form_of_text(row.text), row.form) << row.id;
}

TEST(ProgramText, BothFormsComeThroughOneDoor) {
  const Tape tape = read_programs_text("P0001\nN001G00X+5000\n%", Reading::file);
  const Tape listing = read_programs_text("P0001\n\nN001 G00 X+...5,000 Y..... Z..... (EILGANG)\n%", Reading::file);
  ASSERT_EQ(tape.programs.size(), 1U);
  ASSERT_EQ(listing.programs.size(), 1U);
  EXPECT_EQ(tape.programs[0].program, listing.programs[0].program);
}

TEST(ProgramText, ControlReadsNoListings_DEC_30) {
  const Tape tape = read_programs_text("P0001\nN001 G00 X+...5,000\n%", Reading::strict);
  EXPECT_TRUE(tape.programs.empty());
  EXPECT_FALSE(tape.errors.empty());
}

}  // namespace
}  // namespace cnclab::language
