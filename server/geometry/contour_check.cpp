// Every way against every wall that its box comes near.
//
//        wall (an element of the contour)        way (of the tool's centre)
//      ═════════════════════════════          ─────────────────────────────▶
//                 ▲ found                 found >= R - 1.5 µm, or the way is reported
//      ───────────▼─────────────────▶
//
// Entry and exit are ways like others, except that what stands below them is not cut:
//
//      entry ───╲   looked at from where it is no higher than the wall
//                ╲▼──────────
//      wall ══════════════
#include "geometry/contour_check.hpp"

#include <algorithm>
#include <limits>
#include <ranges>
#include <tuple>
#include <type_traits>
#include <utility>

#include "geometry/offset_element.hpp"

namespace cnclab::geometry {

namespace {

/// So many elements at either end may be run-in or run-out: a line and an arc.
constexpr std::size_t kLongestRunIn = 2;
/// The part of a line that is no higher than this; its lower end is.
PlanePiece part_below(const Line& line, const PlaneAxes& axes, double height_mm) {
  constexpr double kSameHeight_mm = 1e-9;
  const double top = height_mm + kSameHeight_mm, from = line.from.*axes.normal, to = line.to.*axes.normal;
  const PlaneVector begin = in_plane(line.from, axes), end = in_plane(line.to, axes);
  if (from <= top && to <= top) return {.from = begin, .to = end};
  const PlaneVector at_top = between(begin, end, std::clamp((from - top) / (from - to), 0.0, 1.0));
  return from > top ? PlanePiece{.from = at_top, .to = end} : PlanePiece{.from = begin, .to = at_top};
}

/// What two passes of a loop over the same block have in common.
auto trace_of(const PlanePiece& piece, const SourceBlock& source) {
  return std::tie(piece.from.first, piece.from.second, piece.to.first, piece.to.second, piece.center.first,
                  piece.center.second, piece.radius, piece.is_circle, piece.lowest, piece.highest, source.program,
                  source.block);
}

/// By how much the radii at both ends of an arc differ.
double radius_error_of(const PathElement& element) {
  const auto* arc = std::get_if<Arc>(&element);
  if (arc == nullptr) return 0;
  const ArcShape shape = shape_of(*arc);
  return std::abs(shape.end_radius - shape.start_radius);
}

}  // namespace

void ContourCheck::begin(Plane plane, double radius_mm, SourceBlock source, const Line& entry) {
  plane_ = plane;
  radius_mm_ = radius_mm;
  entry_ = {.kind = StageFault::Kind::entry_too_close, .source = source, .line = entry, .element = 1};
  awaits_exit_ = false;
  is_open_ = true;
  elements_ = 0;
  tolerance_mm_ = kRounded_mm;
  joints_.clear();
  contour_.clear();
  ways_.clear();
  first_of_chain_ = findings_.size();
}

void ContourCheck::append(SourceBlock source, const PathElement& element, std::uint32_t number,
                          std::vector<Placed>& pieces) {
  pieces_.clear();
  append_pieces(element, axes_of(plane_), pieces_);
  for (const PlanePiece& piece : pieces_) pieces.push_back({.piece = piece, .element = number, .source = source});
}

void ContourCheck::add_contour(SourceBlock source, const PathElement& element) {
  ++elements_;
  append(source, element, elements_, contour_);
  tolerance_mm_ = std::max(tolerance_mm_, kRounded_mm + radius_error_of(element));
  const PlaneAxes& axes = axes_of(plane_);
  const auto ends = [&](const auto& way) {
    if (joints_.empty()) joints_.push_back(in_plane(way.from, axes));
    joints_.push_back(in_plane(way.to, axes));
  };
  std::visit(ends, element);
}

void ContourCheck::add_path(SourceBlock source, const PathElement& way) { append(source, way, elements_, ways_); }

void ContourCheck::add_corner(SourceBlock source, const Arc& corner) { append(source, corner, 0, ways_); }

void ContourCheck::end() {
  if (!is_open_) return;
  is_open_ = false;
  awaits_exit_ = true;
  keep_closed_part();
  drop_repeated(contour_);
  drop_repeated(ways_);
  plant_tree();
  look_round(entry_);
  const double reach = radius_mm_ - tolerance_mm_;
  for (const Placed& way : ways_) {
    const PieceBox box = box_of(way.piece);
    tree_.visit_near(box, reach, [&](std::size_t first, std::size_t last) {
      for (std::size_t wall = first; wall < last; ++wall)
        if (is_near(boxes_[wall], box, reach)) compare(way, contour_[wall]);
    });
  }
}

void ContourCheck::split() {
  if (!is_open_) return;
  end();
  Passage entry = entry_;
  entry.element = 0;  // of an earlier part
  begin(plane_, radius_mm_, entry.source, entry.line);
  entry_ = entry;
}

void ContourCheck::add_exit(SourceBlock source, const Line& exit) {
  const bool is_next = std::exchange(awaits_exit_, false);
  if (!is_next || joints_.empty()) return;
  look_round({.kind = StageFault::Kind::exit_too_close, .source = source, .line = exit, .element = elements_});
}

/// Drops run-in and run-out from the walls: the largest part that closes is the contour.
void ContourCheck::keep_closed_part() {
  const std::size_t count = elements_;
  is_closed_ = false;
  for (std::size_t dropped = 0; dropped <= 2 * kLongestRunIn; ++dropped) {
    for (std::size_t ahead = 0; ahead <= std::min(dropped, kLongestRunIn); ++ahead) {
      const std::size_t behind = dropped - ahead;
      if (behind > kLongestRunIn || dropped >= count) continue;
      if (size(joints_[ahead] - joints_[count - behind]) > kArcTolerance_mm) continue;
      std::erase_if(contour_,
                    [&](const Placed& wall) { return wall.element <= ahead || wall.element > count - behind; });
      is_closed_ = true;
      return;
    }
  }
}

/// A loop runs along the same walls again and again: once is enough, or its passes would count squared.
void ContourCheck::drop_repeated(std::vector<Placed>& pieces) {
  const auto trace = [&](std::uint32_t index) { return trace_of(pieces[index].piece, pieces[index].source); };
  std::vector<std::uint32_t> order(pieces.size());
  std::ranges::copy(std::views::iota(std::size_t{0}, order.size()), order.begin());
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    const auto order_of_traces = trace(a) <=> trace(b);
    return order_of_traces == 0 ? a < b : order_of_traces < 0;
  });
  std::vector<bool> is_repeated(pieces.size());
  for (std::size_t i = 1; i < order.size(); ++i)
    if (trace(order[i - 1]) == trace(order[i])) is_repeated[order[i]] = true;
  std::erase_if(pieces, [&, index = std::size_t{0}](const Placed&) mutable { return is_repeated[index++]; });
}

