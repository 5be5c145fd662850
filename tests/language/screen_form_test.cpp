// Block lines as the manual prints them, in the form of D-21.
#include "language/screen_form.hpp"

#include <gtest/gtest.h>

#include "tape_block.hpp"

namespace cnclab::language {
namespace {

struct LineRow {
  std::string_view id, text, line;
  std::uint16_t program = 1;
};

constexpr LineRow kLines[] = {
    {"EX-010 Bild 5/7 N001", "N001G00X+50000Y+50000Z+50000", "N001 G00 X+..50.000 Y+..50.000 Z+..50.000 (EILGANG)"},
    {"EX-010 Bild 5/7 N002", "N002G04H0010", "N002 G04 (VERWEILZEIT ZEHNTELSEK.) H0010"},
    {"EX-010 Bild 5/7 N003", "N003G01X+25000Y+10000Z+4000F1000M03",
     "N003 G01 X+..25.000 Y+..10.000 Z+...4.000 F1000 S.... T.. M03"},
    {"EX-010 Bild 5/7 N004", "N004G02X+10000Y+0I+5000J+0", "N004 G02 X+..10.000 Y+...0.000 I+...5.000 J+...0.000"},
    {"EX-010 Bild 5/7 N005", "N005G20P0001N001", "N005 G20 (SPRUNG PROGRAMM) P0001 N001"},
    {"EX-040 N001", "N001G02X+5Y-5I+20000J+0", "N001 G02 X+...0.005 Y-...0.005 I+..20.000 J+...0.000"},
    {"EX-060", "N001G01X#04Z+10000F1000", "N001 G01 X......#04 Y.....,... Z+..10.000 F1000 S.... T.. M.."},
    {"EX-061", "N002\\01#01#02#03", "N002 ↓01          #01 = #02 + #03"},
    {"EX-070", "N001G69X-1000", "N001 G69 X-...1.000 Y.....,... Z.....,... (REFERENZPUNKT FAHREN)"},
    {"EX-080 T001", "T001R+5000L+1000", "T001 R+...5.000 L+...1.000", kToolTable},
    {"EX-080 N001", "N001G68X+0Y+0Z+0", "N001 G68 X+...0.000 Y+...0.000 Z+...0.000 (ISTWERT SETZEN)"},
    {"EX-080 N002", "N002G11F1000T01", "N002 G11 (ZUSATZFUNKTION) F1000 S.... T01 M.."},
    {"EX-080 N003", "N003G01X+20000", "N003 G01 X+..20.000 Y.....,... Z.....,... F.... S.... T.. M.."},
    {"EX-080 N004", "N004G42", "N004 G42 (RADIUSKOMPENSATION RECHTS)"},
    {"EX-080 N009", "N009G01Y-30000", "N009 G01 X.....,... Y-..30.000 Z.....,... F.... S.... T.. M.."},
    {"EX-080 N011", "N011G40", "N011 G40 (RADIUSKOMPENSATION AUS)"},
    {"EX-100 N001", "N001G75X-1000Y+1000", "N001 G75 X-...1.000 Y+...1.000 Z.....,... F.... (SKALENFAKTOR)"},
    {"EX-100 N002", "N002G22P0001N001W00", "N002 G22 (AUFRUF PROGRAMM) P0001 N001 W00"},
    {"EX-100 N007", "N007G74", "N007 G74 (SKALENFAKTOR AUS)"},
    {"EX-100 P0001 N003", "N003G02X+5Y-5I+10000J+10000", "N003 G02 X+...0.005 Y-...0.005 I+..10.000 J+..10.000"},
    {"CYC-206", "N006\\00#54-500", "N006 ↓00          #54 = -...0.500"},
    {"CYC-207", "N007\\10#55#64", "N007 ↓10          #55 = COPY #64"},
    {"CYC-213", "N013\\13#62#62", "N013 ↓13          #62 = CPL #62"},
    {"CYC-233", "N033\\51N040", "N033 ↓51 (JUMP POS TO) N040"},
    {"CYC-322", "N122G04H#63", "N122 G04 (VERWEILZEIT ZEHNTELSEK.) H.#63"},
    {"DEC-60 narrow words", "N001G22P#01N#02W#03", "N001 G22 (AUFRUF PROGRAMM) P.#01 N#02 W#03"},
    {"SCR-011 widest value", "N001G12U-9999999", "N001 G12 (VIERTE ACHSE) U-9999.999"},
    {"D-54 plane by its words", "N001G02X+1000Z+2000I+3000K-4000",
     "N001 G02 X+...1.000 Z+...2.000 I+...3.000 K-...4.000"},
    {"DEC-03 G86", "N001G86R+25000D045W06Z-10000V002H0000",
     "N001 G86 R+..25.000 D045 W06 Z-..10.000 Q.....,... V002 H0000"},
};

TEST(ScreenForm, LinesOfTheManual_SCR_011_to_015) {
  for (const LineRow& row : kLines) {
    const std::string line = block_line(tape_block(row.text, row.program), Plane::xy, Tongue::german);
    EXPECT_EQ(line, row.line) << row.id;
    EXPECT_LE(columns_of(line), 64) << row.id;
  }
}

TEST(ScreenForm, LongestLineFills64Columns_SCR_008) {
  const Block block = tape_block("N001G69X-1000Y-1000Z-1000");
  EXPECT_EQ(columns_of(block_line(block, Plane::xy, Tongue::german)), 64);
}

TEST(ScreenForm, DamagedBlockCarriesItsMark_SCR_052_D_119) {
  Block block = tape_block("N003G17");
  block.is_damaged = true;
  EXPECT_EQ(block_line(block, Plane::xy, Tongue::german), "N003!G17 (KREISEBENE XY)");
}

TEST(ScreenForm, EnglishText_SCR_051) {
  EXPECT_EQ(block_line(tape_block("N001G00X+1000"), Plane::xy, Tongue::english),
            "N001 G00 X+...1.000 Y.....,... Z.....,... (RAPID)");
}

TEST(ScreenForm, EntryLinesOfBild3And4_SCR_033_035) {
  std::string words;
  for (const Address address : find_form({Function::Kind::g, 1}, Plane::xy, {})->words)
    words += ' ' + word_text(address, nullptr);
  EXPECT_EQ("G01" + words, "G01 X.....,... Y.....,... Z.....,... F.... S.... T.. M..");
}

TEST(ScreenForm, Istwert_SCR_010) {
  struct Row {
    std::int64_t um;
    std::string_view text;
  };
  constexpr Row kRows[] = {{0, "+0000.000"},  {85'000, "+0085.000"},    {-1'000, "-0001.000"},
                           {-5, "-0000.005"}, {9'999'999, "+9999.999"}, {-9'999'999, "-9999.999"}};
  for (const Row& row : kRows) EXPECT_EQ(istwert_text({row.um}), row.text);
}

}  // namespace
}  // namespace cnclab::language
