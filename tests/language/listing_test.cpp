// The printer's listing: the manual's own listings word for word, every form of a line, every error with its line.
#include "language/listing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tape_block.hpp"
#include "tape_text.hpp"

namespace cnclab::language {
namespace {

/// EX-080 as the manual prints it: commas, unaligned dots, short empty words.
constexpr std::string_view kSquare = R"(P0000

(09:00:00 16/06/83)

T001 R+...5,000 L+...1,000
%

P0001

(09:00:00 16/06/83)

N001 G68 X+...0,000 Y+...0,000 Z+...0,000 (ISTWERT SETZEN)
N002 G11 (ZUSATZFUNKTION) F1000 S.... T01 M..
N003 G01 X+...20,000 Y..... Z..... F.... S.... T.. M..
N004 G42 (RADIUSKOMPENSATION RECHTS)
N005 G01 X..... Y+...30,000 Z..... F.... S.... T.. M..
N006 G01 X+...30,000 Y..... Z..... F.... S.... T.. M..
N007 G01 X..... Y+...30,000 Z..... F.... S.... T.. M..
N008 G01 X-...30,000 Y..... Z..... F.... S.... T.. M..
N009 G01 X..... Y-...30,000 Z..... F.... S.... T.. M..
N010 G01 X..... Y-...30,000 Z..... F.... S.... T.. M..
N011 G40 (RADIUSKOMPENSATION AUS)
N012 G01 X-...20,000 Y..... Z..... F.... S.... T.. M..
%
)";

constexpr std::string_view kSquareTape = R"(P0000
T001R+5000L+1000
P0001
N001G68X+0Y+0Z+0
N002G11F1000T01
N003G01X+20000
N004G42
N005G01Y+30000
N006G01X+30000
N007G01Y+30000
N008G01X-30000
N009G01Y-30000
N010G01Y-30000
N011G40
N012G01X-20000
)";

/// EX-100.
constexpr std::string_view kMirrored = R"(P0002

(08:41:07 16/06/83)

N001 G75 X-...1,000 Y+...1,000 Z..... F.... (SKALENFAKTOR)
N002 G22 (AUFRUF PROGRAMM) P0001 N001 W00
N003 G75 X+...1,000 Y-...1,000 Z..... F.... (SKALENFAKTOR)
N004 G22 (AUFRUF PROGRAMM) P0001 N001 W00
N005 G75 X-...1,000 Y-...1,000 Z..... F.... (SKALENFAKTOR)
N006 G22 (AUFRUF PROGRAMM) P0001 N001 W00
N007 G74 (SKALENFAKTOR AUS)
N008 G22 (AUFRUF PROGRAMM) P0001 N001 W00

%

P0001

(08:41:15 16/06/83)

N001 G11 (ZUSATZFUNKTION) F1000 S.... T.. M..
N002 G01 X+...20,000 Y+...20,000 Z..... F.... S.... T.. M..
N003 G02 X+...0,005 Y-...0,005 I+...10,000 J+...10,000
N004 G01 X-...0,005 Y+...0,005 Z..... F.... S.... T.. M..
N005 G01 X-...20,000 Y-...20,000 Z..... F.... S.... T.. M..

%
)";

constexpr std::string_view kMirroredTape = R"(P0002
N001G75X-1000Y+1000
N002G22P0001N001W00
N003G75X+1000Y-1000
N004G22P0001N001W00
N005G75X-1000Y-1000
N006G22P0001N001W00
N007G74
N008G22P0001N001W00
P0001
N001G11F1000
N002G01X+20000Y+20000
N003G02X+5Y-5I+10000J+10000
N004G01X-5Y+5
N005G01X-20000Y-20000
)";

TEST(Listing, OfTheManualIsRead_EX_080_EX_100) {
  const Tape square = read_listing(kSquare);
  EXPECT_EQ(messages_of(square), "");
  EXPECT_EQ(programs_of(square), kSquareTape);
  const Tape mirrored = read_listing(kMirrored);
  EXPECT_EQ(messages_of(mirrored), "");
  EXPECT_EQ(programs_of(mirrored), kMirroredTape);
}

