// Drives interpreter, planner and channel tick by tick, and keeps account of what the machine has done.
#include "tool/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>
#include <vector>

#include "geometry/path_math.hpp"
#include "geometry/step_grid.hpp"
#include "motion/planner.hpp"

namespace cnclab::tool {

namespace {

constexpr machine::Epoch kEpoch{1};
/// The window is filled up to the first mark when it has fallen below the second: far more than any braking way needs.
constexpr std::size_t kFillTo = 16'384;
constexpr std::size_t kFillBelow = 8'192;
/// The trace ring is drained so often that it never overflows, ticks.
constexpr std::uint64_t kDrainEvery = 64;

/// The fourth axis moves something else.
double tool_way_of(const geometry::PathItem& item) { return item.is_fourth_axis ? 0 : geometry::length_of(item); }

void append_int32(std::array<char, 16>& bytes, std::size_t at, std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  for (std::size_t byte = 0; byte < 4; ++byte) bytes[at + byte] = static_cast<char>(bits >> (8 * byte) & 0xFFU);
}

}  // namespace

std::string_view name_of(RunEnd end) {
  switch (end) {
    case RunEnd::program_end:
      return "program_end";
    case RunEnd::halt:
      return "halt";
    case RunEnd::wait:
      return "wait";
    case RunEnd::limit_switch:
      return "limit_switch";
    case RunEnd::error:
      return "error";
    case RunEnd::block_limit:
      return "block_limit";
    case RunEnd::time_limit:
      return "time_limit";
  }
  return "error";
}

machine::Inputs StepRecorder::exchange(const machine::Outputs& outputs) noexcept {
  if (out_ != nullptr) {
    std::array<char, 16> bytes{};
    for (std::size_t axis = 0; axis < outputs.steps.size(); ++axis) append_int32(bytes, axis * 4, outputs.steps[axis]);
    out_->write(bytes.data(), bytes.size());
  }
  return machine_.exchange(outputs);
}

Simulation::Simulation(const Job& job, const Options& options, Recording recording)
    : job_(job),
      options_(options),
      recording_(recording),
      machine_(job.data),
      recorder_(machine_, recording.steps),
      channel_(recorder_, job.data) {}

double Simulation::time_s() const { return static_cast<double>(ticks_) * options_.tick_ms / 1000; }

std::expected<RunSummary, language::Error> Simulation::run() {
  auto path = program::CheckedPath::begin(job_.programs, job_.settings, job_.start);
  if (!path) return std::unexpected(path.error());
  channel_.grant(kEpoch, machine::kNeverExpires);
  channel_.set_override(1);
  channel_.record_trace(recording_.trace != nullptr);
  motion::Planner& planner = *channel_.begin_run(kEpoch, job_.start.position);  // the ring is empty, so there is one
  feed(*path, planner);
  static_cast<void>(channel_.command(machine::Go{kEpoch}));
  std::optional<RunEnd> end;
  while (!end) {
    if (waiting_.size() < kFillBelow) feed(*path, planner);
    ++ticks_;
    channel_.tick(std::llround(time_s() * 1e9), options_.tick_ms / 1000);
    const machine::Snapshot now = channel_.snapshot();
    account(now);
    if (ticks_ % kDrainEvery == 0) write_trace();
    end = end_of(now);
  }
  write_trace();
  conclude(*end, channel_.snapshot());
  return std::move(summary_);
}

/// What is known only at the end: where the machine rests, and how much of the item under way was done.
void Simulation::conclude(RunEnd end, const machine::Snapshot& last) {
  summary_.ended = end;
  summary_.machine_time_s = time_s();
  summary_.blocks = last.finished_sequence;
  summary_.istwert_mm = last.istwert_mm;
  if (end == RunEnd::limit_switch) summary_.limit_axis = last.limit_axis;
  if (waiting_.empty()) return;
  const Waiting& under_way = waiting_.front();
  summary_.path_mm += std::min(way_in_element_mm_, under_way.length_mm);
  if (end != RunEnd::halt && end != RunEnd::wait) return;
  note_event(under_way.item);  // the machine stands in it, and all else of its block is done
  if (under_way.item.ends_block) summary_.blocks = under_way.item.sequence;
}

/// Keeps the window filled. Input 1 is inactive all the time here, so blocks that ask for it need no answer.
void Simulation::feed(program::CheckedPath& path, motion::Planner& planner) {
  while (waiting_.size() < kFillTo) {
    if (pending_.empty()) {
      if (all_fed_) break;
      all_fed_ = !take_block(path);
      continue;
    }
    const geometry::PathItem& item = pending_.front();
    static_cast<void>(planner.append(item));  // kFillTo stays far below the window
    waiting_.push_back({.item = item, .length_mm = tool_way_of(item)});
    pending_.pop_front();
  }
  planner.plan();
}

/// Executes the next block into `pending_`. False when nothing follows: the end, an error or the block limit.
bool Simulation::take_block(program::CheckedPath& path) {
  if (path.ended()) return false;
  const bool is_cut = fed_blocks_ >= options_.most_blocks || path.waits_in_vain();
  std::vector<geometry::PathItem> finished;
  const auto executed = is_cut ? path.flush(finished) : path.step(finished);
  geometry::run_in_step_grid(finished, job_.settings.steps_per_mm);
  std::ranges::move(finished, std::back_inserter(pending_));
  ++fed_blocks_;
  if (!executed) summary_.error = executed.error();
  return executed && !is_cut;
}

/// Items behind the machine are added up; of the one it is in, the way so far.
void Simulation::account(const machine::Snapshot& now) {
  const double step_mm = now.speed_mm_per_min / 60 * options_.tick_ms / 1000;
  const bool is_over = !now.started && now.cause != machine::StopCause::program_end;
  if (is_over) return;
  std::uint64_t passed = channel_.queue().popped();
  const bool moved_on = passed > passed_;
  for (; passed_ < passed && !waiting_.empty(); ++passed_) {
    summary_.path_mm += waiting_.front().length_mm;
    note_event(waiting_.front().item);
    waiting_.pop_front();
  }
  way_in_element_mm_ = moved_on ? 0 : way_in_element_mm_ + step_mm;
}

void Simulation::note_event(const geometry::PathItem& item) {
  const bool is_way = std::holds_alternative<geometry::Line>(item.what) ||
                      std::holds_alternative<geometry::Arc>(item.what) ||
                      std::holds_alternative<geometry::Mark>(item.what);
  if (is_way && !item.is_fourth_axis) return;
  const auto* dwell = std::get_if<geometry::Dwell>(&item.what);
  const double lasted_s = dwell == nullptr ? 0 : dwell->seconds;  // items are seen when they are over
  if (summary_.events.size() < kMostEvents)
    summary_.events.push_back({.time_s = time_s() - lasted_s, .item = item});
  else
    ++summary_.events_left_off;
}

std::optional<RunEnd> Simulation::end_of(const machine::Snapshot& now) const {
  const bool rests = now.state == machine::MotionState::standstill && !now.started && channel_.is_settled();
  if (rests && now.cause == machine::StopCause::program_end) return RunEnd::program_end;
  if (rests && now.cause == machine::StopCause::limit_switch) return RunEnd::limit_switch;
  if (rests && now.cause != machine::StopCause::none) return RunEnd::error;
  if (now.state == machine::MotionState::halted)
    return now.cause == machine::StopCause::programmed_halt ? RunEnd::halt : RunEnd::wait;
  if (all_fed_ && pending_.empty() && waiting_.empty() && now.speed_mm_per_min == 0)
    return summary_.error ? RunEnd::error : RunEnd::block_limit;
  if (time_s() >= options_.most_seconds) return RunEnd::time_limit;
  return std::nullopt;
}

void Simulation::write_trace() {
  if (recording_.trace == nullptr) return;
  trace_.clear();
  static_cast<void>(channel_.drain_trace(trace_));
  fmt::memory_buffer rows;
  for (const machine::TracePoint& point : trace_) {
    fmt::format_to(std::back_inserter(rows), "{:.6f}", static_cast<double>(point.tick) * options_.tick_ms / 1000);
    for (std::size_t axis = 0; axis < point.steps.size(); ++axis) {
      const double mm = static_cast<double>(point.steps[axis]) / job_.settings.steps_per_mm[axis];
      fmt::format_to(std::back_inserter(rows), ",{:.6f}", mm);
    }
    fmt::format_to(std::back_inserter(rows), ",{:.6f},{},{},{}\n", point.speed_mm_per_min, point.spindle_rpm,
                   point.source.program, point.source.block);
  }
  recording_.trace->write(rows.data(), static_cast<std::streamsize>(rows.size()));
}

}  // namespace cnclab::tool
