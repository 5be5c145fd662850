// ncurses behind our own types: the rest of the station knows nothing of it.
#include "station/terminal.hpp"

#define NCURSES_NOMACROS 1
#include <curses.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <clocale>
#include <cstdio>
#include <string>

#include "station/curses_attribute.hpp"
#include "station/terminal_fault.hpp"
#include "station/terminal_input.hpp"

namespace cnclab::station {

struct Terminal::Handle {
  SCREEN* screen = nullptr;
};

namespace {

// Long enough for the rest of an escape sequence over a slow line, too short to be felt.
constexpr int kEscapeDelay_ms = 25;
// STOP and MASCHINE HALT (keymap.cpp).
constexpr std::string_view kStops = " !";

}  // namespace

std::expected<std::unique_ptr<Terminal>, Ending> Terminal::open(bool is_ascii) {
  std::setlocale(LC_ALL, "");
  const Language language = language_of_locale();
  const auto refused = [&](const Text& text) {
    return std::unexpected(Ending{ExitCode::usage, std::string(text.in(language))});
  };
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDOUT_FILENO) == 0) {
    return refused({"Kein Terminal: die Station in einem Terminal starten, oder mit --headless.",
                    "No terminal: start the station in a terminal, or with --headless."});
  }
  if (const auto fault = terminal_fault()) return refused(*fault);
  std::unique_ptr<Terminal> terminal(new Terminal);
  if (terminal->handle_->screen == nullptr)
    return refused({"Dieses Terminal lässt sich nicht öffnen.", "This terminal cannot be opened."});
  terminal->set_up(is_ascii);
  return terminal;
}

Terminal::Terminal() : handle_(std::make_unique<Handle>()), decoder_(kStops, coding_of_locale()) {
  handle_->screen = ::newterm(nullptr, stdout, stdin);
}

void Terminal::set_up(bool is_ascii) {
  ::set_term(handle_->screen);
  glyphs_ = terminal_glyphs(is_ascii);
  ::set_escdelay(kEscapeDelay_ms);
  ::raw();
  ::noecho();
  ::nonl();
  ::keypad(stdscr, TRUE);
  ::nodelay(stdscr, TRUE);
  ::curs_set(0);
  ::mousemask(BUTTON1_PRESSED | BUTTON1_RELEASED, nullptr);
  ::mouseinterval(0);  // a press counts at once, without waiting whether it becomes a click
  ask_for_paste_marks();
  if (::has_colors() && ::start_color() == OK && ::use_default_colors() == OK) {
    has_colour_ = true;
    ::init_pair(static_cast<short>(Colour::green), COLOR_GREEN, -1);
    ::init_pair(static_cast<short>(Colour::red), COLOR_RED, -1);
    ::init_pair(static_cast<short>(Colour::yellow), COLOR_YELLOW, -1);
  }
}

Terminal::~Terminal() {
  if (handle_->screen == nullptr) return;
  ::mousemask(0, nullptr);
  leave_paste_marks();
  ::endwin();
  ::delscreen(handle_->screen);
}

int Terminal::rows() const { return ::getmaxy(stdscr); }
int Terminal::columns() const { return ::getmaxx(stdscr); }

void Terminal::resize() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 && size.ws_col > 0) {
    ::resizeterm(size.ws_row, size.ws_col);
  }
}

std::optional<TerminalEvent> Terminal::next_event() { return next_terminal_event(decoder_); }

bool Terminal::is_hung_up() const {
  pollfd descriptor{STDIN_FILENO, POLLIN, 0};
  return ::poll(&descriptor, 1, 0) > 0 && (descriptor.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

void Terminal::clear() { ::werase(stdscr); }

void Terminal::draw(const Screen& stands) {
  const Screen screen = glyphs_ == Glyphs::ascii ? spelled_out(stands) : stands;
  std::string text;
  for (int row = 0; row < Screen::kRows; ++row) {
    for (int column = 0, start = 0; column < Screen::kColumns; ++column) {
      const Cell& cell = screen.at(row, column);
      text += to_utf8(cell.code);
      const bool is_last = column + 1 == Screen::kColumns;
      if (!is_last && screen.at(row, column + 1).attribute == cell.attribute) continue;
      write(row, start, text, cell.attribute);
      text.clear();
      start = column + 1;
    }
  }
}

void Terminal::write(int row, int column, std::string_view utf8, Attribute attribute, Colour colour) {
  std::wstring text;
  for (const char32_t code : from_utf8(utf8)) text += static_cast<wchar_t>(shown_code(code, glyphs_));
  const auto pair = static_cast<short>(has_colour_ ? static_cast<int>(colour) : 0);
  ::wattr_set(stdscr, curses_attribute(attribute), pair, nullptr);
  ::mvwaddnwstr(stdscr, row, column, text.c_str(), static_cast<int>(text.size()));
  ::wattr_set(stdscr, A_NORMAL, 0, nullptr);
}

void Terminal::flush() { ::wrefresh(stdscr); }

void Terminal::redraw() {
  ::clearok(stdscr, TRUE);
  ::wrefresh(stdscr);
}

void Terminal::beep() { ::beep(); }

}  // namespace cnclab::station
