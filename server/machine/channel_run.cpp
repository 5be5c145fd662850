// A run in the tick: follow the path. The events between: channel_events.cpp.
#include <algorithm>
#include <cmath>

#include "machine/channel_tick.hpp"

namespace cnclab::machine {

namespace {

/// The planner makes a full stop in longer rows, so a tick with motion never has more.
constexpr int kMostEventsPerTick = 128;

std::array<double, 4> axes_of(const geometry::Point& point) { return {point.x, point.y, point.z, point.u}; }

const geometry::Point* start_of(const motion::Segment& segment) {
  if (const auto* line = std::get_if<geometry::Line>(&segment.item.what)) return &line->from;
  if (const auto* arc = std::get_if<geometry::Arc>(&segment.item.what)) return &arc->from;
  return nullptr;
}

}  // namespace

void ChannelTick::run_tick(double tick_s, const motion::Demand& demand) noexcept {
  if (run_.waiting != Waiting::no) {
    follower_.choose_rest(demand.single_block);
    if (wait_tick(tick_s)) return;
  }
  double left_s = tick_s;
  for (int events = 0; events < kMostEventsPerTick && activity_ == Activity::run; ++events) {
    anchor_path();
    const motion::Advance done = follower_.advance(left_s, demand);
    speed_mm_per_s_ = follower_.speed_mm_per_s();
    source_ = follower_.source();
    sequence_ = follower_.sequence();
    if (!place_axes(tick_s)) return;
    if (braking_ && !done.moving) return come_to_rest(StopCause::operator_stop);
    if (done.held) return come_to_rest(StopCause::single_block);
    if (!done.event_reached) return;
    left_s = done.left_s;
    const motion::Segment& event = *follower_.current();
    source_ = event.item.source;
    sequence_ = event.item.sequence;
    if (!is_void(event) && !execute(event)) return;
    pass_event();
  }
}

void ChannelTick::pass_event() noexcept {
  if (follower_.pass_event()) come_to_rest(StopCause::single_block);
}

/// One entry per tick is enough: whatever began in it saw the same Input 1. The run's first tick is its START.
void ChannelTick::note_block_start() noexcept {
  auto& starts = run_.starts;
  if (run_.start_count > 0 && sequence_ <= starts[run_.start_count - 1U].sequence) return;
  if (run_.start_count == starts.size()) {
    std::ranges::move(starts.begin() + 1, starts.end(), starts.begin());
    --run_.start_count;
  }
  starts[run_.start_count++] = {sequence_, inputs_.input_1};
}

/// What the present place is called in the path: the next motion's start. The path never jumps, but after G69 only the
/// axes know where they are.
void ChannelTick::anchor_path() noexcept {
  if (!run_.anchor_due) return;
  const motion::Segment* next = follower_.current();
  const geometry::Point* start = next != nullptr ? start_of(*next) : nullptr;
  if (start == nullptr) return;
  run_.anchor_due = false;
  anchor_at(*start);
}

/// Calls the place where the axes are `place`.
void ChannelTick::anchor_at(const geometry::Point& place) noexcept {
  follower_.set_position(place);
  const auto mm = axes_of(place);
  for (std::size_t i = 0; i < 4; ++i) {
    run_.origin[i] = counters_.steps()[i] - std::llround(mm[i] * counters_.per_mm(i));
  }
}

/// Steps follow the exact position, rounded anew in each tick. False: the path jumps, which no planner may produce;
/// nothing of it goes out.
bool ChannelTick::place_axes(double tick_s) noexcept {
  const auto place = axes_of(follower_.position());
  std::array<std::int64_t, 4> target{};
  bool is_possible = true;
  for (std::size_t i = 0; i < 4; ++i) {
    target[i] = run_.origin[i] + std::llround(place[i] * counters_.per_mm(i));
    const auto way = static_cast<double>(std::abs(target[i] - counters_.steps()[i]));
    is_possible = is_possible && way <= limits_.f_max_mm_per_s * tick_s * counters_.per_mm(i) * 1.001 + 2;
  }
  if (!is_possible) {
    lose_reference_if_fast();
    follower_.halt_now();
    switch_off_tools();
    come_to_rest(StopCause::error);
    return false;
  }
  for (std::size_t i = 0; i < 4; ++i) counters_.step_to(i, target[i]);
  return true;
}

/// One tick of a wait. True: the tick is used up.
bool ChannelTick::wait_tick(double tick_s) noexcept {
  if (braking_ && run_.waiting != Waiting::reference) {
    come_to_rest(StopCause::operator_stop);
    return true;
  }
  const motion::Segment* event = follower_.current();
  if (event == nullptr) return false;
  switch (run_.waiting) {
    case Waiting::no:
    case Waiting::halt:
      return true;
    case Waiting::dwell:
      run_.dwell_left_s -= tick_s;
      if (run_.dwell_left_s > tick_s / 2) return true;
      break;
    case Waiting::input: {
      const auto* wait = std::get_if<geometry::Wait>(&event->item.what);
      if (wait != nullptr && !is_input_active(*wait)) {
        note_cause(StopCause::waiting_for_input);
        return true;
      }
      cause_ = StopCause::none;
      break;
    }
    case Waiting::reference:
      switches_.advance(tick_s, mail_.override_ratio.load(std::memory_order_relaxed), braking_, inputs_, counters_);
      speed_mm_per_s_ = switches_.speed_mm_per_s();
      if (switches_.has_failed()) come_to_rest(StopCause::error);
      if (activity_ != Activity::run) return true;
      if (switches_.is_done()) {
        end_program_reference();
        break;
      }
      if (braking_ && speed_mm_per_s_ <= 0) come_to_rest(StopCause::operator_stop);
      return true;
  }
  run_.waiting = Waiting::no;
  pass_event();
  return true;
}

void ChannelTick::begin_program_reference(const geometry::Reference& reference) noexcept {
  Directions directions{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (reference.axes[i]) directions[i] = reference.value[i] < 0 ? -1 : 1;  // G-693: 0 drives in positive direction
  }
  switches_.search(directions, limits_, counters_);
}

/// G-691: the word's value is the Istwert after backing off.
void ChannelTick::end_program_reference() noexcept {
  const motion::Segment* event = follower_.current();
  const auto* reference = event != nullptr ? std::get_if<geometry::Reference>(&event->item.what) : nullptr;
  if (reference == nullptr) return;
  for (std::size_t i = 0; i < 3; ++i) {
    if (reference->axes[i]) note_reference(i, reference->value[i]);
  }
  anchor_at(follower_.position());
  run_.anchor_due = true;
}

}  // namespace cnclab::machine
