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
    {U'−', '-'},
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

bool is_small_letter(char32_t code) {
  return (code >= U'a' && code <= U'z') || std::u32string_view(U"äöüß").contains(code);
}

// A sign whose likeness is two characters, and how it is written before a small letter and else: "Ändern", "LÖSCHEN".
struct WideSign {
  char32_t code;
  std::string_view before_small, before_other;
};

constexpr WideSign kWideSigns[] = {{U'→', "->", "->"}, {U'±', "+-", "+-"}, {U'ä', "ae", "ae"},
                                   {U'ö', "oe", "oe"}, {U'ü', "ue", "ue"}, {U'ß', "ss", "ss"},
                                   {U'Ä', "Ae", "AE"}, {U'Ö', "Oe", "OE"}, {U'Ü', "Ue", "UE"}};

// Two characters in place of `code` with `next` behind it; nothing where one will do.
std::optional<std::string_view> wide_likeness(char32_t code, char32_t next) {
  const auto* const sign = std::ranges::find(kWideSigns, code, &WideSign::code);
  if (sign == std::end(kWideSigns)) return std::nullopt;
  return is_small_letter(next) ? sign->before_small : sign->before_other;
}

// A column that text may take: what is marked stays marked, a cursor stays one.
bool is_free(const Cell& cell, Attribute of_text) {
  return cell.code == U' ' && (cell.attribute == Attribute::normal || cell.attribute == of_text);
}

// Where the text behind a sign ends: a blank column that it may take, followed by another or by the field's end.
std::optional<int> room_behind(const Screen& screen, int row, int sign) {
  const Attribute attribute = screen.at(row, sign).attribute;
  for (int column = sign + 1; column < Screen::kColumns; ++column) {
    const Cell& cell = screen.at(row, column);
    if (is_frame(cell.code)) return std::nullopt;
    if (!is_free(cell, attribute)) continue;
    const bool is_last = column + 1 == Screen::kColumns;
    if (is_last) return column;
    const Cell& next = screen.at(row, column + 1);
    if (is_free(next, attribute) || is_frame(next.code)) return column;
  }
  return std::nullopt;
}

}  // namespace

Screen spelled_out(Screen screen) {
  for (int row = 0; row < Screen::kRows; ++row) {
    for (int column = 0; column < Screen::kColumns; ++column) {
      const Cell sign = screen.at(row, column);
      const char32_t next = column + 1 < Screen::kColumns ? screen.at(row, column + 1).code : U' ';
      const auto likeness = wide_likeness(sign.code, next);
      const auto room = likeness ? room_behind(screen, row, column) : std::nullopt;
      if (!room) continue;
      for (int to = *room; to > column + 1; --to) screen.put(row, to, screen.at(row, to - 1));
      screen.put(row, column, {static_cast<char32_t>(likeness->front()), sign.attribute});
      screen.put(row, ++column, {static_cast<char32_t>(likeness->back()), sign.attribute});
    }
  }
  return screen;
}

std::string spelled_out(std::string_view text) {
  const std::u32string codes = from_utf8(text);
  std::string spelled;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto likeness = wide_likeness(codes[i], i + 1 < codes.size() ? codes[i + 1] : U' ');
    spelled += likeness ? std::string(*likeness) : to_utf8(codes[i]);
  }
  return spelled;
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

std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  for (std::u32string rest = from_utf8(text); !rest.empty();) {
    std::size_t end = std::min(rest.size(), columns);
    if (end < rest.size()) {
      const std::size_t blank = rest.rfind(U' ', end);
      if (blank != std::u32string::npos && blank > 0) end = blank;
    }
    lines.push_back(to_utf8(rest.substr(0, end)));
    rest.erase(0, end);
    if (rest.starts_with(U' ')) rest.erase(0, 1);
  }
  return lines;
}

}  // namespace cnclab::station
