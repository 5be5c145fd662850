// The table of ASCII likenesses, and the refusal of what would not fill one column.
#include "station/cell_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

namespace cnclab::station {
namespace {

constexpr auto kLikenesses = std::to_array<std::pair<char32_t, char>>({
    // The frame and the marks of DEC-01.
    {U'─', '-'},
    {U'│', '|'},
    {U'┌', '+'},
    {U'┐', '+'},
    {U'└', '+'},
    {U'┘', '+'},
    {U'├', '+'},
    {U'┤', '+'},
    {U'┬', '+'},
    {U'┴', '+'},
    {U'┼', '+'},
    {U'□', '#'},
    {U'■', '#'},
    {U'●', '*'},
    {U'○', 'o'},
    {U'►', '>'},
    {U'↻', '>'},
    {U'↺', '<'},
    {U'→', '>'},
    {U'↓', 'v'},
    {U'←', '<'},
    {U'↑', '^'},
    {U'█', '#'},
    // Letters and signs of German and English sentences.
    {U'ä', 'a'},
    {U'ö', 'o'},
    {U'ü', 'u'},
    {U'Ä', 'A'},
    {U'Ö', 'O'},
    {U'Ü', 'U'},
    {U'ß', 's'},
    {U'é', 'e'},
    {U'–', '-'},
    {U'—', '-'},
    {U'…', '.'},
    {U'„', '"'},
    {U'“', '"'},
    {U'”', '"'},
    {U'‚', '\''},
    {U'‘', '\''},
    {U'’', '\''},
    {U'«', '<'},
    {U'»', '>'},
    {U'°', 'o'},
    {U'±', '+'},
    {U'×', 'x'},
    {U'·', '.'},
    {U'•', '*'},
    {U'≥', '>'},
    {U'≤', '<'},
    {U'µ', 'u'},
    {U'⌀', 'o'},
    {U'²', '2'},
    {U'³', '3'},
    {U'\u00A0', ' '},
});

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

// Combining marks, bidirectional marks, East Asian wide forms and emoji would shift the columns behind them.
bool fills_one_column(char32_t code) {
  if (code >= 0x2500 && code < 0x2900) return code < 0x2600 || code >= 0x2800;  // frames, blocks, braille
  if (code < 0x300) return true;
  const bool is_latin_greek_cyrillic = code >= 0x370 && code < 0x483;
  const bool is_punctuation_or_sign = (code >= 0x2010 && code < 0x2028) || (code >= 0x2030 && code < 0x2060) ||
                                      (code >= 0x2070 && code < 0x20D0) || (code >= 0x2100 && code < 0x2300);
  return is_latin_greek_cyrillic || is_punctuation_or_sign || code == U'⌀';
}

// A picture's dots (GRAFIK) by how many of the eight are set (DEC-37). A shade sets four at most, so that a path across
// it stands out.
char braille_likeness(char32_t code) {
  constexpr std::string_view kDensity = " ..::####";
  return kDensity[static_cast<std::size_t>(std::popcount(static_cast<std::uint32_t>(code - 0x2800)))];
}

bool is_braille(char32_t code) { return code >= 0x2800 && code < 0x2900; }

char32_t ascii_likeness(char32_t code) {
  if (code < 0x7F) return code;
  const auto* const found = std::ranges::find(kLikenesses, code, [](const auto& likeness) { return likeness.first; });
  return found == kLikenesses.end() ? U'?' : static_cast<char32_t>(found->second);
}

bool is_frame(char32_t code) { return code >= 0x2500 && code < 0x2580; }

// Where the text behind an arrow ends: a blank column that it may take, followed by another or by the field's end.
std::optional<int> room_behind(const Screen& screen, int row, int arrow) {
  for (int column = arrow + 1; column < Screen::kColumns; ++column) {
    const char32_t code = screen.at(row, column).code;
    if (is_frame(code)) return std::nullopt;
    if (code != U' ') continue;
    const bool is_last = column + 1 == Screen::kColumns;
    const char32_t next = is_last ? U' ' : screen.at(row, column + 1).code;
    if (next == U' ' || is_frame(next)) return column;
  }
  return std::nullopt;
}

}  // namespace

Screen with_wide_arrows(Screen screen) {
  for (int row = 0; row < Screen::kRows; ++row) {
    for (int column = 0; column < Screen::kColumns; ++column) {
      const Cell arrow = screen.at(row, column);
      if (arrow.code != U'→') continue;
      const auto room = room_behind(screen, row, column);
      if (!room) continue;
      for (int to = *room; to > column + 1; --to) screen.put(row, to, screen.at(row, to - 1));
      screen.put(row, column, {U'-', arrow.attribute});
      screen.put(row, ++column, {U'>', arrow.attribute});
    }
  }
  return screen;
}

char32_t shown_code(char32_t code, Glyphs glyphs) {
  if (is_control(code)) return U'?';
  if (is_braille(code) && glyphs != Glyphs::all) return static_cast<char32_t>(braille_likeness(code));
  if (glyphs == Glyphs::ascii) return ascii_likeness(code);
  return fills_one_column(code) ? code : U'?';
}

std::string printable(std::string_view text) {
  std::string line;
  for (const char32_t code : from_utf8(text)) line += is_control(code) ? std::string(" ") : to_utf8(code);
  return line;
}

}  // namespace cnclab::station
