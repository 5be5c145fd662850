// The terminal's description, asked without ncurses' own exit. Alone here: term.h makes macros of common words.
#include "station/terminal_fault.hpp"

#define NCURSES_NOMACROS 1
#include <curses.h>
#include <term.h>
#include <unistd.h>

namespace cnclab::station {

std::optional<Text> terminal_fault() {
  int result = 0;
  if (setupterm(nullptr, STDOUT_FILENO, &result) != OK)
    return Text{"Dieses Terminal ist unbekannt: TERM prüfen, z. B. TERM=xterm-256color.",
                "This terminal is unknown: check TERM, e.g. TERM=xterm-256color."};
  const bool can_place = tigetstr("cup") != nullptr;
  del_curterm(cur_term);
  if (can_place) return std::nullopt;
  return Text{"Auf diesem Terminal lässt sich kein Bild zeichnen: TERM prüfen, z. B. TERM=xterm-256color.",
              "Nothing can be drawn on this terminal: check TERM, e.g. TERM=xterm-256color."};
}

}  // namespace cnclab::station
