// The user's terminal through wide ncurses: cells out, keys and clicks in, put back as it was at the end.
#pragma once

#include <expected>
#include <memory>
#include <optional>
#include <string_view>

#include "shared/screen.hpp"
#include "station/cell_text.hpp"
#include "station/key_decoder.hpp"
#include "station/login.hpp"

namespace cnclab::station {

enum class Colour : std::uint8_t { standard, green, red, yellow };

/// At most one at a time. Owns the screen from `open` until it is destroyed; the terminal is raw, so that Ctrl-C,
/// Ctrl-S and Ctrl-Z are keys like others.
class Terminal {
 public:
  /// is_ascii  also chosen by a locale without UTF-8; the linux console gets everything but braille
  /// errors    usage: stdin or stdout is no terminal, or TERM is unknown or no terminal to draw on
  [[nodiscard]] static std::expected<std::unique_ptr<Terminal>, Ending> open(bool is_ascii);
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal();

  /// Everything is drawn in ASCII; what is written without `draw` is spelled out before (cell_text.hpp).
  [[nodiscard]] bool is_ascii() const { return glyphs_ == Glyphs::ascii; }
  [[nodiscard]] int rows() const;
  [[nodiscard]] int columns() const;
  /// Takes over the window's size after SIGWINCH.
  void resize();
  /// The next key, click or pasted character that has arrived; nothing where none has.
  [[nodiscard]] std::optional<TerminalEvent> next_event();
  /// Nobody is at the other end any more.
  [[nodiscard]] bool is_hung_up() const;

  void clear();
  void draw(const Screen& screen);
  void write(int row, int column, std::string_view utf8, Attribute attribute = Attribute::normal,
             Colour colour = Colour::standard);
  void flush();
  /// Everything is sent again, whatever another program has written over it.
  void redraw();
  void beep();

 private:
  Terminal();
  void set_up(bool is_ascii);

  struct Handle;
  std::unique_ptr<Handle> handle_;
  KeyDecoder decoder_;
  Glyphs glyphs_ = Glyphs::all;
  bool has_colour_ = false;
};

}  // namespace cnclab::station
