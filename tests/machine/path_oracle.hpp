// Where a point lies on a commanded path, worked out from the items alone: nothing of the library's own path
// mathematics is asked, so that it is not its own judge.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/path_item.hpp"

namespace cnclab::machine {

class PathOracle {
 public:
  struct Placement {
    double way_mm = 0;       ///< along the element
    double distance_mm = 0;  ///< of the point from the element
  };

  /// Items count from sequence 1, one each; their path begins at `start`.
  PathOracle(std::vector<geometry::PathItem> items, const geometry::Point& start);

  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] const geometry::PathItem& item(std::size_t index) const { return items_[index]; }
  [[nodiscard]] bool is_motion(std::size_t index) const { return length_mm(index) > kShortest_mm; }
  [[nodiscard]] double length_mm(std::size_t index) const { return shapes_[index].length; }
  /// Of the whole path, up to where the item begins.
  [[nodiscard]] double way_before_mm(std::size_t index) const { return shapes_[index].way_before; }
  [[nodiscard]] double feed_mm_per_min(std::size_t index) const;
  /// 0: straight; the smaller one where both ends of an arc differ (D-55).
  [[nodiscard]] double radius_mm(std::size_t index) const;
  /// Where the item ends; of an event where the path stands.
  [[nodiscard]] const geometry::Point& end(std::size_t index) const { return shapes_[index].end; }
  /// Nearest place at or behind `from_mm`, or distance only.
  [[nodiscard]] Placement place(std::size_t index, const geometry::Point& point, double from_mm) const;
  /// Unit direction of travel.
  [[nodiscard]] geometry::Point heading(std::size_t index, double way_mm) const;

  static constexpr double kShortest_mm = 1e-8;

 private:
  struct Shape {
    double length = 0, way_before = 0;
    double radius = 0, growth = 0;      ///< arcs: where it begins, and by how much it is larger where it ends
    double begin_angle = 0, sweep = 0;  ///< sweep > 0, in the sense of `sense`
    double sense = 1, rise = 0;
    geometry::Point end;
  };

  std::vector<geometry::PathItem> items_;
  std::vector<Shape> shapes_;
};

}  // namespace cnclab::machine
