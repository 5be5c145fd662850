// The whole way from programs to the path of the tool's centre: the interpreter and the stages behind it.
//
//   ProgramSet ──blocks──▶ Interpreter ──programmed items──▶ geometry::PathStages ──▶ items for motion
//
// One `step` executes one block. Its items may come later, when the stages know what follows; items carry the sequence
// of their block, so whoever keeps account of blocks goes by that.
#pragma once

#include <expected>
#include <optional>
#include <vector>

#include "geometry/path_stages.hpp"
#include "program/interpreter.hpp"

namespace cnclab::program {

class PathSource {
 public:
  /// As Interpreter::begin.
  [[nodiscard]] static std::expected<PathSource, language::Error> begin(ProgramSet programs, Settings settings,
                                                                        const Start& start);

  /// Executes the next block and appends every item that is finished now; at the end of the program all of them.
  ///
  /// errors   of the interpreter, or a contour that cannot be followed (compensation_impossible and its like, naming
  ///          the block to blame, which may be an earlier one). What was appended is right and ends at rest; after an
  ///          error further calls return the same.
  /// check    hears of every compensated contour, to find where it cuts into itself; may be null
  [[nodiscard]] std::expected<ExecutedBlock, language::Error> step(std::vector<geometry::PathItem>& out,
                                                                   geometry::ContourCheck* check = nullptr);

  /// Nothing follows: finishes what the stages hold back (a single block in HANDEINGABE, D-75).
  [[nodiscard]] std::expected<void, language::Error> flush(std::vector<geometry::PathItem>& out,
                                                           geometry::ContourCheck* check = nullptr);

  /// Did a stage fail, not a block?
  [[nodiscard]] bool has_contour_fault() const { return has_contour_fault_; }
  /// How many blocks so far have switched on G41 or G42 (one that a run finds in force counts too).
  [[nodiscard]] std::size_t contours_ordered() const { return contours_ordered_; }

  /// Is a way held back until the next block is known?
  [[nodiscard]] bool holds_items() const { return stages_.holds(); }
  /// Path minus Sollwert after everything that has come out, for the next Start (D-75).
  [[nodiscard]] const std::array<double, 3>& compensation_mm() const { return stages_.shift_mm(); }

  /// What the newest block programmed, before the stages: its contour, for drawings and checks.
  [[nodiscard]] const std::vector<geometry::PathItem>& programmed() const { return programmed_; }

  [[nodiscard]] Interpreter& interpreter() { return interpreter_; }
  [[nodiscard]] const Interpreter& interpreter() const { return interpreter_; }
  [[nodiscard]] bool ended() const { return interpreter_.ended() || fault_.has_value(); }

 private:
  PathSource(Interpreter interpreter, const Start& start);
  std::expected<void, language::Error> pass_on(std::vector<geometry::PathItem>& out, geometry::ContourCheck* check);

  Interpreter interpreter_;
  geometry::PathStages stages_;
  std::vector<geometry::PathItem> programmed_;  ///< of the newest block, before the stages
  std::optional<language::Error> fault_;
  bool has_contour_fault_ = false;
  std::size_t contours_ordered_ = 0;
};

/// The control's error for a contour that cannot be followed.
[[nodiscard]] language::Error error_of(const geometry::StageFault& fault);

}  // namespace cnclab::program
