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
    throw Refusal{
        fmt::format("Lauf {} ist nicht zum Wiederholen aufgezeichnet (noch nicht zu Ende, oder zu lang).", number),
        fmt::format("Run {} is not recorded for replay (not over yet, or too long).", number)};
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
          info.set_program(fmt::format("P{:04}", run.program));
          info.set_seconds(run.seconds.value_or(0));
          info.set_ended(run.ended);
          items.push_back(item);
        }
        console.send(reply, items);
      });
}

void Console::run_trace(const Reply& reply, const v1::RunName& request) const {
  ask_store(
      reply,
      [run = static_cast<std::int64_t>(request.run())](db::Database& database) {
        std::string trace = database.trace(run);
        if (trace.empty())
          throw Refusal{fmt::format("Von Lauf {} gibt es keine Spur.", run),
                        fmt::format("There is no trace of run {}.", run)};
        const auto record = database.run(run);
        const auto setup = nlohmann::json::parse(record ? record->setup : "", nullptr, false);
        const bool has_data = setup.is_object() && setup.contains("machine_data");
        const auto limits =
            machine::motion_limits(has_data ? machine_data_of(setup["machine_data"]) : machine::MachineData{});
        return trace_csv(trace, limits.steps_per_mm);
      },
      [reply](const Console& console, const std::string& csv) { console.send_file(reply, csv); });
}

void Console::run_replay(const Reply& reply, const v1::RunName& request) const {
  ask_store(
      reply,
      [number = static_cast<std::int64_t>(request.run())](db::Database& database) {
        return recorded(database, number);
      },
      [reply, number = request.run()](const Console& console, const RecordedRun& run) {
        Lab& lab = console.lab_;
        lab.background_.enqueue([&lab, post = lab.post_, alive = lab.alive_, reply, number, run] {
          post([&lab, alive, reply, number, result = replay(run)] {
            if (*alive && reply.visit->stage == Stage::at_console)
              Console(lab).send(reply, {replay_item(number, result)});
          });
        });
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