TEST(Listing, IsWrittenInScreenForm_EXT_005_D_21) {
  const Tape tape = read_tape(kSquareTape, Reading::file);
  ASSERT_EQ(tape.programs.size(), 2U);
  EXPECT_EQ(write_listing(tape.programs[0].program, "09:00:00 16/06/83", Tongue::german),
            "P0000\n\n(09:00:00 16/06/83)\n\nT001 R+...5.000 L+...1.000\n%\n");
  EXPECT_EQ(write_listing(tape.programs[1].program, "09:00:00 16/06/83", Tongue::german),
            "P0001\n\n(09:00:00 16/06/83)\n\n"
            "N001 G68 X+...0.000 Y+...0.000 Z+...0.000 (ISTWERT SETZEN)\n"
            "N002 G11 (ZUSATZFUNKTION) F1000 S.... T01 M..\n"
            "N003 G01 X+..20.000 Y.....,... Z.....,... F.... S.... T.. M..\n"
            "N004 G42 (RADIUSKOMPENSATION RECHTS)\n"
            "N005 G01 X.....,... Y+..30.000 Z.....,... F.... S.... T.. M..\n"
            "N006 G01 X+..30.000 Y.....,... Z.....,... F.... S.... T.. M..\n"
            "N007 G01 X.....,... Y+..30.000 Z.....,... F.... S.... T.. M..\n"
            "N008 G01 X-..30.000 Y.....,... Z.....,... F.... S.... T.. M..\n"
            "N009 G01 X.....,... Y-..30.000 Z.....,... F.... S.... T.. M..\n"
            "N010 G01 X.....,... Y-..30.000 Z.....,... F.... S.... T.. M..\n"
            "N011 G40 (RADIUSKOMPENSATION AUS)\n"
            "N012 G01 X-..20.000 Y.....,... Z.....,... F.... S.... T.. M..\n"
            "%\n");
}

TEST(Listing, WordsOfAnArcFollowThePlaneBefore_D_54) {
  Program program{.number = 1, .blocks = {tape_block("N001G18"), tape_block("N002G02X+1000")}};
  EXPECT_THAT(write_listing(program, "", Tongue::german),
              testing::HasSubstr("N002 G02 X+...1.000 Z.....,... I.....,... K.....,...\n"));
}

struct ListedRow {
  std::string_view id, line, tape;
};

