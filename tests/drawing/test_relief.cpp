// Shading: what each view makes of removed material.
#include <gtest/gtest.h>

#include "steps_relief.hpp"

namespace cnclab::drawing {
namespace {

float shade_at(const Relief& relief, View view, double right, double up) {
  const Raster raster{.field = {.left = right - 1, .right = right + 1, .low = up - 1, .high = up + 1}};
  return shades_of(relief, view, raster).at(0);
}

TEST(Relief, FromAboveDepthCounts) {
  const ShapedRelief part = pocket();
  EXPECT_FLOAT_EQ(shade_at(part, View::xy, 0, 0), 0.5F);
  EXPECT_FLOAT_EQ(shade_at(part, View::xy, 50, 0), 0);
  EXPECT_FLOAT_EQ(shade_at(part, View::xy, 200, 0), 0);  // beside the workpiece
}

TEST(Relief, FromTheSideTheShareAlongTheLineOfSightCounts) {
  const ShapedRelief part = pocket();
  EXPECT_NEAR(shade_at(part, View::xz, 0, -5), 0.5, 0.02);      // 40 of 80 mm in Y are gone
  EXPECT_NEAR(shade_at(part, View::yz, 0, -5), 1.0 / 3, 0.02);  // 40 of 120 mm in X
  EXPECT_FLOAT_EQ(shade_at(part, View::xz, 0, -20), 0);         // below the pocket
  EXPECT_FLOAT_EQ(shade_at(part, View::xz, 30, -5), 0);
}

TEST(Relief, AtAnAngleTheFloorIsSeenAndWhatIsBehindAWallIsNot) {
  const ShapedRelief step{kBlock, [](double, double y) { return y < 0 ? 0.0 : -15.0; }};  // high in front, low behind
  const auto at = [&](double x, double y, double z) {
    const Flat flat = project({.x = x, .y = y, .z = z}, View::iso);
    return shade_at(step, View::iso, flat.right, flat.up);
  };
  EXPECT_FLOAT_EQ(at(0, 35, -15), 0.5F);
  EXPECT_FLOAT_EQ(at(0, -20, 0), 0);  // the untouched top
  EXPECT_FLOAT_EQ(at(0, 4, -15), 0);  // behind the edge of the front half, whose top is seen there
}

TEST(Relief, WallsAreHalfDark) {
  const ShapedRelief step{kBlock, [](double, double y) { return y < 0 ? -30.0 : 0.0; }};  // low in front
  const Flat wall = project({.x = 0, .y = 0, .z = -10}, View::iso);
  EXPECT_FLOAT_EQ(shade_at(step, View::iso, wall.right, wall.up), 0.5F);
}

TEST(Relief, RastersHaveTheirRowsFromTheTop) {
  const ShapedRelief half{kBlock, [](double, double y) { return y > 0 ? -30.0 : 0.0; }};
  const Raster raster{.field = {.left = -60, .right = 60, .low = -40, .high = 40}, .columns = 3, .rows = 2};
  EXPECT_EQ(shades_of(half, View::xy, raster), (std::vector<float>{1, 1, 1, 0, 0, 0}));
}

}  // namespace
}  // namespace cnclab::drawing
