// Lines are checked at their ends, arcs at their ends and wherever they reach furthest along an axis.
#include "panel/run/travel_guard.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "geometry/path_math.hpp"
#include "machine/manual_drives.hpp"

namespace cnclab::panel {

namespace {

using geometry::Point;

constexpr std::array<double Point::*, 3> kAxisOf{&Point::x, &Point::y, &Point::z};
constexpr int kFirstTravel = 3;        // MD 03..05
constexpr double kRounding_mm = 1e-6;  // a way that ends exactly on the limit is allowed

/// The points of an arc with the greatest and least coordinates: its ends and each quarter turn between them.
std::vector<Point> extremes_of(const geometry::Arc& arc) {
  constexpr double kQuarter = std::numbers::pi / 2;
  std::vector<Point> points{arc.from, arc.to};
  const geometry::ArcShape shape = geometry::shape_of(arc);
  const double end_angle = shape.start_angle + shape.sweep;
  const auto [least, most] = std::minmax(shape.start_angle, end_angle);
  for (auto quarter = std::lround(std::ceil(least / kQuarter)); static_cast<double>(quarter) * kQuarter < most;
       ++quarter) {
    const double angle = static_cast<double>(quarter) * kQuarter;
    const double way = shape.length * (angle - shape.start_angle) / shape.sweep;
    points.push_back(geometry::point_at(arc, shape, std::clamp(way, 0.0, shape.length)));
  }
  return points;
}

std::string millimetres(double value) {
  std::array<char, 32> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.3f", value);
  return {text.data(), static_cast<std::size_t>(std::clamp(length, 0, 31))};
}

}  // namespace

TravelGuard::TravelGuard(const std::array<double, 3>& machine_mm, const machine::MachineData& data,
                         const Point& start) {
  for (std::size_t axis = 0; axis < kAxisOf.size(); ++axis) {
    half_travel_[axis] = static_cast<double>(data.get(kFirstTravel + static_cast<int>(axis))) / 2000.0;
    place(axis, start.*kAxisOf[axis], machine_mm[axis]);
  }
}

/// What the path calls `path_mm` is `machine_mm` from the middle of the travel.
void TravelGuard::place(std::size_t axis, double path_mm, double machine_mm) {
  low_[axis] = path_mm - machine_mm - half_travel_[axis];
  high_[axis] = path_mm - machine_mm + half_travel_[axis];
}

/// The axes come to stand 1 mm before their switches (MOD-012); G-693: 0 drives in positive direction.
void TravelGuard::note_reference(const geometry::Reference& reference) {
  for (std::size_t axis = 0; axis < kAxisOf.size(); ++axis) {
    if (!reference.axes[axis]) continue;
    const double place = half_travel_[axis] - machine::SwitchDrive::kBackOff_mm;
    referenced_at_[axis] = reference.value[axis] < 0 ? -place : place;
  }
}

/// The path goes on from where the reference run has left the axes.
void TravelGuard::settle_references(const Point& from) {
  for (std::size_t axis = 0; axis < kAxisOf.size(); ++axis) {
    if (referenced_at_[axis]) place(axis, from.*kAxisOf[axis], *referenced_at_[axis]);
    referenced_at_[axis].reset();
  }
}

std::optional<language::Error> TravelGuard::fault_of(const geometry::PathItem& item) {
  if (const auto* reference = std::get_if<geometry::Reference>(&item.what)) note_reference(*reference);
  if (const auto* line = std::get_if<geometry::Line>(&item.what)) settle_references(line->from);
  if (const auto* arc = std::get_if<geometry::Arc>(&item.what)) settle_references(arc->from);
  std::vector<Point> points;
  if (const auto* line = std::get_if<geometry::Line>(&item.what)) points = {line->from, line->to};
  if (const auto* arc = std::get_if<geometry::Arc>(&item.what)) points = extremes_of(*arc);
  for (const Point& point : points) {
    for (std::size_t axis = 0; axis < kAxisOf.size(); ++axis) {
      const double value = point.*kAxisOf[axis];
      if (value >= low_[axis] - kRounding_mm && value <= high_[axis] + kRounding_mm) continue;
      return language::Error{.code = language::ErrorCode::travel_exceeded,
                             .program = item.source.program,
                             .block = item.source.block,
                             .word = "XYZ"[axis],
                             .detail = millimetres(value),
                             .expected = millimetres(low_[axis]) + ".." + millimetres(high_[axis])};
    }
  }
  return std::nullopt;
}

}  // namespace cnclab::panel
