// Drawings and programs of the lesson. The curves are worked out from the drawing (corners, centres, radii, angles) and
// know nothing of blocks; the programs are what a student writes. Times aim at 2.5 to 5 s with F MAX 3000 and RAMPE
// 100.
#include "parts.hpp"

#include <cmath>
#include <numbers>

namespace cnclab::lesson {

namespace {

constexpr double kPi = std::numbers::pi;

Arc arc_xy(Turn turn, double centre_x, double centre_y, double to_x, double to_y) {
  return {Plane::xy, turn, {centre_x, centre_y, 0}, {to_x, to_y, 0}};
}

/// A length as a drawing states it: in 1/1000 mm.
double to_thousandths(double mm) { return std::round(mm * 1000) / 1000; }

Part rectangle() {
  return {.student = "anna",
          .title = "rectangle 30 x 20, incremental",
          .programs = {{1, {"G91", "G11 F3000 S2000 M03", "G01 X30", "G01 Y20", "G01 X-30", "G01 Y-20 M05"}}},
          .curves = {Line{{30, 0, 0}}, Line{{30, 20, 0}}, Line{{0, 20, 0}}, Line{{0, 0, 0}}},
          .rests = {},
          .shown_at_end = {}};
}

Part triangle() {
  return {.student = "bernd",
          .title = "equilateral triangle, absolute",
          .programs = {{1, {"G90", "G68 X0 Y0 Z0", "G11 F3000", "G01 X40 Y0", "G01 X20 Y34.641", "G01 X0 Y0", "G91"}}},
          .curves = {Line{{40, 0, 0}}, Line{{20, to_thousandths(20 * std::tan(kPi / 3)), 0}}, Line{{0, 0, 0}}},
          .is_absolute = true,
          .rests = {},
          .shown_at_end = {}};
}

Part manuals_circle() {
  return {
      .student = "clara",
      .title = "P0001 of the manual's appendix",
      .programs = {{1,
                    {"G11 F3000", "G01 X20 Y20", "G02 X0.005 Y-0.005 I10 J10", "G01 X-0.005 Y0.005", "G01 X-20 Y-20"}}},
      .curves = {Line{{20, 20, 0}}, arc_xy(Turn::cw, 30, 30, 20.005, 19.995), Line{{20, 20, 0}}, Line{{0, 0, 0}}},
      .rests = {},
      .shown_at_end = {}};
}

Part circle_in_two_blocks() {
  return {.student = "dieter",
          .title = "full circle in two blocks",
          .programs = {{1, {"G17", "G91", "G11 F3000", "G02 X0.005 Y-0.005 I20 J0", "G01 X-0.005 Y0.005"}}},
          .curves = {arc_xy(Turn::cw, 20, 0, 0.005, -0.005), Line{{0, 0, 0}}},
          .rests = {},
          .shown_at_end = {}};
}

Part circle_in_one_block() {
  return {.student = "elif",
          .title = "full circle in one block, with lead-in",
          .programs = {{1, {"G17", "G91", "G01 X15 F3000", "G03 X0 Y0 I-15 J0", "G01 X-15"}}},
          .curves = {Line{{15, 0, 0}}, arc_xy(Turn::ccw, 0, 0, 15, 0), Line{{0, 0, 0}}},
          .rests = {},
          .shown_at_end = {}};
}

Part slot() {
  return {
      .student = "franz",
      .title = "long hole, two half circles",
      .programs = {{1, {"G17", "G91", "G01 X30 F3000", "G03 X0 Y20 I0 J10", "G01 X-30", "G03 X0 Y-20 I0 J-10"}}},
      .curves = {Line{{30, 0, 0}}, arc_xy(Turn::ccw, 30, 10, 30, 20), Line{{0, 20, 0}}, arc_xy(Turn::ccw, 0, 10, 0, 0)},
      .rests = {},
      .shown_at_end = {}};
}

// G18 is seen against +Y: angles count from Z towards X (D-128). Clockwise from (10, 0) about (20, 0) the tool goes
// down through Z -10; counterclockwise from (30, 15) about (20, 15) it also goes down, through Z 5.
Part arches_in_xz() {
  const Arc down{Plane::xz, Turn::cw, {20, 0, 0}, {30, 0, 0}};
  const Arc back{Plane::xz, Turn::ccw, {20, 0, 15}, {10, 0, 15}};
  return {.student = "greta",
          .title = "two half circles in XZ",
          .programs = {{1,
                        {"G18", "G91", "G01 X10 F3000", "G02 X20 Z0 I10 K0", "G01 Z15", "G03 X-20 Z0 I-10 K0",
                         "G01 X-10 Z-15", "G17"}}},
          .curves = {Line{{10, 0, 0}}, down, Line{{30, 0, 15}}, back, Line{{0, 0, 0}}},
          .view = "xz",
          .rests = {},
          .shown_at_end = {}};
}

Part rounded_frame_in_yz() {
  const auto corner = [](double centre_y, double centre_z, double to_y, double to_z) {
    return Arc{Plane::yz, Turn::ccw, {0, centre_y, centre_z}, {0, to_y, to_z}};
  };
  return {.student = "hakan",
          .title = "rounded frame in YZ",
          .programs = {{1,
                        {"G19", "G91", "G01 Y16 F3000", "G03 Y8 Z8 J0 K8", "G01 Z10", "G03 Y-8 Z8 J-8 K0", "G01 Y-16",
                         "G03 Y-8 Z-8 J0 K-8", "G01 Z-10", "G03 Y8 Z-8 J8 K0", "G17"}}},
          .curves = {Line{{0, 16, 0}}, corner(16, 8, 24, 8), Line{{0, 24, 18}}, corner(16, 18, 16, 26),
                     Line{{0, 0, 26}}, corner(0, 18, -8, 18), Line{{0, -8, 8}}, corner(0, 8, 0, 0)},
          .view = "yz",
          .rests = {},
          .shown_at_end = {}};
}

Part row_of_holes() {
  std::vector<Curve> curves;
  for (int hole = 1; hole <= 3; ++hole) {
    const double x = 10.0 * hole;
    curves.insert(curves.end(), {Line{{x, 0, 0}}, Line{{x, 0, -4}}, Line{{x, 0, 0}}});
  }
  curves.emplace_back(Line{{0, 0, 0}});
  return {.student = "ilse",
          .title = "row of holes, subprogram with W02",
          .programs = {{1, {"G91", "G11 F3000 M08", "G22 P0002 N001 W02", "G00 X-30", "G11 M09"}},
                       {2, {"G00 X10", "G01 Z-4", "G00 Z4"}}},
          .curves = curves,
          .view = "xz",
          .rests = {},
          .shown_at_end = {}};
}

Part wave() {
  std::vector<Curve> curves;
  for (int i = 0; i < 3; ++i) {
    const double x = 16.0 * i;
    curves.emplace_back(arc_xy(Turn::ccw, x + 4, 0, x + 8, 0));
    curves.emplace_back(arc_xy(Turn::cw, x + 12, 0, x + 16, 0));
  }
  curves.emplace_back(Line{{0, 0, 0}});
  return {.student = "jonas",
          .title = "wave of half circles, W02",
          .programs = {{1, {"G17", "G91", "G11 F3000", "G22 P0010 N001 W02", "G00 X-48"}},
                       {10, {"G03 X8 Y0 I4 J0", "G02 X8 Y0 I4 J0"}}},
          .curves = curves,
          .rests = {},
          .shown_at_end = {}};
}

Part stairs() {
  std::vector<Curve> curves;
  double x = 0, y = 0, z = 0;
  for (int flight = 0; flight < 2; ++flight) {
    for (int step = 0; step < 2; ++step) {
      x += 6;
      curves.emplace_back(Line{{x, y, z}});
      y += 4;
      curves.emplace_back(Line{{x, y, z}});
    }
    z += 2;
    curves.emplace_back(Line{{x, y, z}});
  }
  curves.emplace_back(Line{{0, 0, 0}});
  return {.student = "karla",
          .title = "stairs, subprogram in a subprogram",
          .programs = {{1, {"G91", "G11 F3000", "G22 P0002 N001 W01", "G01 X-24 Y-16 Z-4"}},
                       {2, {"G22 P0003 N001 W01", "G01 Z2"}},
                       {3, {"G01 X6", "G01 Y4"}}},
          .curves = curves,
          .view = "iso",
          .rests = {},
          .shown_at_end = {}};
}

// A five-pointed star in a circle of radius 12; the tool starts at the top point and joins every second corner.
Part star() {
  std::vector<Curve> curves;
  for (int i = 1; i <= 5; ++i) {
    const double angle = kPi / 2 + i * 4 * kPi / 5;
    curves.emplace_back(Line{{to_thousandths(12 * std::cos(angle)), to_thousandths(12 * std::sin(angle) - 12), 0}});
  }
  return {.student = "lukas",
          .title = "five-pointed star, absolute",
          .programs = {{1,
                        {"G90", "G68 X0 Y0 Z0", "G11 F3000", "G01 X-7.053 Y-21.708", "G01 X11.413 Y-8.292",
                         "G01 X-11.413 Y-8.292", "G01 X7.053 Y-21.708", "G01 X0 Y0", "G91"}}},
          .curves = curves,
          .is_absolute = true,
          .rests = {},
          .shown_at_end = {}};
}

// Half circles that grow: each begins where the last one ends, with the same tangent, on the X axis.
Part spiral() {
  std::vector<Curve> curves;
  double x = 0;
  double side = -1;
  for (const double radius : {4.0, 6.0, 8.0, 10.0}) {
    curves.emplace_back(arc_xy(Turn::ccw, x + side * radius, 0, x + 2 * side * radius, 0));
    x += 2 * side * radius;
    side = -side;
  }
  curves.emplace_back(Line{{0, 0, 0}});
  return {.student = "mira",
          .title = "spiral of half circles",
          .programs = {{1,
                        {"G17", "G91", "G11 F3000", "G03 X-8 Y0 I-4 J0", "G03 X12 Y0 I6 J0", "G03 X-16 Y0 I-8 J0",
                         "G03 X20 Y0 I10 J0", "G00 X-8"}}},
          .curves = curves,
          .rests = {},
          .shown_at_end = {}};
}

// After the dwell the place gets the name 0/0/0; from there the drawing is in absolute dimensions.
Part shifted_zero() {
  return {.student = "noah",
          .title = "dwell, zero set by G68, then absolute",
          .programs = {{1,
                        {"G91", "G01 X20 Y10 F3000", "G04 H0005", "G68 X0 Y0 Z0", "G90", "G01 X15 Y0 Z-5",
                         "G01 X15 Y15", "G01 X-20 Y-10 Z0", "G91"}}},
          .curves = {Line{{20, 10, 0}}, Line{{35, 10, -5}}, Line{{35, 25, -5}}, Line{{0, 0, 0}}},
          .view = "iso",
          .is_absolute = true,
          .rests = {{{20, 10, 0}, 0.5}},
          .shown_at_end = {-20, -10, 0}};
}

// A regular hexagon with sides of 12, begun at its rightmost corner; G20 jumps over a block that nobody may run.
Part hexagon() {
  std::vector<Curve> curves;
  for (int i = 1; i <= 6; ++i) {
    const double angle = i * kPi / 3;
    curves.emplace_back(Line{{to_thousandths(12 * std::cos(angle) - 12), to_thousandths(12 * std::sin(angle)), 0}});
  }
  return {.student = "olga",
          .title = "hexagon, with a jump",
          .programs = {{1,
                        {"G91", "G01 X-6 Y10.392 F3000", "G01 X-12", "G01 X-6 Y-10.392", "G20 P0001 N007", "G00 Z-40",
                         "G01 X6 Y-10.392", "G01 X12", "G01 X6 Y10.392"}}},
          .curves = curves,
          .rests = {},
          .shown_at_end = {}};
}

}  // namespace

std::vector<Part> parts() {
  return {rectangle(),
          triangle(),
          manuals_circle(),
          circle_in_two_blocks(),
          circle_in_one_block(),
          slot(),
          arches_in_xz(),
          rounded_frame_in_yz(),
          row_of_holes(),
          wave(),
          stairs(),
          star(),
          spiral(),
          shifted_zero(),
          hexagon()};
}

}  // namespace cnclab::lesson
