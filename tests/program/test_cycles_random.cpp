// Random cycles, under G90 and G91, scaled and mirrored, against the step lists (rom-programs "Simulated").
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "cycle_oracle.hpp"
#include "cycle_run.hpp"
#include "random_cases.hpp"

namespace cnclab::program {
namespace {

std::string number(std::int64_t value, int digits) {
  std::ostringstream text;
  text << std::setfill('0') << std::setw(digits) << value;
  return text.str();
}

std::string length(char letter, std::int64_t um) {
  return letter + std::string(um < 0 ? "" : "+") + std::to_string(um);
}

std::string depth_words(const CycleWords& words, bool has_q) {
  return length('Z', words.z_um) + (has_q ? length('Q', words.q_um) : "") + 'V' + number(words.v_mm, 3) + 'H' +
         number(words.h_tenths, 4);
}

/// Q divides Z, or does not, or lies beyond it; at most `most` cuts.
CycleWords any_words(std::int64_t most) {
  CycleWords words;
  words.v_mm = static_cast<int>(between(1, 50));
  words.h_tenths = between(0, 2) == 0 ? 0 : static_cast<int>(between(1, 9999));
  words.q_um = -between(1, 20'000);
  words.z_um = between(0, 2) == 0 ? words.q_um * between(1, most) : -between(1, -words.q_um * most);
  return words;
}

/// Any place, between thousandths too; G90 or G91; factors 1, or scaled and mirrored.
Start any_start() {
  const std::int64_t grid_nm = between(0, 1) == 0 ? 1'000 : 1;
  const auto place = [&] {
    return static_cast<double>(between(-300'000'000 / grid_nm, 300'000'000 / grid_nm) * grid_nm) / 1e6;
  };
  Start start = between(0, 1) == 0 ? start_at(place(), place(), place()) : start_at(0, 0, 0);
  if (between(0, 1) == 0) start.modal.dimension = Dimension::absolute;
  if (between(0, 1) == 0) {
    start.modal.scale_on = true;
    for (std::int64_t& factor : start.modal.scale)
      factor = *rc::gen::element<std::int64_t>(1000, -1000, 500, -2000, 333, 1);
  }
  return start;
}

/// A place in µm from the point under the place of the call, as the words say it: without factors.
std::array<double, 3> unscaled_um(const Nanometres& at, const Start& start, const CycleWords& words) {
  const std::array<double, 3> from{start.position.x, start.position.y, start.position.z};
  std::array<double, 3> result{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t way_nm = at[axis] - std::llround(from[axis] * 1e6);
    result[axis] = static_cast<double>(way_nm) / static_cast<double>(start.modal.scale[axis]);
  }
  result[2] += words.v_mm * 1000;
  return result;
}

/// Every step, each axis within `tolerance_um` of its word; the last at the place of the call exactly.
void expect_steps(const RunResult& run, const Start& start, const CycleWords& words,
                  const std::vector<IdealStep>& ideal, const std::array<double, 3>& tolerance_um) {
  RC_ASSERT(!run.error);
  const std::vector<Step> steps = cycle_steps(run, start);
  RC_ASSERT(steps.size() == ideal.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    RC_ASSERT(steps[i].what == ideal[i].what);
    RC_ASSERT(steps[i].tenths == ideal[i].tenths);
    const std::array<double, 3> at_um = unscaled_um(steps[i].at, start, words);
    for (std::size_t axis = 0; axis < 3; ++axis)
      RC_ASSERT(std::abs(at_um[axis] - ideal[i].at_um[axis]) <= tolerance_um[axis] + 1e-6);
  }
  const std::array<double, 3> end_um = unscaled_um(steps.back().at, start, words);
  RC_ASSERT(end_um == (std::array<double, 3>{0, 0, words.v_mm * 1000.0}));
  RC_ASSERT(run.blocks.back().modal.dimension == Dimension::incremental);
}

constexpr std::array<double, 3> kExact{};

RC_GTEST_PROP(RandomCycles, DrillAsListed_CYC081_CYC082, ()) {
  for (int i = 0; i < 40; ++i) {
    const CycleWords words = any_words(12);
    const Start start = any_start();
    IdealCycle deep(words), plain(words);
    deep.drill(true);
    plain.drill(false);
    expect_steps(run_cycle("G82" + depth_words(words, true), start), start, words, deep.steps(), kExact);
    expect_steps(run_cycle("G81" + depth_words(words, false), start), start, words, plain.steps(), kExact);
  }
}

RC_GTEST_PROP(RandomCycles, CutThreadsAsListed_CYC083, ()) {
  for (int i = 0; i < 5; ++i) {
    const CycleWords words = any_words(12);
    const Start start = any_start();
    IdealCycle ideal(words);
    ideal.thread();
    expect_steps(run_cycle("G83" + depth_words(words, false), start), start, words, ideal.steps(), kExact);
  }
}

/// The half of an odd number of thousandths is rounded once (ROM-07).
RC_GTEST_PROP(RandomCycles, MillSlotsAsListed_CYC084, ()) {
  for (int i = 0; i < 15; ++i) {
    CycleWords words = any_words(8);
    words.cutter_um = between(0, 1) * between(1, 9'000);
    const std::int64_t length_um = 2 * words.cutter_um + between(words.cutter_um == 0 ? 2 : 0, 100'000);
    const std::size_t axis = static_cast<std::size_t>(between(0, 1));
    (axis == 0 ? words.x_um : words.y_um) = length_um;
    Start start = any_start();
    if (words.cutter_um == 0) start.modal.tool = 0;
    IdealCycle ideal(words);
    ideal.slot(axis);
    const RunResult run =
        run_cycle("G84" + length('X', words.x_um) + length('Y', words.y_um) + depth_words(words, true), start,
                  std::max<std::int64_t>(words.cutter_um, 1));
    expect_steps(run, start, words, ideal.steps(), {0.5, 0.5, 0});
  }
}

bool lies_on_thousandths(const geometry::Point& place) {
  return std::llround(place.x * 1e6) % 1000 == 0 && std::llround(place.y * 1e6) % 1000 == 0;
}

/// Radii up to 100 mm, where ROM-07 promises a thousandth. Half of one is the word's rounding, 0.15 µm are sine, cosine
/// and the sum of angles; where the place of the call lies between thousandths, its rounding is another half.
RC_GTEST_PROP(RandomCycles, DrillHoleCirclesAsListed_DEC03_ROM07, ()) {
  for (int i = 0; i < 4; ++i) {
    CycleWords words = any_words(4);
    words.r_um = between(1'000, 100'000);  // no two of 99 holes in the same thousandth
    words.d_degrees = static_cast<int>(between(0, 359));
    words.w_holes = static_cast<int>(between(1, 99));
    const bool has_q = between(0, 1) == 0;
    const Start start = any_start();
    IdealCycle ideal(words);
    ideal.hole_circle(has_q);
    const std::string block = "G86" + length('R', words.r_um) + 'D' + number(words.d_degrees, 3) + 'W' +
                              number(words.w_holes, 2) + depth_words(words, has_q);
    const double tolerance_um = lies_on_thousandths(start.position) ? 0.65 : 1.15;
    expect_steps(run_cycle(block, start), start, words, ideal.steps(), {tolerance_um, tolerance_um, 0});
  }
}

// G85: the path itself is given by its table; here is what every pocket must be.

struct Place {
  double x = 0, y = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

struct Layer {
  double floor_um = 0;
  std::vector<Place> path;
};

double distance_to_way(Place p, Place from, Place to) {
  const double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
  const double along = square == 0 ? 0 : std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / square, 0.0, 1.0);
  return std::hypot(p.x - from.x - along * dx, p.y - from.y - along * dy);
}

double distance_to_path(Place p, const std::vector<Place>& path) {
  double least = std::hypot(p.x - path.front().x, p.y - path.front().y);
  for (std::size_t i = 1; i < path.size(); ++i) least = std::min(least, distance_to_way(p, path[i - 1], path[i]));
  return least;
}

/// Takes the steps apart; rapids only at V, up to V, or down to 0.5 above the floor reached.
std::vector<Layer> layers_of(const RunResult& run, const Start& start, const CycleWords& words) {
  std::vector<Layer> layers;
  const double safety_um = words.v_mm * 1000.0;
  std::array<double, 3> from{0, 0, safety_um};
  for (const Step& step : cycle_steps(run, start)) {
    const std::array<double, 3> to = unscaled_um(step.at, start, words);
    const bool is_vertical = from[0] == to[0] && from[1] == to[1];
    const double floor_um = layers.empty() ? 0 : layers.back().floor_um;
    if (step.what == "rapid") {
      const bool at_safety = from[2] == safety_um && to[2] == safety_um;
      const bool is_lifted = is_vertical && to[2] == safety_um;
      const bool is_lowered = is_vertical && from[2] == safety_um && std::abs(to[2] - floor_um - 500) < 1e-6;
      RC_ASSERT(at_safety || is_lifted || is_lowered);
    } else if (is_vertical) {
      layers.push_back({.floor_um = to[2], .path = {{to[0], to[1]}}});
    } else {
      RC_ASSERT(!layers.empty() && to[2] == floor_um);
      layers.back().path.push_back({to[0], to[1]});
    }
    from = to;
  }
  RC_ASSERT(from == (std::array<double, 3>{0, 0, safety_um}));
  return layers;
}

void expect_depths(const std::vector<Layer>& layers, const CycleWords& words) {
  double floor_um = 0;
  for (const Layer& layer : layers) {
    floor_um = std::max(floor_um + static_cast<double>(words.q_um), static_cast<double>(words.z_um));
    RC_ASSERT(std::abs(layer.floor_um - floor_um) < 1e-6);
    RC_ASSERT(layer.path == layers.front().path);
  }
  RC_ASSERT(floor_um == static_cast<double>(words.z_um));
}

/// The cutter's centre stays where the cutter is inside the pocket, and no point that it can reach is left.
void expect_clear(const std::vector<Place>& path, const CycleWords& words) {
  constexpr double kRounding_um = 1.01;  // of the start point: of place and half length once each
  const auto radius = static_cast<double>(words.cutter_um);
  const double half_x = static_cast<double>(words.x_um) / 2 - radius,
               half_y = static_cast<double>(words.y_um) / 2 - radius;
  for (const Place& place : path) {
    RC_ASSERT(std::abs(place.x) <= half_x + kRounding_um);
    RC_ASSERT(std::abs(place.y) <= half_y + kRounding_um);
  }
  constexpr int kGrid = 24;
  for (int i = -kGrid; i <= kGrid; ++i) {
    for (int j = -kGrid; j <= kGrid; ++j) {
      const Place p{i * (half_x + radius) / kGrid, j * (half_y + radius) / kGrid};
      const double beyond = std::hypot(std::max(std::abs(p.x) - half_x, 0.0), std::max(std::abs(p.y) - half_y, 0.0));
      if (beyond <= radius) RC_ASSERT(distance_to_path(p, path) <= radius + 2 * kRounding_um);
    }
  }
}

RC_GTEST_PROP(RandomCycles, ClearPockets_CYC085_CYC090_CYC091, ()) {
  for (int i = 0; i < 4; ++i) {
    CycleWords words = any_words(5);
    words.cutter_um = between(501, 10'000);
    const auto side = [&] {
      return 2 * words.cutter_um + (between(0, 1) == 0 ? between(1, 1'000) : between(1, 40'000));
    };
    words.x_um = side();
    words.y_um = side();
    const Start start = any_start();
    const RunResult run = run_cycle(
        "G85" + length('X', words.x_um) + length('Y', words.y_um) + depth_words(words, true), start, words.cutter_um);
    RC_ASSERT(!run.error);
    const std::vector<Layer> layers = layers_of(run, start, words);
    RC_ASSERT(!layers.empty());
    expect_depths(layers, words);
    expect_clear(layers.front().path, words);
  }
}

}  // namespace
}  // namespace cnclab::program
