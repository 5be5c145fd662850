// Pieces of a plane's path for questions of distance, and a tree of boxes that finds the near ones.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// A box in the plane and along its normal.
struct PieceBox {
  double first_low, first_high, second_low, second_high, normal_low, normal_high;
};
[[nodiscard]] PieceBox box_of(const PlanePiece& piece);

/// Boxes round runs of consecutive pieces, and boxes round those, and so on.
///
/// A contour's neighbours in order are neighbours in the plane, so the order of the contour is all the sorting needed.
class PieceTree {
 public:
  static constexpr std::size_t kPiecesPerLeaf = 4;  // 2 to 8 measured alike, 16 slower

  /// Begins anew; then `add` every box in order, then `complete`.
  void clear() { boxes_.clear(); }
  void reserve_leaves(std::size_t pieces);
  void add(std::size_t index, const PieceBox& box);
  void complete();

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
  [[nodiscard]] static bool is_near(const PieceBox& a, const PieceBox& b, double reach);

  std::size_t pieces_ = 0, leaves_ = 0;
  std::vector<PieceBox> boxes_;  ///< [1] is the root, [n] holds [2n] and [2n + 1], leaves from leaves_ on
};

}  // namespace cnclab::geometry
