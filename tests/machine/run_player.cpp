// The operator's actions, and what the test itself knows of the state that they lead to.
#include "run_player.hpp"

#include <fmt/core.h>

namespace cnclab::machine {

namespace {

constexpr int kMostTicks = 5000;
/// A dwell lasts at most 300 ticks; anything longer without motion is a path that hangs.
constexpr int kMostStuckTicks = 400;

}  // namespace

RunPlayer::RunPlayer(const RandomRun& run)
    : run_(run),
      data_(data_of(run.setup)),
      items_(items_of(run.elements)),
      machine_(data_),
      channel_(machine_, data_),
      checker_(PathOracle(items_, {}), motion_limits(data_), kTick_s) {}

void RunPlayer::begin() {
  motion::Planner* planner = channel_.begin_run(Epoch{epoch_}, {});
  if (planner == nullptr) return;
  ordered_ = begin_due_ = true;
  has_run_ = false;
  fed_ = 0;
  if (run_.setup.fed_at_once == 0) feed();
}

/// Appends the next items as a lab thread does that is not much faster than the machine.
void RunPlayer::feed() {
  const std::size_t at_once =
      run_.setup.fed_at_once == 0 ? items_.size() : static_cast<std::size_t>(run_.setup.fed_at_once);
  for (std::size_t i = 0; i < at_once && fed_ < items_.size(); ++i) {
    if (!channel_.planner().append(items_[fed_])) return;
    ++fed_;
    const bool is_due = fed_ % static_cast<std::size_t>(run_.setup.plan_every) == 0 || fed_ == items_.size();
    if (is_due) channel_.planner().plan();
  }
}

/// One counted order per tick, so that the counters of refused and dropped ones tell which it was.
void RunPlayer::order(const Command& command, Doing begins) {
  if (ordered_) tick();
  if (!channel_.command(command)) return;
  ordered_ = true;
  due_ = begins;
}

/// A stop; what was ordered in the same tick before it must not begin any more (AUTH-006).
void RunPlayer::must_rest() {
  must_rest_ = true;
  is_overtaken_ = is_overtaken_ || ordered_;
}

void RunPlayer::end_lease() {
  has_lease_ = false;
  must_rest();
}

void RunPlayer::perform(const Action& action) {
  using Kind = Action::Kind;
  const auto direction = [&](int axis) { return static_cast<std::int8_t>(action.value / (axis * axis + 1) % 3 - 1); };
  switch (action.kind) {
    case Kind::stop:
      channel_.stop(StopCause::operator_stop);
      return must_rest();
    case Kind::go:
      return order(Go{Epoch{epoch_}}, Doing::run);
    case Kind::stale_go:
      return order(Go{Epoch{epoch_ - 1}}, Doing::run);
    case Kind::potentiometer:
      ratio_ = action.value % 101 / 100.0;
      return channel_.set_override(ratio_);
    case Kind::single_block:
      return channel_.set_single_block(action.value % 2 != 0);
    case Kind::power_off:
      if (ordered_) tick();
      cut_ = channel_.command(PowerOff{});
      return must_rest();
    case Kind::power_on:
      if (ordered_) tick();
      static_cast<void>(channel_.command(PowerOn{}));
      return;
    case Kind::fault:
      fault_ticks_ = 1 + action.value % 5;
      return;
    case Kind::revoke:
      channel_.revoke(StopCause::lease_ended);
      return end_lease();
    case Kind::expire:
      expiry_ns_ = now_ns_ + action.value % 60 * kTick_ns;
      return channel_.grant(Epoch{epoch_}, expiry_ns_);
    case Kind::grant:
      channel_.grant(Epoch{++epoch_}, expiry_ns_ = kNeverExpires);
      has_lease_ = true;
      return must_rest();
    case Kind::halt:
      channel_.latch(true);
      return must_rest();
    case Kind::release_halt:
      return channel_.latch(false);
    case Kind::abandon:
      if (ordered_) tick();
      static_cast<void>(channel_.command(Abandon{}));
      return must_rest();
    case Kind::jog:
      return order(Jog{Epoch{epoch_}, {direction(0), direction(1), direction(2)}}, Doing::hand);
    case Kind::reference:
      return order(RunReference{Epoch{epoch_}, {direction(0), direction(1), direction(2)}}, Doing::reference);
    case Kind::input:
      return machine_.simulated.set_input(0, 0, action.value % 2 != 0);
    case Kind::begin_again:
      if (ordered_) tick();
      return is_at_rest() ? begin() : void();
    case Kind::feed:
      return channel_.planner().plan();
  }
}

/// What the orders of this tick led to, by the channel's own counters.
void RunPlayer::note_orders(const Snapshot& before, const Snapshot& now) {
  const bool is_taken = now.refused + now.dropped == before.refused + before.dropped;
  if (due_ != Doing::nothing && is_taken) {
    if (!has_lease_) played_.broken = "an order was taken without a lease";
    if (is_overtaken_) played_.broken = "an order was taken that is older than a stop";
    if (due_ == Doing::run && !has_run_) played_.broken = "START of a run that there is not";
    doing_ = due_;
    must_rest_ = false;
    if (due_ != Doing::run) has_run_ = false;
  }
  if (begin_due_ && is_taken) {
    checker_.begin_run(before.steps, {});
    has_run_ = true;
  }
  due_ = Doing::nothing;
  begin_due_ = ordered_ = is_overtaken_ = false;
}

void RunPlayer::tick() {
  if (run_.setup.fed_at_once > 0) feed();
  machine_.fault = fault_ticks_ > 0;
  fault_ticks_ = std::max(0, fault_ticks_ - 1);
  now_ns_ += kTick_ns;
  if (now_ns_ >= expiry_ns_ && has_lease_) end_lease();
  const Snapshot before = seen_;
  channel_.tick(now_ns_, kTick_s);
  seen_ = channel_.snapshot();
  conclude_tick(before, seen_);
  was_fault_ = machine_.fault;
}

void RunPlayer::conclude_tick(const Snapshot& before, const Snapshot& now) {
  ++played_.ticks;
  note_orders(before, now);
  if (was_fault_) must_rest();
  const bool in_reference = is_in_reference(before);
  const Doing doing = in_reference ? Doing::reference : doing_;
  Tick seen{before, now, machine_.last, doing, ratio_, must_rest_, has_lease_, cut_ || was_fault_};
  if (played_.broken.empty()) played_.broken = checker_.broken_rule(seen);
  if (in_reference && now.run == before.run && now.finished_sequence >= before.sequence) {
    checker_.anchor(now.steps, before.sequence - 1);
    ++played_.program_references;
  }
  guard_progress(before, now);
  for (std::size_t i = 0; i < 4; ++i) {
    if (machine_.sum[i] != machine_.simulated.position_steps()[i] && played_.broken.empty()) {
      played_.broken = fmt::format("axis {} ran into the end of its over-travel", i);
    }
  }
  played_.moving_ticks += now.speed_mm_per_min > 0 ? 1 : 0;
  if (now.cause == StopCause::limit_switch && before.cause != StopCause::limit_switch) ++played_.limit_stops;
  const bool has_ended = !now.started && doing_ != Doing::nothing;
  if (has_ended && must_rest_) ++played_.rests_after_stop;
  if (has_ended) doing_ = Doing::nothing;
  if (!now.run_active) has_run_ = false;
  cut_ = false;
  if (!played_.broken.empty() && !played_.broken.starts_with("tick")) {
    played_.broken = fmt::format("tick {}: {}", played_.ticks, played_.broken);
  }
}

/// The program's own reference run was under way when the tick began.
bool RunPlayer::is_in_reference(const Snapshot& before) const {
  if (doing_ != Doing::run || before.sequence == 0 || before.sequence > items_.size()) return false;
  return before.finished_sequence < before.sequence &&
         std::holds_alternative<geometry::Reference>(items_[before.sequence - 1].what);
}

/// A run that may move and has somewhere to go does so.
void RunPlayer::guard_progress(const Snapshot& before, const Snapshot& now) {
  const bool may_move = doing_ == Doing::run && !must_rest_ && now.state == MotionState::moving && ratio_ > 0;
  const bool is_same = now.sequence == before.sequence && channel_.queue().waiting() > 0;
  const bool stands = now.speed_mm_per_min <= 0 && is_same;
  stuck_ticks_ = may_move && stands ? stuck_ticks_ + 1 : 0;
  if (stuck_ticks_ > kMostStuckTicks && played_.broken.empty()) played_.broken = "the path hangs";
}

/// Everything on that START needs; the potentiometer stays where it is unless that would take too long.
void RunPlayer::release_all() {
  constexpr double kSlowest = 0.1;
  perform({Action::Kind::release_halt, 0, 0});
  perform({Action::Kind::power_on, 0, 0});
  perform({Action::Kind::single_block, 0, 0});
  perform({Action::Kind::input, 0, 1});
  if (ratio_ < kSlowest) perform({Action::Kind::potentiometer, 0, 100});
}

/// A run that was lost is begun anew, on a machine that is well again.
void RunPlayer::recover() {
  release_all();
  if (!has_lease_) perform({Action::Kind::grant, 0, 0});
  for (int i = 0; i < kMostTicks && !(is_at_rest() && doing_ == Doing::nothing) && !has_run_; ++i) tick();
  if (has_run_ || !is_at_rest()) return;
  perform({Action::Kind::begin_again, 0, 0});
  tick();
}

/// START again and again until the program is over, or else a last STOP.
void RunPlayer::finish() {
  recover();
  while (played_.ticks < kMostTicks && played_.broken.empty() && has_run_ && has_lease_) {
    const bool waits = seen_.state == MotionState::halted || (is_at_rest() && doing_ == Doing::nothing);
    if (waits && fed_ == items_.size()) perform({Action::Kind::go, 0, 0});
    tick();
  }
  played_.reached_end = seen_.finished_sequence == items_.size() && seen_.cause == StopCause::program_end;
  if (played_.reached_end && played_.broken.empty()) {
    const auto& end = checker_.path().end(items_.size() - 1);
    if (seen_.path_mm != std::array{end.x, end.y, end.z, end.u}) played_.broken = "does not end on the end point";
  }
  perform({Action::Kind::stop, 0, 0});
  for (int i = 0; i < kMostTicks * 4 && doing_ != Doing::nothing && played_.broken.empty(); ++i) tick();
}

Played RunPlayer::play() {
  channel_.grant(Epoch{epoch_}, kNeverExpires);
  tick();
  begin();
  tick();
  perform({Action::Kind::go, 0, 0});
  for (const Action& action : run_.actions) {
    for (int i = 0; i < action.after && played_.broken.empty() && played_.ticks < kMostTicks; ++i) tick();
    perform(action);
    if (!played_.broken.empty()) return played_;
  }
  finish();
  return played_;
}

}  // namespace cnclab::machine
