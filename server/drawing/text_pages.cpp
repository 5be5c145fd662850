// Cells of text to shapes.
#include "drawing/text_pages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace cnclab::drawing {

namespace {

constexpr double kCellWidth = 6;  // Courier: 0.6 of its size, which is 10
constexpr double kLineHeight = 11.5, kBaseLine = 8.5;

/// Parts of a frame that leave the middle of a cell.
enum Part : unsigned { kLeft = 1, kRight = 2, kUp = 4, kDown = 8 };

struct FrameGlyph {
  char32_t code;
  unsigned parts;
};
constexpr std::array<FrameGlyph, 11> kFrames{{{U'─', kLeft | kRight},
                                              {U'│', kUp | kDown},
                                              {U'┌', kRight | kDown},
                                              {U'┐', kLeft | kDown},
                                              {U'└', kRight | kUp},
                                              {U'┘', kLeft | kUp},
                                              {U'├', kRight | kUp | kDown},
                                              {U'┤', kLeft | kUp | kDown},
                                              {U'┬', kLeft | kRight | kDown},
                                              {U'┴', kLeft | kRight | kUp},
                                              {U'┼', kLeft | kRight | kUp | kDown}}};

std::u32string decoded(std::string_view text) {
  std::u32string codes;
  for (std::size_t at = 0; at < text.size();) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t length = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    char32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length && at + i < text.size(); ++i)
      code = code << 6U | (static_cast<unsigned char>(text[at + i]) & 0x3FU);
    codes += code;
    at += length;
  }
  return codes;
}

void append_utf8(std::string& text, char32_t code) {
  if (code >= 0x80) {
    text += static_cast<char>(0xC0U | code >> 6U);
    text += static_cast<char>(0x80U | (code & 0x3FU));
  } else {
    text += static_cast<char>(code);
  }
}

/// In Windows Latin 1, so a letter of the font.
bool is_letter(char32_t code) { return code < 0x100; }

class PageSetter {
 public:
  explicit PageSetter(Picture& picture) : picture_(picture) {}

  /// Sets cells of one line; `is_inverse` says it of each column.
  template <class IsInverse>
  void set_line(std::string_view line, double top, const IsInverse& is_inverse) {
    const std::u32string codes = decoded(line);
    for (std::size_t column = 0; column < codes.size();) {
      const bool inverse = is_inverse(static_cast<int>(column));
      std::string run;
      const std::size_t begin = column;
      while (column < codes.size() && is_letter(codes[column]) && is_inverse(static_cast<int>(column)) == inverse)
        append_utf8(run, codes[column++]);
      if (column == begin) ++column;
      const double left = static_cast<double>(begin) * kCellWidth;
      const double width = static_cast<double>(column - begin) * kCellWidth;
      if (inverse) add(Rectangle{Style::ink, {left, top}, width, kLineHeight});
      if (run.empty())
        set_sign(codes[begin], left, top);
      else if (run.find_first_not_of(' ') != std::string::npos)
        add(Words{inverse ? Style::inverse : Style::script, Anchor::start, {left, top + kBaseLine}, run});
    }
  }

 private:
  template <class Drawn>
  void add(Drawn&& shape) {
    picture_.shapes.emplace_back(std::forward<Drawn>(shape));
  }

  void stretch(double x, double y, double to_x, double to_y) { add(Stretch{Style::line, {x, y}, {to_x, to_y}}); }

  void set_sign(char32_t code, double left, double top) {
    if (code > 0x2800 && code <= 0x28FF) return set_braille(static_cast<unsigned>(code - 0x2800), left, top);
    const double middle = left + kCellWidth / 2, center = top + kLineHeight / 2;
    const auto frame = std::ranges::find(kFrames, code, &FrameGlyph::code);
    if (frame != kFrames.end()) {
      if ((frame->parts & kLeft) != 0) stretch(left, center, middle, center);
      if ((frame->parts & kRight) != 0) stretch(middle, center, left + kCellWidth, center);
      if ((frame->parts & kUp) != 0) stretch(middle, top, middle, center);
      if ((frame->parts & kDown) != 0) stretch(middle, center, middle, top + kLineHeight);
      return;
    }
    set_picture_sign(code, middle, center, left, top);
  }