TEST(Listing, EveryFormOfALine_EXT_005_SCR_012_to_016_SCR_051_to_053) {
  constexpr ListedRow kRows[] = {
      {"EX-010 N001", "N001 G00 X+..50.000 Y+..50.000 Z+..50.000 (EILGANG)", "N001G00X+50000Y+50000Z+50000"},
      {"English text", "N001 G00 X+..50.000 Y.....,... Z.....,... (RAPID)", "N001G00X+50000"},
      {"no text", "N001 G00 X+..50.000 Y.....,... Z.....,...", "N001G00X+50000"},
      {"text in small letters", "N001 G00 X+..50.000 (Eilgang)", "N001G00X+50000"},
      {"EX-030 no sign", "N001 G01 X.100.000 Y.100.000 F1000", "N001G01X+100000Y+100000F1000"},
      {"EX-060 four dots behind the comma", "N001 G01 X.....#04 Y.....,.... Z...10,000 F1000 S.... T.. M..",
       "N001G01X#04Z+10000F1000"},
      {"no dots at all", "N001 G01 X+5,5 Y-0.001", "N001G01X+5500Y-1"},
      {"no blanks", "N001G01X+...5,500Y.....F1000", "N001G01X+5500F1000"},
      {"EX-010 N002", "N002 G04 (VERWEILZEIT ZEHNTELSEK.) H0010", "N002G04H0010"},
      {"CYC-322 narrow parameter", "N122 G04 (VERWEILZEIT ZEHNTELSEK.) H.#63", "N122G04H#63"},
      {"DEC-60 P N W by parameters", "N001 G22 (AUFRUF PROGRAMM) P.#01 N#02 W#03", "N001G22P#01N#02W#03"},
      {"EX-010 N005", "N005 G20 (SPRUNG PROGRAMM) P0001 N001", "N005G20P0001N001"},
      {"fewer digits", "N001 G11 F.500 S..60 T.1 M.3", "N001G11F0500S0060T01M03"},
      {"EX-061", "N002 ↓01          #01 = #02 + #03", "N002\\01#01#02#03"},
      {"backslash for the arrow", "N002 \\04 #01 = #02 / #03", "N002\\04#01#02#03"},
      {"subtraction", "N002 ↓02 #01 = #02 - #03", "N002\\02#01#02#03"},
      {"no blanks in a calculation", "N002↓03#01=#02*#03", "N002\\03#01#02#03"},
      {"CYC-206", "N006 ↓00          #54 = -...0.500", "N006\\00#54-500"},
      {"value with comma, no sign", "N006 ↓00 #54 = ...0,500", "N006\\00#54+500"},
      {"CYC-207", "N007 ↓10          #55 = COPY #64", "N007\\10#55#64"},
      {"PAR-020", "N007 ↓15          #55 = SQRT #64", "N007\\15#55#64"},
      {"CYC-233", "N033 ↓51 (JUMP POS TO) N040", "N033\\51N040"},
      {"jump without its text", "N033 ↓53 N040", "N033\\53N040"},
      {"DEC-03 G86", "N001 G86 R+..25.000 D045 W06 Z-..10.000 Q.....,... V002 H0000",
       "N001G86R+25000D045W06Z-10000V002H0000"},
      {"BLK-181 G81", "N001 G81 X.....,... Y.....,... Z-..10.000 Q.....,... V002 H0010", "N001G81Z-10000V002H0010"},
      {"D-67 G75 with F", "N001 G75 X-...1,000 Y..... Z..... F0500 (SKALENFAKTOR)", "N001G75X-1000F0500"},
      {"widest length", "N001 G12 (VIERTE ACHSE) U-9999.999", "N001G12U-9999999"},
      {"all words empty", "N001 G01 X..... Y..... Z..... F.... S.... T.. M..", "N001G01"},
      {"G18 words", "N001 G02 X+...1.000 Z+...2.000 I+...3.000 K-...4.000", "N001G02X+1000Z+2000I+3000K-4000"},
  };
  for (const ListedRow& row : kRows) {
    const Tape tape = read_listing("P0001\n" + std::string(row.line) + "\n%\n");
    EXPECT_EQ(messages_of(tape), "") << row.id;
    EXPECT_EQ(programs_of(tape), "P0001\n" + std::string(row.tape) + "\n") << row.id;
  }
}

TEST(Listing, DamagedBlocksStayDamaged_SCR_052_D_119) {
  const Tape tape =
      read_listing("P0001\nN003!G17 (KREISEBENE XY)\nN004 G18\n%\nP0000\nT001!R+...5.000 L.....,...\n%\n");
  EXPECT_EQ(messages_of(tape), "");
  ASSERT_EQ(tape.programs.size(), 2U);
  EXPECT_TRUE(tape.programs[0].program.blocks[0].is_damaged);
  EXPECT_FALSE(tape.programs[0].program.blocks[1].is_damaged);
  EXPECT_TRUE(tape.programs[1].program.blocks[0].is_damaged);
  EXPECT_THAT(write_listing(tape.programs[0].program, "", Tongue::german),
              testing::HasSubstr("N003!G17 (KREISEBENE XY)\n"));
}

