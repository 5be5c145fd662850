// The window that GRAFIK looks through, and what it shows there (DEC-37): workpiece, contour, path and tool in dots.
#pragma once

#include <optional>

#include "drawing/braille_canvas.hpp"
#include "drawing/path_picture.hpp"

namespace cnclab::drawing {

/// View, zoom and pan. Value; the whole part is seen at zoom 1.
struct Window {
  static constexpr double kClosest = 64, kFarthest = 0.25;
  View view = View::xy;
  double zoom = 1;
  double shift_right = 0, shift_up = 0;  ///< of the middle, in widths and heights of the window

  /// Half or twice as close, about the middle; not beyond the limits.
  void zoom_in();
  void zoom_out();
  /// A quarter of the window; `right` and `up` are −1, 0 or 1.
  void pan(int right, int up);
  /// Another view shows the whole part.
  void look(View from);
};

/// What there is to see. Everything is only looked at.
struct Scene {
  Traces traces;
  std::optional<Box> workpiece{};
  const Relief* relief = nullptr;
  std::optional<geometry::Point> tool{};  ///< the tip, where it stands now
  double tool_radius_mm = 0;
};

/// Draws it: the workpiece's edges, removed material as a pattern that is denser the deeper it is, the contour and the
/// path solid, rapids dashed, the tool as a ring in XY and as a stem in the other views.
[[nodiscard]] BrailleCanvas draw_scene(const Scene& scene, const Window& window);

}  // namespace cnclab::drawing
