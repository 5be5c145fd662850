// A run by hand, tick by tick, with its record.
#include "replay_rig.hpp"

#include <gtest/gtest.h>

#include <future>
#include <nlohmann/json.hpp>

#include "lab/console/console.hpp"
#include "lab/runs/run_order_json.hpp"
#include "lab/stored_control.hpp"
#include "language/tape.hpp"

namespace cnclab::lab {

ReplayRig::ReplayRig(const std::string& text) {
  auto database = db::Database::open(":memory:").value();
  db::Person anna;
  anna.name = "anna";
  anna.role = "student";
  anna_ = *database.add_person(anna, 1);
  const language::Tape tape = language::read_tape(text, language::Reading::file);
  for (const auto& error : tape.errors) ADD_FAILURE() << tape_error(error, language::Tongue::english);
  for (const auto& read : tape.programs) {
    database.replace_program(anna_, read.program.number, stored_blocks(read.program), {"anna", 1, 1});
    order.programs.put(read.program);
  }
  store = std::make_unique<db::Store>(std::move(database), [](const std::function<void()>&) {});
  channel = std::make_shared<machine::Channel>(machine, order.data);
  channel->grant(kEpoch, machine::kNeverExpires);
  recorder = std::make_unique<RunRecorder>(*store, channel, RunRecorder::Keeps::trace);
}

void ReplayRig::ticks(int count) {
  constexpr std::int64_t kTick_ns = 1'000'000, kLookEvery = 17;
  for (int i = 0; i < count; ++i) {
    channel->tick(++tick_ * kTick_ns, 0.001);
    if (tick_ % kLookEvery != 0) continue;
    static_cast<void>(run.poll());
    recorder->poll();
  }
}

void ReplayRig::start(bool is_lab_machine) {
  order.start.position.x = channel->snapshot().istwert_mm[0];
  order.start.position.y = channel->snapshot().istwert_mm[1];
  order.start.position.z = channel->snapshot().istwert_mm[2];
  const auto begun = run.begin({channel, kEpoch, is_lab_machine, {}}, order);
  ASSERT_TRUE(begun) << language::message_of(begun.error(), language::Tongue::english);
  recorder->begin({.person = anna_,
                   .station = 1,
                   .lease = 0,
                   .program = 1,
                   .block = 1,
                   .unix_ms = 5,
                   .order = run.order(),
                   .machine_data = order.data});
}

void ReplayRig::begin_by_hand() {
  recorder->poll();
  ASSERT_TRUE(recorder->has_hand_start());
  recorder->begin({.person = anna_,
                   .station = 1,
                   .lease = 3,
                   .program = 0,
                   .block = 0,
                   .unix_ms = 5,
                   .order = nullptr,
                   .machine_data = order.data,
                   .hand = HandStart{channel->snapshot().start_istwert_mm, order.data}});
}

RecordedRun ReplayRig::newest_run(db::Database& database) const {
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

RecordedRun ReplayRig::recorded() {
  recorder->end("test");
  std::promise<RecordedRun> result;
  store->run(
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

}  // namespace cnclab::lab
