// Recorded runs played again: the same trajectory from versions, start and events alone (STO-007).
#include "lab/runs/run_replay.hpp"

#include <gtest/gtest.h>

#include <future>
#include <nlohmann/json.hpp>

#include "lab/console/console.hpp"
#include "lab/runs/run_order_json.hpp"
#include "lab/runs/run_recorder.hpp"
#include "lab/stored_control.hpp"
#include "language/tape.hpp"
#include "machine/simulated_machine.hpp"

namespace cnclab::lab {
namespace {

constexpr machine::Epoch kEpoch{1};

/// A machine that is driven by hand, a recorder that looks at it, and the database that the recorder writes to.
class Replay : public testing::Test {
 protected:
  Replay() {
    auto database = db::Database::open(":memory:").value();
    db::Person anna;
    anna.name = "anna";
    anna.role = "student";
    anna_ = *database.add_person(anna, 1);
    const language::Tape tape = language::read_tape(kProgram, language::Reading::file);
    for (const auto& error : tape.errors) ADD_FAILURE() << tape_error(error, language::Tongue::english);
    for (const auto& read : tape.programs) {
      database.replace_program(anna_, read.program.number, stored_blocks(read.program), {"anna", 1, 1});
      order_.programs.put(read.program);
    }
    store_ = std::make_unique<db::Store>(std::move(database), [](const std::function<void()>&) {});
    channel_ = std::make_shared<machine::Channel>(machine_, order_.data);
    channel_->grant(kEpoch, machine::kNeverExpires);
    recorder_ = std::make_unique<RunRecorder>(*store_, channel_, RunRecorder::Keeps::trace);
  }

  void ticks(int count) {
    for (int i = 0; i < count; ++i) {
      channel_->tick(++tick_ * 1'000'000, 0.001);
      if (tick_ % 17 != 0) continue;  // not as regularly as the replay does
      static_cast<void>(run_.poll());
      recorder_->poll();
    }
  }
  void start(bool is_lab_machine = false) {
    order_.start.position.x = channel_->snapshot().istwert_mm[0];
    order_.start.position.y = channel_->snapshot().istwert_mm[1];
    order_.start.position.z = channel_->snapshot().istwert_mm[2];
    const auto begun = run_.begin({channel_, kEpoch, is_lab_machine, {}}, order_);
    ASSERT_TRUE(begun) << language::message_of(begun.error(), language::Tongue::english);
    recorder_->begin({.person = anna_,
                      .station = 1,
                      .lease = 0,
                      .program = 1,
                      .block = 1,
                      .unix_ms = 5,
                      .order = run_.order(),
                      .machine_data = order_.data});
  }
  RecordedRun newest_run(db::Database& database) {
    const auto record = database.runs(anna_).at(0);
    const auto setup = nlohmann::json::parse(record.setup);
    const bool by_hand = setup.contains("hand");
    return {.order = by_hand ? panel::RunOrder{} : order_of(setup.at("order"), database, anna_).value(),
            .hand_istwert_mm =
                by_hand ? std::optional(setup["hand"].at("istwert").get<std::array<double, 4>>()) : std::nullopt,
            .is_lab_machine = false,
            .machine_data = {},
            .steps = setup.at("steps"),
            .events = database.run_events(record.id),
            .ticks = static_cast<std::uint64_t>(record.ticks),
            .digest = record.digest,
            .trace = trace_steps(database.trace(record.id))};
  }
  /// The record as the instructor's command reads it.
  RecordedRun recorded() {
    recorder_->end("test");
    std::promise<RecordedRun> result;
    store_->run(
        [&](db::Database& database) {
          try {
            result.set_value(newest_run(database));
          } catch (...) {
            result.set_exception(std::current_exception());
          }
        },
        [](const std::expected<void, db::StoreError>&) {});
    return result.get_future().get();
  }

  static constexpr const char* kProgram =
      "P0001N001G01X+20000Y+5000F2000S1000M03N002G02X+5000Y+5000I+5000J+0N003G04H0002N004G01X-3000N005G22P0002N001W01"
      "N006G01Z+4000F500M00N007G01X+1000F800M02"
      "P0002N001G01Y+2000F900N002G01Y-1000";

