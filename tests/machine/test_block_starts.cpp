// Input 1 at the starts of blocks, for the two-block rule of G21 and G23 (D-56).
#include <gtest/gtest.h>

#include <type_traits>

#include "channel_rig.hpp"

namespace cnclab::machine {
namespace {

static_assert(std::is_trivially_copyable_v<Snapshot>);

std::vector<geometry::PathItem> blocks(int count, double way_mm) {
  Items items;
  for (int i = 1; i <= count; ++i) items.line_to({i * way_mm, 0, 0, 0}, 600);
  return items;
}

/// Sets Input 1 once block `sequence` has begun.
void set_input_in(ChannelRig& rig, std::uint64_t sequence, bool active) {
  ASSERT_TRUE(rig.tick_until([&](const Snapshot& s) { return s.sequence >= sequence; }));
  rig.machine.simulated.set_input(0, 0, active);
}

TEST(BlockStarts, D56InputIsTheOneOfTheTickInWhichTheBlockBegan) {
  ChannelRig rig;
  rig.run(blocks(4, 1));
  set_input_in(rig, 1, true);
  set_input_in(rig, 2, false);
  set_input_in(rig, 3, true);
  const Snapshot now = rig.channel.snapshot();
  EXPECT_EQ(input_1_at_start(now, 0), false);
  EXPECT_EQ(input_1_at_start(now, 1), false);
  EXPECT_EQ(input_1_at_start(now, 2), true) << "became active during block 1";
  EXPECT_EQ(input_1_at_start(now, 3), false);
  EXPECT_EQ(input_1_at_start(now, 4), std::nullopt) << "has not begun";
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.sequence == 4; }));
  EXPECT_EQ(input_1_at_start(rig.channel.snapshot(), 4), true);
}

TEST(BlockStarts, D56StartIsKnownBeforeAnyBlockIsAppended) {
  ChannelRig rig;
  rig.machine.simulated.set_input(0, 0, true);
  rig.begin({});
  EXPECT_EQ(input_1_at_start(rig.tick(), 0), std::nullopt) << "taken up but not started";
  rig.go();
  EXPECT_EQ(input_1_at_start(rig.tick(), 0), true);
  rig.machine.simulated.set_input(0, 0, false);
  EXPECT_EQ(input_1_at_start(rig.tick(50), 0), true);
  EXPECT_EQ(input_1_at_start(rig.tick(50), 1), std::nullopt);
}

TEST(BlockStarts, BlocksOfOneTickShareAnEntry) {
  ChannelRig rig;
  rig.machine.simulated.set_input(0, 0, true);
  Items items;
  for (int i = 0; i < 20; ++i) items.add(geometry::Mark{});
  items.line_to({5, 0, 0, 0});
  rig.tick();
  rig.run(items);
  const Snapshot now = rig.channel.snapshot();
  EXPECT_EQ(now.block_start_count, 1);
  for (const std::uint64_t sequence : {0U, 1U, 20U, 21U}) EXPECT_EQ(input_1_at_start(now, sequence), true) << sequence;
}

TEST(BlockStarts, TheLastFourAreKeptAndStopAddsNone) {
  ChannelRig rig;
  rig.run(blocks(8, 1));
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.sequence == 6; }));
  rig.channel.stop(StopCause::operator_stop);
  ASSERT_TRUE(rig.tick_to_rest());
  rig.go();
  const Snapshot now = rig.tick(5);
  ASSERT_EQ(now.block_start_count, 4);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(now.block_starts[i].sequence, 3 + i);
}

TEST(BlockStarts, ANewRunKnowsNothingOfTheLastOne) {
  ChannelRig rig;
  rig.run(blocks(3, 0.1));
  rig.tick(1000);
  rig.channel.stop(StopCause::operator_stop);
  ASSERT_TRUE(rig.tick_to_rest());
  rig.begin({}, {0.3, 0, 0, 0});
  EXPECT_EQ(rig.tick().block_start_count, 0);
}

}  // namespace
}  // namespace cnclab::machine
