// The stages between the program and motion: the programmed path in, the path of the tool's centre out.
//
//   programmed items ──▶ round corners (G10) ──▶ offset the contour (G41, G42) ──▶ shift axes (G43, G44, G46) ──▶ path
//
// A stage that must know the next element before it can finish the last one holds that back, and every item behind it,
// so that the order of the stream never changes. Memory is that of one held element and the items behind it.
//
// A G10 comes behind its first line, so every G01 in whatever plane is held back until the next block is known.
#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <memory>
#include <vector>

#include "geometry/path_item.hpp"

namespace cnclab::geometry {

/// Why a contour cannot be followed (DEC-09, D-66, D-71), and the block to blame.
struct StageFault {
  enum class Kind : std::uint8_t {
    arc_at_entry_or_exit,    ///< an arc where only a line can go: entering, leaving (D-71)
    arc_under_axis_offset,   ///< an arc while G43/G44 shift, or have shifted, an axis of its plane (D-72)
    inside_arc_too_small,    ///< the tool does not fit into an arc
    no_intersection,         ///< the offset elements at an inside corner do not meet
    runs_backwards,          ///< between its two corners, or shortened by G44, an element would be run backwards
    too_close,               ///< another element of the chain lies within the tool's radius (see `ContourCheck`)
    entry_too_close,         ///< the same on the way that enters the chain (COMP-007)
    exit_too_close,          ///< the same on the way that leaves it
    rounding_without_lines,  ///< G10 not between two lines of the plane
    rounding_too_large,      ///< G10: the radius does not fit into one of the two lines; needed 0: a way back
  };
  Kind kind{};
  SourceBlock block;
  SourceBlock other;  ///< … too_close: the element that is hit; else as `block`
  /// What there is and what there ought to be, 0 and 0 where nothing is measured: radius of the arc and of the tool;
  /// length of the element and what its corners take of it; distance of the tool's centre and the tool's radius.
  double found_mm = 0, needed_mm = 0;
  friend bool operator==(const StageFault&, const StageFault&) = default;
};

/// A fault of the item's own block.
[[nodiscard]] inline std::unexpected<StageFault> fault_at(StageFault::Kind kind, const PathItem& item,
                                                          double found_mm = 0, double needed_mm = 0) {
  return std::unexpected(StageFault{
      .kind = kind, .block = item.source, .other = item.source, .found_mm = found_mm, .needed_mm = needed_mm});
}

class ContourCheck;

/// All stages, in their order. A value that can be copied: a copy goes on from the same state.
///
/// What holds: elements leave joined (no gap above 1 nm), `sequence` never falls, each block's last item has
/// `ends_block`, and no RadiusOffset, LengthOffset or CornerRounding leaves.
class PathStages {
 public:
  /// shift_mm   path minus programmed position of X, Y, Z at the start: what compensation has left behind (D-75). The
  ///            orders that are in force at the start must come as the first items, or the shift is taken back: in the
  ///            plane with the next line there, along its normal with the next line that moves or names that axis.
  explicit PathStages(const std::array<double, 3>& shift_mm = {});
  PathStages(const PathStages& other);
  PathStages(PathStages&&) noexcept;
  PathStages& operator=(const PathStages& other);
  PathStages& operator=(PathStages&&) noexcept;
  ~PathStages();

  /// Takes the next programmed item; appends to `out` whatever is finished now.
  /// check    hears of every element of compensated contours and of the ways beside it; may be null
  /// errors   the fault; what was appended before is right, and the path ends there (DEC-09): drop the stages then
  [[nodiscard]] std::expected<void, StageFault> push(const PathItem& item, std::vector<PathItem>& out,
                                                     ContourCheck* check = nullptr);

  /// Nothing follows (end of the program, an error of the program, a single block in HANDEINGABE): finishes
  /// what is held back as if the contour ended there, at the normal offset of its own end (D-75).
  [[nodiscard]] std::expected<void, StageFault> flush(std::vector<PathItem>& out, ContourCheck* check = nullptr);

  /// Is anything held back?
  [[nodiscard]] bool holds() const;

  /// Path minus programmed position after everything that has left.
  [[nodiscard]] const std::array<double, 3>& shift_mm() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::geometry
