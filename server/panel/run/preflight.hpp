// Looking ahead before START: the contours that a run will follow are checked as a whole before anything moves
// (DEC-09).
//
// A single corner is checked when the path is made; that a later wall comes too close shows only in the whole contour.
// The check plays the program without a machine, on a copy of everything that decides its course, off the lab thread.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "language/error.hpp"
#include "panel/run/long_work.hpp"
#include "program/path_source.hpp"

namespace cnclab::panel {

class Preflight {
 public:
  /// What the check has found.
  struct Result {
    std::optional<language::Error> error;  ///< the first fault of a contour
    /// Contours found right, counted from START in the order in which the run follows them. Those behind the first
    /// block that asks for Input 1 are not among them, nor is one whose exit lies there.
    std::size_t sound_contours = 0;
  };

  /// Begins at once, through `long_work`.
  Preflight(const LongWork& long_work, program::ProgramSet programs, program::Settings settings, program::Start start);
  /// As before, from where a run stands now; questions for Input 1 are answered as far as the answers go.
  Preflight(const LongWork& long_work, program::PathSource source, std::vector<bool> answers);
  ~Preflight();  ///< whoever is still at it gives up soon
  Preflight(Preflight&&) noexcept = default;
  Preflight& operator=(Preflight&&) noexcept = default;
  Preflight(const Preflight&) = delete;
  Preflight& operator=(const Preflight&) = delete;

  /// The result, or nothing while the check is under way.
  [[nodiscard]] std::optional<Result> result() const;

  /// Is there a contour to check: can G41 or G42 be reached from the start, or is it in force there?
  [[nodiscard]] static bool is_needed(const program::ProgramSet& programs, const program::Start& start);

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace cnclab::panel
