// Commands of the lab thread, each checked for its lease, its age and the state it meets.
#include <algorithm>
#include <cmath>

#include "machine/channel_tick.hpp"

namespace cnclab::machine {

void ChannelTick::take_orders() noexcept {
  for (std::size_t i = 0; i < kOrders; ++i) {
    const auto order = mail_.orders.pop();
    if (!order) return;
    ++orders_;
    const bool is_latched = mail_.latched.load(std::memory_order_acquire);
    const bool is_fresh = !is_latched && order->stops_seen == stops_seen_;
    std::visit([&](const auto& what) { obey(what, is_fresh); }, order->order);
  }
}

void ChannelTick::obey(const Command& command, bool is_fresh) noexcept {
  std::visit(Overloaded{
                 [&](const Abandon&) {
                   if (activity_ == Activity::none && run_.is_active) abandon_run();
                   if (activity_ == Activity::run || activity_ == Activity::hand || activity_ == Activity::reference) {
                     braking_ = abandon_at_rest_ = true;
                     note_cause(StopCause::operator_stop);
                   }
                 },
                 [&](const Go& go_command) { go(go_command.epoch, is_fresh); },
                 [&](const SwitchSpindle& c) {
                   if (!may(c.epoch)) return;
                   const bool on = c.spindle.turn != geometry::SpindleTurn::off;
                   if (on && (!is_fresh || !outputs_.drives_on)) {
                     ++dropped_;
                     return;
                   }
                   outputs_.spindle = c.spindle.turn;
                   outputs_.spindle_rpm = on ? static_cast<std::int32_t>(c.spindle.rpm) : 0;
                 },
                 [&](const SwitchCoolant& c) {
                   if (!may(c.epoch)) return;
                   if (c.on && (!is_fresh || !outputs_.drives_on)) {
                     ++dropped_;
                     return;
                   }
                   outputs_.coolant = c.on;
                 },
                 [&](const SetIstwert& c) { set_istwert(c); },
                 [&](const Jog& jog) { start_hand(jog, is_fresh); },
                 [&](const RunReference& reference) { start_reference(reference, is_fresh); },
                 [&](const PowerOff&) { heed(StopCause::power_off); },
                 [&](const PowerOn&) { outputs_.drives_on = outputs_.drives_on || !inputs_.fault; },
             },
             command);
}

void ChannelTick::use_limits(const motion::Limits& limits) noexcept {
  limits_ = limits;
  limits_due_.reset();
  counters_.set_steps_per_mm(limits.steps_per_mm);
}

void ChannelTick::obey(const UseLimits& order, bool /*is_fresh*/) noexcept {
  limits_due_ = order.limits;
  settle_limits();
}

/// New machine data hold as soon as no run is kept that was planned with the old ones (DEC-28).
void ChannelTick::settle_limits() noexcept {
  if (limits_due_ && activity_ == Activity::none && !run_.is_active) use_limits(*limits_due_);
}

/// Takes a run up; starts nothing, so an older stop does not matter.
void ChannelTick::obey(const BeginRun& order, bool /*is_fresh*/) noexcept {
  if (!may(order.epoch)) return;
  if (activity_ != Activity::none || !outputs_.drives_on) {
    ++dropped_;
    return;
  }
  if (run_.is_active) abandon_run();
  use_limits(order.limits);
  follower_.begin(order.run, order.position, order.limits);
  run_ = {.number = order.run, .is_active = true, .anchor_due = true, .is_program = order.is_program};
  anchor_at(order.position);
  sequence_ = 0;
  resumptions_seen_ = order.resumptions;
}

/// For whatever sets axes in motion.
bool ChannelTick::may_start(Epoch epoch, bool is_fresh) noexcept {
  if (!may(epoch)) return false;
  if (is_fresh && outputs_.drives_on && activity_ == Activity::none) return true;
  ++dropped_;
  return false;
}

void ChannelTick::begin_activity(Activity activity) noexcept {
  activity_ = activity;
  started_ = true;
  braking_ = abandon_at_rest_ = false;
  cause_ = StopCause::none;
  limit_axis_ = 0xFF;
  start_steps_ = counters_.steps();
  for (std::size_t i = 0; i < 4; ++i) start_istwert_mm_[i] = counters_.istwert_mm(i);
}

/// There is no path by hand: places are called by their Istwert, in the trace too.
void ChannelTick::begin_by_hand(Activity activity, const Directions& directions) noexcept {
  begin_activity(activity);
  for (std::size_t i = 0; i < 4; ++i) {
    run_.origin[i] = counters_.steps()[i] - std::llround(counters_.istwert_mm(i) * counters_.per_mm(i));
  }
  std::copy_n(directions.begin(), levels_.by_hand.size(), levels_.by_hand.begin());
  levels_.is_reference = activity == Activity::reference;
}

void ChannelTick::go(Epoch epoch, bool is_fresh) noexcept {
  const bool is_released_halt = run_.waiting == Waiting::halt || run_.waiting == Waiting::input;
  if (activity_ == Activity::run && is_released_halt && !braking_) {
    if (!may(epoch)) return;
    if (!is_fresh) {
      ++dropped_;
      return;
    }
    const bool was_halt = run_.waiting == Waiting::halt;
    run_.waiting = Waiting::no;
    cause_ = StopCause::none;
    levels_.go = true;
    // In single block the halt itself was the rest behind its block: this START already means the next one.
    if (was_halt) {
      static_cast<void>(follower_.pass_event());
    } else {
      pass_event();
    }
    return;
  }
  if (!may_start(epoch, is_fresh)) return;
  if (!run_.is_active) {
    ++dropped_;
    return;
  }
  begin_activity(Activity::run);
  levels_.go = true;
  if (!run_.has_begun) {
    run_.has_begun = true;
    if (run_.is_program || !cut_base_.is_set) begin_workpiece();
  }
  if (run_.waiting == Waiting::halt) {  // START after STOP in a halt: the halt waited for just that
    run_.waiting = Waiting::no;
    static_cast<void>(follower_.pass_event());
  }
}

/// Whence the tool's way is counted from here on (DEC-24).
void ChannelTick::begin_workpiece() noexcept {
  cut_base_ = {.steps = counters_.steps(), .is_set = true, .is_new = true};
  for (std::size_t i = 0; i < 3; ++i) cut_base_.mm[i] = counters_.istwert_mm(i);
}

void ChannelTick::start_hand(const Jog& jog, bool is_fresh) noexcept {
  if (!may_start(jog.epoch, is_fresh)) return;
  Directions directions{};
  bool any = false, towards_switch = false;
  for (std::size_t i = 0; i < 3; ++i) {
    directions[i] = static_cast<std::int8_t>((jog.direction[i] > 0) - (jog.direction[i] < 0));
    any = any || directions[i] != 0;
    towards_switch =
        towards_switch || (directions[i] > 0 && inputs_.limit_plus[i]) || (directions[i] < 0 && inputs_.limit_minus[i]);
  }
  if (!any || towards_switch) {
    ++dropped_;
    return;
  }
  if (run_.is_active) abandon_run();
  settle_limits();
  hand_.start(directions, limits_, counters_);
  begin_by_hand(Activity::hand, directions);
}

void ChannelTick::start_reference(const RunReference& reference, bool is_fresh) noexcept {
  if (!may_start(reference.epoch, is_fresh)) return;
  Directions directions{};
  for (std::size_t i = 0; i < 3; ++i) {
    directions[i] = static_cast<std::int8_t>((reference.direction[i] > 0) - (reference.direction[i] < 0));
  }
  if (directions == Directions{}) {
    ++dropped_;
    return;
  }
  if (run_.is_active) abandon_run();
  settle_limits();
  switches_.search(directions, limits_, counters_);
  begin_by_hand(Activity::reference, directions);
}

/// Sub mode ISTWERT (HA): at rest only.
void ChannelTick::set_istwert(const SetIstwert& command) noexcept {
  if (!may(command.epoch)) return;
  if (activity_ != Activity::none) {
    ++dropped_;
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (command.axes[i]) counters_.set_istwert(i, command.value_mm[i]);
  }
}

}  // namespace cnclab::machine
