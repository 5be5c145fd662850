// Keys and clicks from ncurses, for the station and the console alike.
#pragma once

#include <optional>

#include "station/cell_text.hpp"
#include "station/key_decoder.hpp"

namespace cnclab::station {

/// What this terminal shows: ASCII where it is wished for or the locale is without UTF-8; on the linux console
/// everything but braille. ncurses has the terminal.
[[nodiscard]] Glyphs terminal_glyphs(bool is_ascii);

/// The terminal tells from now on where pasted text begins and ends; ncurses has the terminal.
void ask_for_paste_marks();
void leave_paste_marks();

/// The next key, click or pasted character that has arrived; nothing where none has. Never waits for a key; stdscr is
/// without delay and with keypad.
[[nodiscard]] std::optional<TerminalEvent> next_terminal_event(KeyDecoder& decoder);

}  // namespace cnclab::station
