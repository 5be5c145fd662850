// The order of things in a tick, manual motion, and what goes out: to the machine, to the lab, into the trace.
#include "machine/channel_tick.hpp"

#include <cmath>
#include <utility>

namespace cnclab::machine {

namespace {

/// As `TickLevels` has them.
std::uint32_t levels_of(const Inputs& inputs) noexcept {
  return (inputs.input_1 ? 1U : 0U) | static_cast<std::uint32_t>(inputs.cards[0]) << 8U |
         static_cast<std::uint32_t>(inputs.cards[1]) << 16U;
}

}  // namespace

ChannelTick::ChannelTick(Machine& machine, motion::SegmentQueue& queue, Mailbox& mail, const motion::Limits& limits)
    : machine_(machine), mail_(mail), follower_(queue, limits), limits_(limits), counters_(limits.steps_per_mm) {}

void ChannelTick::tick(std::int64_t now_ns, double tick_s) noexcept {
  ++tick_;
  was_started_ = started_;
  levels_ = {};
  outputs_.signal = false;
  guard_lease(now_ns);
  heed_stops();
  take_orders();
  heed_machine();
  follower_.drop_old_runs();
  const auto before = counters_.steps();
  activity_before_ = activity_;
  move(tick_s);
  if (activity_before_ == Activity::run) note_block_start();
  send(before);
  show_tool();
  report();
}

void ChannelTick::move(double tick_s) noexcept {
  const double ratio = mail_.override_ratio.load(std::memory_order_relaxed);
  const bool single_block = mail_.single_block.load(std::memory_order_relaxed);
  levels_.override_ratio = static_cast<float>(ratio);
  levels_.single_block = single_block;
  if (activity_ == Activity::run) {  // at rest nothing is traced: then it is the next START that finds it
    levels_.resumption = mail_.resumptions.load(std::memory_order_acquire);
    const std::uint64_t before = std::exchange(resumptions_seen_, levels_.resumption);
    levels_.resumptions = static_cast<std::uint32_t>(levels_.resumption - before);
  }
  switch (activity_) {
    case Activity::none:
      speed_mm_per_s_ = 0;
      break;
    case Activity::run:
      run_tick(tick_s, {ratio, braking_, single_block});
      break;
    case Activity::hand:
      hand_tick(tick_s, ratio);
      break;
    case Activity::reference:
      reference_tick(tick_s, ratio);
      break;
    case Activity::back_off:
      back_off_tick(tick_s);
      break;
  }
}

void ChannelTick::hand_tick(double tick_s, double ratio) noexcept {
  hand_.advance(tick_s, ratio, braking_, counters_);
  speed_mm_per_s_ = hand_.speed_mm_per_s();
  if (braking_ && speed_mm_per_s_ <= 0) come_to_rest(StopCause::operator_stop);
}

void ChannelTick::reference_tick(double tick_s, double ratio) noexcept {
  switches_.advance(tick_s, ratio, braking_, inputs_, counters_);
  speed_mm_per_s_ = switches_.speed_mm_per_s();
  if (switches_.has_failed()) return come_to_rest(StopCause::error);
  if (switches_.is_done()) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (switches_.has_axis(i)) note_reference(i, 0);
    }
    return come_to_rest(StopCause::program_end);
  }
  if (braking_ && speed_mm_per_s_ <= 0) {
    switches_.cancel();
    come_to_rest(StopCause::operator_stop);
  }
}

/// The axis stands at its reference point, and that is called so (D-11, G-691).
void ChannelTick::note_reference(std::size_t axis, double istwert_mm) noexcept {
  counters_.set_istwert(axis, istwert_mm);
  referenced_[axis] = true;
  reference_steps_[axis] = counters_.steps()[axis];
}

/// Part of the stop at a limit switch, so neither lease nor potentiometer matter (AUTH-009).
void ChannelTick::back_off_tick(double tick_s) noexcept {
  switches_.advance(tick_s, 1, false, inputs_, counters_);
  speed_mm_per_s_ = switches_.speed_mm_per_s();
  if (!switches_.is_done()) return;
  if (switches_.has_failed()) lose_reference();
  for (std::size_t i = 0; i < 4; ++i) {
    if (switches_.has_axis(i)) counters_.set_istwert(i, 0);
  }
  activity_ = Activity::none;
  speed_mm_per_s_ = 0;
}

void ChannelTick::send(const std::array<std::int64_t, 4>& before) noexcept {
  for (std::size_t i = 0; i < 4; ++i) {
    outputs_.steps[i] = static_cast<std::int32_t>(counters_.steps()[i] - before[i]);
  }
  outputs_.start = started_;
  inputs_before_ = inputs_;
  inputs_ = machine_.exchange(outputs_);
}

