// A run in the tick: follow the path, execute the events between.
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

bool ChannelTick::is_input_active(const geometry::Wait& wait) const noexcept {
  if (wait.card < 1 || wait.card > 2) return inputs_.input_1;
  const std::uint8_t lines = inputs_.cards[static_cast<std::size_t>(wait.card - 1)];
  if (wait.line < 1 || wait.line > 8) return lines == 0xFF;
  return (lines >> (wait.line - 1) & 1U) != 0;
}

void ChannelTick::set_output(const geometry::Output& output) noexcept {
  if (output.card < 1 || output.card > 2) return;
  std::uint8_t& lines = outputs_.cards[static_cast<std::size_t>(output.card - 1)];
  const unsigned mask = output.line < 1 || output.line > 8 ? 0xFFU : 1U << (output.line - 1);
  lines = static_cast<std::uint8_t>(output.on ? lines | mask : lines & ~mask);
}

/// A run that brakes to be abandoned may still pass events, but nothing becomes active by it any more (AUTH-009).
bool ChannelTick::is_void(const motion::Segment& event) const noexcept {
  if (!abandon_at_rest_) return false;
  if (const auto* spindle = std::get_if<geometry::Spindle>(&event.item.what)) {
    return spindle->turn != geometry::SpindleTurn::off;
  }
  if (const auto* coolant = std::get_if<geometry::Coolant>(&event.item.what)) return coolant->on;
  if (const auto* output = std::get_if<geometry::Output>(&event.item.what)) return output->on;
  return std::holds_alternative<geometry::SpindleDigits>(event.item.what) ||
         std::holds_alternative<geometry::Signal>(event.item.what);
}

/// True when the event is done and the path goes on; false when the program waits, ends or the tick is over.
bool ChannelTick::execute(const motion::Segment& event) noexcept {
  const auto wait_for = [this](Waiting waiting) {
    run_.waiting = waiting;
    return false;
  };
  return std::visit(Overloaded{
                        [&](const geometry::Dwell& dwell) {
                          run_.dwell_left_s = dwell.seconds;
                          return dwell.seconds > 0 ? wait_for(Waiting::dwell) : true;
                        },
                        [&](const geometry::Spindle& spindle) {
                          outputs_.spindle = spindle.turn;
                          const bool on = spindle.turn != geometry::SpindleTurn::off;
                          outputs_.spindle_rpm = on ? static_cast<std::int32_t>(std::lround(spindle.rpm)) : 0;
                          return true;
                        },
                        [&](const geometry::Coolant& coolant) {
                          outputs_.coolant = coolant.on;
                          return true;
                        },
                        [&](const geometry::Output& output) {
                          set_output(output);
                          return true;
                        },
                        [&](const geometry::Wait& wait) { return is_input_active(wait) || wait_for(Waiting::input); },
                        [&](const geometry::SetActual& actual) {
                          for (std::size_t i = 0; i < 3; ++i) {
                            if (actual.axes[i]) counters_.set_istwert(i, actual.value[i]);
                          }
                          return true;
                        },
                        [&](const geometry::Reference& reference) {
                          begin_program_reference(reference);
                          return wait_for(Waiting::reference);
                        },
                        [&](const geometry::Halt& halt) {
                          signals_ += halt.signal ? 1 : 0;
                          outputs_.signal = outputs_.signal || halt.signal;
                          note_cause(StopCause::programmed_halt);
                          return wait_for(Waiting::halt);
                        },
                        [&](const geometry::Signal&) {
                          ++signals_;
                          outputs_.signal = true;
                          return true;
                        },
                        [&](const geometry::SpindleDigits& digits) {
                          outputs_.s_digits = digits.rpm;
                          return true;
                        },
                        [&](const geometry::End&) {
                          static_cast<void>(follower_.pass_event());
                          come_to_rest(StopCause::program_end);
                          return false;
                        },
                        [&](const geometry::ToolChange& tool) {
                          tool_ = {tool.number, tool.radius_mm, tool.length_mm};
                          return true;
                        },
                        [](const geometry::Mark&) { return true; },
                        [](const geometry::RadiusOffset&) { return true; },
                        [](const geometry::LengthOffset&) { return true; },
                        [](const geometry::CornerRounding&) { return true; },
                        [](const geometry::Line&) { return true; },
                        [](const geometry::Arc&) { return true; },
                    },
                    event.item.what);
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