TEST(Listing, LineEndsAndBlankLinesSayNothing) {
  const Tape tape =
      read_listing("\xEF\xBB\xBFP0001\r\n\r\n(09:00:00 16/06/83)\r\n \t\r\nN001 G17\r\n  N002 G18  \r\n%\r\n");
  EXPECT_EQ(messages_of(tape), "");
  EXPECT_EQ(programs_of(tape), "P0001\nN001G17\nN002G18\n");
  ASSERT_EQ(tape.programs.size(), 1U);
  EXPECT_THAT(tape.programs[0].lines, testing::ElementsAre(5, 6));
}

TEST(Listing, ProgramsEndAsOnTapes_EXT_055_EDIT_032) {
  EXPECT_EQ(programs_of(read_listing("P0001\nN001 G17\nP0002\nN001 G18")), "P0001\nN001G17\nP0002\nN001G18\n");
  EXPECT_EQ(programs_of(read_listing("P0001\nN003 G17\nN001 G18\n%")), "P0001\nN001G18\nN003G17\n");
  EXPECT_EQ(programs_of(read_listing("P0001\nN001 G17\n%\nP0001\nN002 G18\n%")), "P0001\nN002G18\n");
  const Tape reserved = read_listing("P9981\nN001 G17\n%\nP0001\nN001 G17\n%");
  EXPECT_EQ(programs_of(reserved), "P0001\nN001G17\n");
  EXPECT_EQ(reserved.notices.size(), 1U);
}

struct BadRow {
  std::string_view id, line, message;
};

TEST(Listing, ErrorsSayLineWordAndRemedy) {
  constexpr BadRow kRows[] = {
      {"length without a point", "N001 G00 X+500", "X +500 ist so nicht lesbar, richtig: +...1.500. Text berichtigen."},
      {"dots before a length without a point", "N001 G00 X+.500",
       "X +.500 ist so nicht lesbar, richtig: +...1.500. Text berichtigen."},
      {"sign alone", "N001 G00 X+.....", "X ist so nicht lesbar. Text berichtigen."},
      {"no value and no dots", "N001 G00 X Y+...1.000", "X ist so nicht lesbar. Text berichtigen."},
      {"four decimals", "N001 G00 X+...1.0005", "X ist so nicht lesbar, richtig: 0.001. Text berichtigen."},
      {"too large", "N001 G00 X+10000.000",
       "X 10000.000 ist nicht erlaubt, richtig: -9999.999..9999.999. Wert ändern."},
      {"F0000", "N001 G11 F0000", "F 0000 ist nicht erlaubt, richtig: 0001..9999. Wert ändern."},
      {"foreign word", "N001 G00 X+...1.000 F1000", "F passt nicht in diesen Satz, richtig: X Y Z. Wort entfernen."},
      {"word twice", "N001 G00 X+...1.000 X+...1.000", "X 2× passt nicht in diesen Satz. Wort entfernen."},
      {"unknown function", "N001 G99 X.....", "G99 gibt es an dieser Steuerung nicht. Andere Funktion eingeben."},
      {"no function", "N001 X+...1.000", "G fehlt, richtig: G00..G91. Wort ergänzen."},
      {"number alone", "N001", "G fehlt, richtig: G00..G91. Wort ergänzen."},
      {"jump without target", "N001 ↓53 (JUMP TO) N...", "N fehlt. Wort ergänzen."},
      {"operand open", "N001 ↓01 #01 = #.. + #03", "# fehlt. Wort ergänzen."},
      {"value open", "N001 ↓00 #01 = .....,...", "Wert fehlt. Wort ergänzen."},
      {"wrong operator", "N001 ↓01 #01 = #02 - #03", "- ist so nicht lesbar, richtig: +. Text berichtigen."},
      {"wrong name", "N001 ↓10 #01 = SIN #02", "S ist so nicht lesbar, richtig: COPY. Text berichtigen."},
      {"no =", "N001 ↓10 #01 COPY #02", "C ist so nicht lesbar, richtig: =. Text berichtigen."},
      {"something behind", "N001 ↓10 #01 = COPY #02 + #03", "+ ist so nicht lesbar. Text berichtigen."},
      {"parameter too high", "N001 G00 X......#70", "X #70 ist nicht erlaubt, richtig: #00..#69. Wert ändern."},
      {"strange character", "N001 G00 X+...1.000 €", "€ ist so nicht lesbar. Text berichtigen."},
      {"open parenthesis", "N001 G17 (KREISEBENE", ""},
      {"two blocks", "N001 G17 N002 G18", "N ist so nicht lesbar. Text berichtigen."},
      {"machine data", "N001 G11 M03 MD", "Der Satz ist so nicht lesbar. Text berichtigen."},
  };
  for (const BadRow& row : kRows) {
    const Tape tape = read_listing("P0007\n\n" + std::string(row.line) + "\nN900 G17\n%\n");
    const std::string expected = row.message.empty() ? "3 ( ist so nicht lesbar, richtig: ). Text berichtigen.\n"
                                                     : "3 P0007 N001: " + std::string(row.message) + "\n";
    EXPECT_EQ(messages_of(tape), expected) << row.id;
    EXPECT_EQ(programs_of(tape), row.message.empty() ? "P0007\nN001G17\nN900G17\n" : "") << row.id;
  }
}

