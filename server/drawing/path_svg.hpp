// A drawing of a tool path as SVG: ways and arcs, rapids dashed, workpiece, axes in mm, start and end.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "geometry/path_item.hpp"

namespace cnclab::drawing {

/// From where the part is seen: against Z, Y or X (D-128), or from above at an angle with all three axes.
enum class View : std::uint8_t { xy, xz, yz, iso };

/// The workpiece in path coordinates, mm.
struct Box {
  geometry::Point low, high;
};

/// The words in the drawing.
struct Captions {
  std::string start = "Start", end = "Ende", feed = "Vorschub", rapid = "Eilgang", workpiece = "Werkstück",
              contour = "Kontur";
};

struct SvgOptions {
  std::string title;  ///< any text; escaped here
  View view = View::xy;
  std::optional<Box> workpiece{};
  std::span<const geometry::PathItem> contour{};  ///< the programmed contour, drawn where the tool keeps beside it
  Captions captions{};
};

/// The whole file. Items that are neither line nor arc are passed over, as is the fourth axis; an empty path gives the
/// workpiece, or an empty frame.
[[nodiscard]] std::string path_svg(std::span<const geometry::PathItem> path, const SvgOptions& options);

/// The workpiece of the simulated machine: 120 × 80 × 30 mm, centred under the start, its top at Z = 0 (DEC-24).
[[nodiscard]] Box standard_workpiece(const geometry::Point& start);

}  // namespace cnclab::drawing
