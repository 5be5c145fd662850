// Requests about what was recorded: runs, traces, journal, backup (STO-006 to STO-008).
#include <fmt/format.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "lab/console/console_ask.hpp"
#include "lab/runs/run_order_json.hpp"
#include "lab/runs/run_replay.hpp"

namespace cnclab::lab {

namespace {

/// Local time "2026-11-22" or "2026-11-22T10:15"; nothing when malformed.
std::optional<std::int64_t> parse_since(const std::string& text) {
  if (text.empty()) return 0;
  for (const char* format : {"%Y-%m-%dT%H:%M:%S", "%Y-%m-%dT%H:%M", "%Y-%m-%d"}) {
    std::tm time{};
    time.tm_isdst = -1;
    const char* end = strptime(text.c_str(), format, &time);
    if (end != nullptr && *end == '\0') return static_cast<std::int64_t>(std::mktime(&time)) * 1000;
  }
  return std::nullopt;
}

/// As a run's setup keeps them. Twice: F START/STOP may not exceed F MAX, in whichever order they come.
machine::MachineData machine_data_of(const nlohmann::json& json) {
  machine::MachineData data;
  for (int pass = 0; pass < 2; ++pass)
    for (const auto& [datum, value] : json.items()) static_cast<void>(data.set(std::stoi(datum), value));
  return data;
}

/// Everything that a replay needs, or why it cannot be.
RecordedRun recorded(db::Database& database, std::int64_t number) {
  const auto record = database.run(number);
  if (!record) throw Refusal{fmt::format("Lauf {} gibt es nicht.", number), fmt::format("There is no run {}.", number)};
  if (record->digest.empty())
    throw Refusal{fmt::format("Lauf {} ist nicht zum Wiederholen aufgezeichnet ({}).", number,
                              record->ended.empty() ? "noch nicht zu Ende" : "unvollständig oder zu lang"),
                  fmt::format("Run {} is not recorded for replay ({}).", number,
                              record->ended.empty() ? "not over yet" : "not whole, or too long")};
  const auto setup = nlohmann::json::parse(record->setup, nullptr, false);
  const auto unreadable = [&](const std::string& what) {
    return Refusal{fmt::format("Lauf {}: nicht lesbar: {}", number, what),
                   fmt::format("Run {}: cannot be read: {}", number, what)};
  };
  const bool by_hand = setup.is_object() && setup.contains("hand");
  if (!by_hand && (!setup.is_object() || !setup.contains("order"))) throw unreadable("setup");
  std::expected<panel::RunOrder, std::string> order;
  if (by_hand)
    order->data = machine_data_of(setup["hand"].at("data"));
  else
    order = order_of(setup["order"], database, record->person);
  if (!order) throw unreadable(order.error());
  RecordedRun run{.order = std::move(*order),
                  .hand_istwert_mm =
                      by_hand ? std::optional(setup["hand"].at("istwert").get<std::array<double, 4>>()) : std::nullopt,
                  .is_lab_machine = record->machine == "lab",
                  .machine_data = machine_data_of(setup.at("machine_data")),
                  .steps = setup.value("steps", std::array<std::int64_t, 4>{}),
                  .events = database.run_events(number),
                  .ticks = static_cast<std::uint64_t>(record->ticks),
                  .digest = record->digest,
                  .trace = trace_steps(database.trace(number))};
  return run;
}

/// What a run executed, in the words of the keys where it was no stored program.
std::string ran(int program) {
  constexpr int kLastProgram = 9999;
  if (program > kLastProgram) return "HANDEINGABE";
  return program == 0 ? "HAND" : fmt::format("P{:04}", program);
}

v1::InstructorItem replay_item(std::uint32_t number, const ReplayResult& result) {
  v1::InstructorItem item;
  auto& replayed = *item.mutable_replay();
  replayed.set_id(number);
  replayed.set_same(result.same);
  replayed.set_ticks(static_cast<double>(result.ticks));
  replayed.set_largest_deviation_mm(result.largest_deviation_mm);
  replayed.set_detail(result.detail);
  return item;
}

}  // namespace

void Console::runs(const Reply& reply, const v1::StudentName& request) const {
  ask_store(
      reply, [name = request.name()](db::Database& database) { return database.runs(person_named(database, name).id); },
      [reply](const Console& console, const std::vector<db::RunRecord>& runs) {
        Items items;
        for (const auto& run : runs) {
          v1::InstructorItem item;
          auto& info = *item.mutable_run();
          info.set_id(static_cast<std::uint32_t>(run.id));
          info.set_started(iso_time(run.started_ms));
          info.set_machine(run.machine);
          info.set_program(ran(run.program));
          info.set_seconds(run.seconds.value_or(0));
          info.set_ended(run.ended);
          items.push_back(item);
        }
        console.send(reply, items);
      });
}

void Console::replay_then(const Reply& reply, RecordedRun run, std::function<void(const ReplayResult&)> then) const {
  lab_.background_.enqueue(
      [post = lab_.post_, alive = lab_.alive_, reply, run = std::move(run), then = std::move(then)] {
        post([alive, reply, then, result = replay(run)] {
          if (*alive && reply.visit->stage == Stage::at_console) then(result);
        });
      });
}

/// Of a run on the training machine, and of an old one, no trace is kept: the run once more has the same.
void Console::run_trace(const Reply& reply, const v1::RunName& request) const {
  struct Traced {
    std::string packed;  ///< as it was kept; empty: `run` has to run once more
    std::optional<RecordedRun> run;
    std::array<double, 4> steps_per_mm{};
  };
  ask_store(
      reply,
      [number = static_cast<std::int64_t>(request.run())](db::Database& database) {
        Traced traced{.packed = database.trace(number), .run = {}};
        if (traced.packed.empty()) traced.run = recorded(database, number);
        const auto record = database.run(number);
        const auto setup = nlohmann::json::parse(record ? record->setup : "", nullptr, false);
        const bool has_data = setup.is_object() && setup.contains("machine_data");
        traced.steps_per_mm =
            machine::motion_limits(has_data ? machine_data_of(setup["machine_data"]) : machine::MachineData{})
                .steps_per_mm;
        return traced;
      },
      [reply, number = request.run()](const Console& console, Traced traced) {
        if (!traced.run) return console.send_file(reply, trace_csv(traced.packed, traced.steps_per_mm));
        const auto send_csv = [&lab = console.lab_, reply, number,
                               steps_per_mm = traced.steps_per_mm](const ReplayResult& result) {
          if (result.same) return Console(lab).send_file(reply, trace_csv(pack_trace(result.points), steps_per_mm));
          Console(lab).send_error(reply,
                                  fmt::format(fmt::runtime(say(reply.tongue, "Lauf {} ist nicht mehr nachzufahren: {}",
                                                               "Run {} cannot be followed again: {}")),
                                              number, result.detail));
        };
        console.replay_then(reply, std::move(*traced.run), send_csv);
      });
}

void Console::run_replay(const Reply& reply, const v1::RunName& request) const {
  ask_store(
      reply,
      [number = static_cast<std::int64_t>(request.run())](db::Database& database) {
        return recorded(database, number);
      },
      [reply, number = request.run()](const Console& console, RecordedRun run) {
        const auto send_result = [&lab = console.lab_, reply, number](const ReplayResult& result) {
          Console(lab).send(reply, {replay_item(number, result)});
        };
        console.replay_then(reply, std::move(run), send_result);
      });
}

void Console::journal(const Reply& reply, const v1::JournalQuery& request) const {
  const auto since = parse_since(request.since());
  if (!since)
    return send_error(reply, say(reply.tongue, "Zeit als JJJJ-MM-TT oder JJJJ-MM-TTThh:mm angeben.",
                                 "Give the time as YYYY-MM-DD or YYYY-MM-DDThh:mm."));
  lab_.journal_.flush();
  ask_store(
      reply,
      [name = request.student(), since = *since](db::Database& database) { return database.journal(name, since); },
      [reply](const Console& console, const std::vector<db::JournalEntry>& entries) {
        Items items;
        for (const auto& entry : entries) {
          v1::InstructorItem item;
          auto& line = *item.mutable_journal();
          line.set_time(iso_time(entry.time_ms));
          line.set_station(static_cast<std::uint32_t>(entry.station));
          line.set_student(entry.person);
          line.set_kind(entry.kind);
          line.set_detail(entry.detail);
          line.set_lease(static_cast<double>(entry.lease));
          items.push_back(item);
        }
        console.send(reply, items);
      });
}

void Console::backup(const Reply& reply) const {
  const bool begun = lab_.backup_.make([&lab = lab_, alive = lab_.alive_, reply](const BackupCopy::Result& copy) {
    if (!*alive || reply.visit->stage != Stage::at_console) return;
    const Console console(lab);
    if (!copy) return console.send_error(reply, copy.error());
    lab.journal_.write("backup", fmt::format("{} bytes", copy->size), 0, reply.visit->person.name);
    console.send_file(reply, copy->stream, copy->size);
  });
  if (!begun) send_error(reply, say(reply.tongue, "Eine Sicherung läuft schon.", "A backup is under way already."));
}

}  // namespace cnclab::lab