MotionState ChannelTick::motion_state() const noexcept {
  if (!outputs_.drives_on) return MotionState::off;
  if (activity_ == Activity::back_off || braking_) return MotionState::stopping;
  if (activity_ == Activity::none) return MotionState::standstill;
  const bool waits = run_.waiting == Waiting::halt || run_.waiting == Waiting::input;
  return activity_ == Activity::run && waits ? MotionState::halted : MotionState::moving;
}

/// The exact position where the path is being followed; else the place that the axes were driven to by other ways.
std::array<double, 4> ChannelTick::path_mm() const noexcept {
  const geometry::Point& exact = follower_.position();
  std::array<double, 4> place{exact.x, exact.y, exact.z, exact.u};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int64_t steps = counters_.steps()[i] - run_.origin[i];
    if (std::llround(place[i] * counters_.per_mm(i)) != steps) {
      place[i] = static_cast<double>(steps) / counters_.per_mm(i);
    }
  }
  return place;
}

void ChannelTick::report() noexcept {
  Snapshot now;
  now.tick = tick_;
  now.state = motion_state();
  now.cause = cause_;
  now.started = started_;
  now.run = run_.number;
  now.run_active = run_.is_active;
  now.orders = orders_;
  now.epoch = lease_.epoch;
  now.lease_valid = lease_valid_;
  now.steps = counters_.steps();
  for (std::size_t i = 0; i < 4; ++i) {
    now.istwert_mm[i] = counters_.istwert_mm(i);
    now.limit[i] = inputs_.limit_plus[i] || inputs_.limit_minus[i];
  }
  now.path_mm = path_mm();
  now.start_steps = start_steps_;
  now.start_istwert_mm = start_istwert_mm_;
  now.speed_mm_per_min = speed_mm_per_s_ * 60;
  now.sequence = sequence_;
  now.source = source_;
  now.finished_sequence = follower_.finished_sequence();
  now.spindle = outputs_.spindle;
  now.spindle_rpm = outputs_.spindle_rpm;
  now.coolant = outputs_.coolant;
  now.inputs = inputs_.cards;
  now.outputs = outputs_.cards;
  now.input_1 = inputs_.input_1;
  now.block_starts = run_.starts;
  now.block_start_count = run_.start_count;
  now.limit_axis = limit_axis_;
  now.is_referenced = referenced_[0] && referenced_[1] && referenced_[2];
  now.reference_steps = reference_steps_;
  now.references_lost = references_lost_;
  now.tool = tool_.number;
  now.signals = signals_;
  now.refused = refused_;
  now.dropped = dropped_;
  trace(now);
  mail_.snapshot.store(now);
}

/// The tool's end for the workpiece, in every tick in which it moves.
void ChannelTick::show_tool() noexcept {
  CutFeed* feed = mail_.cuts.load(std::memory_order_acquire);
  if (feed == nullptr) return;
  const bool moved = outputs_.steps[0] != 0 || outputs_.steps[1] != 0 || outputs_.steps[2] != 0;
  if (!moved && !cut_base_.is_new) return;
  const bool by_program = activity_before_ == Activity::run;
  ToolPoint point;
  point.tick = tick_;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t way = counters_.steps()[i] - cut_base_.steps[i];
    point.mm[i] = cut_base_.mm[i] + static_cast<double>(way) / counters_.per_mm(i);
  }
  point.mm[2] -= tool_.length_mm;
  point.radius_mm = tool_.radius_mm;
  if (by_program) point.source = source_;
  point.begins_run = cut_base_.is_new;
  point.is_rapid = by_program && follower_.is_rapid();
  point.spindle_on = outputs_.spindle != geometry::SpindleTurn::off;
  point.after_gap = cut_base_.has_gap;
  cut_base_.has_gap = !feed->ring.push(point);
  if (cut_base_.has_gap) {
    feed->dropped.fetch_add(1, std::memory_order_relaxed);
  } else {
    cut_base_.is_new = false;
  }
}

void ChannelTick::trace(const Snapshot& state) noexcept {
  // A block without a way, and EINZELSATZ: begun and at rest again within one tick.
  const bool belongs_to_run = started_ || was_started_ || levels_.go;
  if (!mail_.trace_on.load(std::memory_order_acquire) || !belongs_to_run) return;
  TraceRing* ring = mail_.trace.load(std::memory_order_acquire);
  if (ring == nullptr) return;
  TracePoint point;
  point.tick = tick_;
  for (std::size_t i = 0; i < 4; ++i) point.steps[i] = static_cast<std::int32_t>(state.steps[i] - run_.origin[i]);
  point.speed_mm_per_min = static_cast<float>(state.speed_mm_per_min);
  const bool is_reversed = state.spindle == geometry::SpindleTurn::counterclockwise;
  point.spindle_rpm = is_reversed ? -state.spindle_rpm : state.spindle_rpm;
  point.source = state.source;
  point.levels = levels_;
  point.levels.inputs_found = levels_of(inputs_before_);
  point.levels.inputs = levels_of(inputs_);
  if (!ring->push(point)) mail_.trace_lost.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace cnclab::machine
