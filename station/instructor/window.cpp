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
#include "station/overlays.hpp"
#include "station/terminal_input.hpp"

namespace cnclab::instructor {
namespace {

// MASCHINE HALT, and what stops at a keyboard that is taken over.
constexpr std::string_view kStops = "h! ";

/// A key that the console has a meaning of its own for; the others are for a station's keyboard only.
Input key_input(station::Special key) {
  using S = station::Special;
  constexpr std::array<std::pair<S, Special>, 7> kKeys{{{S::up, Special::up},
                                                        {S::down, Special::down},
                                                        {S::enter, Special::enter},
                                                        {S::escape, Special::escape},
                                                        {S::backspace, Special::backspace},
                                                        {S::f8, Special::give_back},
                                                        {S::f12, Special::halt}}};
  const auto* const found = std::ranges::find(kKeys, key, &std::pair<S, Special>::first);
  if (found == kKeys.end()) return StationKey{key};
  return found->second;
}

Input input_of(const station::TerminalEvent& event) {
  if (const auto* const click = std::get_if<station::Click>(&event)) return Clicked{click->row};
  if (const auto* const stray = std::get_if<station::Stray>(&event)) return Pasted{stray->character};
  const auto& input = std::get<station::Input>(event);
  if (const auto* const character = std::get_if<char32_t>(&input)) return Typed{*character};
  return key_input(std::get<station::Special>(input));
}

/// Of the user's locale, which holds from now on.
station::Coding coding() {
  std::setlocale(LC_ALL, "");
  return station::coding_of_locale();
}

void put(const Screen& stands, int left, station::Glyphs glyphs) {
  const Screen screen = glyphs == station::Glyphs::ascii ? station::spelled_out(stands) : stands;
  const int rows = std::min(LINES, Screen::kRows);
  const int columns = std::min(COLS - left, Screen::kColumns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Cell& cell = screen.at(row, column);
      const wchar_t text[] = {static_cast<wchar_t>(station::shown_code(cell.code, glyphs)), L'\0'};
      cchar_t character{};
      setcchar(&character, text, station::curses_attribute(cell.attribute), 0, nullptr);
      mvadd_wch(row, left + column, &character);
    }
  }
}

}  // namespace

Window::Window(bool is_ascii) : decoder_(kStops, coding()) {
  initscr();
  glyphs_ = station::terminal_glyphs(is_ascii);
  set_escdelay(25);  // ms until a lone Esc is one
  cbreak();
  noecho();
  nonl();
  curs_set(0);
  keypad(stdscr, TRUE);
  nodelay(stdscr, TRUE);
  mouseinterval(0);
  mousemask(BUTTON1_PRESSED | BUTTON1_RELEASED, nullptr);
  station::ask_for_paste_marks();
}

Window::~Window() {
  station::leave_paste_marks();
  endwin();
}

void Window::show(const Drawn& drawn) {
  erase();
  put(drawn.screen, 0, glyphs_);
  if (drawn.beside) put(*drawn.beside, Screen::kColumns + 1, glyphs_);
  refresh();
}

void Window::show_too_small(station::Language language) {
  Screen screen;
  screen.write(0, 0, station::too_small_text(LINES, COLS, language));
  show({screen, std::nullopt});
}

bool Window::has_room() { return LINES >= Screen::kRows && COLS >= Screen::kColumns; }
int Window::columns() { return COLS; }

std::optional<Input> Window::next_input() {
  const auto event = station::next_terminal_event(decoder_);
  return event ? std::optional(input_of(*event)) : std::nullopt;
}

}  // namespace cnclab::instructor
