// Looking along a contour that START could not check because it lies behind a question for Input 1: once the run has
// come to it, nothing stands between any more (DEC-09).
//
//   run, at G41 or G42 ── copy ──▶ Preflight, to the contour's end ──▶ right: the run goes on
//                                        │                            wrong: it ends before the block to blame
//                                        └─ a question inside the contour: the run goes on to it; with each answer the
//                                           contour is looked at again, from its beginning
//
// Only for machines that may come to such a contour: the lab's refuses it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/path_item.hpp"
#include "language/error.hpp"
#include "panel/run/long_work.hpp"
#include "panel/run/preflight.hpp"
#include "program/path_source.hpp"

namespace cnclab::panel {

class ContourScout {
 public:
  /// at_contour   what the run is made from, right behind the block that has switched the contour on
  ContourScout(LongWork long_work, program::PathSource at_contour);

  /// Which contour it looks along, counted as `PathSource::contours_ordered`.
  [[nodiscard]] std::size_t contour() const { return at_contour_.contours_ordered(); }
  /// A question inside the contour was answered.
  void take_answer(bool input_1);

  /// What it sees has not been asked for yet.
  [[nodiscard]] bool is_looking() const { return preflight_.has_value(); }
  /// Has it seen as much as can be seen now? Until then the run executes no further block.
  [[nodiscard]] bool has_looked();
  /// Contours found right, counted as in `Preflight::Result`.
  [[nodiscard]] std::size_t sound_contours() const { return sound_contours_; }
  /// Takes the items of the block to blame, and all behind it, away from those that the run has made.
  /// returns   its error, where the run has come to it
  [[nodiscard]] std::optional<language::Error> guard(std::vector<geometry::PathItem>& items) const;

 private:
  void look();

  LongWork long_work_;
  program::PathSource at_contour_;
  std::vector<bool> answers_;
  std::optional<Preflight> preflight_;  ///< while it looks
  std::size_t sound_contours_ = 0;
  std::optional<language::Error> fault_;
};

}  // namespace cnclab::panel
