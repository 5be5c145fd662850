// The terminal under the console: ncurses with wide characters, colours left to the user, mouse.
#define NCURSES_WIDECHAR 1
#include "instructor/window.hpp"

#include <curses.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdio>
#include <utility>

#include "station/curses_attribute.hpp"

namespace cnclab::instructor {
namespace {

/// Keys that only a station's keyboard knows.
std::optional<Input> station_key(wint_t key) {
  using S = station::Special;
  constexpr std::array<std::pair<int, S>, 8> kKeys{{{KEY_LEFT, S::left},
                                                    {KEY_RIGHT, S::right},
                                                    {KEY_PPAGE, S::page_up},
                                                    {KEY_NPAGE, S::page_down},
                                                    {KEY_HOME, S::home},
                                                    {KEY_END, S::end},
                                                    {KEY_IC, S::insert},
                                                    {KEY_DC, S::remove}}};
  for (const auto& [code, special] : kKeys)
    if (key == static_cast<wint_t>(code)) return StationKey{special};
  constexpr int kFunctionKeys = 12;
  for (int number = 1; number <= kFunctionKeys; ++number)
    if (key == static_cast<wint_t>(KEY_F(number)))
      return StationKey{static_cast<S>(static_cast<int>(S::f1) + number - 1)};
  return std::nullopt;
}

std::optional<Input> key_input(wint_t key) {
  constexpr int kHaltKey = 12;
  if (key == KEY_UP) return Special::up;
  if (key == KEY_DOWN) return Special::down;
  if (key == KEY_ENTER) return Special::enter;
  if (key == KEY_F(kHaltKey)) return Special::halt;
  if (key == KEY_BACKSPACE) return Special::backspace;
  constexpr int kGiveBackKey = 8;
  if (key == KEY_F(kGiveBackKey)) return Special::give_back;
  if (auto other = station_key(key)) return other;
  if (key != KEY_MOUSE) return std::nullopt;
  MEVENT event{};
  if (getmouse(&event) != OK || (event.bstate & (BUTTON1_PRESSED | BUTTON1_CLICKED)) == 0) return std::nullopt;
  return Clicked{event.y};
}

Input character_input(wint_t character) {
  constexpr wint_t kEscape = 27;
  if (character == L'\n' || character == L'\r') return Special::enter;
  if (character == kEscape) return Special::escape;
  constexpr wint_t kDelete = 127, kBackspace = 8;
  if (character == kDelete || character == kBackspace) return Special::backspace;
  if (character == L'\t') return StationKey{station::Special::tab};
  return Typed{static_cast<char32_t>(character)};
}

void put(const Screen& screen, int left) {
  const int rows = std::min(LINES, Screen::kRows);
  const int columns = std::min(COLS - left, Screen::kColumns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Cell& cell = screen.at(row, column);
      const wchar_t text[] = {static_cast<wchar_t>(cell.code), L'\0'};
      cchar_t character{};
      setcchar(&character, text, station::curses_attribute(cell.attribute), 0, nullptr);
      mvadd_wch(row, left + column, &character);
    }
  }
}

}  // namespace

Window::Window() {
  std::setlocale(LC_ALL, "");
  initscr();
  set_escdelay(25);  // ms until a lone Esc is one
  cbreak();
  noecho();
  nonl();
  curs_set(0);
  keypad(stdscr, TRUE);
  nodelay(stdscr, TRUE);
  mouseinterval(0);
  mousemask(BUTTON1_PRESSED | BUTTON1_CLICKED, nullptr);
}

Window::~Window() { endwin(); }

void Window::show(const Drawn& drawn) {
  erase();
  put(drawn.screen, 0);
  if (drawn.beside) put(*drawn.beside, Screen::kColumns + 1);
  refresh();
}

int Window::columns() { return COLS; }

std::optional<Input> Window::next_input() {
  wint_t key = 0;
  switch (get_wch(&key)) {
    case OK:
      return character_input(key);
    case KEY_CODE_YES:
      return key_input(key);
    default:
      return std::nullopt;
  }
}

}  // namespace cnclab::instructor
