// Requests about the machine: status, selector, inputs, data, runs, journal.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "lab/console_ask.hpp"
#include "lab/stored_control.hpp"

namespace cnclab::lab {

namespace {

std::string state_name(machine::MotionState state) {
  using machine::MotionState;
  switch (state) {
    case MotionState::standstill:
      return "standstill";
    case MotionState::moving:
      return "moving";
    case MotionState::stopping:
      return "stopping";
    case MotionState::halted:
      return "halted";
    case MotionState::off:
      return "off";
  }
  return "";
}

void fill_machine(v1::MachineStatus& out, const machine::Snapshot& snapshot, const Authority& authority) {
  const bool at_rest = snapshot.state == machine::MotionState::standstill;
  std::string state = state_name(snapshot.state);
  if (at_rest && authority.is_halted()) state = "halted";
  if (!authority.is_powered()) state = "off";
  out.set_state(state);
  out.set_referenced(snapshot.is_referenced);
  out.set_x(snapshot.istwert_mm[0]);
  out.set_y(snapshot.istwert_mm[1]);
  out.set_z(snapshot.istwert_mm[2]);
  out.set_u(snapshot.istwert_mm[3]);
  out.set_feed(snapshot.speed_mm_per_min);
  const double rpm = std::max(1, snapshot.spindle_rpm);  // a spindle without S turns all the same
  out.set_spindle(snapshot.spindle == geometry::SpindleTurn::off         ? 0
                  : snapshot.spindle == geometry::SpindleTurn::clockwise ? rpm
                                                                         : -rpm);
}

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

v1::InstructorItem datum_item(int number, std::int64_t value) {
  v1::InstructorItem item;
  item.mutable_machine_datum()->set_number(static_cast<std::uint32_t>(number));
  item.mutable_machine_datum()->set_value(static_cast<std::int32_t>(value));
  return item;
}

}  // namespace

void Console::status(const Reply& reply) const {
  v1::InstructorItem item;
  auto& status = *item.mutable_status();
  const Authority& authority = lab_.authority_;
  status.set_selected(static_cast<std::uint32_t>(authority.selected()));
  status.set_offered(static_cast<std::uint32_t>(authority.offered()));
  status.set_lease(static_cast<double>(static_cast<std::uint64_t>(authority.newest())));
  status.set_halted_by(authority.halted_by());
  fill_machine(*status.mutable_machine(), lab_.channel_->snapshot(), authority);
  const auto ticks = lab_.ticks_.statistics();
  status.mutable_ticks()->set_late(static_cast<double>(ticks.late));
  status.mutable_ticks()->set_longest_ms(static_cast<double>(ticks.longest_delay_ns) / 1e6);
  std::vector<Lab::DeskPtr> desks;
  for (const auto& [id, desk] : lab_.desks_) desks.push_back(desk);
  std::ranges::sort(desks, {}, [](const auto& desk) { return desk->station; });
  for (const auto& desk : desks) {
    auto& station = *status.add_stations();
    const auto situation = desk->control.situation();
    station.set_station(static_cast<std::uint32_t>(desk->station));
    station.set_user(desk->person.name);
    station.set_role(desk->person.role);
    station.set_mode(std::string(panel::name_of(situation.mode)));
    station.set_running(desk->control.is_running());
    station.set_connected(desk->is_seated());
    station.set_program(situation.program);
    station.set_block(situation.block);
    station.set_last_key(desk->last_key);
    const auto hand = std::ranges::find_if(lab_.hands_, [&](const auto& raised) { return raised.lock() == desk; });
    if (hand != lab_.hands_.end()) station.set_meldung(static_cast<std::uint32_t>(hand - lab_.hands_.begin()) + 1);
  }
  send(reply, {item});
}

void Console::decided(const Reply& reply, const Event& event) const {
  const std::string refusal = lab_.decide(event, reply.tongue);
  if (!refusal.empty()) return send_error(reply, refusal);
  send_done(reply);
}

void Console::input(const Reply& reply, const v1::SetInput& request) const {
  const auto number = request.input();
  const bool known = number == 0 || (number >= 11 && number <= 18) || (number >= 21 && number <= 28);
  if (!known)
    return send_error(reply, lab_.say(reply.tongue, "Eingänge: 0, 11 bis 18 (Karte 1), 21 bis 28 (Karte 2).",
                                      "Inputs: 0, 11 to 18 (card 1), 21 to 28 (card 2)."));
  lab_.machine_.set_input(static_cast<int>(number / 10), static_cast<int>(number % 10), request.on());
  lab_.write_journal("input", fmt::format("{} {}", number, request.on() ? "on" : "off"), 0, reply.visit->person.name);
  send_done(reply);
}

void Console::machine_data(const Reply& reply, const v1::ChangeMachineData& request) const {
  if (request.data().empty()) {
    Items items;
    for (const auto& form : machine::datum_forms())
      items.push_back(datum_item(form.number, lab_.machine_data_.get(form.number)));
    return send(reply, items);
  }
  if (lab_.authority_.phase() != Phase::nobody)
    return send_error(reply,
                      lab_.say(reply.tongue, "Maschinendaten lassen sich nur ändern, wenn kein Platz die Maschine hat.",
                               "Machine data can be changed only while no station has the machine."));
  machine::MachineData wished = lab_.machine_data_;
  for (const auto& datum : request.data())
    if (const auto set = wished.set(static_cast<int>(datum.number()), datum.value()); !set)
      return send_error(reply, fmt::format("{:02}={}: {}", datum.number(), datum.value(), set.error()));
  // DEC-25: a stop from F MAX must not take longer than 2 s.
  const auto limits = machine::motion_limits(wished);
  if (limits.f_max_mm_per_s / limits.stop_deceleration_mm_per_s2 > 2.0)
    return send_error(
        reply,
        lab_.say(reply.tongue,
                 "Mit diesen Daten dauert ein Halt aus F MAX über 2 s: RAMPE größer oder F MAX kleiner wählen.",
                 "With these data a stop from F MAX takes over 2 s: choose a greater RAMPE or a smaller F MAX."));
  ask_store(
      reply,
      [wished, author = db::Author{reply.visit->person.name, 0, lab_.clock_.unix_ms()}](db::Database& database) {
        for (const auto& form : machine::datum_forms())
          database.put_machine_datum(db::kLabMachine, stored_datum(form.number, wished.get(form.number)), author);
        return true;
      },
      [reply, wished](const Console& console, bool) {
        console.lab_.machine_data_ = wished;
        static_cast<void>(console.lab_.channel_->set_data(wished));
        console.send_done(reply);
      });
}

void Console::message(const Reply& reply, const v1::SendMessage& request) const {
  const std::string text = request.text().substr(0, 200);
  bool anybody = false;
  for (const auto& [id, desk] : lab_.desks_) {
    if (request.station() != 0 && desk->station != static_cast<int>(request.station())) continue;
    lab_.note(*desk, reply.visit->person.name + ": " + text);
    anybody = true;
  }
  if (!anybody)
    return send_error(reply, lab_.say(reply.tongue, "Dort ist niemand angemeldet.", "Nobody is logged in there."));
  lab_.write_journal("message", text, static_cast<int>(request.station()), reply.visit->person.name);
  send_done(reply);
}

void Console::expel(const Reply& reply, const v1::StationOnly& request) const {
  const auto desk = lab_.seated_at(static_cast<int>(request.station()));
  if (!desk)
    return send_error(reply, lab_.say(reply.tongue, "Dort ist niemand angemeldet.", "Nobody is logged in there."));
  const auto visit = desk->visit.lock();
  lab_.vacate(visit, "expelled");
  lab_.dismiss(desk);
  lab_.farewell(visit, 9,
                lab_.say(lab_.tongue_of(desk->person), "Die Lehrkraft hat die Verbindung beendet.",
                         "The instructor has ended the connection."));
  send_done(reply);
}

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
        return trace;
      },
      [reply](const Console& console, const std::string& packed) {
        const auto limits = machine::motion_limits(console.lab_.machine_data_);
        console.send_file(reply, trace_csv(packed, limits.steps_per_mm));
      });
}

void Console::journal(const Reply& reply, const v1::JournalQuery& request) const {
  const auto since = parse_since(request.since());
  if (!since)
    return send_error(reply, lab_.say(reply.tongue, "Zeit als JJJJ-MM-TT oder JJJJ-MM-TTThh:mm angeben.",
                                      "Give the time as YYYY-MM-DD or YYYY-MM-DDThh:mm."));
  lab_.flush_journal();
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

}  // namespace cnclab::lab
