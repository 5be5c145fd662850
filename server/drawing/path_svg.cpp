// Writes the drawing: frame and marks, workpiece, path, start and end, title and legend.
#include "drawing/path_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "drawing/projection.hpp"
#include "geometry/path_math.hpp"

namespace cnclab::drawing {

namespace {

constexpr std::string_view kStyle =
    "text{font-family:sans-serif;fill:#222}"
    ".title{font-size:24px;font-weight:bold}.label{font-size:14px}.mark{font-size:15px;font-weight:bold}"
    ".frame{fill:none;stroke:#222;stroke-width:1}.tick{stroke:#bbb;stroke-width:0.6}"
    ".workpiece{fill:#e8e2d4;stroke:#a89c80;stroke-width:1}.edge{stroke:#a89c80;stroke-width:1}"
    ".contour{fill:none;stroke:#222;stroke-width:3.2;stroke-linejoin:round}"
    ".feed{fill:none;stroke:#0b4f9e;stroke-width:2;stroke-linejoin:round}"
    ".rapid{fill:none;stroke:#c04000;stroke-width:1.4;stroke-dasharray:7 5}";

/// One stroke of the pen: points that belong together and are drawn alike.
struct Stroke {
  bool is_rapid = false;
  std::vector<geometry::Point> points;
};

/// So many chords that none leaves the arc by more than 0.01 mm or spans more than 5°.
int chords_of(const geometry::ArcShape& shape) {
  constexpr double kSagitta_mm = 0.01, kWidest_rad = std::numbers::pi / 36;
  constexpr int kMost = 4000;
  const double radius = std::max(shape.start_radius, shape.end_radius);
  const double by_sagitta = radius > kSagitta_mm ? 2 * std::acos(1 - kSagitta_mm / radius) : kWidest_rad;
  return std::clamp(static_cast<int>(std::ceil(std::abs(shape.sweep) / std::min(by_sagitta, kWidest_rad))), 1, kMost);
}

void append_stroke(std::vector<Stroke>& strokes, bool is_rapid, const geometry::Point& from) {
  const bool goes_on = !strokes.empty() && strokes.back().is_rapid == is_rapid && strokes.back().points.back() == from;
  if (!goes_on) strokes.push_back({.is_rapid = is_rapid, .points = {from}});
}

std::vector<Stroke> strokes_of(std::span<const geometry::PathItem> path) {
  std::vector<Stroke> strokes;
  for (const geometry::PathItem& item : path) {
    if (item.is_fourth_axis) continue;
    if (const auto* line = std::get_if<geometry::Line>(&item.what)) {
      append_stroke(strokes, line->is_rapid, line->from);
      strokes.back().points.push_back(line->to);
    }
    if (const auto* arc = std::get_if<geometry::Arc>(&item.what)) {
      const geometry::ArcShape shape = geometry::shape_of(*arc);
      const int chords = chords_of(shape);
      append_stroke(strokes, false, arc->from);
      for (int chord = 1; chord <= chords; ++chord)
        strokes.back().points.push_back(geometry::point_at(*arc, shape, shape.length * chord / chords));
    }
  }
  return strokes;
}

std::array<geometry::Point, 8> corners_of(const Box& box) {
  std::array<geometry::Point, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {(i & 1U) != 0 ? box.high.x : box.low.x, (i & 2U) != 0 ? box.high.y : box.low.y,
                  (i & 4U) != 0 ? box.high.z : box.low.z};
  return corners;
}

/// Everything that is drawn along the path.
struct Strokes {
  std::vector<Stroke> contour, path;
};

Bounds bounds_of(const Strokes& strokes, const SvgOptions& options) {
  Bounds bounds;
  for (const std::vector<Stroke>* layer : {&strokes.contour, &strokes.path})
    for (const Stroke& stroke : *layer)
      for (const geometry::Point& point : stroke.points) bounds.take(project(point, options.view));
  if (options.workpiece)
    for (const geometry::Point& corner : corners_of(*options.workpiece)) bounds.take(project(corner, options.view));
  return bounds;
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

/// "0", "12.5", never "-0".
std::string mark_text(double mm) {
  const double rounded = std::round(mm * 1000) / 1000;
  return fmt::format("{:g}", rounded == 0 ? 0.0 : rounded);
}

class Drawing {
 public:
  Drawing(const SvgOptions& options, const Strokes& strokes)
      : options_(options), strokes_(strokes), sheet_(bounds_of(strokes, options)) {}

  std::string text() {
    add(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:g} {:g}" width="{:g}" height="{:g}">)"
        "\n",
        Sheet::kWidth_px, Sheet::kHeight_px, Sheet::kWidth_px, Sheet::kHeight_px);
    add("<title>{}</title>\n<style>{}</style>\n", escaped(options_.title), kStyle);
    add(R"(<rect width="100%" height="100%" fill="white"/>)"
        "\n");
    add_workpiece();
    options_.view == View::iso ? add_space_axes() : add_frame();
    for (const Stroke& stroke : strokes_.contour) add_stroke("contour", stroke);
    for (const Stroke& stroke : strokes_.path) add_stroke(stroke.is_rapid ? "rapid" : "feed", stroke);
    add_ends();
    add_texts();
    return out_ + "</svg>\n";
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Values>(values)...);
  }

