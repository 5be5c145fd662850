// The terminal under the console: ncurses with wide characters, colours left to the user, mouse.
#pragma once

#include <optional>

#include "instructor/console_model.hpp"
#include "instructor/console_view.hpp"
#include "station/cell_text.hpp"
#include "station/key_decoder.hpp"

namespace cnclab::instructor {

/// One at a time; the terminal is as before when it goes.
class Window {
 public:
  /// is_ascii  also chosen by a locale without UTF-8
  explicit Window(bool is_ascii);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Brings what was drawn to the terminal's top left corner; what does not fit is cut.
  void show(const Drawn& drawn);
  /// Says how large the terminal has to be.
  void show_too_small(station::Language language);
  /// The terminal has room for 24 rows of 80 columns.
  [[nodiscard]] static bool has_room();
  [[nodiscard]] static int columns();
  /// What the user did; nothing while they do nothing. Never waits.
  [[nodiscard]] std::optional<Input> next_input();

 private:
  station::KeyDecoder decoder_;
  station::Glyphs glyphs_ = station::Glyphs::all;
};

}  // namespace cnclab::instructor
