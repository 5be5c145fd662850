// Puts the drawing together: frame and marks, workpiece, path, start and end, title and legend.
#include "drawing/path_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/projection.hpp"
#include "machine/workpiece.hpp"

namespace cnclab::drawing {

namespace {

Bounds bounds_of(const Traces& traces, const PictureOptions& options) {
  Bounds bounds;
  for (const std::span<const Stroke> layer : {traces.contour, traces.path})
    for (const Stroke& stroke : layer)
      for (const Spot& spot : stroke.spots) bounds.take(project(point_of(spot), options.view));
  if (options.workpiece)
    for (const geometry::Point& corner : corners_of(*options.workpiece)) bounds.take(project(corner, options.view));
  return bounds;
}

/// "0", "12.5", never "-0".
std::string mark_text(double mm) {
  const double rounded = std::round(mm * 1000) / 1000;
  return fmt::format("{:g}", rounded == 0 ? 0.0 : rounded);
}

/// Marks are counted from 0.
int first_mark(double from_mm, double tick_mm) { return static_cast<int>(std::ceil(from_mm / tick_mm)); }

std::optional<Style> shade_style(float shade) {
  constexpr float kVisible = 0.02F;
  if (shade < kVisible) return std::nullopt;
  constexpr std::array kShades{Style::shade1, Style::shade2, Style::shade3, Style::shade4};
  return kShades[std::min<std::size_t>(static_cast<std::size_t>(shade * 4), 3)];
}

class Drawing {
 public:
  Drawing(const Traces& traces, const PictureOptions& options)
      : options_(options), traces_(traces), sheet_(bounds_of(traces, options)) {}

  Picture picture() {
    picture_ = {.width_px = Sheet::kWidth_px, .height_px = Sheet::kHeight_px, .title = options_.title};
    add_workpiece();
    add_shades();
    options_.view == View::iso ? add_space_axes() : add_frame();
    for (const Stroke& stroke : traces_.contour) add_stroke(Style::contour, stroke);
    for (const Stroke& stroke : traces_.path) add_stroke(stroke.is_rapid ? Style::rapid : Style::feed, stroke);
    add_ends();
    add_legend();
    return std::move(picture_);
  }

 private:
  [[nodiscard]] Flat place(const geometry::Point& point) const {
    const Flat flat = project(point, options_.view);
    return {sheet_.x(flat.right), sheet_.y(flat.up)};
  }

  template <class Drawn>
  void add(Drawn&& shape) {
    picture_.shapes.emplace_back(std::forward<Drawn>(shape));
  }
  void add_words(Style style, Anchor anchor, const Flat& at, std::string_view text) {
    add(Words{style, anchor, at, std::string(text)});
  }

  void add_workpiece() {
    if (!options_.workpiece) return;
    const Box& box = *options_.workpiece;
    if (options_.view == View::iso) {
      const auto corners = corners_of(box);
      for (std::size_t i = 0; i < corners.size(); ++i)
        for (const std::size_t axis : {1UL, 2UL, 4UL})
          if ((i & axis) == 0) add(Stretch{Style::edge, place(corners[i]), place(corners[i | axis])});
      return;
    }
    const Flat low = place(box.low), high = place(box.high);
    add(Rectangle{Style::workpiece, {low.right, high.up}, high.right - low.right, low.up - high.up});
  }

  /// Where material is gone: runs of cells that are equally dark.
  void add_shades() {
    if (options_.relief == nullptr) return;
    const double cell_px = options_.view == View::iso ? 6 : 3;  // at an angle, as fine as the surface is looked at
    const Bounds& field = sheet_.bounds();
    const double left = sheet_.x(field.left), top = sheet_.y(field.high);
    const double width = sheet_.x(field.right) - left, height = sheet_.y(field.low) - top;
    const Raster raster{.field = field,
                        .columns = std::max(1, static_cast<int>(width / cell_px)),
                        .rows = std::max(1, static_cast<int>(height / cell_px))};
    const std::vector<float> shades = shades_of(*options_.relief, options_.view, raster);
    const double across = width / raster.columns, down = height / raster.rows;
    for (int row = 0; row < raster.rows; ++row) {
      const auto line =
          std::span(shades).subspan(static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns),
                                    static_cast<std::size_t>(raster.columns));
      for (int from = 0, to = 0; from < raster.columns; from = to) {
        const auto style = shade_style(line[static_cast<std::size_t>(from)]);
        while (to < raster.columns && shade_style(line[static_cast<std::size_t>(to)]) == style) ++to;
        if (style) add(Rectangle{*style, {left + from * across, top + row * down}, (to - from) * across, down});
      }
    }
  }

