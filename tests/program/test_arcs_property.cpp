// Random arcs: those by radius have it and the right sweep; the pulses of a helix are those that one would count.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/path_math.hpp"
#include "random_cases.hpp"
#include "run_text.hpp"

namespace cnclab::program {
namespace {

using geometry::Arc;
using geometry::Plane;
using language::Address;
using language::Block;
using language::Function;
using language::Word;

int any_of(int least, int most) { return *rc::gen::inRange(least, most + 1); }

Block block(int number, int code, language::Words words = {}) {
  return {.number = static_cast<std::uint16_t>(number),
          .function = {Function::Kind::g, static_cast<std::uint8_t>(code)},
          .words = std::move(words)};
}

RunResult run_blocks(std::vector<Block> blocks) {
  ProgramSet programs;
  programs.put({.number = 1, .blocks = std::move(blocks)});
  return run_programs(programs, wide_settings(), {});
}

/// The words of an arc's end in each plane.
struct PlaneRow {
  Plane plane;
  int code;
  Address first, second;
};
constexpr std::array kPlanes{PlaneRow{Plane::xy, 17, Address::X, Address::Y},
                             PlaneRow{Plane::xz, 18, Address::X, Address::Z},
                             PlaneRow{Plane::yz, 19, Address::Y, Address::Z}};

RC_GTEST_PROP(ArcProperty, ByRadiusHasItAndTheShorterOrLongerSweep_D66, ()) {
  const PlaneRow& row = kPlanes.at(static_cast<std::size_t>(any_of(0, 2)));
  const int first = any_of(-90'000, 90'000), second = any_of(-90'000, 90'000);
  RC_PRE(first != 0 || second != 0);
  const int half_chord = static_cast<int>(std::ceil(std::hypot(first, second) / 2));
  const int radius = half_chord + any_of(0, 200'000);
  const bool is_longer = any_of(0, 1) == 1;
  const int code = any_of(5, 6);
  const RunResult run = run_blocks(
      {block(1, row.code), block(2, 11, {word(Address::F, 500)}),
       block(3, code,
             {word(row.first, first), word(Address::R, is_longer ? -radius : radius), word(row.second, second)})});
  RC_ASSERT(!run.error);
  const auto arcs = all_of<Arc>(run);
  RC_ASSERT(arcs.size() == 1u);
  const geometry::ArcShape shape = geometry::shape_of(arcs[0]);
  RC_ASSERT(arcs[0].plane == row.plane);
  RC_ASSERT(std::abs(shape.start_radius - radius / 1000.0) < 1e-9);
  RC_ASSERT(std::abs(shape.end_radius - radius / 1000.0) < 1e-9);
  RC_ASSERT((shape.sweep > 0) == (code == 6));
  constexpr double kNoise = 1e-6;
  const double beyond_half = std::abs(shape.sweep) - std::numbers::pi;
  RC_ASSERT((is_longer ? beyond_half : -beyond_half) > -kNoise);
}

/// Pulses of X and Y along an arc, counted on the way: at each of very many points the axes stand at the nearest step.
std::int64_t counted_pulses(const Arc& arc, double steps_per_mm) {
  constexpr int kPoints = 50'000;
  const geometry::ArcShape shape = geometry::shape_of(arc);
  std::int64_t pulses = 0, x = 0, y = 0;
  for (int i = 1; i <= kPoints; ++i) {
    const geometry::Point at = geometry::point_at(arc, shape, shape.length * i / kPoints);
    const std::int64_t next_x = std::llround((at.x - arc.from.x) * steps_per_mm);
    const std::int64_t next_y = std::llround((at.y - arc.from.y) * steps_per_mm);
    pulses += std::abs(next_x - x) + std::abs(next_y - y);
    x = next_x;
    y = next_y;
  }
  return pulses;
}

RC_GTEST_PROP(ArcProperty, HelixPulsesAreThoseCounted_D65, ()) {
  const int i = any_of(-9000, 9000), j = any_of(-9000, 9000);
  RC_PRE(std::hypot(i, j) > 1000);
  const double turned = any_of(1, 35) * std::numbers::pi / 18;
  const double start = std::atan2(-j, -i), radius = std::hypot(i, j);
  const int code = any_of(7, 8);
  const double end = code == 8 ? start + turned : start - turned;
  const int x = static_cast<int>(std::lround(i + radius * std::cos(end)));
  const int y = static_cast<int>(std::lround(j + radius * std::sin(end)));
  const auto helix = [&](int pulses_of_z) {
    constexpr int kMicrometresPerStep = 5;
    return run_blocks({block(1, 11, {word(Address::F, 500)}),
                       block(2, code,
                             {word(Address::X, x), word(Address::Y, y), word(Address::I, i), word(Address::J, j),
                              word(Address::Z, pulses_of_z * kMicrometresPerStep)})});
  };
  const RunResult flat = helix(0);
  RC_ASSERT(!flat.error);
  const auto counted = static_cast<int>(counted_pulses(all_of<Arc>(flat).at(0), wide_settings().steps_per_mm[0]));
  constexpr int kAtTurns = 4;  // where an axis turns back, rounding may make a step there and back, or none
  RC_ASSERT(!helix(counted - kAtTurns - 1).error);
  RC_ASSERT(helix(counted + kAtTurns).error);
}

}  // namespace
}  // namespace cnclab::program
