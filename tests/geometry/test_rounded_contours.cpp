// Tangential contours whose coordinates are rounded, as on any drawing (D-55, D-71, COMP-011): they run, and the tool's
// centre keeps beside the contour that was meant.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "seeded.hpp"
#include "slow_contour.hpp"
#include "stage_rig.hpp"

namespace {

using namespace rig;
using Kind = StageFault::Kind;
using std::numbers::pi;

constexpr double kRounding = 0.0016;  ///< mm: a centre and a start rounded to 1/1000, with some numerical noise

/// A fillet, and the line behind it that touches it.
struct Turning {
  double radius = 0, sweep = 0;  ///< mm, radians > 0 left
  double length = 0;             ///< mm of the line; 0: the next fillet touches this one
};

struct Drawing {
  double tool_radius = 0;
  bool is_left = false;
  double heading = 0, length = 0;  ///< of the first line
  std::vector<Turning> turnings{};
};

/// The contour as meant: every joint exactly tangential.
std::vector<PathElement> meant_by(const Drawing& drawing) {
  std::vector<PathElement> elements;
  Point at;
  double heading = drawing.heading;
  const auto go = [&](double length) {
    const Point to{at.x + length * std::cos(heading), at.y + length * std::sin(heading)};
    elements.emplace_back(Line{at, to, 1000});
    at = to;
  };
  go(drawing.length);
  for (const Turning& turning : drawing.turnings) {
    const double sense = turning.sweep > 0 ? 1 : -1;
    const Point center{at.x - sense * turning.radius * std::sin(heading),
                       at.y + sense * turning.radius * std::cos(heading)};
    heading += turning.sweep;
    const Point to{center.x + sense * turning.radius * std::sin(heading),
                   center.y - sense * turning.radius * std::cos(heading)};
    elements.emplace_back(Arc{at, to, center, sense > 0 ? Turn::counterclockwise : Turn::clockwise, Plane::xy, 1000});
    at = to;
    if (turning.length > 0) go(turning.length);
  }
  return elements;
}

Point rounded(const Point& point, double unit_mm) {
  return {std::round(point.x / unit_mm) * unit_mm, std::round(point.y / unit_mm) * unit_mm};
}

/// The contour as printed.
std::vector<PathElement> printed(std::vector<PathElement> elements, double unit_mm) {
  for (PathElement& element : elements) {
    std::visit(
        [&](auto& way) {
          way.from = rounded(way.from, unit_mm);
          way.to = rounded(way.to, unit_mm);
        },
        element);
    if (auto* arc = std::get_if<Arc>(&element)) arc->center = rounded(arc->center, unit_mm);
  }
  return elements;
}

double radius_at(const Point& point, const Arc& arc) {
  return std::hypot(point.x - arc.center.x, point.y - arc.center.y);
}

/// By how much the two radii of an arc differ; the program refuses more than 0.020 (D-55).
double radius_error(const PathElement& element) {
  const auto* arc = std::get_if<Arc>(&element);
  return arc == nullptr ? 0 : std::abs(radius_at(arc->from, *arc) - radius_at(arc->to, *arc));
}

/// Entry and exit square to the contour, from the free side and to it.
Part program_of(const std::vector<PathElement>& elements, const Drawing& drawing) {
  const double to_left = (drawing.tool_radius + 1) * (drawing.is_left ? 1 : -1);
  const slow::Spot begin = slow::spot_at(elements.front(), 0, to_left),
                   end = slow::spot_at(elements.back(), 1, to_left);
  const slow::Spot corner = slow::spot_at(elements.front(), 0);
  Part part;
  part.from(begin.x, begin.y).radius(drawing.is_left ? OffsetSide::left : OffsetSide::right, drawing.tool_radius);
  part.line(corner.x, corner.y);
  for (const PathElement& element : elements) std::visit([&](const auto& way) { part.add(way); }, element);
  const Point last = std::visit([](const auto& way) { return way.to; }, elements.back());
  return part.from(last.x, last.y).off().line(end.x, end.y);
}

/// How far a spot is from the normal offset of an element whose radius changes evenly with the angle (D-55).
double error_beside(slow::Spot spot, const PathElement& element, double to_left) {
  const auto* arc = std::get_if<Arc>(&element);
  if (arc == nullptr) {
    const slow::Spot from = slow::spot_at(element, 0, to_left), to = slow::spot_at(element, 1, to_left);
    const double x = to.x - from.x, y = to.y - from.y;
    return std::abs((spot.x - from.x) * y - (spot.y - from.y) * x) / std::hypot(x, y);
  }
  Arc to_spot = *arc;
  to_spot.to = {spot.x, spot.y};
  double share = slow::swept(to_spot) / slow::swept(*arc);
  if (share > 1.5) share = 0;  // ahead of the start by rounding
  const double sense = arc->turn == Turn::counterclockwise ? 1 : -1;
  const double radius = std::lerp(radius_at(arc->from, *arc), radius_at(arc->to, *arc), share) - sense * to_left;
  return std::abs(radius_at(to_spot.to, *arc) - radius);
}

/// Fillets larger than the tool by that much.
Drawing any_drawing(int least_um, int most_um) {
  const auto number = [](int least, int most) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
  };
  Drawing drawing{.tool_radius = number(1, 24) / 4.0,
                  .is_left = *rc::gen::arbitrary<bool>(),
                  .heading = number(0, 6283) / 1000.0,
                  .length = number(8'000, 40'000) / 1000.0};
  const int count = number(1, 3);
  for (int i = 0; i < count; ++i) {
    const double radius = drawing.tool_radius + number(least_um, most_um) / 1000.0;
    const double degrees = number(8, 45) * (number(0, 1) == 0 ? 1 : -1);
    const bool has_line = i + 1 == count || number(0, 2) > 0;
    drawing.turnings.push_back(
        {.radius = radius, .sweep = degrees / 180 * pi, .length = has_line ? number(8'000, 40'000) / 1000.0 : 0});
  }
  return drawing;
}