  void add_frame() {
    const Bounds& field = sheet_.bounds();
    const double tick = sheet_.tick_mm();
    const double left = sheet_.x(field.left), right = sheet_.x(field.right);
    const double bottom = sheet_.y(field.low), top = sheet_.y(field.high);
    for (int mark = first_mark(field.left, tick); mark * tick <= field.right; ++mark) {
      const double mm = mark * tick;
      add(Stretch{Style::tick, {sheet_.x(mm), bottom}, {sheet_.x(mm), top}});
      add_words(Style::label, Anchor::middle, {sheet_.x(mm), bottom + 20}, mark_text(mm));
    }
    for (int mark = first_mark(field.low, tick); mark * tick <= field.high; ++mark) {
      const double mm = mark * tick;
      add(Stretch{Style::tick, {left, sheet_.y(mm)}, {right, sheet_.y(mm)}});
      add_words(Style::label, Anchor::end, {left - 8, sheet_.y(mm) + 5}, mark_text(mm));
    }
    add(Rectangle{Style::frame, {left, top}, right - left, bottom - top});
    add_words(Style::label, Anchor::end, {right, bottom + 42}, options_.view == View::yz ? "Y / mm" : "X / mm");
    add_words(Style::label, Anchor::start, {left, top - 10}, options_.view == View::xy ? "Y / mm" : "Z / mm");
  }

  /// X, Y and Z from the point that was the start, each with its marks.
  void add_space_axes() {
    const geometry::Point origin =
        traces_.path.empty() ? geometry::Point{} : point_of(traces_.path.front().spots.front());
    const double tick = sheet_.tick_mm();
    constexpr std::array<std::pair<double geometry::Point::*, std::string_view>, 3> kAxes{
        {{&geometry::Point::x, "X / mm"}, {&geometry::Point::y, "Y / mm"}, {&geometry::Point::z, "Z / mm"}}};
    for (const auto& [axis, name] : kAxes) {
      const double first = origin.*axis;
      geometry::Point at = origin;
      for (int step = 1; step <= 4; ++step) {
        at.*axis = first + tick * step;
        const Flat mark = place(at);
        add(Disc{Style::dot, mark, 2});
        add_words(Style::label, Anchor::start, {mark.right + 5, mark.up - 4}, mark_text(at.*axis));
      }
      add(Stretch{Style::tick, place(origin), place(at)});
      at.*axis = first + tick * 4.5;
      add_words(Style::label, Anchor::middle, place(at), name);
    }
  }

  void add_stroke(Style style, const Stroke& stroke) {
    Polyline line{.style = style, .points = {}};
    for (const Spot& spot : stroke.spots) line.points.push_back(place(point_of(spot)));
    add(std::move(line));
  }

  void add_ends() {
    if (traces_.path.empty()) return;
    const Flat start = place(point_of(traces_.path.front().spots.front()));
    const Flat end = place(point_of(traces_.path.back().spots.back()));
    add(Disc{Style::start, start, 6});
    add_words(Style::mark, Anchor::start, {start.right + 9, start.up + 18}, options_.captions.start);
    add(Rectangle{Style::end, {end.right - 4.5, end.up - 4.5}, 9, 9});
    add_words(Style::mark, Anchor::start, {end.right + 9, end.up - 9}, options_.captions.end);
  }

  void add_legend() {
    add_words(Style::title, Anchor::start, {Sheet::kLeft_px, 36}, options_.title);
    const Captions& captions = options_.captions;
    const bool has_contour = !traces_.contour.empty();
    double right = Sheet::kWidth_px - Sheet::kRight_px - (has_contour ? 445 : 330);
    const auto add_entry = [&](Style style, std::string_view caption) {
      add(Stretch{style, {right, 32}, {right + 30, 32}});
      add_words(Style::label, Anchor::start, {right + 36, 37}, caption);
      right += 115;
    };
    if (has_contour) add_entry(Style::contour, captions.contour);
    add_entry(Style::feed, captions.feed);
    add_entry(Style::rapid, captions.rapid);
    if (options_.workpiece) add_entry(Style::edge, captions.workpiece);
  }

  const PictureOptions& options_;
  const Traces& traces_;
  Sheet sheet_;
  Picture picture_;
};

}  // namespace

Picture path_picture(const Traces& traces, const PictureOptions& options) { return Drawing(traces, options).picture(); }

Box workpiece_under(const geometry::Point& start, const std::array<double, 3>& size_mm) {
  const auto& [x, y, z] = size_mm;
  return {.low = {start.x - x / 2, start.y - y / 2, -z}, .high = {start.x + x / 2, start.y + y / 2, 0}};
}

Box standard_workpiece(const geometry::Point& start) {
  return workpiece_under(start, machine::WorkpieceSpec{}.size_mm);
}

}  // namespace cnclab::drawing
