// The command lines of the headless protocol (interfaces.md section 3).
#include "station/headless_command.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace cnclab::station {
namespace {

using namespace std::chrono_literals;

std::expected<HeadlessCommand, std::string> parse(std::string_view line) {
  return parse_headless(line, Language::english);
}

TEST(HeadlessCommand, KeysAndChords) {
  const auto command = parse("key HAND  3+6+9 ENTER");
  ASSERT_TRUE(command) << command.error();
  const std::vector<Chord> expected{{Key::HAND}, {Key::D3, Key::D6, Key::D9}, {Key::ENTER}};
  EXPECT_EQ(std::get<PressCommand>(*command).chords, expected);
}

TEST(HeadlessCommand, TypeSendsDigitsPointAndSign) {
  const auto command = parse("type -12.5");
  ASSERT_TRUE(command);
  const std::vector<Chord> expected{{Key::SIGN}, {Key::D1}, {Key::D2}, {Key::POINT}, {Key::D5}};
  EXPECT_EQ(std::get<PressCommand>(*command).chords, expected);
}

TEST(HeadlessCommand, HoldPotWaitAndGone) {
  const auto hold = std::get<HoldCommand>(parse("hold 2100 DOWN+RESET").value());
  EXPECT_EQ(hold.duration, 2100ms);
  EXPECT_EQ(hold.chord, (Chord{Key::DOWN, Key::RESET}));
  EXPECT_EQ(std::get<PotCommand>(parse("pot 0").value()).percent, 0U);
  EXPECT_EQ(std::get<PotCommand>(parse("pot 100").value()).percent, 100U);
  const auto wait = std::get<WaitCommand>(parse("wait 500 PROGRAMM NR  P0001").value());
  EXPECT_EQ(wait.limit, 500ms);
  EXPECT_EQ(wait.text, "PROGRAMM NR  P0001") << "blanks within the text count";
  EXPECT_TRUE(wait.until_present);
  EXPECT_FALSE(std::get<WaitCommand>(parse("gone 0 x").value()).until_present);
}

TEST(HeadlessCommand, WrongOnesSayWhatIsWrong) {
  struct Row {
    const char* line;
    const char* named;
  };
  const Row rows[] = {
      {"", "unknown command"},
      {"KEY HAND", "unknown command"},
      {"quit now", "unknown command"},
      {"screen 1", "unknown command"},
      {"key", "key NAME"},
      {"key HAND HANDX", "HANDX"},
      {"key hand", "hand"},
      {"key 3+6+9+1", "at most three keys at once, not 3+6+9+1"},
      {"hold 100 1+2+3+4", "at most three keys at once, not 1+2+3+4"},
      {"hold 100 1+2+3+X", "unknown key 1+2+3+X"},
      {"key +", "unknown key"},
      {"hold HAND", "hold MS"},
      {"hold 5", "hold MS"},
      {"hold -1 HAND", "hold MS"},
      {"hold 600001 HAND", "hold MS"},
      {"hold 5 HAND STOP", "hold MS"},
      {"type", "type TEXT"},
      {"type 12a", "digits"},
      {"type 1 2", "digits"},
      {"pot", "pot PERCENT"},
      {"pot 101", "pot PERCENT"},
      {"pot 5x", "pot PERCENT"},
      {"pot 99999999999999999999", "pot PERCENT"},
      {"wait 5", "wait MS"},
      {"wait x y", "wait MS"},
      {"gone", "gone MS"},
  };
  for (const Row& row : rows) {
    const auto command = parse(row.line);
    ASSERT_FALSE(command) << row.line;
    EXPECT_NE(command.error().find(row.named), std::string::npos) << row.line << ": " << command.error();
    EXPECT_EQ(command.error().find('\n'), std::string::npos) << "a reply is one line";
  }
}

RC_GTEST_PROP(HeadlessCommand, AnyLineIsACommandOrAMessage, (const std::string& line)) {
  const auto command = parse(line);
  if (!command) RC_ASSERT(!command.error().empty());
}

}  // namespace
}  // namespace cnclab::station