  void set_picture_sign(char32_t code, double middle, double center, double left, double top) {
    constexpr double kArrow = 2.6, kHead = 1.6, kRadius = 2.3;
    const auto arrow = [&](double x, double y) {  // x, y: direction of unit length along an axis
      const double tip_x = middle + x * kArrow, tip_y = center + y * kArrow;
      stretch(middle - x * kArrow, center - y * kArrow, tip_x, tip_y);
      stretch(tip_x, tip_y, tip_x - (x + y) * kHead, tip_y - (y + x) * kHead);
      stretch(tip_x, tip_y, tip_x - (x - y) * kHead, tip_y - (y - x) * kHead);
    };
    switch (code) {
      case U'→':
        return arrow(1, 0);
      case U'←':
        return arrow(-1, 0);
      case U'↓':
        return arrow(0, 1);
      case U'↑':
        return arrow(0, -1);
      case U'□':
        return add(Rectangle{Style::line, {left + 0.8, center - 2.6}, kCellWidth - 1.6, 5.2});
      case U'●':
        return add(Disc{Style::ink, {middle, center}, kRadius});
      case U'○':
        return add(Disc{Style::line, {middle, center}, kRadius});
      case U'↻':
      case U'↺':
        return turning_arrow(code == U'↻', middle, center, kRadius);
      default:
        return add(Words{Style::script, Anchor::start, {left, top + kBaseLine}, "?"});
    }
  }

  /// Three quarters of a circle, open at the top right or left, with its head.
  void turning_arrow(bool is_clockwise, double middle, double center, double radius) {
    const double side = is_clockwise ? 1 : -1;
    Polyline bow{.style = Style::line, .points = {}};
    for (int step = 0; step <= 12; ++step) {
      const double angle = std::numbers::pi / 2 * (step / 4.0);
      bow.points.push_back({middle + side * radius * std::cos(angle), center + radius * std::sin(angle)});
    }
    add(std::move(bow));
    const double tip_y = center - radius;
    stretch(middle, tip_y, middle - side * 1.5, tip_y - 1.3);
    stretch(middle, tip_y, middle - side * 1.5, tip_y + 1.3);
  }

  void set_braille(unsigned bits, double left, double top) {
    constexpr std::array<std::pair<int, int>, 8> kDots{
        {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}, {0, 3}, {1, 3}}};
    for (std::size_t dot = 0; dot < kDots.size(); ++dot) {
      if ((bits >> dot & 1U) == 0) continue;
      const auto [column, row] = kDots[dot];
      add(Disc{Style::ink, {left + (column + 0.5) * kCellWidth / 2, top + (row + 0.5) * kLineHeight / 4}, 1.0});
    }
  }

  Picture& picture_;
};

}  // namespace

Picture text_page(std::span<const std::string> lines, std::string_view title) {
  constexpr int kColumns = 80, kLines = 66;
  Picture picture{.width_px = kColumns * kCellWidth, .height_px = kLines * kLineHeight, .title = std::string(title)};
  PageSetter setter(picture);
  for (std::size_t line = 0; line < lines.size(); ++line)
    setter.set_line(lines[line], static_cast<double>(line) * kLineHeight, [](int) { return false; });
  return picture;
}

Picture screen_page(std::span<const std::string> rows, std::span<const InverseRun> inverse, std::string_view title) {
  constexpr int kColumns = 80, kRows = 24;
  Picture picture{.width_px = kColumns * kCellWidth, .height_px = kRows * kLineHeight, .title = std::string(title)};
  PageSetter setter(picture);
  for (std::size_t row = 0; row < rows.size(); ++row)
    setter.set_line(rows[row], static_cast<double>(row) * kLineHeight, [&](int column) {
      return std::ranges::any_of(inverse, [&](const InverseRun& run) {
        return run.row == static_cast<int>(row) && column >= run.column && column < run.column + run.length;
      });
    });
  return picture;
}

}  // namespace cnclab::drawing
