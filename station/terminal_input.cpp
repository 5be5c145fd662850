// ncurses gives bytes, or codes for the keys that it knows of this terminal. Its wide reading would drop all that came
// together with a byte that is no character (AUTH-006), so the characters are made here.
#include "station/terminal_input.hpp"

#define NCURSES_NOMACROS 1
#include <curses.h>
#include <langinfo.h>

#include <cstdio>
#include <ranges>
#include <string_view>
#include <vector>

namespace cnclab::station {
namespace {

std::optional<Special> special_of(int code) {
  if (code > KEY_F0 && code <= KEY_F(12)) {
    return static_cast<Special>(static_cast<int>(Special::f1) + code - KEY_F(1));
  }
  switch (code) {
    case KEY_ENTER:
      return Special::enter;
    case KEY_BACKSPACE:
      return Special::backspace;
    case KEY_UP:
      return Special::up;
    case KEY_DOWN:
      return Special::down;
    case KEY_LEFT:
      return Special::left;
    case KEY_RIGHT:
      return Special::right;
    case KEY_PPAGE:
      return Special::page_up;
    case KEY_NPAGE:
      return Special::page_down;
    case KEY_HOME:
      return Special::home;
    case KEY_END:
      return Special::end;
    case KEY_IC:
      return Special::insert;
    case KEY_DC:
      return Special::remove;
    default:
      return std::nullopt;
  }
}

/// The oldest press that nobody has asked for yet. Of what comes together ncurses tells once or not at all, and hands
/// out the newest first; the younger ones go back.
std::optional<TerminalEvent> click() {
  std::vector<MEVENT> presses;
  MEVENT mouse{};
  while (::getmouse(&mouse) == OK)
    if ((mouse.bstate & BUTTON1_PRESSED) != 0) presses.push_back(mouse);
  if (presses.empty()) return std::nullopt;
  const MEVENT oldest = presses.back();
  presses.pop_back();
  for (MEVENT& younger : std::views::reverse(presses)) ::ungetmouse(&younger);
  return Click{oldest.y, oldest.x};
}

void send_now(const char* sequence) {
  std::fputs(sequence, stdout);
  std::fflush(stdout);
}

}  // namespace

Glyphs terminal_glyphs(bool is_ascii) {
  const bool has_utf8 = std::string_view(::nl_langinfo(CODESET)) == "UTF-8";
  if (is_ascii || !has_utf8) return Glyphs::ascii;
  const bool is_linux_console = std::string_view(::termname()).contains("linux");
  return is_linux_console ? Glyphs::no_braille : Glyphs::all;
}

void ask_for_paste_marks() { send_now("\x1b[?2004h"); }
void leave_paste_marks() { send_now("\x1b[?2004l"); }

std::optional<TerminalEvent> next_terminal_event(KeyDecoder& decoder) {
  constexpr int kLastByte = 0xFF;
  for (;;) {
    const int code = ::wgetch(stdscr);
    std::optional<TerminalEvent> event;
    if (code == ERR) return (event = click()) ? event : decoder.pause();
    if (code <= kLastByte) {
      event = decoder.take(static_cast<unsigned char>(code), KeyDecoder::Clock::now());
    } else if (code == KEY_MOUSE) {
      event = click();
    } else if (const auto special = special_of(code)) {
      event = decoder.take(*special);
    }
    if (event) return event;
  }
}

}  // namespace cnclab::station
