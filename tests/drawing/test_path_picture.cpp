// Drawings of paths: what must be in the file, and where it stands on the sheet.
#include <gmock/gmock.h>

#include <cmath>
#include <regex>

#include "drawing/path_picture.hpp"
#include "drawing/projection.hpp"
#include "drawing/svg.hpp"

namespace cnclab::drawing {
namespace {

using geometry::PathItem;
using geometry::Point;
using testing::HasSubstr;
using testing::Not;

PathItem line(Point from, Point to, bool is_rapid) {
  PathItem item;
  item.what = geometry::Line{.from = from, .to = to, .feed_mm_per_min = 100, .is_rapid = is_rapid};
  return item;
}

PathItem circle(Point start, Point center) {
  PathItem item;
  item.what = geometry::Arc{.from = start,
                            .to = start,
                            .center = center,
                            .turn = geometry::Turn::clockwise,
                            .plane = geometry::Plane::xy,
                            .feed_mm_per_min = 100};
  return item;
}

std::string path_svg(std::span<const PathItem> path, const PictureOptions& options) {
  const auto strokes = strokes_of(path);
  return svg_of(path_picture({.path = strokes, .contour = {}}, options));
}

/// All points of the polylines of a class, in pixels.
std::vector<Flat> points_of(const std::string& svg, const std::string& style) {
  std::vector<Flat> points;
  const std::regex polyline("<polyline class=\"" + style + "\" points=\"([^\"]*)\"/>");
  const std::regex pair("([-0-9.]+),([-0-9.]+)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), polyline), end; it != end; ++it) {
    const std::string list = (*it)[1];
    for (std::sregex_iterator point(list.begin(), list.end(), pair); point != end; ++point)
      points.push_back({std::stod((*point)[1]), std::stod((*point)[2])});
  }
  return points;
}

TEST(PathPicture, DrawsRapidsDashedAndFeedsSolid) {
  const std::vector path{line({}, {10, 0, 0}, true), line({10, 0, 0}, {10, 10, 0}, false)};
  const std::string svg = path_svg(path, {.title = "P0001"});
  EXPECT_EQ(points_of(svg, "rapid").size(), 2u);
  EXPECT_EQ(points_of(svg, "feed").size(), 2u);
  EXPECT_THAT(svg, HasSubstr(".rapid{fill:none;stroke:#c04000;stroke-width:1.4;stroke-dasharray"));
  EXPECT_THAT(svg, HasSubstr(">P0001</text>"));
  EXPECT_THAT(svg, HasSubstr(">Start</text>"));
  EXPECT_THAT(svg, HasSubstr(">Ende</text>"));
  EXPECT_THAT(svg, HasSubstr(">X / mm</text>"));
  EXPECT_THAT(svg, HasSubstr(">Y / mm</text>"));
}

TEST(PathPicture, KeepsOneScaleForBothAxesAndPutsYUpwards) {
  const std::vector path{line({}, {100, 0, 0}, false), line({100, 0, 0}, {100, 50, 0}, false)};
  const auto points = points_of(path_svg(path, {.title = "t"}), "feed");
  ASSERT_EQ(points.size(), 3u);
  const double right = points[1].right - points[0].right, up = points[1].up - points[2].up;
  EXPECT_NEAR(right, 2 * up, 0.05);
  EXPECT_GT(up, 0);
}

TEST(PathPicture, ACircleIsRoundAndStaysInsideTheSheet) {
  const auto points = points_of(path_svg(std::vector{circle({}, {20, 0, 0})}, {.title = "t"}), "feed");
  ASSERT_GT(points.size(), 70u);
  Bounds bounds;
  for (const Flat& point : points) bounds.take(point);
  EXPECT_NEAR(bounds.right - bounds.left, bounds.high - bounds.low, 0.5);
  EXPECT_GE(bounds.left, 0);
  EXPECT_LE(bounds.right, Sheet::kWidth_px);
  EXPECT_GE(bounds.low, 0);
  EXPECT_LE(bounds.high, Sheet::kHeight_px);
}

TEST(PathPicture, ViewsLookAlongTheirAxis) {
  EXPECT_EQ(project({1, 2, 3}, View::xy).up, 2);
  EXPECT_EQ(project({1, 2, 3}, View::xz).up, 3);
  EXPECT_EQ(project({1, 2, 3}, View::yz).right, 2);
  const Flat iso = project({1, 1, 1}, View::iso);
  EXPECT_NEAR(iso.right, 0, 1e-12);
  EXPECT_NEAR(iso.up, 2, 1e-12);
}

TEST(PathPicture, WorkpieceIsThatOfTheSimulatedMachine_DEC24) {
  const Box box = standard_workpiece({10, 20, 5});
  EXPECT_EQ(box.low, (Point{-50, -20, -30}));
  EXPECT_EQ(box.high, (Point{70, 60, 0}));
  const std::string svg = path_svg({}, {.title = "t", .workpiece = box});
  EXPECT_THAT(svg, HasSubstr("class=\"workpiece\""));
}

TEST(PathPicture, TitlesAreEscaped) {
  const std::string svg = path_svg({}, {.title = "<b>&\"x\""});
  EXPECT_THAT(svg, HasSubstr("&lt;b&gt;&amp;&quot;x&quot;"));
  EXPECT_THAT(svg, Not(HasSubstr("<b>")));
}

TEST(PathPicture, EmptyAndPointLikePathsGiveAWholeFile) {
  for (const auto view : {View::xy, View::xz, View::yz, View::iso}) {
    const std::string svg = path_svg(std::vector{line({1, 1, 1}, {1, 1, 1}, false)}, {.title = "t", .view = view});
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
    EXPECT_THAT(path_svg({}, {.title = "t", .view = view}), Not(HasSubstr("nan")));
  }
}

TEST(PathPicture, MarksStandAtRoundMillimetres) {
  for (const double size_mm : {0.02, 1.0, 37.0, 500.0, 90'000.0}) {
    Bounds bounds;
    bounds.take({0, 0});
    bounds.take({size_mm, size_mm});
    const double tick = Sheet(bounds).tick_mm();
    const double mantissa = tick / std::pow(10, std::floor(std::log10(tick) + 1e-9));
    EXPECT_TRUE(std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 || std::abs(mantissa - 5) < 1e-9)
        << tick;
    EXPECT_GE(Sheet(bounds).x(tick) - Sheet(bounds).x(0), 60 - 1e-9) << size_mm;
  }
}

}  // namespace
}  // namespace cnclab::drawing
