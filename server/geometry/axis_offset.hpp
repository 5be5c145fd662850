// The stage of G43, G44 and G46: each axis shifted by an amount of its own, kept until the axis' next move.
#pragma once

#include <array>
#include <expected>

#include "geometry/path_item.hpp"
#include "geometry/path_stages.hpp"

namespace cnclab::geometry {

/// Shifts one item after the other in place; holds nothing back.
///
/// What holds: what leaves is joined; RadiusOffset and LengthOffset become Marks, and so do lines that lead nowhere.
class AxisOffset {
 public:
  explicit AxisOffset(const std::array<double, 3>& shift_mm) : shift_mm_(shift_mm) {}

  /// errors   arc_under_axis_offset: an arc while an axis of its plane is, or has to be, shifted by a radius
  ///          runs_backwards: under G43 or G44 the radius would take more off an axis' way than there is of it
  [[nodiscard]] std::expected<void, StageFault> rewrite(PathItem& item);

  [[nodiscard]] const std::array<double, 3>& shift_mm() const { return shift_mm_; }

 private:
  /// When an axis takes its new shift, and which.
  enum class Rule : std::uint8_t {
    leaves_together,  ///< both axes of the plane go to zero with the next line of the plane
    leaves_alone,     ///< each axis goes to zero with its next move (G40 behind G43, G44)
    follows_ways,     ///< each axis goes to ± the radius with its next move (G43, G44)
  };

  void take(const RadiusOffset& order);
  void take(const LengthOffset& order);
  [[nodiscard]] std::expected<void, StageFault> shift(const PathItem& item, Line& line);
  [[nodiscard]] double next_shift(std::size_t axis, double way, bool is_named, bool moves_in_plane) const;
  [[nodiscard]] bool runs_backwards(double way, double change) const;
  [[nodiscard]] bool refuses(const Arc& arc) const;

  std::array<double, 3> shift_mm_{};
  Plane plane_ = Plane::xy;
  Rule rule_ = Rule::leaves_together;
  double radius_mm_ = 0;  ///< follows_ways: added in the direction of the way, < 0 under G44
  double length_mm_ = 0;  ///< of the axis perpendicular to the plane
};

}  // namespace cnclab::geometry
