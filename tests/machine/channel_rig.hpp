// A channel with a simulated machine in virtual time; what goes over the seam is recorded.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <utility>
#include <vector>

#include "machine/channel.hpp"
#include "machine/simulated_machine.hpp"

namespace cnclab::machine {

inline constexpr double kTick_s = 1e-3;
inline constexpr std::int64_t kTick_ns = 1'000'000;
inline constexpr Epoch kLease{7};

/// Passes everything on to the simulated machine and keeps what it saw.
class WatchedMachine final : public Machine {
 public:
  explicit WatchedMachine(const MachineData& data) : simulated(data) {}
  Inputs exchange(const Outputs& outputs) noexcept override {
    last = outputs;
    for (std::size_t i = 0; i < 4; ++i) sum[i] += outputs.steps[i];
    const bool moves = outputs.steps != motion::AxisSteps{};
    moving_ticks += moves ? 1 : 0;
    inputs = simulated.exchange(outputs);
    inputs.fault = inputs.fault || fault;
    return inputs;
  }

  SimulatedMachine simulated;
  Outputs last;
  Inputs inputs;
  std::array<std::int64_t, 4> sum{};
  int moving_ticks = 0;
  bool fault = false;
};

inline MachineData data_with(std::initializer_list<std::pair<int, std::int64_t>> values) {
  MachineData data;
  for (const auto& [number, value] : values) {
    if (!data.set(number, value)) std::abort();
  }
  return data;
}

class ChannelRig {
 public:
  explicit ChannelRig(const MachineData& data = {}, bool with_lease = true) : machine(data), channel(machine, data) {
    if (with_lease) channel.grant(kLease, kNeverExpires);
    tick();
  }

  Snapshot tick(int count = 1) {
    for (int i = 0; i < count; ++i) channel.tick(now_ns += kTick_ns, kTick_s);
    return channel.snapshot();
  }

  /// Ticks until the condition holds; false after `most` ticks.
  template <class Condition>
  bool tick_until(Condition&& condition, int most = 200'000) {
    for (int i = 0; i < most; ++i) {
      if (condition(tick())) return true;
    }
    return false;
  }
  bool tick_to_rest(int most = 200'000) {
    return tick_until([](const Snapshot& s) { return s.state == MotionState::standstill; }, most);
  }

  /// Begins a run of these items from the path's origin; every item is a block of its own unless it says otherwise.
  void begin(const std::vector<geometry::PathItem>& items, geometry::Point from = {}, Epoch epoch = kLease) {
    motion::Planner* planner = channel.begin_run(epoch, from);
    if (planner == nullptr) std::abort();
    for (const auto& item : items) {
      if (!planner->append(item)) std::abort();
    }
    planner->plan();
  }
  void go(Epoch epoch = kLease) {
    if (!channel.command(Go{epoch})) std::abort();
  }
  void run(const std::vector<geometry::PathItem>& items, geometry::Point from = {}) {
    begin(items, from);
    go();
    tick();
  }

  WatchedMachine machine;
  Channel channel;
  std::int64_t now_ns = 0;
};

/// Items with running numbers; each ends its block.
class Items {
 public:
  Items& add(auto what) {
    geometry::PathItem item;
    item.what = what;
    item.sequence = static_cast<std::uint64_t>(list_.size()) + 1;
    item.source = {1, static_cast<std::uint16_t>(item.sequence)};
    item.ends_block = true;
    list_.push_back(item);
    return *this;
  }
  Items& line_to(geometry::Point to, double feed = 1200) {
    add(geometry::Line{at_, to, feed, false});
    at_ = to;
    return *this;
  }
  operator const std::vector<geometry::PathItem>&() const { return list_; }

 private:
  std::vector<geometry::PathItem> list_;
  geometry::Point at_;
};

}  // namespace cnclab::machine
