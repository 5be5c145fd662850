// Where the words of a block lead, and how a way enters the stream; shared by straight ways and arcs.
//
//   word (µm) × factor (1/1000) = way or target (nm) ──▶ Sollwert (nm) ──▶ + offset of G68 ──▶ path (mm)
#pragma once

#include <array>

#include "program/block_run.hpp"

namespace cnclab::program {

inline constexpr double kNanometresPerMm = 1e6;

[[nodiscard]] constexpr AxisSet axis_bit(std::size_t axis) { return static_cast<AxisSet>(1U << axis); }

/// Members of a Point by axis index: X 0, Y 1, Z 2.
inline constexpr std::array<double geometry::Point::*, 3> kPathAxes{&geometry::Point::x, &geometry::Point::y,
                                                                    &geometry::Point::z};

/// Axes by their index.
struct PlaneIndices {
  std::array<std::size_t, 2> in_plane;
  std::size_t normal;
};
[[nodiscard]] PlaneIndices indices_of(geometry::Plane plane);

/// Does the function move X, Y, Z to the end of its words: G00 to G03, G05 to G08, and those with exact stop?
[[nodiscard]] bool is_way(language::Function function);

/// Where a block leads.
struct Target {
  Nanometres programmed_nm{};
  std::array<std::int64_t, 3> unscaled_um{};  ///< as ExecutionState has it
  geometry::Point path;
  AxisSet named_axes = 0;  ///< axes that have a word
};

/// The end of the way that X, Y, Z of the block give (G-022, D-68, DEC-05).
/// errors: word_out_of_range where endless sums leave what a coordinate can hold
[[nodiscard]] std::expected<Target, language::Error> target_of(const BlockRun& run);

/// The modal F must be there and within F MAX (D-59, DEC-25: the lab machine's limit may be the smaller one).
[[nodiscard]] Outcome check_feed(const BlockRun& run);

/// The end of a way is the beginning of the next.
void arrive(BlockRun& run, const Target& target);

/// A straight way to `target`. A way of no length is no element: nothing moves and nothing has to stop for it. Where
/// compensation is at work it is one all the same, since it may be the way on which that is entered or left.
void go_straight(BlockRun& run, const Target& target, double feed_mm_per_min, bool is_rapid);

/// The way along `arc` to `target`.
void go_round(BlockRun& run, const Target& target, const geometry::Arc& arc);

/// A value in mm as messages show it.
[[nodiscard]] std::string in_mm(double value_mm);

}  // namespace cnclab::program