void print(const Drawing& drawing, std::ostream& os) {
  os << "R " << drawing.tool_radius << (drawing.is_left ? " left" : " right") << ", line " << drawing.length << " at "
     << drawing.heading;
  for (const Turning& turning : drawing.turnings)
    os << ", fillet " << turning.radius << " by " << turning.sweep << ", line " << turning.length;
}

/// The ways beside the contour against the contour as printed and as meant.
void assert_beside(const Outcome& outcome, const std::vector<PathElement>& contour,
                   const std::vector<PathElement>& meant, const Drawing& drawing, double unit_mm) {
  const double to_left = drawing.is_left ? drawing.tool_radius : -drawing.tool_radius;
  double way_length = 0, meant_length = 0, known_mm = kRounding;
  for (const PathElement& element : contour) known_mm = std::max(known_mm, kRounding + radius_error(element));
  for (const PathItem& item : outcome.items) {
    const std::size_t index = item.source.block - kFirstBlock;
    if (item.source.block < kFirstBlock || index >= contour.size()) continue;
    PathElement way;
    if (const auto* line = std::get_if<Line>(&item.what)) way = *line;
    if (const auto* arc = std::get_if<Arc>(&item.what)) way = *arc;
    if (!std::holds_alternative<Line>(item.what) && !std::holds_alternative<Arc>(item.what)) continue;
    way_length += slow::length(way);
    for (const double t : {0.0, 0.13, 0.5, 0.87, 1.0}) {
      const slow::Spot spot = slow::spot_at(way, t);
      const bool is_corner = !item.ends_block;
      if (!is_corner) RC_ASSERT(error_beside(spot, contour[index], to_left) < known_mm);
      RC_ASSERT(std::abs(slow::distance(spot, meant[index]) - drawing.tool_radius) < 3 * unit_mm);
    }
  }
  for (const PathElement& element : meant) {
    const auto* arc = std::get_if<Arc>(&element);
    const double side = arc == nullptr ? 0 : (arc->turn == Turn::counterclockwise ? to_left : -to_left);
    meant_length +=
        arc == nullptr ? slow::length(element) : slow::length(element) * (1 - side / radius_at(arc->from, *arc));
  }
  RC_ASSERT(std::abs(way_length - meant_length) < 5 * unit_mm * static_cast<double>(contour.size()));
}

void assert_runs(const Drawing& drawing, double unit_mm) {
  const std::vector<PathElement> meant = meant_by(drawing), contour = printed(meant, unit_mm);
  RC_PRE(std::ranges::all_of(contour, [](const PathElement& element) { return radius_error(element) <= 0.020; }));
  const Outcome outcome = run(program_of(contour, drawing));
  RC_ASSERT(!outcome.fault);
  RC_ASSERT(outcome.gouges.empty());
  expect_sound(outcome, "rounded");
  assert_beside(outcome, contour, meant, drawing, unit_mm);
}

RC_GTEST_PROP(RoundedContours, InThousandthsRunBesideWhatWasMeant_D55_COMP011, ()) {
  RC_PRE(kSeeded);
  const Drawing drawing = any_drawing(20, 20'000);
  print(drawing, RC_LOG());
  assert_runs(drawing, 0.001);
}

RC_GTEST_PROP(RoundedContours, InHundredthsRunBesideWhatWasMeant_D55_COMP011, ()) {
  const Drawing drawing = any_drawing(20, 20'000);
  print(drawing, RC_LOG());
  assert_runs(drawing, 0.010);
}

/// The tool turns on a point, where it is inside.
RC_GTEST_PROP(RoundedContours, FilletsOfTheToolsRadiusRun_D55_D71, ()) {
  const Drawing drawing = any_drawing(0, 0);
  print(drawing, RC_LOG());
  assert_runs(drawing, 0.001);
}

}  // namespace
