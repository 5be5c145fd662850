// Who may move the machine, and everything that stops it: lease, stops, limit switches, power (AUTH-002 to AUTH-010).
#include <algorithm>

#include "machine/channel_tick.hpp"

namespace cnclab::machine {

bool abandons_run(StopCause cause) {
  switch (cause) {
    case StopCause::none:
    case StopCause::operator_stop:
    case StopCause::programmed_halt:
    case StopCause::waiting_for_input:
    case StopCause::single_block:
      return false;
    case StopCause::program_end:
    case StopCause::limit_switch:
    case StopCause::power_off:
    case StopCause::machine_halt:
    case StopCause::lease_ended:
    case StopCause::lease_expired:
    case StopCause::error:
      return true;
  }
  return true;
}

/// The tick's own look at the lease: it holds without the lab thread's help (AUTH-007).
void ChannelTick::guard_lease(std::int64_t now_ns) noexcept {
  if (const auto newest = mail_.lease.try_load(); newest && newest->epoch >= lease_.epoch) lease_ = *newest;
  const auto number = static_cast<std::uint64_t>(lease_.epoch);
  const bool is_revoked = number <= mail_.revoked_up_to.load(std::memory_order_acquire);
  if (!is_revoked && now_ns >= lease_.expiry_ns) expired_up_to_ = std::max(expired_up_to_, number);
  const bool has_expired = number <= expired_up_to_;
  lease_valid_ = number != 0 && !is_revoked && !has_expired;
  if (holder_ == Epoch{} || (lease_valid_ && lease_.epoch == holder_)) return;
  const bool by_expiry = static_cast<std::uint64_t>(holder_) <= expired_up_to_;
  holder_ = Epoch{};
  heed(by_expiry ? StopCause::lease_expired : mail_.revoke_cause.load(std::memory_order_relaxed));
}

bool ChannelTick::may(Epoch epoch) noexcept {
  if (lease_valid_ && epoch == lease_.epoch) {
    holder_ = epoch;
    return true;
  }
  ++refused_;
  return false;
}

void ChannelTick::heed_stops() noexcept {
  const std::uint64_t count = mail_.stops.load(std::memory_order_acquire);
  if (count == stops_seen_) return;
  stops_seen_ = count;
  const std::uint32_t causes = mail_.stop_causes.exchange(0, std::memory_order_acquire);
  for (std::uint32_t bit = 0; bit <= static_cast<std::uint32_t>(StopCause::error); ++bit) {
    if ((causes >> bit & 1U) != 0) heed(static_cast<StopCause>(bit));
  }
}

/// A stop from outside the machine; the trace keeps it.
void ChannelTick::heed(StopCause cause) noexcept {
  levels_.stops = static_cast<std::uint16_t>(levels_.stops | 1U << static_cast<unsigned>(cause));
  stop_for(cause);
}

/// The first cause wins; but one that abandons the run is what the operator must know.
void ChannelTick::note_cause(StopCause cause) noexcept {
  const bool is_mild = !abandons_run(cause_) || cause_ == StopCause::program_end;
  if (cause_ == StopCause::none || (is_mild && abandons_run(cause))) cause_ = cause;
}

void ChannelTick::switch_off_tools() noexcept {
  outputs_.spindle = geometry::SpindleTurn::off;
  outputs_.spindle_rpm = 0;
  outputs_.coolant = false;
}

void ChannelTick::stop_for(StopCause cause) noexcept {
  if (cause == StopCause::power_off) {
    power_off();
    return;
  }
  const bool abandons = abandons_run(cause);
  if (abandons) switch_off_tools();
  const bool is_lease = cause == StopCause::lease_ended || cause == StopCause::lease_expired;
  if (activity_ == Activity::back_off && is_lease) return;  // part of a stop itself (AUTH-009)
  if (activity_ == Activity::back_off) {
    switches_.cancel();
    lose_reference();
    activity_ = Activity::none;
  }
  if (activity_ != Activity::none) {
    braking_ = true;
    abandon_at_rest_ = abandon_at_rest_ || abandons;
    note_cause(cause);
  } else if (abandons) {
    if (run_.is_active) abandon_run();
    note_cause(cause);
  }
}

void ChannelTick::come_to_rest(StopCause cause) noexcept {
  note_cause(cause);
  if (abandon_at_rest_ || abandons_run(cause)) abandon_run();
  activity_ = Activity::none;
  started_ = braking_ = abandon_at_rest_ = false;
  speed_mm_per_s_ = 0;
  settle_limits();
}

void ChannelTick::abandon_run() noexcept {
  follower_.abandon();
  switches_.cancel();
  run_.is_active = false;
  run_.waiting = Waiting::no;
  abandon_at_rest_ = false;
}

void ChannelTick::lose_reference() noexcept {
  if (referenced_ != std::array<bool, 3>{}) ++references_lost_;
  referenced_ = {};
}

void ChannelTick::lose_reference_if_fast() noexcept {
  if (speed_mm_per_s_ > limits_.start_stop_mm_per_s * 1.000001) lose_reference();
}

void ChannelTick::power_off() noexcept {
  lose_reference_if_fast();
  follower_.halt_now();
  hand_.halt_now();
  switches_.cancel();
  switch_off_tools();
  const unsigned off = mail_.outputs_off_at_power_off.load(std::memory_order_relaxed);
  for (std::size_t card = 0; card < outputs_.cards.size(); ++card)
    outputs_.cards[card] = static_cast<std::uint8_t>(outputs_.cards[card] & ~(off >> (8 * card)));
  outputs_.drives_on = false;
  if (cause_ != StopCause::power_off && (activity_ != Activity::none || run_.is_active)) cause_ = StopCause::none;
  come_to_rest(StopCause::power_off);
}

/// What came back from the machine after the last tick: a fault, or a switch that an axis ran onto.
void ChannelTick::heed_machine() noexcept {
  if (inputs_.fault && outputs_.drives_on) power_off();
  const bool answers = activity_before_ == Activity::run || activity_before_ == Activity::hand;
  if (!outputs_.drives_on || !answers || run_.waiting == Waiting::reference) return;
  Directions active{};
  bool any = false;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int32_t moved = outputs_.steps[i];
    const bool plus = inputs_.limit_plus[i], minus = inputs_.limit_minus[i];
    const bool came_on = (plus && !inputs_before_.limit_plus[i]) || (minus && !inputs_before_.limit_minus[i]);
    const bool runs_into = (plus && moved > 0) || (minus && moved < 0);
    if (moved == 0 || !(came_on || runs_into)) continue;
    active[i] = plus ? 1 : -1;
    any = true;
  }
  if (any) stop_at_switches(active);
}

/// ERR-020 in a run: all axes stop at once, the one on the switch is driven free. By hand it just stops (D-117).
void ChannelTick::stop_at_switches(const Directions& active) noexcept {
  const bool by_hand = activity_before_ == Activity::hand;
  lose_reference_if_fast();
  follower_.halt_now();
  hand_.halt_now();
  for (std::size_t i = 4; i-- > 0;) {
    if (active[i] != 0) limit_axis_ = static_cast<std::uint8_t>(i);
  }
  come_to_rest(StopCause::limit_switch);
  if (by_hand) return;
  activity_ = Activity::back_off;
  switches_.back_off(active, limits_, counters_);
}

}  // namespace cnclab::machine
