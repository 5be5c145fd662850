// By how much compensation has moved the path beside the program, at every place where a run can come to rest (D-39,
// D-75): whatever ends the run, the next one begins with exactly the offset that the tool stands in.
//
//   items from the stages ──▶ OffsetRecord ──block and place of the rest──▶ Istwert minus Sollwert of X, Y, Z
//
// Within a way the offset passes evenly from that at its beginning to that at its end, turning with an arc:
//
//   entry: grows from 0 to R        element: stays R beside it        corner arc: turns about the corner
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "geometry/path_item.hpp"

namespace cnclab::panel {

class OffsetRecord {
 public:
  /// start_mm   what the run has begun with
  explicit OffsetRecord(const std::array<double, 3>& start_mm) : before_mm_(start_mm), newest_mm_(start_mm) {}

  /// Takes items as they leave the stages, in their order.
  void take(const std::vector<geometry::PathItem>& items);
  /// Nobody will ask for blocks (PathItem::sequence) before this one.
  void forget_before(std::uint64_t sequence);

  /// When the block was done last, or the one before it where it has nothing of its own.
  [[nodiscard]] std::array<double, 3> behind(std::uint64_t sequence) const;
  /// While the block is being done.
  /// path_mm   where the axes are, in the coordinates of the path; beside it the nearest place of the block counts
  [[nodiscard]] std::array<double, 3> within(std::uint64_t sequence, const std::array<double, 4>& path_mm) const;

 private:
  struct Way {
    std::uint64_t sequence = 0;
    geometry::PathElement element;
    std::array<double, 3> from_mm{}, to_mm{};  ///< offset at its ends
  };

  /// In their order; those without any offset are left out.
  std::deque<Way> ways_;
  std::array<double, 3> before_mm_;  ///< ahead of the first way kept
  std::array<double, 3> newest_mm_;  ///< behind everything taken
};

}  // namespace cnclab::panel
