// A drawing of a tool path: ways and arcs, rapids dashed, workpiece, axes in mm, start and end.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "drawing/projection.hpp"
#include "drawing/relief.hpp"
#include "drawing/strokes.hpp"

namespace cnclab::drawing {

/// The words in the drawing.
struct Captions {
  std::string start = "Start", end = "Ende", feed = "Vorschub", rapid = "Eilgang", workpiece = "Werkstück",
              contour = "Kontur";
};

/// What is drawn of a program. The strokes are only looked at.
struct Traces {
  std::span<const Stroke> path;     ///< of the tool's centre
  std::span<const Stroke> contour;  ///< as programmed, where the tool keeps beside it
};

struct PictureOptions {
  std::string title;  ///< any text
  View view = View::xy;
  std::optional<Box> workpiece{};
  const Relief* relief = nullptr;  ///< shades the workpiece by what was removed
  Captions captions{};
};

/// The whole drawing. An empty path gives the workpiece, or an empty frame.
[[nodiscard]] Picture path_picture(const Traces& traces, const PictureOptions& options);

/// The workpiece of the simulated machine, centred under the start, its top at Z = 0 (DEC-24). size_mm   X Y Z
[[nodiscard]] Box workpiece_under(const geometry::Point& start, const std::array<double, 3>& size_mm);
/// The usual one: 120 × 80 × 30 mm.
[[nodiscard]] Box standard_workpiece(const geometry::Point& start);

}  // namespace cnclab::drawing
