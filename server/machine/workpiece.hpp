// The workpiece of the simulated machine: how high the material still stands, cell by cell (DEC-24).
//
// Rules
//  1. A height field: one height per cell in X and Y, so undercuts do not exist. The tool is a cylinder with a flat
//  end.
//  2. A cell is cut when its centre lies within the tool's radius of the way; then it stands no higher than the lowest
//     point that the tool's end had while it was over it. So holes are right within a cell, edges within half of one.
//  3. Coordinates are those of the path: Istwert coordinates of the run's start. The piece does not move.
//  4. Contact is what the tool takes away inside its edge, whose width the caller knows: on a way that it has gone
//     before, with other roundings or chords, the edge always finds some cells again.
// A plain value: copies are cut independently (graphic test run).
#pragma once

#include <array>
#include <cstddef>
#include <expected>
#include <optional>
#include <span>
#include <vector>

#include "geometry/path_item.hpp"

namespace cnclab::machine {

struct WorkpieceSpec {
  std::array<double, 3> size_mm{120, 80, 30};  ///< X Y Z, > 0
  double cell_mm = 0.25;                       ///< side of a cell, > 0
};

/// The cells of a live workpiece, about: 1.6 MB (`fitted`).
inline constexpr double kUsualCells = 400'000;

/// The same piece with cells so large that there are about `most_cells` at most.
[[nodiscard]] WorkpieceSpec fitted(WorkpieceSpec spec, double most_cells = kUsualCells);

enum class WorkpieceError { not_positive, too_many_cells };

/// What one way of the tool took away.
struct Cut {
  double removed_mm3 = 0;
  double deepest_mm = 0;  ///< by how much the cell that lost most became lower
  double contact_mm = 0;  ///< the same, of the cells inside the tool's edge (rule 4)
};

class Workpiece {
 public:
  /// 16 MB: 120 × 80 mm at 0.05 mm.
  static constexpr std::size_t kMostCells = 4'000'000;

  /// A whole piece whose top lies at `top_center.z`, centred at `top_center` in X and Y.
  /// The last column and row may reach beyond the size by less than a cell.
  [[nodiscard]] static std::expected<Workpiece, WorkpieceError> make(const WorkpieceSpec& spec,
                                                                     const geometry::Point& top_center);

  /// The tool's end goes straight from `from` to `to`.
  /// edge_mm   so far inside the radius nothing counts as contact, of thin tools half the radius
  Cut cut(const geometry::Point& from, const geometry::Point& to, double radius_mm, double edge_mm);

  [[nodiscard]] std::size_t columns() const { return columns_; }  ///< along X
  [[nodiscard]] std::size_t rows() const { return rows_; }        ///< along Y
  [[nodiscard]] double cell_mm() const { return cell_mm_; }
  [[nodiscard]] const geometry::Point& corner() const { return corner_; }  ///< least X, Y; Z of the bottom
  [[nodiscard]] double full_height_mm() const { return full_height_mm_; }
  /// Above the bottom, mm, 0..full_height_mm; row by row from the corner on.
  [[nodiscard]] std::span<const float> heights() const { return heights_; }
  /// Z of the surface at a place; nothing beside the piece.
  [[nodiscard]] std::optional<double> surface_z(double x, double y) const;
  [[nodiscard]] double removed_mm3() const { return removed_mm3_; }

 private:
  Workpiece() = default;
  struct Way;
  void cut_row(std::size_t row, const Way& way, Cut& cut);
  void cut_columns(std::size_t row, double first, double last, const Way& way, Cut& cut);
  float lower(std::size_t index, double z);

  std::size_t columns_ = 0, rows_ = 0;
  double cell_mm_ = 0, full_height_mm_ = 0;
  geometry::Point corner_;
  std::vector<float> heights_;
  double removed_mm3_ = 0;
  geometry::Point last_end_;  ///< of the way that was cut last, from the corner
  double last_radius_mm_ = 0;
};

}  // namespace cnclab::machine
