// Dots in cells (DEC-37).
#include <gtest/gtest.h>

#include "drawing/braille_canvas.hpp"

namespace cnclab::drawing {
namespace {

TEST(BrailleCanvas, IsMonitorRows3To15) {
  EXPECT_EQ(BrailleCanvas::kColumns, 128);
  EXPECT_EQ(BrailleCanvas::kRows, 52);
}

/// Each dot of a cell has its own code (Unicode, Braille Patterns).
TEST(BrailleCanvas, EachDotHasItsCode) {
  struct Row {
    int column, row;
    const char* text;
  };
  for (const auto& [column, row, text] : {Row{0, 0, "⠁"}, Row{0, 1, "⠂"}, Row{0, 2, "⠄"}, Row{0, 3, "⡀"},
                                          Row{1, 0, "⠈"}, Row{1, 1, "⠐"}, Row{1, 2, "⠠"}, Row{1, 3, "⢀"}}) {
    BrailleCanvas canvas;
    canvas.set(column, row);
    EXPECT_EQ(canvas.row_text(0), std::string(text) + std::string(63, ' ')) << text;
    EXPECT_TRUE(canvas.is_set(column, row));
    canvas.set(column, row, false);
    EXPECT_EQ(canvas.row_text(0), std::string(64, ' '));
  }
}

TEST(BrailleCanvas, LinesRunFromEndToEnd) {
  BrailleCanvas canvas;
  canvas.line({0.5, 0.5}, {127.5, 51.5});
  EXPECT_TRUE(canvas.is_set(0, 0));
  EXPECT_TRUE(canvas.is_set(127, 51));
  for (int column = 0; column < 128; ++column) {
    int dots = 0;
    for (int row = 0; row < 52; ++row) dots += canvas.is_set(column, row) ? 1 : 0;
    EXPECT_GE(dots, 1) << column;
  }
}

TEST(BrailleCanvas, WhatLiesOutsideIsCutOff) {
  BrailleCanvas canvas;
  canvas.line({-1e9, 10.5}, {1e9, 10.5});
  for (int column = 0; column < 128; ++column) EXPECT_TRUE(canvas.is_set(column, 10)) << column;
  BrailleCanvas empty;
  empty.line({-100, -5}, {500, -5});
  empty.line({200, -50}, {200, 500});
  empty.set(-1, 0);
  empty.set(0, 52);
  for (int row = 0; row < BrailleCanvas::kCellRows; ++row) EXPECT_EQ(empty.row_text(row), std::string(64, ' '));
}

TEST(BrailleCanvas, DashesGoOnFromStrokeToStroke) {
  BrailleCanvas canvas;
  int phase = 0;
  canvas.dashed_line({0.5, 0.5}, {10.5, 0.5}, phase);
  std::string seen;
  for (int column = 0; column < 11; ++column) seen += canvas.is_set(column, 0) ? '#' : '.';
  EXPECT_EQ(seen, "###..###..#");
  EXPECT_EQ(phase, 11);
}

}  // namespace
}  // namespace cnclab::drawing
