// Targets in whole nanometres, so that no sum ever rounds.
#include "program/ways.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "program/compensation.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

using language::Address;
using language::ErrorCode;

/// Sums beyond 100 km leave the exact range of a path coordinate; no machine is that long.
constexpr std::int64_t kFarthest_nm = 100'000'000'000'000;

/// The original moved as many whole steps as fit an incremental way best, so that rests add up (6.11, D-115, DEC-05).
std::int64_t in_whole_steps(std::int64_t way_nm, double steps_per_mm) {
  const auto steps = std::llround(static_cast<double>(way_nm) / kNanometresPerMm * steps_per_mm);
  return std::llround(static_cast<double>(steps) / steps_per_mm * kNanometresPerMm);
}

/// Takes a word of one axis into the target. In a ROM program an absolute word counts from where the program would be
/// without scale, so that its way is scaled and not its place: #55..#57 always lead back (DEC-51).
void take_word(const BlockRun& run, std::size_t axis, std::int64_t word_um, Target& target) {
  const ModalState& modal = run.state.modal;
  const bool is_absolute = modal.dimension == Dimension::absolute;
  if (language::is_reserved_for_cycles(run.source.program)) {
    const std::int64_t way_um = is_absolute ? word_um - target.unscaled_um[axis] : word_um;
    target.unscaled_um[axis] += way_um;
    target.programmed_nm[axis] += way_um * modal.scale[axis];
    return;
  }
  std::int64_t scaled_nm = word_um * modal.scale[axis];
  if (run.settings.rests_accumulate && !is_absolute)
    scaled_nm = in_whole_steps(scaled_nm, run.settings.steps_per_mm[axis]);
  target.programmed_nm[axis] = is_absolute ? scaled_nm : target.programmed_nm[axis] + scaled_nm;
}

}  // namespace

PlaneIndices indices_of(geometry::Plane plane) {
  switch (plane) {
    case geometry::Plane::xy:
      return {.in_plane = {0, 1}, .normal = 2};
    case geometry::Plane::xz:
      return {.in_plane = {0, 2}, .normal = 1};
    case geometry::Plane::yz:
      return {.in_plane = {1, 2}, .normal = 0};
  }
  return {.in_plane = {0, 1}, .normal = 2};
}

bool is_way(language::Function function) {
  if (function.kind != language::Function::Kind::g) return false;
  const int code = function.code > 60 && function.code < 67 ? function.code - 60 : function.code;
  return code <= 8 && code != 4;
}

std::string in_mm(double value_mm) { return fmt::format("{:.3f}", value_mm); }

std::expected<Target, language::Error> target_of(const BlockRun& run) {
  const ExecutionState& state = run.state;
  Target target{.programmed_nm = state.programmed_nm, .unscaled_um = state.unscaled_um, .path = state.path};
  for (std::size_t axis = 0; axis < kAxisWords.size(); ++axis) {
    const language::Word* word = run.block.find(kAxisWords[axis]);
    if (word == nullptr) continue;
    target.named_axes |= axis_bit(axis);
    take_word(run, axis, word->number, target);
    const std::int64_t before_nm = state.programmed_nm[axis];
    const std::int64_t after_nm = target.programmed_nm[axis];
    const std::int64_t path_nm = after_nm + state.offset_nm[axis];
    if (std::max(std::abs(after_nm), std::abs(path_nm)) > kFarthest_nm)
      return error_at(ErrorCode::word_out_of_range, run.source, language::letter(kAxisWords[axis]),
                      in_mm(static_cast<double>(after_nm) / kNanometresPerMm));
    if (after_nm != before_nm) target.path.*kPathAxes[axis] = static_cast<double>(path_nm) / kNanometresPerMm;
  }
  return target;
}

Outcome check_feed(const BlockRun& run) {
  const int feed = run.state.modal.feed_mm_per_min;
  if (feed <= 0) return error_at(ErrorCode::feed_missing, run.source, 'F');
  if (feed > run.settings.f_max_mm_per_min) return feed_above_limit(run.source, feed, run.settings);
  return {};
}

void arrive(BlockRun& run, const Target& target) {
  follow_compensation(run.state, target);
  run.state.programmed_nm = target.programmed_nm;
  run.state.unscaled_um = target.unscaled_um;
  run.state.path = target.path;
}

void go_straight(BlockRun& run, const Target& target, double feed_mm_per_min, bool is_rapid) {
  const bool may_enter_or_leave = target.named_axes != 0 && is_path_compensated(run.state);
  if (target.path != run.state.path || may_enter_or_leave)
    run.emit_way(
        geometry::Line{
            .from = run.state.path, .to = target.path, .feed_mm_per_min = feed_mm_per_min, .is_rapid = is_rapid},
        target.named_axes);
  arrive(run, target);
}

void go_round(BlockRun& run, const Target& target, const geometry::Arc& arc) {
  run.emit_way(arc, target.named_axes);
  arrive(run, target);
}

}  // namespace cnclab::program