TEST(Listing, EveryErrorIsListed) {
  const Tape tape = read_listing(
      "N001 G17\nN002 G17\nP12\nN001 G17\nP0001 N001 G17\nN000 G17\nT001 R+...1.000\nN001 G17\nN001 G18\n"
      "QUADRAT\n% P0002\nP0000\nN001 G17\nT100 R+...1.000\n%\nP0003\n%\nP0004\nN001 G17\n%\n");
  EXPECT_EQ(messages_of(tape),
            "1 N: Übertragung falsch, richtig: P0001N001. Daten prüfen, neu senden.\n"
            "3 Programmnummer P falsch, richtig: P0000..P9999. P und vier Ziffern angeben.\n"
            "5 P0001: N ist so nicht lesbar, richtig: P0001. Text berichtigen.\n"
            "6 P0001: Satznummer N 000 geht nicht, richtig: N001..N999. Andere Nummer wählen.\n"
            "7 P0001: T ist so nicht lesbar, richtig: N001. Text berichtigen.\n"
            "9 P0001 N001: Satznummer N 2× geht nicht. Andere Nummer wählen.\n"
            "10 P0001: Q ist so nicht lesbar, richtig: N001. Text berichtigen.\n"
            "11 P ist so nicht lesbar, richtig: %. Text berichtigen.\n"
            "13 P0000: N ist so nicht lesbar, richtig: T001. Text berichtigen.\n"
            "14 P0000: Satznummer T 100 geht nicht, richtig: T001..T099. Andere Nummer wählen.\n"
            "16 P0003: Das Programm hat keinen Satz, richtig: N001. Sätze ergänzen oder Nummer streichen.\n");
  EXPECT_EQ(programs_of(tape), "P0004\nN001G17\n");
}

TEST(Listing, WithSmallLettersGivesNoProgramAtAll_DEC_30) {
  const Tape tape = read_listing("P0001\nN001 G17\n%\nP0002\nn001 g17\nN002 G18\n%\n");
  EXPECT_TRUE(tape.programs.empty());
  EXPECT_THAT(tape.errors, testing::ElementsAre(Error{.code = ErrorCode::lower_case, .detail = "n", .line = 5}));
}

TEST(Listing, ErrorsAreBounded) {
  std::string text = "P0001\n";
  for (int i = 0; i < 5000; ++i) text += "N001 G99\n";
  const Tape tape = read_listing(text, Tongue::english);
  EXPECT_EQ(tape.errors.size(), 1000U);
  EXPECT_THAT(tape.notices, testing::ElementsAre("4000 more errors are not listed."));
}

}  // namespace
}  // namespace cnclab::language
