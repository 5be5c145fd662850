// A path whose compensated contours come out only when they are right as a whole (DEC-09): nothing gouges.
//
//   PathSource ──items──▶ [ an open contour waits here ] ──the last wall is known, none is hit──▶ out
//                                                        └─a wall is hit──▶ the elements before it, and the error
//
// For runs that nobody checks beforehand: whether a way cuts into a later wall shows only when that wall is known. A
// control tells its operator at START instead.
#pragma once

#include <cstddef>
#include <expected>
#include <optional>
#include <vector>

#include "geometry/contour_check.hpp"
#include "program/path_source.hpp"

namespace cnclab::program {

class CheckedPath {
 public:
  /// So many items wait at most, some 20 MiB. A longer contour is checked in parts of this length.
  static constexpr std::size_t kMostHeld = 100'000;

  /// As Interpreter::begin.
  [[nodiscard]] static std::expected<CheckedPath, language::Error> begin(ProgramSet programs, Settings settings,
                                                                         const Start& start);

  /// Executes the next block and appends every item that is finished and right; behind the program's last block all.
  ///
  /// errors   as PathSource::step; also too_close: then the path ends, at rest, before the first block whose way cuts
  ///          into another element of its contour. After an error further calls return the same.
  [[nodiscard]] std::expected<void, language::Error> step(std::vector<geometry::PathItem>& out);

  /// Nothing follows: finishes what is held back.
  [[nodiscard]] std::expected<void, language::Error> flush(std::vector<geometry::PathItem>& out);

  [[nodiscard]] bool ended() const { return source_.ended() || fault_.has_value(); }
  /// Have more than 2 · kMostHeld blocks in a row let nothing go? Then the program goes round in an open contour
  /// without a way, and what waits grows without end: callers stop as at a block limit.
  [[nodiscard]] bool waits_in_vain() const { return silent_blocks_ > 2 * kMostHeld; }

 private:
  explicit CheckedPath(PathSource source) : source_(std::move(source)) {}
  std::expected<void, language::Error> judge(std::vector<geometry::PathItem>& out);
  void keep_what_is_right();

  PathSource source_;
  geometry::ContourCheck check_;
  std::vector<geometry::PathItem> held_;  ///< in their order; empty while no contour is open
  std::size_t findings_seen_ = 0;
  std::size_t silent_blocks_ = 0;  ///< since something came out
  std::optional<language::Error> fault_;
};

}  // namespace cnclab::program
