// What passes between lab thread and tick of one channel: levels as atomics, commands in a ring, state by seqlock.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <variant>

#include "machine/channel.hpp"
#include "machine/milling.hpp"
#include "machine/seqlock.hpp"
#include "machine/spsc_ring.hpp"

namespace cnclab::machine {

/// Made by Channel::begin_run alone, so that planner, run number and limits always belong together.
struct BeginRun {
  Epoch epoch{};
  std::uint64_t run = 0;
  geometry::Point position;
  motion::Limits limits;
  bool is_program = true;
  std::uint64_t resumptions = 0;  ///< before it: those of earlier runs
};

/// New machine data for manual motion and counters.
struct UseLimits {
  motion::Limits limits;
};

using Order = std::variant<Command, BeginRun, UseLimits>;

struct StampedOrder {
  Order order;
  std::uint64_t stops_seen = 0;  ///< stops given before this order
};

struct Lease {
  Epoch epoch{};
  std::int64_t expiry_ns = 0;
};

inline constexpr std::size_t kOrders = 64;
inline constexpr std::size_t kTracePoints = 8'192;
using TraceRing = SpscRing<TracePoint, kTracePoints>;

struct Mailbox {
  // lab to tick
  SpscRing<StampedOrder, kOrders> orders;
  std::atomic<std::uint64_t> stops{0};        ///< how often stop() was called
  std::atomic<std::uint32_t> stop_causes{0};  ///< bit = StopCause, set before `stops` rises
  std::atomic<bool> latched{false};           ///< MASCHINE HALT: no start command is taken
  std::atomic<double> override_ratio{1};
  std::atomic<bool> single_block{false};
  std::atomic<std::uint64_t> resumptions{0};               ///< their number so far
  std::atomic<std::uint16_t> outputs_off_at_power_off{0};  ///< bits 0..7 card 1, 8..15 card 2
  SeqLock<Lease> lease;
  std::atomic<std::uint64_t> revoked_up_to{0};  ///< epochs up to this one are dead
  std::atomic<StopCause> revoke_cause{StopCause::lease_ended};
  std::atomic<bool> trace_on{false};
  std::atomic<TraceRing*> trace{nullptr};
  std::atomic<CutFeed*> cuts{nullptr};
  // tick to lab
  SeqLock<Snapshot> snapshot;
  std::atomic<std::uint64_t> trace_lost{0};
};

}  // namespace cnclab::machine
