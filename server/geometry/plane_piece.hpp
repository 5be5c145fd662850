// Pieces of a plane's path for questions of distance, and a tree of boxes that finds the near ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane_vector.hpp"

namespace cnclab::geometry {

/// A line or a true circular arc, without direction: arcs run counterclockwise from `from` to `to`.
struct PlanePiece {
  PlaneVector from{}, to{};
  PlaneVector center{};
  double radius = 0;  ///< mm; 0: a line
  bool is_circle = false;
  double lowest = 0, highest = 0;  ///< range along the normal, mm
};

/// Appends the pieces of an element: one, or for a spiral (D-55) so many that none is further than 0.25 µm from it.
void append_pieces(const PathElement& element, const PlaneAxes& axes, std::vector<PlanePiece>& pieces);

/// The smallest distance between two pieces in the plane, mm; 0 where they cross.
[[nodiscard]] double distance_between(const PlanePiece& a, const PlanePiece& b);

/// What is left of a piece outside a circle: all, nothing, or from where it leaves the circle on. A piece that has both
/// ends inside is nothing.
[[nodiscard]] std::optional<PlanePiece> part_outside(const PlanePiece& piece, PlaneVector center, double radius_mm);

/// A box in the plane and along its normal.
struct PieceBox {
  double first_low, first_high, second_low, second_high, normal_low, normal_high;
};
[[nodiscard]] PieceBox box_of(const PlanePiece& piece);

/// May what is in the boxes come closer than `reach` in the plane, and do their ranges along the normal meet?
[[nodiscard]] inline bool is_near(const PieceBox& a, const PieceBox& b, double reach) {
  constexpr double kSameHeight_mm = 1e-9;
  return a.first_low <= b.first_high + reach && b.first_low <= a.first_high + reach &&
         a.second_low <= b.second_high + reach && b.second_low <= a.second_high + reach &&
         a.normal_low <= b.normal_high + kSameHeight_mm && b.normal_low <= a.normal_high + kSameHeight_mm;
}

/// The indices of the boxes along a curve that fills space (Morton's), so that near ones stand near each other.
[[nodiscard]] std::vector<std::uint32_t> order_in_space(const std::vector<PieceBox>& boxes);

/// Boxes round runs of consecutive pieces, and boxes round those, and so on. The better the order (see
/// `order_in_space`), the fewer boxes a question touches.
class PieceTree {
 public:
  static constexpr std::size_t kPiecesPerLeaf = 4;

  /// Begins anew with these.
  void plant(const std::vector<PieceBox>& boxes);

  /// Calls `visit(first, last)` for each run of pieces [first, last) that may come closer than `reach` to the box.
  template <typename Visit>
  void visit_near(const PieceBox& box, double reach, Visit visit) const {
    if (boxes_.empty()) return;
    std::size_t pending[128];
    std::size_t count = 0;
    pending[count++] = 1;
    while (count > 0) {
      const std::size_t node = pending[--count];
      if (!is_near(boxes_[node], box, reach)) continue;
      if (node >= leaves_) {
        const std::size_t first = (node - leaves_) * kPiecesPerLeaf;
        visit(first, std::min(first + kPiecesPerLeaf, pieces_));
      } else {
        pending[count++] = 2 * node + 1;
        pending[count++] = 2 * node;
      }
    }
  }

 private:
  std::size_t pieces_ = 0, leaves_ = 0;
  std::vector<PieceBox> boxes_;  ///< [1] is the root, [n] holds [2n] and [2n + 1], leaves from leaves_ on
};

}  // namespace cnclab::geometry