  panel::RunOrder order_;
  machine::SimulatedMachine machine_{machine::MachineData{}};
  std::shared_ptr<machine::Channel> channel_;
  std::unique_ptr<db::Store> store_;
  std::unique_ptr<RunRecorder> recorder_;
  panel::Run run_;
  db::PersonId anna_{};
  std::int64_t tick_ = 0;
};

TEST_F(Replay, STO_007_ARunWithStopsPotentiometerHaltsAndSingleBlocksIsPlayedAgainExactly) {
  start();
  ticks(400);
  channel_->set_override(0.37);
  ticks(211);
  run_.stop();
  ticks(900);
  channel_->set_override(0.8);
  run_.go_on();
  ticks(150);
  channel_->set_single_block(true);
  ticks(4000);
  channel_->set_single_block(false);
  for (int start = 0; start < 6; ++start) {  // behind the single block, and out of M00
    run_.go_on();
    ticks(3001);
  }
  const RecordedRun run = recorded();
  EXPECT_FALSE(run_.is_present()) << "the program has ended";
  ASSERT_GT(run.ticks, 3000U);
  ASSERT_GT(run.events.size(), 8U);
  const ReplayResult result = replay(run);
  EXPECT_TRUE(result.same) << result.detail;
  EXPECT_EQ(result.ticks, run.ticks);
  EXPECT_EQ(result.largest_deviation_mm, 0);
  EXPECT_EQ(run.trace.size(), run.ticks);
}

TEST_F(Replay, STO_007_ARunThatAHaltBrokeOffEndsInTheSamePlace) {
  start();
  ticks(523);
  channel_->latch(true);
  ticks(1000);
  const RecordedRun run = recorded();
  const ReplayResult result = replay(run);
  EXPECT_TRUE(result.same) << result.detail;
}

TEST_F(Replay, STO_007_ARunThatTheTravelBrokeOffEndsInTheSamePlace) {
  ASSERT_TRUE(channel_->command(machine::RunReference{kEpoch, {1, 1, 1}}));
  ticks(20'000);
  ASSERT_TRUE(channel_->snapshot().is_referenced);
  order_.programs.put(
      language::read_tape("P0001N001G01X-2000F2000N002G04H0001N003G01X-5000N004G01X+900000", language::Reading::file)
          .programs.at(0)
          .program);
  start(true);
  ticks(3000);
  const RecordedRun run = recorded();
  EXPECT_FALSE(run_.is_present()) << "the fourth block was refused";
  ASSERT_GT(run.ticks, 300U);
  const ReplayResult result = replay(run);
  EXPECT_TRUE(result.same) << result.detail;
}

TEST_F(Replay, STO_007_AMotionByHandIsPlayedAgainToItsSwitchAndFromIt) {
  for (const bool is_reference : {false, true}) {
    machine::Command command = machine::Jog{kEpoch, {1, 0, -1}};
    if (is_reference) command = machine::RunReference{kEpoch, {-1, 1, 0}};
    channel_->set_override(0.6);
    ASSERT_TRUE(channel_->command(machine::SetIstwert{kEpoch, {true, false, true}, {12.5, 0, -3}}));
    ticks(17);
    ASSERT_TRUE(channel_->command(command));
    for (int i = 0; i < 3; ++i) channel_->tick(++tick_ * 1'000'000, 0.001);  // the lab sees it at its next look
    recorder_->begin({.person = anna_,
                      .station = 1,
                      .lease = 3,
                      .program = 0,
                      .block = 0,
                      .unix_ms = 5,
                      .order = nullptr,
                      .machine_data = order_.data,
                      .hand = HandStart{channel_->snapshot().start_istwert_mm, order_.data}});
    ticks(170);
    channel_->set_override(0.9);
    ticks(30'000);
    const RecordedRun run = recorded();
    ASSERT_GT(run.ticks, 1000U);
    const ReplayResult result = replay(run);
    EXPECT_TRUE(result.same) << (is_reference ? "reference: " : "jog: ") << result.detail;
    EXPECT_EQ(result.largest_deviation_mm, 0);
  }
}

TEST_F(Replay, STO_007_ToolsOfTheMachinesListHaltInTheReplayToo) {
  order_.programs.put(language::read_tape("P0000T003R+5000L+0", language::Reading::file).programs.at(0).program);
  order_.programs.put(language::read_tape("P0001N001G01X+2000F2000N002G11T03N003G01X-5000", language::Reading::file)
                          .programs.at(0)
                          .program);
  order_.tools.emplace();
  order_.tools->put(3, {5, 0});
  start();
  ticks(1000);
  EXPECT_EQ(run_.tool_due(), 3);
  run_.go_on();
  ticks(2000);
  const RecordedRun run = recorded();
  ASSERT_TRUE(run.order.tools);
  EXPECT_EQ(run.order.tools->tools(), order_.tools->tools());
  const ReplayResult result = replay(run);
  EXPECT_TRUE(result.same) << result.detail;
}

TEST_F(Replay, STO_007_AnythingThatDecidesTheCourseMakesAnotherTrajectory) {
  start();
  ticks(400);
  channel_->set_override(0.5);
  ticks(300);
  run_.stop();
  ticks(600);
  const RecordedRun run = recorded();
  ASSERT_TRUE(replay(run).same);
  const auto differs = [](const RecordedRun& changed) {
    const ReplayResult result = replay(changed);
    return !result.same && !result.detail.empty();
  };
  RecordedRun later_stop = run;
  for (auto& event : later_stop.events)
    if (event.kind == "stop") event.tick += 1;
  EXPECT_TRUE(differs(later_stop));
  RecordedRun other_override = run;
  for (auto& event : other_override.events)
    if (event.kind == "override" && event.tick > 0) event.value = 0.51;
  EXPECT_TRUE(differs(other_override));
  RecordedRun other_data = run;
  ASSERT_TRUE(other_data.order.data.set(6, 1500));
  EXPECT_TRUE(differs(other_data));
  RecordedRun other_program = run;
  other_program.order.programs.put(
      language::read_tape("P0001N001G01X+20000Y+5001F2000M02", language::Reading::file).programs.at(0).program);
  EXPECT_TRUE(differs(other_program));
}

}  // namespace
}  // namespace cnclab::lab
