// A picture before it is written: strokes, areas and words in their places, each with a style. SVG and PDF are written
// from it (svg.hpp, pdf.hpp), so that both show the same.
//
// Coordinates are pixels to the right and down from the top left corner; how a style looks is one table.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cnclab::drawing {

enum class Style : std::uint8_t {
  title,      ///< words: the heading
  label,      ///< … at axes and in the legend
  mark,       ///< … at start and end
  script,     ///< … monospaced: lists and screens
  inverse,    ///< … monospaced on dark ground
  frame,      ///< edge of the field
  tick,       ///< lines of the grid
  dot,        ///< marks of the axes in space
  workpiece,  ///< its area
  shade1,     ///< material removed from it: up to a quarter of its thickness
  shade2,     ///< … half
  shade3,     ///< … three quarters
  shade4,     ///< … all
  edge,       ///< its edges
  contour,    ///< what was programmed
  feed,       ///< the tool's path
  rapid,      ///< … in rapid
  start,      ///< where the path begins
  end,        ///< … and ends
  ink,        ///< dark areas: dots, ground of inverse cells
  line,       ///< thin dark lines: frames of screens
};
inline constexpr int kStyles = static_cast<int>(Style::line) + 1;

/// How a style looks. Colours are 0xRRGGBB.
struct Look {
  std::string_view name;  ///< class in SVG
  std::optional<std::uint32_t> fill{}, stroke{};
  double width_px = 1;
  double dash_px = 0, gap_px = 0;  ///< 0: solid
  double font_px = 0;              ///< words only; `fill` is their colour
  bool is_bold = false, is_monospaced = false;
  bool has_round_joins = false;
};
[[nodiscard]] const Look& look_of(Style style);

/// A point: to the right, and up or down as its user says.
struct Flat {
  double right = 0, up = 0;
};

struct Stretch {
  Style style{};
  Flat from, to;
};
struct Polyline {
  Style style{};
  std::vector<Flat> points;
};
struct Rectangle {
  Style style{};
  Flat corner;  ///< top left
  double width = 0, height = 0;
};
struct Disc {
  Style style{};
  Flat center;
  double radius = 0;
};
enum class Anchor : std::uint8_t { start, middle, end };
struct Words {
  Style style{};
  Anchor anchor{};
  Flat at;  ///< on the base line
  std::string text;
};
using Shape = std::variant<Stretch, Polyline, Rectangle, Disc, Words>;

struct Picture {
  double width_px = 0, height_px = 0;
  std::string title;  ///< of the file; any text
  std::vector<Shape> shapes{};
};

}  // namespace cnclab::drawing
