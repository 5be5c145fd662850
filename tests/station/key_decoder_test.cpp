// Bytes of a terminal that ncurses knows no key for: what acts, what is swallowed, what is never lost (AUTH-006).
#include "station/key_decoder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "shared/screen.hpp"
#include "station/event_queue.hpp"

namespace cnclab::station {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view kStops = " !";
const KeyDecoder::Clock::time_point kStart{1h};

std::string name(const TerminalEvent& event) {
  if (const auto* const stray = std::get_if<Stray>(&event)) return "stray " + to_utf8(stray->character);
  const auto* const input = std::get_if<Input>(&event);
  return input == nullptr ? "click" : input_name(*input, Language::english);
}

/// Everything that a burst of bytes comes to, separated by commas.
std::string typed(KeyDecoder& decoder, std::string_view bytes, KeyDecoder::Clock::time_point now = kStart) {
  std::string all;
  const auto note = [&](const std::optional<TerminalEvent>& event) {
    if (event) all += (all.empty() ? "" : ",") + name(*event);
  };
  for (const char byte : bytes) note(decoder.take(static_cast<unsigned char>(byte), now));
  note(decoder.pause());
  return all;
}

std::string typed(std::string_view bytes) {
  KeyDecoder decoder(kStops, Coding::utf8);
  return typed(decoder, bytes);
}

TEST(KeyDecoder, what_is_no_known_key_means_nothing_as_a_whole_and_the_next_key_counts) {
  struct Row {
    std::string_view sent;
    const char* what;
  };
  constexpr Row kRows[] = {{"\x1bs", "Alt and s, START"},
                           {"\x1b\xC3\xBC", "Alt and ü"},
                           {"\x1b\r", "Alt and Enter"},
                           {"\x1b\x1b[A", "Alt and an arrow"},
                           {"\x1b[99~", "a number of no key"},
                           {"\x1b[57399u", "a key of the numeric pad after another protocol"},
                           {"\x1b[1;5D", "Ctrl and ←"},
                           {"\x1b[15;2~", "Shift and F5"},
                           {"\x1bOR", "F3 of another terminal"},
                           {"\x1bO5P", "Ctrl and F1, the old way"},
                           {"\x1b[[A", "F1 of the linux console"},
                           {"\x1b[?1;2c", "an answer about the terminal"},
                           {"\x1b]11;rgb:00/11/22\x07", "an answer about a colour"},
                           {"\x1bP1$r0m\x1b\\", "an answer about a setting"},
                           {"\x9B"
                            "5R",
                            "a position in eight bits"}};
  for (const Row& row : kRows) {
    EXPECT_EQ(typed(row.sent), "") << row.what;
    EXPECT_EQ(typed(std::string(row.sent) + "x"), "x") << row.what;
    EXPECT_EQ(typed(std::string(row.sent) + "!"), "!") << row.what;
  }
}

TEST(KeyDecoder, an_Escape_alone_is_the_key_and_a_sequence_behind_it_on_a_slow_line_is_swallowed_yet) {
  KeyDecoder decoder(kStops, Coding::utf8);
  EXPECT_EQ(typed(decoder, "\x1b"), "Esc");
  EXPECT_EQ(typed(decoder, "s", kStart + 100ms), "s") << "pressed by itself";
  EXPECT_EQ(typed(decoder, "\x1b", kStart + 200ms), "Esc");
  EXPECT_EQ(typed(decoder, "[15", kStart + 300ms), "");
  EXPECT_EQ(typed(decoder, ";2~", kStart + 400ms), "");
  EXPECT_EQ(typed(decoder, "\x1b[1", kStart + 500ms), "");
  EXPECT_EQ(typed(decoder, "5", kStart + 2s), "5") << "a key, long after a sequence that has lost its end";
}

TEST(KeyDecoder, AUTH_006_a_stop_key_counts_in_the_midst_of_anything) {
  for (const std::string_view begun : {"\x1b", "\x1b[", "\x1b[1;", "\x1bO", "\x1b]11;", "\x1b[[", "\xC3", "\xF6",
                                       "\x80", "\xE2\x82", "\xFF\xFE", "\x1b[200~abc"}) {
    EXPECT_TRUE(typed(std::string(begun) + "!").ends_with("!")) << begun;
    EXPECT_TRUE(typed(std::string(begun) + " ").ends_with(begun[0] == '\x1b' ? "stray  " : "Space")) << begun;
    EXPECT_TRUE(typed(std::string(begun) + "\x1b[24~").ends_with("F12")) << begun;
  }
}

TEST(KeyDecoder, AUTH_006_F12_that_ncurses_knows_counts_behind_Escape_and_in_pasted_text_others_do_not) {
  KeyDecoder decoder(kStops, Coding::utf8);
  static_cast<void>(decoder.take(27, kStart));
  EXPECT_FALSE(decoder.take(Special::f5)) << "Alt and F5";
  static_cast<void>(decoder.take(27, kStart));
  EXPECT_EQ(decoder.take(Special::f12), TerminalEvent(Input(Special::f12)));
  EXPECT_EQ(decoder.take(Special::f5), TerminalEvent(Input(Special::f5)));
  EXPECT_EQ(typed(decoder, "\x1b[200~"), "");
  EXPECT_FALSE(decoder.take(Special::up));
  EXPECT_EQ(decoder.take(Special::f12), TerminalEvent(Input(Special::f12)));
}

TEST(KeyDecoder, pasted_text_is_no_key_press_up_to_its_end_mark) {
  EXPECT_EQ(typed("\x1b[200~hx\rs\xC3\xBC\x1b[201~s"), "stray h,stray x,stray s,stray ü,s");
  KeyDecoder decoder(kStops, Coding::utf8);
  EXPECT_EQ(typed(decoder, "\x1b[200~s"), "stray s");
  EXPECT_EQ(typed(decoder, "s\x1b[31ms", kStart + 10s), "stray s,stray s")
      << "however long it takes, whatever is in it";
  EXPECT_EQ(typed(decoder, "\x1b", kStart + 20s), "Esc") << "the end mark was lost";
  EXPECT_EQ(typed(decoder, "s", kStart + 21s), "s");
}

TEST(KeyDecoder, characters_are_made_of_UTF_8_and_a_byte_that_is_none_is_dropped_alone) {
  EXPECT_EQ(typed("m\xC3\xBCller \xE2\x82\xAC"), "m,ü,l,l,e,r,Space,€");
  EXPECT_EQ(typed("\xF6h\xE4x\xC3\xC3\xBC"), "h,x,ü");
  EXPECT_EQ(typed("\r\t\x7f\x03\x0c\x01"), "Enter,Tab,Backspace,Ctrl-C,Ctrl-L");
}

RC_GTEST_PROP(KeyDecoder, AUTH_006_a_halt_behind_any_bytes_is_never_lost, (const std::string& bytes)) {
  KeyDecoder decoder(kStops, Coding::utf8);
  const std::size_t before = typed(decoder, bytes).size();
  KeyDecoder same(kStops, Coding::utf8);
  const std::string all = typed(same, bytes + "!");
  RC_ASSERT(all.ends_with("!"));
  RC_ASSERT(all.size() > before || bytes.ends_with("\x1b"));
}

TEST(EventQueue, AUTH_006_more_than_anybody_types_ahead_is_dropped_but_no_stop_key) {
  EventQueue queue;
  for (std::size_t i = 0; i < 2000; ++i) queue.push(Input(U'1'));
  for (int i = 0; i < 3; ++i) {
    queue.push(Input(U'!'));
    queue.push(Input(Special::f12));
    queue.push(Stray{U' '});
    queue.push(Input(U'1'));
  }
  std::string last;
  std::size_t count = 0;
  for (; const auto event = queue.pop(); ++count)
    if (count >= EventQueue::kMost) last += name(*event) + ",";
  EXPECT_EQ(last, "!,F12,stray  ,");
  EXPECT_EQ(count, EventQueue::kMost + 3);
}

}  // namespace
}  // namespace cnclab::station
