// The lab thread's side of a channel.
#include "machine/channel.hpp"

#include <algorithm>
#include <bitset>
#include <utility>

#include "machine/channel_mailbox.hpp"
#include "machine/channel_tick.hpp"

namespace cnclab::machine {

std::optional<bool> input_1_at_start(const Snapshot& now, std::uint64_t sequence) {
  for (std::size_t i = 0; i < now.block_start_count; ++i) {
    if (now.block_starts[i].sequence >= sequence) return now.block_starts[i].input_1;
  }
  return std::nullopt;
}

struct Channel::Impl {
  Impl(Machine& iron, const MachineData& data)
      : machine(iron), limits(motion_limits(data)), planner(queue, limits), ticker(iron, queue, mail, limits) {}

  [[nodiscard]] bool order(const Order& what) {
    if (!mail.orders.push({what, mail.stops.load(std::memory_order_relaxed)})) return false;
    ++given;
    queue.trim();
    return true;
  }

  Machine& machine;
  motion::Limits limits;  ///< of the newest machine data
  motion::SegmentQueue queue;
  motion::Planner planner;
  Mailbox mail;
  ChannelTick ticker;
  std::unique_ptr<TraceRing> trace;
  std::uint64_t given = 0;  ///< orders put into the ring
  std::uint64_t trace_lost_seen = 0;
  Epoch newest_epoch{};
  std::bitset<kResumptionsKept> answers;  ///< at the newest resumptions, each in the place of its number
};

Channel::Channel(Machine& machine, const MachineData& data) : impl_(std::make_unique<Impl>(machine, data)) {}
Channel::~Channel() = default;

motion::Planner* Channel::begin_run(Epoch epoch, const geometry::Point& position, bool is_program) {
  const BeginRun order{epoch,      impl_->planner.run() + 1,
                       position,   impl_->limits,
                       is_program, impl_->mail.resumptions.load(std::memory_order_relaxed)};
  if (!impl_->order(order)) return nullptr;
  impl_->planner.restart(impl_->limits);
  return &impl_->planner;
}

motion::Planner& Channel::planner() { return impl_->planner; }
const motion::SegmentQueue& Channel::queue() const { return impl_->queue; }
bool Channel::command(const Command& command) { return impl_->order(command); }
bool Channel::is_settled() const { return snapshot().orders == impl_->given; }

void Channel::stop(StopCause cause) {
  impl_->mail.stop_causes.fetch_or(1U << static_cast<unsigned>(cause), std::memory_order_release);
  impl_->mail.stops.fetch_add(1, std::memory_order_release);
}

void Channel::cut() noexcept {
  impl_->machine.cut();
  stop(StopCause::power_off);
}

void Channel::latch(bool on) {
  impl_->mail.latched.store(on, std::memory_order_release);
  if (on) stop(StopCause::machine_halt);
}

void Channel::set_override(double ratio) {
  // As exactly as the trace keeps it, so that a replay turns it to the same.
  const auto kept = static_cast<float>(std::clamp(ratio, 0.0, 1.0));
  impl_->mail.override_ratio.store(static_cast<double>(kept), std::memory_order_relaxed);
}

void Channel::note_resumption(bool input_1) {
  // Only this thread writes.
  const std::uint64_t number = impl_->mail.resumptions.load(std::memory_order_relaxed) + 1;
  impl_->answers[number % kResumptionsKept] = input_1;
  impl_->mail.resumptions.store(number, std::memory_order_release);
}

bool Channel::answer_at_resumption(std::uint64_t number) const { return impl_->answers[number % kResumptionsKept]; }

void Channel::set_single_block(bool on) { impl_->mail.single_block.store(on, std::memory_order_relaxed); }

void Channel::set_outputs_off_at_power_off(const std::array<std::uint8_t, 2>& cards) {
  impl_->mail.outputs_off_at_power_off.store(static_cast<std::uint16_t>(cards[0] | cards[1] << 8),
                                             std::memory_order_relaxed);
}

void Channel::grant(Epoch epoch, std::int64_t expiry_ns) {
  if (epoch < impl_->newest_epoch) return;
  impl_->newest_epoch = epoch;
  impl_->mail.lease.store({epoch, expiry_ns});
}

void Channel::revoke(StopCause cause) {
  impl_->mail.revoke_cause.store(cause, std::memory_order_relaxed);
  impl_->mail.revoked_up_to.store(static_cast<std::uint64_t>(impl_->newest_epoch), std::memory_order_release);
}

bool Channel::set_data(const MachineData& data) {
  const Snapshot now = snapshot();
  const bool at_rest = now.state == MotionState::standstill || now.state == MotionState::off;
  if (now.started || !at_rest || !is_settled()) return false;
  const motion::Limits limits = motion_limits(data);
  if (!impl_->order(UseLimits{limits})) return false;
  impl_->limits = limits;
  return true;
}

Snapshot Channel::snapshot() const { return impl_->mail.snapshot.load(); }

void Channel::record_trace(bool on) {
  if (on && !impl_->trace) {
    impl_->trace = std::make_unique<TraceRing>();
    impl_->mail.trace.store(impl_->trace.get(), std::memory_order_release);
  }
  impl_->mail.trace_on.store(on, std::memory_order_release);
}

std::uint64_t Channel::drain_trace(std::vector<TracePoint>& out) {
  if (!impl_->trace) return 0;
  while (const auto point = impl_->trace->pop()) out.push_back(*point);
  const std::uint64_t lost = impl_->mail.trace_lost.load(std::memory_order_relaxed);
  return lost - std::exchange(impl_->trace_lost_seen, lost);
}

void Channel::feed_cuts(CutFeed* feed) { impl_->mail.cuts.store(feed, std::memory_order_release); }

void Channel::tick(std::int64_t now_ns, double tick_s) noexcept { impl_->ticker.tick(now_ns, tick_s); }

}  // namespace cnclab::machine
