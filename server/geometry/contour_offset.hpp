// The stage of G41 and G42: the tool's centre keeps beside the programmed contour by the tool's radius.
//
//      entry      contour: each element with its joints            exit
//    ─────────▶ ═════════════▶ ═════════▶ … ═════════▶ ─────────────────▶
//    G41, then   held back until the next one is known      G40, then the next
//    the next                                               line of the plane
//    line of the plane
#pragma once

#include <array>
#include <expected>
#include <vector>

#include "geometry/offset_element.hpp"
#include "geometry/path_item.hpp"
#include "geometry/path_stages.hpp"

namespace cnclab::geometry {

class ContourCheck;

/// What holds: everything that has left is joined, and right whatever follows (DEC-09). An element leaves when the
/// joint at its end is known to be right; the corner arc before it leaves with it.
///
/// Orders of G40 to G44 leave too, in their place, for the stage that shifts axes.
class ContourOffset {
 public:
  [[nodiscard]] std::expected<void, StageFault> push(const PathItem& item, std::vector<PathItem>& out,
                                                     ContourCheck* check);
  /// Ends the chain at the normal offset of its last element's own end; the next line is an entry again (D-75).
  [[nodiscard]] std::expected<void, StageFault> flush(std::vector<PathItem>& out, ContourCheck* check);

  [[nodiscard]] bool holds() const { return state_ == State::entry_held || state_ == State::element_held; }
  /// Does every item but an order leave as it comes?
  [[nodiscard]] bool is_idle() const { return state_ == State::off && !is_shifted_; }
  /// Path minus programmed position after everything that has left; u is 0.
  [[nodiscard]] const Point& shift() const { return shift_; }

 private:
  enum class State : std::uint8_t { off, awaits_entry, entry_held, element_held };

  [[nodiscard]] std::expected<void, StageFault> take_order(const PathItem& item, std::vector<PathItem>& out,
                                                           ContourCheck* check);
  [[nodiscard]] std::expected<void, StageFault> take_way(const PathItem& item, std::vector<PathItem>& out,
                                                         ContourCheck* check);
  /// What an element of the contour becomes; an error where the tool does not fit in, or the plane is another.
  [[nodiscard]] std::expected<OffsetElement, StageFault> offset_beside(const PathItem& item) const;
  [[nodiscard]] std::expected<void, StageFault> begin_contour(const PathItem& item, std::vector<PathItem>& out,
                                                              ContourCheck* check);
  [[nodiscard]] std::expected<void, StageFault> join(const PathItem& item, std::vector<PathItem>& out,
                                                     ContourCheck* check);
  [[nodiscard]] bool closes_circle(const PathItem& item) const;
  void close_circle(const PathItem& item);
  void hold(const PathItem& item, const OffsetElement& element, const Joint& joint);
  void finish(std::vector<PathItem>& out, ContourCheck* check);
  void leave(const PathItem& item, std::vector<PathItem>& out);
  void leave_contour(const PathItem& item, std::vector<PathItem>& out, ContourCheck* check);
  void emit_entry(PlaneVector end, std::vector<PathItem>& out, ContourCheck* check);
  void emit_element(const Joint& joint, std::vector<PathItem>& out, ContourCheck* check);
  void emit_corner(std::vector<PathItem>& out, ContourCheck* check);
  void emit_behind(std::vector<PathItem>& out);
  void set_shift(PlaneVector place, const Point& programmed);

  State state_ = State::off;
  bool is_shifted_ = false;  ///< shift_ is not zero
  RadiusOffset order_;       ///< the newest one that was not merely repeated
  double offset_ = 0;        ///< mm, > 0 left
  Point shift_;
  PathItem held_;                 ///< entry or element, as programmed
  OffsetElement element_;         ///< element_held: the shape of held_
  Joint start_;                   ///< element_held: its joint with the element before
  PlaneVector at_;                ///< where the tool's centre stands in the plane: end of the last way that has left
  std::vector<PathItem> behind_;  ///< what came behind held_ and does not move in the plane
};

}  // namespace cnclab::geometry
