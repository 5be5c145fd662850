// Plays a program without a machine as far as its course is known, and listens to its contours.
#include "panel/run/preflight.hpp"

#include <utility>
#include <vector>

#include "geometry/contour_check.hpp"
#include "program/reachable.hpp"
#include "program/ways.hpp"

namespace cnclab::panel {

namespace {

/// A program that loops without ever coming back to the same state is followed so far: hours of machining.
constexpr std::uint64_t kMostBlocks = 200'000;

bool switches_contour_on(const language::Block& block) {
  return block.function.kind == language::Function::Kind::g && (block.function.code == 41 || block.function.code == 42);
}

bool is_contour(program::RadiusCompensation side) {
  return side == program::RadiusCompensation::left || side == program::RadiusCompensation::right;
}

/// Does the tool still stand beside the contour that was switched off?
bool awaits_exit(const program::PathSource& source) {
  const program::ModalState& modal = source.interpreter().modal();
  if (modal.radius != program::RadiusCompensation::off) return false;
  const auto [first, second] = program::indices_of(modal.plane).in_plane;
  return source.compensation_mm()[first] != 0 || source.compensation_mm()[second] != 0;
}

/// Contours that were left again: the last one is still open where compensation is in force, and until its exit.
std::size_t closed_contours(const program::PathSource& source) {
  const bool is_open = is_contour(source.interpreter().modal().radius) || awaits_exit(source);
  return source.contours_ordered() - (is_open && source.contours_ordered() > 0 ? 1 : 0);
}

Preflight::Result play(program::PathSource& source, const std::vector<bool>& answers,
                       const std::atomic<bool>& is_abandoned) {
  Preflight::Result result;
  geometry::ContourCheck check;
  std::size_t answered = 0;
  std::vector<geometry::PathItem> items;
  for (std::uint64_t blocks = 0; blocks < kMostBlocks && !source.ended() && !is_abandoned; ++blocks) {
    if (source.interpreter().awaited_input()) {
      if (answered == answers.size()) break;
      source.interpreter().answer_input(answers[answered++]);
    }
    items.clear();
    const auto executed = source.step(items, &check);
    if (!check.findings().empty()) {
      result.error = program::error_of(check.findings().front());
      return result;
    }
    if (executed) {
      result.sound_contours = closed_contours(source);
      continue;
    }
    // Any other error of a block shows when the run comes to it; the contour up to there was right.
    if (source.has_contour_fault())
      result.error = executed.error();
    else
      result.sound_contours = source.contours_ordered();
    return result;
  }
  if (source.ended()) result.sound_contours = source.contours_ordered();
  return result;
}

}  // namespace

struct Preflight::Shared {
  std::atomic<bool> is_abandoned = false, is_done = false;
  Result result;  ///< written before `is_done`
};

Preflight::Preflight(const LongWork& long_work, program::ProgramSet programs, program::Settings settings,
                     program::Start start)
    : shared_(std::make_shared<Shared>()) {
  long_work([shared = shared_, programs = std::move(programs), settings = std::move(settings),
             start = std::move(start)]() mutable {
    auto source = program::PathSource::begin(std::move(programs), std::move(settings), start);
    if (source) shared->result = play(*source, {}, shared->is_abandoned);
    shared->is_done.store(true, std::memory_order_release);
  });
}

Preflight::Preflight(const LongWork& long_work, program::PathSource source, std::vector<bool> answers)
    : shared_(std::make_shared<Shared>()) {
  long_work([shared = shared_, source = std::move(source), answers = std::move(answers)]() mutable {
    shared->result = play(source, answers, shared->is_abandoned);
    shared->is_done.store(true, std::memory_order_release);
  });
}

Preflight::~Preflight() {
  if (shared_) shared_->is_abandoned = true;
}

std::optional<Preflight::Result> Preflight::result() const {
  if (!shared_->is_done.load(std::memory_order_acquire)) return std::nullopt;
  return shared_->result;
}

bool Preflight::is_needed(const program::ProgramSet& programs, const program::Start& start) {
  bool found = is_contour(start.modal.radius);
  program::walk_reachable(programs, start.program, start.block,
                          [&](geometry::SourceBlock, const language::Block& block) {
                            found = found || switches_contour_on(block);
                            return !found;
                          });
  return found;
}

}  // namespace cnclab::panel
