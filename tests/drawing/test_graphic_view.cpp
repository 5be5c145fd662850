// The picture of GRAFIK in dots: drawings in golden/ (CNCLAB_REDRAW=1 writes them anew, for review).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "drawing/graphic_view.hpp"
#include "steps_relief.hpp"

namespace cnclab::drawing {
namespace {

std::string text_of(const BrailleCanvas& canvas) {
  std::string text;
  for (int row = 0; row < BrailleCanvas::kCellRows; ++row) text += "|" + canvas.row_text(row) + "|\n";
  return text;
}

int dots_of(const BrailleCanvas& canvas) {
  int dots = 0;
  for (int row = 0; row < BrailleCanvas::kRows; ++row)
    for (int column = 0; column < BrailleCanvas::kColumns; ++column) dots += canvas.is_set(column, row) ? 1 : 0;
  return dots;
}

void expect_golden(const std::string& name, const std::string& drawn) {
  const std::filesystem::path file = std::filesystem::path(CNCLAB_TEST_DATA) / "golden" / (name + ".txt");
  if (std::getenv("CNCLAB_REDRAW") != nullptr) std::ofstream(file, std::ios::binary) << drawn;
  std::ostringstream golden;
  golden << std::ifstream(file, std::ios::binary).rdbuf();
  EXPECT_EQ(drawn, golden.str()) << file;
}

/// A pocket is cut: rapid to it, down, across and about, the tool still in it.
class GraphicView : public testing::Test {
 public:
  ShapedRelief part = pocket();
  std::vector<Stroke> path{
      {.is_rapid = true, .spots = {{-60, -40, 20}, {15, 0, 20}, {15, 0, 2}}},
      {.is_rapid = false, .spots = {{15, 0, 2}, {15, 0, -15}, {-15, 0, -15}, {0, 15, -15}, {0, -15, -15}}}};
  std::vector<Stroke> contour{{.is_rapid = false, .spots = {{-50, -30, 0}, {-50, 30, 0}, {-40, 30, 0}}}};
  Scene scene{.traces = {.path = path, .contour = contour},
              .workpiece = kBlock,
              .relief = &part,
              .tool = geometry::Point{0, -15, -15},
              .tool_radius_mm = 5};
};

TEST_F(GraphicView, EachViewIsDrawnAsReviewed_DEC_37) {
  expect_golden("xy", text_of(draw_scene(scene, {.view = View::xy})));
  expect_golden("xz", text_of(draw_scene(scene, {.view = View::xz})));
  expect_golden("yz", text_of(draw_scene(scene, {.view = View::yz})));
  expect_golden("iso", text_of(draw_scene(scene, {.view = View::iso})));
}

TEST_F(GraphicView, ZoomAndPanMoveTheWindow_DEC_37) {
  Window window{.view = View::xy};
  window.zoom_in();
  window.zoom_in();
  window.pan(1, 0);
  window.pan(0, 1);
  expect_golden("xy_close", text_of(draw_scene(scene, window)));
  for (int step = 0; step < 20; ++step) window.zoom_in();
  EXPECT_EQ(window.zoom, Window::kClosest);
  for (int step = 0; step < 20; ++step) window.zoom_out();
  EXPECT_EQ(window.zoom, Window::kFarthest);
  window.look(View::iso);
  EXPECT_EQ(window.zoom, 1);
  EXPECT_EQ(window.shift_right, 0);
}

TEST_F(GraphicView, DeeperIsDenser) {
  const auto dots_at = [](double depth) {
    const ShapedRelief flat{kBlock, [depth](double, double) { return -depth; }};
    return dots_of(draw_scene({.traces = {}, .workpiece = std::nullopt, .relief = &flat}, {.zoom = 0.25}));
  };
  int before = dots_at(0);
  EXPECT_EQ(before, 0);
  for (const double depth : {5.0, 15.0, 30.0}) {
    EXPECT_GT(dots_at(depth), before) << depth;
    before = dots_at(depth);
  }
}

TEST_F(GraphicView, NothingToSeeIsAnEmptyPicture) {
  EXPECT_EQ(dots_of(draw_scene({}, {})), 0);
  for (const View view : {View::xy, View::xz, View::yz, View::iso}) {
    Scene only_tool;
    only_tool.tool = geometry::Point{1e6, -1e6, 3};
    EXPECT_GT(dots_of(draw_scene(only_tool, {.view = view})), 3);
  }
}

}  // namespace
}  // namespace cnclab::drawing
