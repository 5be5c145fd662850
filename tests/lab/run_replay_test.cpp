// Recorded runs played again: the same trajectory from versions, start and events alone (STO-007).
#include "lab/runs/run_replay.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "language/tape.hpp"
#include "replay_rig.hpp"

namespace cnclab::lab {
namespace {

class Replay : public testing::Test, protected ReplayRig {};

TEST_F(Replay, STO_007_ARunWithStopsPotentiometerHaltsAndSingleBlocksIsPlayedAgainExactly) {
  start();
  ticks(400);
  channel->set_override(0.37);
  ticks(211);
  run.stop();
  ticks(900);
  channel->set_override(0.8);
  run.go_on();
  ticks(150);
  channel->set_single_block(true);
  ticks(4000);
  channel->set_single_block(false);
  for (int start = 0; start < 6; ++start) {  // behind the single block, and out of M00
    run.go_on();
    ticks(3001);
  }
  const RecordedRun record = recorded();
  EXPECT_FALSE(run.is_present()) << "the program has ended";
  ASSERT_GT(record.ticks, 3000U);
  ASSERT_GT(record.events.size(), 8U);
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
  EXPECT_EQ(result.ticks, record.ticks);
  EXPECT_EQ(result.largest_deviation_mm, 0);
  EXPECT_EQ(record.trace.size(), record.ticks);
}

TEST_F(Replay, STO_007_ARunThatAHaltBrokeOffEndsInTheSamePlace) {
  start();
  ticks(523);
  channel->latch(true);
  ticks(1000);
  const RecordedRun record = recorded();
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
}

TEST_F(Replay, STO_007_ARunThatTheTravelBrokeOffEndsInTheSamePlace) {
  ASSERT_TRUE(channel->command(machine::RunReference{kEpoch, {1, 1, 1}}));
  ticks(20'000);
  ASSERT_TRUE(channel->snapshot().is_referenced);
  order.programs.put(
      language::read_tape("P0001N001G01X-2000F2000N002G04H0001N003G01X-5000N004G01X+900000", language::Reading::file)
          .programs.at(0)
          .program);
  start(true);
  ticks(3000);
  const RecordedRun record = recorded();
  EXPECT_FALSE(run.is_present()) << "the fourth block was refused";
  ASSERT_GT(record.ticks, 300U);
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
}

TEST_F(Replay, STO_007_AMotionByHandIsPlayedAgainToItsSwitchAndFromIt) {
  for (const bool is_reference : {false, true}) {
    machine::Command command = machine::Jog{kEpoch, {1, 0, -1}};
    if (is_reference) command = machine::RunReference{kEpoch, {-1, 1, 0}};
    channel->set_override(0.6);
    ASSERT_TRUE(channel->command(machine::SetIstwert{kEpoch, {true, false, true}, {12.5, 0, -3}}));
    ticks(17);
    ASSERT_TRUE(channel->command(command));
    ticks(3);  // the lab sees it at its next look
    begin_by_hand();
    ticks(170);
    channel->set_override(0.9);
    ticks(30'000);
    const RecordedRun record = recorded();
    ASSERT_GT(record.ticks, 1000U);
    const ReplayResult result = replay(record);
    EXPECT_TRUE(result.same) << (is_reference ? "reference: " : "jog: ") << result.detail;
    EXPECT_EQ(result.largest_deviation_mm, 0);
  }
}

TEST_F(Replay, STO_007_ToolsOfTheMachinesListHaltInTheReplayToo) {
  order.programs.put(language::read_tape("P0000T003R+5000L+0", language::Reading::file).programs.at(0).program);
  order.programs.put(language::read_tape("P0001N001G01X+2000F2000N002G11T03N003G01X-5000", language::Reading::file)
                         .programs.at(0)
                         .program);
  order.tools.emplace();
  order.tools->put(3, {5, 0});
  start();
  ticks(1000);
  EXPECT_EQ(run.tool_due(), 3);
  run.go_on();
  ticks(2000);
  const RecordedRun record = recorded();
  ASSERT_TRUE(record.order.tools);
  EXPECT_EQ(record.order.tools->tools(), order.tools->tools());
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
}

/// Every block of a program under EINZELSATZ, as the keys would do it.
class SingleBlocks : public testing::Test, protected ReplayRig {
 protected:
  SingleBlocks() : ReplayRig("P0030N001G91N002G11F3000N003G01X5000N004G11M16N005G01Y5000") {
    channel->set_single_block(true);
  }
};

TEST_F(SingleBlocks, STO_007_BlocksWithoutAWayRestInTheTickThatBeganThem) {
  order.start.program = 30;
  start();
  for (int block = 1; block <= 5; ++block) {
    ticks(1200);
    if (block == 3) machine.set_input(0, 0, true);  // while the axes rest, so M16 finds it at once
    ticks(60);
    if (block < 5) run.go_on();
  }
  const RecordedRun record = recorded();
  EXPECT_FALSE(run.is_present()) << "the program has ended";
  EXPECT_EQ(std::ranges::count(record.events, "go", &db::RunEvent::kind), 5);
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
  EXPECT_EQ(result.largest_deviation_mm, 0);
}

/// Two questions whose second blocks before have seen different inputs, both answered while the axes rest.
class Questions : public testing::Test, protected ReplayRig {
 protected:
  Questions()
      : ReplayRig(
            "P0001N001G11F2000N002G17N003G21P0001N008N004G21P0001N006N005G01X+5000N006G01Y+3000N007G11M02"
            "N008G01X+9000") {
    channel->set_single_block(true);
    start();
    ticks(3);  // N001 rests in the tick that began it, and nobody has looked
    machine.set_input(0, 0, true);
    ticks(2);
    run.go_on();
    ticks(3);  // so does N002
    ticks(80);
  }
};

TEST_F(Questions, STO_007_D_56_EachAnswerOfThoseGivenAtRestIsInTheRecordInItsOrder) {
  machine.set_input(0, 0, false);
  channel->set_single_block(false);
  ticks(40);
  run.go_on();
  ticks(3000);
  EXPECT_EQ(channel->snapshot().istwert_mm[0], 0) << "Input 1 was off when N001 began, and on with N002";
  EXPECT_EQ(channel->snapshot().istwert_mm[1], 3);
  const RecordedRun record = recorded();
  std::vector<double> answers;
  for (const db::RunEvent& event : record.events)
    if (event.kind == "resume") answers.push_back(event.value);
  EXPECT_EQ(answers, (std::vector<double>{0, 1}));
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
  EXPECT_EQ(result.largest_deviation_mm, 0);
}

TEST_F(Questions, STO_007_AnswersOfARunThatWasGivenUpAreNotThoseOfTheNext) {
  static_cast<void>(run.abandon());
  static_cast<void>(recorded());
  channel->set_single_block(false);
  order.programs.put(language::read_tape("P0001N001G01X+2000F2000N002G01X-1000N003G21P0001N005N004G01X+500N005G01Y+700",
                                         language::Reading::file)
                         .programs.at(0)
                         .program);
  ticks(20);
  start();
  ticks(3000);
  const RecordedRun record = recorded();
  EXPECT_EQ(std::ranges::count(record.events, "resume", &db::RunEvent::kind), 1);
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
}

TEST_F(Replay, STO_007_ARunThatNeverBeganIsPlayedAgainToNothing) {
  start();
  run.stop();  // in the same moment: the tick sees the STOP first, and the START before it counts no more
  ticks(100);
  const RecordedRun record = recorded();
  EXPECT_EQ(record.ticks, 0U);
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
  EXPECT_EQ(result.ticks, 0U);
}

TEST_F(Replay, STO_007_AMotionByHandIsKeptHoweverShortItWas) {
  ASSERT_TRUE(channel->command(machine::Jog{kEpoch, {1, 0, 0}}));
  ticks(3);
  channel->stop(machine::StopCause::operator_stop);
  ticks(60);  // at rest before anybody has looked
  begin_by_hand();
  ASSERT_TRUE(channel->command(machine::Jog{kEpoch, {0, 1, 0}}));
  ticks(100);
  EXPECT_TRUE(recorder->has_hand_start()) << "each START is a record of its own";
  const RecordedRun record = recorded();
  EXPECT_GT(record.ticks, 3U);
  EXPECT_LT(record.ticks, 50U);
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
}

TEST_F(Replay, STO_007_AnythingThatDecidesTheCourseMakesAnotherTrajectory) {
  start();
  ticks(400);
  channel->set_override(0.5);
  ticks(300);
  run.stop();
  ticks(600);
  const RecordedRun record = recorded();
  ASSERT_TRUE(replay(record).same);
  const auto differs = [](const RecordedRun& changed) {
    const ReplayResult result = replay(changed);
    return !result.same && !result.detail.empty();
  };
  RecordedRun later_stop = record;
  for (auto& event : later_stop.events)
    if (event.kind == "stop") event.tick += 1;
  EXPECT_TRUE(differs(later_stop));
  RecordedRun other_override = record;
  for (auto& event : other_override.events)
    if (event.kind == "override" && event.tick > 0) event.value = 0.51;
  EXPECT_TRUE(differs(other_override));
  RecordedRun other_data = record;
  ASSERT_TRUE(other_data.order.data.set(6, 1500));
  EXPECT_TRUE(differs(other_data));
  RecordedRun other_program = record;
  other_program.order.programs.put(
      language::read_tape("P0001N001G01X+20000Y+5001F2000M02", language::Reading::file).programs.at(0).program);
  EXPECT_TRUE(differs(other_program));
}

/// The lab looks along a contour on another thread: it is seen some looks later, in a replay at once.
TEST(ReplayOfContours, STO_007_BehindAQuestionTheyArePlayedAgainHoweverLongTheLookAlongThemTook) {
  const std::string head = "P0000T001R+1000L+10000P0006N001G01X+1000N002G17P0001N001G91";
  const std::string tail = "N006G01Y+5000N007G01X+5000N008G40N009G17";
  for (const std::string& blocks : {"N002G11F2000T01M03S500N003G42N004G01X+10000N005G21P0006N001" + tail,
                                    "N002G11F2000T01M03S500N003G42N004G01X+10000N005G23P0006N001W01" + tail,
                                    "N002G21P0006N001N003G11F2000T01M03S500N004G42N005G01X+10000" + tail}) {
    ReplayRig rig(head + blocks);
    const auto waiting = std::make_shared<std::vector<std::function<void()>>>();
    const auto is_slow = std::make_shared<bool>(false);
    rig.order.long_work = [waiting, is_slow](std::function<void()> job) {
      if (!*is_slow) return job();
      waiting->push_back(std::move(job));
    };
    rig.start();
    *is_slow = true;
    for (int look = 0; look < 400; ++look) {
      rig.ticks(20);
      for (const auto& job : std::exchange(*waiting, {})) job();
    }
    const RecordedRun record = rig.recorded();
    EXPECT_GT(record.ticks, 300U) << blocks;
    EXPECT_TRUE(std::ranges::any_of(record.events, [](const auto& event) { return event.kind == "resume"; })) << blocks;
    const ReplayResult result = replay(record);
    EXPECT_TRUE(result.same) << blocks << ": " << result.detail;
  }
}

TEST(ReplayOfContours, STO_007_OnesThatWereReadAheadAtRestOverSeveralLooksAreThereAtTheNextStart) {
  std::string tape = "P0000T001R+1000L+10000P0001N001G91N002G21P0001N001N003G11F2000T01M03S500";
  for (int number = 4; number <= 700; ++number) tape += fmt::format("N{:03}G17", number);
  tape += "N701G42N702G01X+10000N703G01Y+5000N704G01X+5000N705G40N706G01X+1000";
  ReplayRig rig(tape);
  rig.channel->set_single_block(true);
  rig.start();
  rig.ticks(200);  // N001 has ended, the blocks behind it are read and looked along
  rig.channel->set_single_block(false);
  rig.run.go_on();
  rig.ticks(5000);
  EXPECT_FALSE(rig.run.is_present()) << "the program has ended";
  const RecordedRun record = rig.recorded();
  EXPECT_GT(record.ticks, 700U);
  EXPECT_EQ(std::ranges::count(record.events, "resume", &db::RunEvent::kind), 2) << "the question, and the contour";
  const ReplayResult result = replay(record);
  EXPECT_TRUE(result.same) << result.detail;
}

}  // namespace
}  // namespace cnclab::lab
