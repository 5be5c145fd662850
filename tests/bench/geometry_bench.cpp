// What the stages behind the program cost per element: nothing on, G42, and G42 with the gouge check.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "figure.hpp"
#include "geometry/contour_check.hpp"
#include "geometry/path_stages.hpp"

namespace {

using namespace cnclab;

constexpr double kToolRadius_mm = 2;

/// A pocket's spiral as lines of some 3 mm, 8 mm from turn to turn, with small waves: corners of both kinds.
std::vector<geometry::PathItem> spiral(int elements, geometry::OffsetSide side) {
  std::vector<geometry::PathItem> items;
  items.reserve(static_cast<std::size_t>(elements) + 2);
  const auto add = [&](const auto& what) {
    geometry::PathItem item;
    item.sequence = items.size() + 1;
    item.source = {1, static_cast<std::uint16_t>(items.size() % 999 + 1)};
    item.ends_block = true;
    item.what = what;
    items.push_back(item);
  };
  add(geometry::RadiusOffset{side, kToolRadius_mm, geometry::Plane::xy});
  geometry::Point at{0, 0, 0, 0};
  double angle = 0;
  for (int i = 0; i <= elements; ++i) {
    const double radius = 20 + 8 * angle / 6.283185307179586;
    angle += 3 / radius;
    const double waved = radius + 0.2 * std::sin(i * 0.9);
    const geometry::Point to{waved * std::cos(angle), waved * std::sin(angle), 0, 0};
    add(geometry::Line{at, to, 1500, false});
    at = to;
  }
  return items;
}

struct Measured {
  double ns_per_element = 0;
  std::size_t gouges = 0;
};

/// The median of several runs through fresh stages; `out` is emptied as the planner would do.
Measured run(const std::vector<geometry::PathItem>& items, bool with_check) {
  std::vector<double> times;
  Measured measured;
  std::vector<geometry::PathItem> out;
  out.reserve(1024);
  for (int repeat = 0; repeat < 9; ++repeat) {
    geometry::PathStages stages;
    geometry::ContourCheck check;
    const std::clock_t begin = std::clock();  // processor time: other work on the computer does not count
    for (const geometry::PathItem& item : items) {
      if (!stages.push(item, out, with_check ? &check : nullptr)) std::abort();
      if (out.size() >= 500) out.clear();
    }
    if (!stages.flush(out, with_check ? &check : nullptr)) std::abort();
    const double taken_ns = static_cast<double>(std::clock() - begin) * (1e9 / CLOCKS_PER_SEC);
    times.push_back(taken_ns / static_cast<double>(items.size()));
    measured.gouges = check.findings().size();
    out.clear();
  }
  measured.ns_per_element = bench::percentile(times, 0.5);
  return measured;
}

}  // namespace

int main() {
  for (const int elements : {1'000, 10'000, 100'000}) {
    const std::string count = std::to_string(elements);
    const auto off = spiral(elements, geometry::OffsetSide::off), right = spiral(elements, geometry::OffsetSide::right);
    bench::print_figure("stages_off_" + count, run(off, false).ns_per_element, "ns/element");
    bench::print_figure("stages_g42_" + count, run(right, false).ns_per_element, "ns/element");
    const Measured checked = run(right, true);
    if (checked.gouges != 0) std::abort();
    bench::print_figure("stages_g42_checked_" + count, checked.ns_per_element, "ns/element");
  }
  return 0;
}
