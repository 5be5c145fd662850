// From millimetres to dots.
#include "drawing/graphic_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cnclab::drawing {

namespace {

Bounds bounds_of(const Scene& scene, View view) {
  Bounds bounds;
  for (const std::span<const Stroke> layer : {scene.traces.contour, scene.traces.path})
    for (const Stroke& stroke : layer)
      for (const Spot& spot : stroke.spots) bounds.take(project(point_of(spot), view));
  if (scene.workpiece)
    for (const geometry::Point& corner : corners_of(*scene.workpiece)) bounds.take(project(corner, view));
  if (scene.tool) bounds.take(project(*scene.tool, view));
  if (bounds.is_empty()) bounds.take({});
  return bounds;
}

class Painter {
 public:
  Painter(const Scene& scene, const Window& window) : scene_(scene), view_(window.view) {
    const Bounds all = bounds_of(scene, view_);
    constexpr double kLeast_mm = 1, kMargin = 1.06;
    const double width = std::max(all.right - all.left, kLeast_mm), height = std::max(all.high - all.low, kLeast_mm);
    const double mm_per_dot = std::max(width / BrailleCanvas::kColumns, height / BrailleCanvas::kRows) * kMargin;
    mm_per_dot_ = mm_per_dot / window.zoom;
    left_ = (all.left + all.right) / 2 + (window.shift_right - 0.5) * BrailleCanvas::kColumns * mm_per_dot_;
    high_ = (all.low + all.high) / 2 + (window.shift_up + 0.5) * BrailleCanvas::kRows * mm_per_dot_;
  }

  BrailleCanvas paint() {
    draw_shades();
    draw_edges();
    for (const Stroke& stroke : scene_.traces.contour) draw_stroke(stroke);
    for (const Stroke& stroke : scene_.traces.path) draw_stroke(stroke);
    draw_tool();
    return canvas_;
  }

 private:
  [[nodiscard]] Flat dot_of(const Flat& flat) const {
    return {(flat.right - left_) / mm_per_dot_, (high_ - flat.up) / mm_per_dot_};
  }
  [[nodiscard]] Flat dot_of(const geometry::Point& point) const { return dot_of(project(point, view_)); }

  /// Ordered dither: a dot is set where the place is darker than the pattern's threshold there; never all of them, so
  /// that the path can still be seen.
  void draw_shades() {
    if (scene_.relief == nullptr) return;
    constexpr std::array<std::array<int, 4>, 4> kPattern{
        {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};
    constexpr double kDensest = 0.5, kVisible = 0.01;
    const Raster raster{.field = {.left = left_,
                                  .right = left_ + BrailleCanvas::kColumns * mm_per_dot_,
                                  .low = high_ - BrailleCanvas::kRows * mm_per_dot_,
                                  .high = high_},
                        .columns = BrailleCanvas::kColumns,
                        .rows = BrailleCanvas::kRows};
    const std::vector<float> shades = shades_of(*scene_.relief, view_, raster);
    for (int row = 0; row < raster.rows; ++row)
      for (int column = 0; column < raster.columns; ++column) {
        const double shade =
            shades[static_cast<std::size_t>(row) * BrailleCanvas::kColumns + static_cast<std::size_t>(column)];
        const int threshold = kPattern[static_cast<std::size_t>(row % 4)][static_cast<std::size_t>(column % 4)];
        if (shade > kVisible && threshold < std::ceil(shade * kDensest * 16)) canvas_.set(column, row);
      }
  }

  void draw_edges() {
    if (!scene_.workpiece) return;
    const auto corners = corners_of(*scene_.workpiece);
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (const std::size_t axis : {1UL, 2UL, 4UL}) {
        constexpr std::size_t kHidden = 3;  // the edges at high X and Y, low Z, lie behind the block at an angle
        const std::size_t other = i | axis;
        const bool is_hidden = view_ == View::iso && (i == kHidden || other == kHidden);
        if ((i & axis) == 0 && !is_hidden) canvas_.line(dot_of(corners[i]), dot_of(corners[other]));
      }
  }

  void draw_stroke(const Stroke& stroke) {
    int phase = 0;
    for (std::size_t i = 1; i < stroke.spots.size(); ++i) {
      const Flat from = dot_of(point_of(stroke.spots[i - 1])), to = dot_of(point_of(stroke.spots[i]));
      stroke.is_rapid ? canvas_.dashed_line(from, to, phase) : canvas_.line(from, to);
    }
  }

  /// At least two dots wide, or it would not be seen.
  void draw_tool() {
    if (!scene_.tool) return;
    const Flat tip = dot_of(*scene_.tool);
    const double radius = std::max(scene_.tool_radius_mm / mm_per_dot_, 1.5);
    constexpr double kStem_dots = 8;
    if (view_ == View::xy) {
      constexpr int kSides = 24;
      const auto at = [&](int side) {
        const double angle = 2 * std::numbers::pi * side / kSides;
        return Flat{tip.right + radius * std::cos(angle), tip.up + radius * std::sin(angle)};
      };
      for (int side = 0; side < kSides; ++side) canvas_.line(at(side), at(side + 1));
      return;
    }
    const Flat left{tip.right - radius, tip.up}, right{tip.right + radius, tip.up};
    canvas_.line(left, right);
    canvas_.line(left, {left.right, left.up - kStem_dots});
    canvas_.line(right, {right.right, right.up - kStem_dots});
  }

  const Scene& scene_;
  View view_;
  double mm_per_dot_ = 1, left_ = 0, high_ = 0;
  BrailleCanvas canvas_;
};

}  // namespace

void Window::zoom_in() { zoom = std::min(zoom * 2, kClosest); }
void Window::zoom_out() { zoom = std::max(zoom / 2, kFarthest); }

void Window::pan(int right, int up) {
  constexpr double kStep = 0.25, kFarthestShift = kClosest;
  shift_right = std::clamp(shift_right + kStep * right, -kFarthestShift, kFarthestShift);
  shift_up = std::clamp(shift_up + kStep * up, -kFarthestShift, kFarthestShift);
}

void Window::look(View from) { *this = {.view = from}; }

BrailleCanvas draw_scene(const Scene& scene, const Window& window) { return Painter(scene, window).paint(); }

}  // namespace cnclab::drawing