  [[nodiscard]] Flat place(const geometry::Point& point) const {
    const Flat flat = project(point, options_.view);
    return {sheet_.x(flat.right), sheet_.y(flat.up)};
  }

  void add_segment(std::string_view style, const Flat& from, const Flat& to) {
    add(R"(<line class="{}" x1="{:.2f}" y1="{:.2f}" x2="{:.2f}" y2="{:.2f}"/>)"
        "\n",
        style, from.right, from.up, to.right, to.up);
  }

  void add_label(std::string_view style, std::string_view anchor, const Flat& at, std::string_view text) {
    add(R"(<text class="{}" x="{:.2f}" y="{:.2f}" text-anchor="{}">{}</text>)"
        "\n",
        style, at.right, at.up, anchor, escaped(text));
  }

  void add_workpiece() {
    if (!options_.workpiece) return;
    const Box& box = *options_.workpiece;
    if (options_.view == View::iso) {
      const auto corners = corners_of(box);
      for (std::size_t i = 0; i < corners.size(); ++i)
        for (const std::size_t axis : {1UL, 2UL, 4UL})
          if ((i & axis) == 0) add_segment("edge", place(corners[i]), place(corners[i | axis]));
      return;
    }
    const Flat low = place(box.low), high = place(box.high);
    add(R"(<rect class="workpiece" x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}"/>)"
        "\n",
        low.right, high.up, high.right - low.right, low.up - high.up);
  }

