// The tick allocates nothing (architecture.md rule 6): operator new is replaced and counts.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "channel_rig.hpp"
#include "machine/milling.hpp"
#include "machine/recorder.hpp"

namespace {
std::atomic<bool> counting{false};
std::atomic<std::uint64_t> allocations{0};

void* counted(std::size_t size) {
  if (counting.load()) allocations.fetch_add(1);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* counted(std::size_t size, std::align_val_t alignment) {
  if (counting.load()) allocations.fetch_add(1);
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return counted(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return counted(size, alignment); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace cnclab::machine {
namespace {

/// Ticks with the counter on; returns what was allocated meanwhile.
std::uint64_t allocated_in(ChannelRig& rig, int ticks) {
  allocations = 0;
  counting = true;
  for (int i = 0; i < ticks; ++i) rig.channel.tick(rig.now_ns += kTick_ns, kTick_s);
  counting = false;
  return allocations;
}

TEST(TickCost, NoTickOfAnyKindAllocates) {
  auto* probe = new int(1);
  allocations = 0;
  counting = true;
  delete new int(2);
  counting = false;
  delete probe;
  ASSERT_EQ(allocations, 1U) << "the counter counts";

  ChannelRig rig(data_with({{3, 60'000}}));
  rig.channel.record_trace(true);
  CutFeed cuts;
  rig.channel.feed_cuts(&cuts);
  Items items;
  items.line_to({5, 5, 0, 0}).add(geometry::Spindle{geometry::SpindleTurn::clockwise, 100}).add(geometry::Dwell{0.1});
  items.add(
      geometry::Arc{{5, 5, 0, 0}, {5, 5, 0, 0}, {0, 5, 0, 0}, geometry::Turn::clockwise, geometry::Plane::xy, 900});
  items.add(geometry::Wait{1, 1}).add(geometry::Reference{{true, false, false}, {1, 0, 0}});
  items.add(geometry::Halt{true}).line_to({60, 5, 0, 0});
  rig.begin(items);
  rig.go();
  std::uint64_t sum = allocated_in(rig, 3000);
  rig.go();
  sum += allocated_in(rig, 5000);  // wait cancelled, reference, halt
  rig.channel.stop(StopCause::operator_stop);
  sum += allocated_in(rig, 500);
  rig.go();
  rig.channel.set_override(0.7);
  sum += allocated_in(rig, 4000);  // onto the switch and back
  (void)rig.channel.command(Jog{kLease, {-1, 0, 1}});
  sum += allocated_in(rig, 300);
  rig.channel.revoke(StopCause::lease_ended);
  sum += allocated_in(rig, 500);
  EXPECT_EQ(sum, 0U);
  EXPECT_EQ(rig.channel.snapshot().cause, StopCause::lease_ended);
  EXPECT_GT(rig.machine.moving_ticks, 2000);
  EXPECT_TRUE(cuts.ring.pop()) << "the workpiece was fed";
}

TEST(TickCost, RecordingAndReplayingAllocateNothing) {
  SimulatedMachine simulated({});
  MachineRecorder recorder(simulated, 4000);
  Outputs outputs;
  allocations = 0;
  counting = true;
  for (int i = 0; i < 2000; ++i) {
    outputs.steps = {i % 9, -i, 0, 0};
    (void)recorder.exchange(outputs);
  }
  counting = false;
  EXPECT_EQ(allocations, 0U);
  EXPECT_GT(recorder.ticks_lost(), 0U) << "also when it is full";
  const auto bytes = recorder.bytes();
  ReplayMachine replay(bytes);
  counting = true;
  for (int i = 0; i < 2000; ++i) (void)replay.exchange(outputs);
  counting = false;
  EXPECT_EQ(allocations, 0U);
}

}  // namespace
}  // namespace cnclab::machine
