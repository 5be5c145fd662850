// A run in the tick: what stands between the motions is executed.
#include <cmath>

#include "machine/channel_tick.hpp"

namespace cnclab::machine {

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
struct ChannelTick::Execution {
  ChannelTick& tick;

  [[nodiscard]] bool wait_for(Waiting waiting) const noexcept {
    tick.run_.waiting = waiting;
    return false;
  }

  bool operator()(const geometry::Dwell& dwell) const noexcept {
    tick.run_.dwell_left_s = dwell.seconds;
    return dwell.seconds > 0 ? wait_for(Waiting::dwell) : true;
  }
  bool operator()(const geometry::Wait& wait) const noexcept {
    return tick.is_input_active(wait) || wait_for(Waiting::input);
  }
  bool operator()(const geometry::Halt& halt) const noexcept {
    tick.signals_ += halt.signal ? 1 : 0;
    tick.outputs_.signal = tick.outputs_.signal || halt.signal;
    tick.note_cause(StopCause::programmed_halt);
    return wait_for(Waiting::halt);
  }
  bool operator()(const geometry::Reference& reference) const noexcept {
    tick.begin_program_reference(reference);
    return wait_for(Waiting::reference);
  }
  bool operator()(const geometry::End&) const noexcept {
    static_cast<void>(tick.follower_.pass_event());
    tick.come_to_rest(StopCause::program_end);
    return false;
  }

  bool operator()(const geometry::Spindle& spindle) const noexcept {
    tick.outputs_.spindle = spindle.turn;
    const bool on = spindle.turn != geometry::SpindleTurn::off;
    tick.outputs_.spindle_rpm = on ? static_cast<std::int32_t>(std::lround(spindle.rpm)) : 0;
    return true;
  }
  bool operator()(const geometry::SpindleDigits& digits) const noexcept {
    tick.outputs_.s_digits = digits.rpm;
    return true;
  }
  bool operator()(const geometry::Coolant& coolant) const noexcept {
    tick.outputs_.coolant = coolant.on;
    return true;
  }
  bool operator()(const geometry::Output& output) const noexcept {
    tick.set_output(output);
    return true;
  }
  bool operator()(const geometry::Signal&) const noexcept {
    ++tick.signals_;
    tick.outputs_.signal = true;
    return true;
  }
  bool operator()(const geometry::SetActual& actual) const noexcept {
    for (std::size_t i = 0; i < 3; ++i)
      if (actual.axes[i]) tick.counters_.set_istwert(i, actual.value[i]);
    return true;
  }
  bool operator()(const geometry::ToolChange& tool) const noexcept {
    tick.tool_ = {tool.number, tool.radius_mm, tool.length_mm};
    return true;
  }

  // Nothing to do here: marks, what the stages before have used up, and motions, which are the follower's.
  bool operator()(const geometry::Mark&) const noexcept { return true; }
  bool operator()(const geometry::RadiusOffset&) const noexcept { return true; }
  bool operator()(const geometry::LengthOffset&) const noexcept { return true; }
  bool operator()(const geometry::CornerRounding&) const noexcept { return true; }
  bool operator()(const geometry::Line&) const noexcept { return true; }
  bool operator()(const geometry::Arc&) const noexcept { return true; }
};

bool ChannelTick::execute(const motion::Segment& event) noexcept {
  return std::visit(Execution{*this}, event.item.what);
}

}  // namespace cnclab::machine
