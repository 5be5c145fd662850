// The station on the terminals that schools have: drawing, keys, umlauts, marks without colour, the keyboard's three
// blocks by mouse (DEC-01, KEY-001).
#include <gtest/gtest.h>

#include <array>

#include "harness/classroom.hpp"

namespace cnclab::harness {
namespace {

constexpr int kTall = 40;

/// A terminal description, and what its keyboard sends.
struct Kind {
  const char* term;
  const char* f2;
  const char* arrow_down;
  const char* f12;
  bool has_mouse;
};
constexpr Kind kKinds[] = {{"xterm-256color", "\x1bOQ", "\x1bOB", "\x1b[24~", true},
                           {"linux", "\x1b[[B", "\x1b[B", "\x1b[24~", false},
                           {"vt220", "\x1bOQ", "\x1b[B", "\x1b[24~", false},
                           {"putty", "\x1b[12~", "\x1bOB", "\x1b[24~", true}};

class Terminals : public testing::TestWithParam<Kind> {
 protected:
  Terminals() { room_.add_student("anna"); }
  Terminal open(int rows, const std::vector<std::string>& more = {}, const std::string& locale = "C.UTF-8") {
    StationOptions options = room_.station_options(1, "anna");
    options.more = more;
    return Terminal({.program = programs_folder() / "cnclab-station",
                     .arguments = station_arguments(options),
                     .environment = {{"TERM", GetParam().term},
                                     {"LC_ALL", locale},
                                     {"XDG_STATE_HOME", (room_.folder().path() / "state").string()}},
                     .rows = rows,
                     .columns = kScreenColumns});
  }
  void give_part();
  Classroom room_;
};

TEST_P(Terminals, DEC_01_FrameUmlautsAndMarksAreDrawn) {
  Terminal terminal = open(kScreenRows);
  terminal.wait_for("? alle Tasten");
  EXPECT_TRUE(terminal.row(0).starts_with("┌──")) << terminal.text();
  EXPECT_TRUE(terminal.row(17).starts_with("└──")) << terminal.text();
  EXPECT_NE(terminal.text().find("SPEICHER LÖSCHEN   Speicher Löschen"), std::string::npos) << terminal.text();
  EXPECT_NE(terminal.text().find("START    ○"), std::string::npos) << terminal.text();
  terminal.type("o");
  terminal.wait_for("Was möchten Sie tun?");
  EXPECT_TRUE(terminal.is_inverse(18, 2)) << "what is marked is inverse, not only coloured";
  EXPECT_FALSE(terminal.is_inverse(18, 10));
}

TEST_P(Terminals, FunctionKeysHavePlainTwinsAndAltAndAKeyIsNoKey) {
  Terminal terminal = open(kScreenRows);
  terminal.wait_for("? alle Tasten");
  terminal.type(GetParam().f2);
  terminal.wait_for("EINGABEMODUS");
  terminal.type("\x1bh");  // Alt and h is not HAND
  terminal.type("m");
  terminal.wait_for("□ EXTERNE DATEN");
  terminal.type("?");
  terminal.wait_gone("□ EXTERNE DATEN");
  terminal.type("\x1b");  // leaves the help page without waiting for a sequence to go on
  terminal.wait_for("□ EXTERNE DATEN");
  terminal.type(GetParam().f12);
  terminal.wait_for("HALT Platz 01");
}

TEST_P(Terminals, AsciiDrawsTheSameWithPlusMinusBar) {
  Terminal terminal = open(kScreenRows, {"--ascii"});
  terminal.wait_for("? alle Tasten");
  EXPECT_TRUE(terminal.row(0).starts_with("+--")) << terminal.text();
  EXPECT_TRUE(terminal.row(1).starts_with("|CNC 3300")) << terminal.text();
  EXPECT_NE(terminal.text().find("SPEICHER LOESCHEN"), std::string::npos) << terminal.text();
  terminal.type("\t");  // EINGABE, whose sentence names the key
  terminal.wait_for("->");
  for (const char c : terminal.text()) ASSERT_TRUE(c == '\n' || (c >= ' ' && c <= '~')) << terminal.text();
}

/// A frame milled round a square pocket, seen from above.
constexpr const char* kPart =
    "P0000T001R+5000L+0P0001N001G11F3000S1000T01M03N002G00Z+3000N003G00X-45000Y-25000N004G01Z-8000N005G01X+90000"
    "N006G01Y+50000N007G01X-90000N008G01Y-50000N009G00Z+8000N010G00X+45000Y+25000%";

void Terminals::give_part() {
  room_.instructor().must({"program", "send", room_.folder().write("part", kPart).string(), "anna"});
}

/// Plays it in GRAFIK; monitor rows 3 to 15 without the blanks at their ends.
std::string played(Terminal& terminal) {
  constexpr int kFirst = 3, kRows = 13;
  terminal.wait_for("? alle Tasten");
  terminal.type("g\rs");
  terminal.wait_for("P0001 N010 100 %  X-Y ");
  std::string picture = "\n";
  for (int row = kFirst; row < kFirst + kRows; ++row) {
    std::string cells = terminal.row(row);
    const std::string frame = cells.starts_with("|") ? "|" : "│";
    cells = cells.substr(frame.size(), cells.find(frame, frame.size()) - frame.size());
    picture += cells.substr(0, cells.find_last_not_of(' ') + 1) + "\n";
  }
  return picture;
}

/// The workpiece's outline, the slot that the cutter has left, the rapid to its corner, and the cutter.
constexpr std::string_view kLikeness = R"(
             :....................................:
             :                                    :
             :   .:.:.:.:.:.:.:.:.:.:.:.:.:.::..  :
             :   .:.. . . . . . . . . . . . .#..  :
             :   .:.                         #..  :
             :   .:.          ..:.           #..  :
             :   .:.          # .#           #..  :
             :   .:.       .....:.           #..  :
             :   .:.   ...                   #..  :
             :   .:..... . . . . . . . . . . #..  :
             :   .::::::::::::::::::::::::::::..  :
             :                                    :
             :....................................:
)";

TEST_P(Terminals, DEC_37_APictureHasDotsWhereTheTerminalHas) {
  give_part();
  Terminal terminal = open(kScreenRows);
  const std::string picture = played(terminal);
  EXPECT_TRUE(terminal.row(0).starts_with("┌──"));
  if (std::string_view(GetParam().term) == "linux") {  // its font has frames and umlauts, but no braille
    EXPECT_EQ(picture, kLikeness) << terminal.text();
    return;
  }
  EXPECT_NE(picture.find("\u2812\u2812\u2812"), std::string::npos) << terminal.text();
}

TEST_P(Terminals, DEC_37_APictureIsKnownAgainInAscii) {
  give_part();
  {
    Terminal terminal = open(kScreenRows, {"--ascii"});
    EXPECT_EQ(played(terminal), kLikeness) << terminal.text();
  }
  Terminal terminal = open(kScreenRows, {}, "C");
  EXPECT_EQ(played(terminal), kLikeness) << terminal.text();
}

TEST_P(Terminals, KEY_001_TheKeyboardHasTheOriginalsThreeBlocks) {
  Terminal terminal = open(kTall);
  terminal.wait_for("? alle Tasten");
  terminal.wait_for("A HANDBETRIEB");
  terminal.wait_for("B BETRIEBSARTEN");
  terminal.wait_for("C DATENEINGABE");
  if (!GetParam().has_mouse) return;
  const auto click = [&](const std::string& cap) {
    const auto place = terminal.find_below(cap, kScreenRows);
    ASSERT_TRUE(place.has_value()) << cap << "\n" << terminal.text();
    terminal.click(place->first, place->second + 2);
  };
  click(" EINGABE ");  // block B
  terminal.wait_for("PROGRAMM NR □0001");
  click("  7  ");  // block C
  terminal.wait_gone("□0001");
  click("  MENU  ");
  terminal.wait_for("□ EXTERNE DATEN");
  click("  HAND  ");  // block A
  terminal.wait_for("REFERENZ   FRÄSER   KÜHLMITTEL");
}

/// As a terminal reports a press and the release behind it (SGR 1006), in one piece.
std::string press_and_release(int row, int column) {
  const std::string press = "\x1b[<0;" + std::to_string(column + 1) + ";" + std::to_string(row + 1) + "M";
  return press + press.substr(0, press.size() - 1) + "m";
}

TEST_P(Terminals, KEY_001_NoClickIsLostHoweverItsPressAndReleaseCome) {
  if (!GetParam().has_mouse) GTEST_SKIP() << "no mouse";
  Terminal terminal = open(kTall);
  terminal.wait_for("? alle Tasten");
  for (int round = 0; round < 10; ++round) {
    for (const auto& [cap, mode, before] : {std::array{" EINGABE ", "EINGABEMODUS", "□ EXTERNE DATEN"},
                                            std::array{"  MENU  ", "□ EXTERNE DATEN", "EINGABEMODUS"}}) {
      const auto place = terminal.find_below(cap, kScreenRows);
      ASSERT_TRUE(place.has_value()) << terminal.text();
      if (round % 2 == 0)
        terminal.type(press_and_release(place->first, place->second + 2));
      else
        terminal.click(place->first, place->second + 2);
      terminal.wait_for(mode);
      terminal.wait_gone(before);
    }
  }
}

TEST_P(Terminals, KEY_001_ClicksThatComeTogetherAllCountInTheirOrder) {
  if (!GetParam().has_mouse) GTEST_SKIP() << "no mouse";
  Terminal terminal = open(kTall);
  terminal.wait_for("? alle Tasten");
  std::string bytes;
  for (const char* const cap : {" EINGABE ", "  1  ", "  2  ", "  3  "}) {
    const auto place = terminal.find_below(cap, kScreenRows);
    ASSERT_TRUE(place.has_value()) << cap << terminal.text();
    bytes += press_and_release(place->first, place->second + 2);
  }
  terminal.type(bytes);
  terminal.wait_for("PROGRAMM NR □0123");
}

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.term; }

INSTANTIATE_TEST_SUITE_P(Terminfo, Terminals, testing::ValuesIn(kKinds), [](const auto& kind) {
  std::string name = kind.param.term;
  std::erase_if(name, [](char c) { return c == '-'; });
  return name;
});

}  // namespace
}  // namespace cnclab::harness