/// Sorts the walls so that neighbours in space are neighbours in the tree.
void ContourCheck::plant_tree() {
  boxes_.clear();
  for (const Placed& wall : contour_) boxes_.push_back(box_of(wall.piece));
  const std::vector<std::uint32_t> order = order_in_space(boxes_);
  const auto sort = [&](auto& values) {
    std::remove_reference_t<decltype(values)> sorted;
    sorted.reserve(values.size());
    for (const std::uint32_t index : order) sorted.push_back(values[index]);
    values.swap(sorted);
  };
  sort(contour_);
  sort(boxes_);
  tree_.plant(boxes_);
}

void ContourCheck::compare(const Placed& way, const Placed& wall) {
  // Beside its own element a way keeps the tool's radius by construction; a corner need not (an arc that returns).
  if (way.element == wall.element) return;
  const double found = distance_between(way.piece, wall.piece);
  if (found < radius_mm_ - tolerance_mm_) note(StageFault::Kind::too_close, way.source, wall.source, found);
}

/// Every wall that entry or exit comes near while it is no higher.
void ContourCheck::look_round(const Passage& passage) {
  const PlaneAxes& axes = axes_of(plane_);
  const double reach = radius_mm_ - tolerance_mm_;
  pieces_.clear();
  append_pieces(passage.line, axes, pieces_);
  PieceBox box = box_of(pieces_.front());
  box.normal_high = std::numeric_limits<double>::infinity();
  tree_.visit_near(box, reach, [&](std::size_t first, std::size_t last) {
    for (std::size_t index = first; index < last; ++index)
      if (is_near(boxes_[index], box, reach)) look_at(passage, contour_[index]);
  });
}

void ContourCheck::look_at(const Passage& passage, const Placed& wall) {
  const std::optional<PlanePiece> counted = counted_part(passage, wall);
  if (!counted) return;
  const PlanePiece way = part_below(passage.line, axes_of(plane_), wall.piece.highest);
  const double found = distance_between(way, *counted);
  if (found < radius_mm_ - tolerance_mm_) note(passage.kind, passage.source, wall.source, found);
}

/// Of an open contour, what lies farther from its free end than the tool's radius: from where it first leaves that
/// circle on.
std::optional<PlanePiece> ContourCheck::counted_part(const Passage& passage, const Placed& wall) const {
  if (is_closed_ || passage.element == 0) return wall.piece;
  const bool is_entry = passage.kind == StageFault::Kind::entry_too_close;
  const auto joint = [&](std::uint32_t steps) { return joints_[is_entry ? steps : elements_ - steps]; };
  const std::uint32_t steps = is_entry ? wall.element - 1 : elements_ - wall.element;  // from the end to the wall
  for (std::uint32_t step = 1; step <= steps; ++step)
    if (size(joint(step) - joint(0)) >= radius_mm_) return wall.piece;
  return part_outside(wall.piece, joint(0), radius_mm_);
}

void ContourCheck::note(StageFault::Kind kind, SourceBlock way, SourceBlock wall, double found_mm) {
  const auto first = findings_.begin() + static_cast<std::ptrdiff_t>(first_of_chain_);
  const auto known = std::find_if(first, findings_.end(),
                                  [&](const StageFault& fault) { return fault.block == way && fault.other == wall; });
  if (known != findings_.end())
    known->found_mm = std::min(known->found_mm, found_mm);
  else if (findings_.size() - first_of_chain_ < kMostFindings)
    findings_.push_back({.kind = kind, .block = way, .other = wall, .found_mm = found_mm, .needed_mm = radius_mm_});
}

}  // namespace cnclab::geometry