  void add_frame() {
    const Bounds& field = sheet_.bounds();
    const double tick = sheet_.tick_mm();
    const double left = sheet_.x(field.left), right = sheet_.x(field.right);
    const double bottom = sheet_.y(field.low), top = sheet_.y(field.high);
    for (double mm = std::ceil(field.left / tick) * tick; mm <= field.right; mm += tick) {
      add_segment("tick", {sheet_.x(mm), bottom}, {sheet_.x(mm), top});
      add_label("label", "middle", {sheet_.x(mm), bottom + 20}, mark_text(mm));
    }
    for (double mm = std::ceil(field.low / tick) * tick; mm <= field.high; mm += tick) {
      add_segment("tick", {left, sheet_.y(mm)}, {right, sheet_.y(mm)});
      add_label("label", "end", {left - 8, sheet_.y(mm) + 5}, mark_text(mm));
    }
    add(R"(<rect class="frame" x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}"/>)"
        "\n",
        left, top, right - left, bottom - top);
    add_label("label", "end", {right, bottom + 42}, options_.view == View::yz ? "Y / mm" : "X / mm");
    add_label("label", "start", {left, top - 10}, options_.view == View::xy ? "Y / mm" : "Z / mm");
  }

  /// X, Y and Z from the point that was the start, each with its marks.
  void add_space_axes() {
    const geometry::Point origin = strokes_.path.empty() ? geometry::Point{} : strokes_.path.front().points.front();
    const double tick = sheet_.tick_mm();
    constexpr std::array<std::pair<double geometry::Point::*, std::string_view>, 3> kAxes{
        {{&geometry::Point::x, "X / mm"}, {&geometry::Point::y, "Y / mm"}, {&geometry::Point::z, "Z / mm"}}};
    for (const auto& [axis, name] : kAxes) {
      const double first = origin.*axis;
      geometry::Point at = origin;
      for (int step = 1; step <= 4; ++step) {
        at.*axis = first + tick * step;
        const Flat mark = place(at);
        add(R"(<circle cx="{:.2f}" cy="{:.2f}" r="2" fill="#222"/>)"
            "\n",
            mark.right, mark.up);
        add_label("label", "start", {mark.right + 5, mark.up - 4}, mark_text(at.*axis));
      }
      add_segment("tick", place(origin), place(at));
      at.*axis = first + tick * 4.5;
      add_label("label", "middle", place(at), name);
    }
  }

  void add_stroke(std::string_view style, const Stroke& stroke) {
    add(R"(<polyline class="{}" points=")", style);
    for (const geometry::Point& point : stroke.points) {
      const Flat at = place(point);
      add("{:.2f},{:.2f} ", at.right, at.up);
    }
    out_.back() = '"';
    out_ += "/>\n";
  }

  void add_ends() {
    const std::vector<Stroke>& path = strokes_.path;
    if (path.empty()) return;
    const Flat start = place(path.front().points.front()), end = place(path.back().points.back());
    add(R"(<circle cx="{:.2f}" cy="{:.2f}" r="6" fill="#1a7f37"/>)"
        "\n",
        start.right, start.up);
    add_label("mark", "start", {start.right + 9, start.up + 18}, options_.captions.start);
    add(R"(<rect x="{:.2f}" y="{:.2f}" width="9" height="9" fill="none" stroke="#a40e26" stroke-width="2.5"/>)"
        "\n",
        end.right - 4.5, end.up - 4.5);
    add_label("mark", "start", {end.right + 9, end.up - 9}, options_.captions.end);
  }

  void add_texts() {
    add_label("title", "start", {Sheet::kLeft_px, 36}, options_.title);
    const Captions& captions = options_.captions;
    const bool has_contour = !strokes_.contour.empty();
    double right = Sheet::kWidth_px - Sheet::kRight_px - (has_contour ? 445 : 330);
    const auto add_entry = [&](std::string_view style, std::string_view caption) {
      add_segment(style, {right, 32}, {right + 30, 32});
      add_label("label", "start", {right + 36, 37}, caption);
      right += 115;
    };
    if (has_contour) add_entry("contour", captions.contour);
    add_entry("feed", captions.feed);
    add_entry("rapid", captions.rapid);
    if (options_.workpiece) add_entry("edge", captions.workpiece);
  }

  const SvgOptions& options_;
  const Strokes& strokes_;
  Sheet sheet_;
  std::string out_;
};

}  // namespace

std::string path_svg(std::span<const geometry::PathItem> path, const SvgOptions& options) {
  const Strokes strokes{.contour = strokes_of(options.contour), .path = strokes_of(path)};
  return Drawing(options, strokes).text();
}

Box standard_workpiece(const geometry::Point& start) {
  constexpr double kX_mm = 120, kY_mm = 80, kZ_mm = 30;
  return {.low = {start.x - kX_mm / 2, start.y - kY_mm / 2, -kZ_mm},
          .high = {start.x + kX_mm / 2, start.y + kY_mm / 2, 0}};
}

}  // namespace cnclab::drawing
