// The 1 ms beat on the real clock: channels come and go while it runs.
#include <gtest/gtest.h>

#include <thread>

#include "channel_rig.hpp"
#include "comes_true.hpp"
#include "machine/tick_thread.hpp"

namespace cnclab::machine {
namespace {

TEST(TickThread, TicksEachChannelAndTellsWhatItWasGranted) {
  TickThread beat;
  EXPECT_FALSE(beat.privileges().empty());
  WatchedMachine machine_a{{}}, machine_b{{}};
  const auto a = std::make_shared<Channel>(machine_a, MachineData{});
  const auto b = std::make_shared<Channel>(machine_b, MachineData{});
  ASSERT_TRUE(beat.add(a));
  ASSERT_TRUE(beat.add(b));
  EXPECT_TRUE(comes_true([&] { return a->snapshot().tick > 20 && b->snapshot().tick > 20; }));
  EXPECT_GE(beat.statistics().ticks, 20U);
}

TEST(TickThread, ARemovedChannelIsNeverTouchedAgain) {
  TickThread beat;
  for (int round = 0; round < 50; ++round) {
    auto machine = std::make_unique<WatchedMachine>(MachineData{});
    auto channel = std::make_shared<Channel>(*machine, MachineData{});
    ASSERT_TRUE(beat.add(channel));
    ASSERT_TRUE(comes_true([&] { return channel->snapshot().tick > 0; }));
    beat.remove(channel);
    const auto tick = channel->snapshot().tick;
    EXPECT_EQ(channel.use_count(), 1);
    EXPECT_EQ(channel->snapshot().tick, tick);
  }
}

TEST(TickThread, LabThreadFeedsStopsAndRenewsWhileTheBeatRuns) {
  TickThread beat;
  WatchedMachine machine{{}};
  const auto channel = std::make_shared<Channel>(machine, MachineData{});
  channel->grant(kLease, kNeverExpires);
  channel->record_trace(true);
  ASSERT_TRUE(beat.add(channel));
  std::vector<TracePoint> trace;
  for (int run = 0; run < 10; ++run) {
    motion::Planner* planner = channel->begin_run(kLease, {});
    ASSERT_NE(planner, nullptr);
    ASSERT_TRUE(channel->command(Go{kLease}));
    Items items;
    for (int i = 1; i <= 100; ++i) items.line_to({i * 0.01, 0, 0, 0}, 3000);
    items.add(geometry::End{});
    for (const auto& item : static_cast<const std::vector<geometry::PathItem>&>(items)) {
      ASSERT_TRUE(planner->append(item));
      planner->plan();
      channel->grant(kLease, kNeverExpires);
      channel->set_override(1);
      (void)channel->drain_trace(trace);
    }
    if (run % 3 == 0) channel->stop(run % 2 == 0 ? StopCause::operator_stop : StopCause::machine_halt);
    ASSERT_TRUE(comes_true([&] { return channel->is_settled() && !channel->snapshot().started; })) << run;
  }
  beat.remove(channel);
  EXPECT_EQ(machine.sum[0], channel->snapshot().steps[0]);
  EXPECT_GE(machine.sum[0], 6 * 200) << "the runs without a stop went their way";
}

TEST(TickThread, PlacesAreBounded) {
  TickThread beat;
  WatchedMachine machine{{}};
  std::vector<std::shared_ptr<Channel>> channels;
  for (int i = 0; i < TickThread::kMostChannels; ++i) {
    channels.push_back(std::make_shared<Channel>(machine, MachineData{}));
    ASSERT_TRUE(beat.add(channels.back()));
  }
  const auto one_more = std::make_shared<Channel>(machine, MachineData{});
  EXPECT_FALSE(beat.add(one_more));
  beat.remove(channels.front());
  EXPECT_TRUE(beat.add(one_more));
}

}  // namespace
}  // namespace cnclab::machine
