// Requests about the machine: status, selector, inputs, data, tools, workpiece.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/console/console_ask.hpp"
#include "lab/stored_control.hpp"
#include "language/tape.hpp"
#include "shared/station_id.hpp"

namespace cnclab::lab {

namespace {

constexpr std::int64_t kMinute_ns = 60'000'000'000;
constexpr double kLeastWorkpiece_mm = 1, kMostWorkpiece_mm = 1000;
constexpr std::size_t kJournalled = 200;  ///< of a value, characters

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
  out.set_feed(std::round(snapshot.speed_mm_per_min * 1000) / 1000);
  const double rpm = std::max(1, snapshot.spindle_rpm);  // a spindle without S turns all the same
  out.set_spindle(snapshot.spindle == geometry::SpindleTurn::off         ? 0
                  : snapshot.spindle == geometry::SpindleTurn::clockwise ? rpm
                                                                         : -rpm);
}

v1::InstructorItem datum_item(int number, std::int64_t value) {
  v1::InstructorItem item;
  item.mutable_machine_datum()->set_number(static_cast<std::uint32_t>(number));
  item.mutable_machine_datum()->set_value(static_cast<std::int32_t>(value));
  return item;
}

/// Why a datum does not take a value. `english` is the machine's own word for it.
std::string datum_fault(int number, std::int64_t value, std::string_view english, language::Tongue tongue) {
  const auto& forms = machine::datum_forms();
  const auto form = std::ranges::find(forms, number, &machine::DatumForm::number);
  const bool german = tongue == language::Tongue::german;
  std::string why(english);
  if (form == std::end(forms)) {
    if (german) why = "diese Nummer gibt es nicht; es gibt 03-07, 09-12, 14-17, 19, 20 und 22";
  } else if (value < form->least || value > form->most) {
    why = fmt::format(fmt::runtime(german ? "{} bis {} ist möglich" : "{} to {} is possible"), form->least, form->most);
  } else if (german) {
    why = number == 19   ? "ENDSCHALTER POL ist 201 oder 51503"
          : number == 20 ? "BAUDRATE ist 300, 600, 1200, 2400 oder 4800"
                         : "F START/STOP wäre über F MAX";
  }
  return fmt::format("{:02}={}: {}", number, value, why);
}

}  // namespace

void Console::status(const Reply& reply) const {
  v1::InstructorItem item;
  auto& status = *item.mutable_status();
  const Authority& authority = lab_.authority_;
  status.set_selected(static_cast<std::uint32_t>(authority.selected()));
  status.set_offered(static_cast<std::uint32_t>(authority.offered()));
  status.set_lease(static_cast<double>(static_cast<std::uint64_t>(authority.newest())));
  status.set_halted_by(authority.halted_by(reply.tongue));
  status.set_shown(static_cast<std::uint32_t>(lab_.shown_station_));
  status.set_runs_lost(static_cast<double>(lab_.runs_lost_));
  fill_machine(*status.mutable_machine(), lab_.machine_.snapshot(), authority);
  for (const int number : lab_.machine_.damaged_data())
    status.mutable_machine()->add_damaged_data(static_cast<std::uint32_t>(number));
  const auto ticks = lab_.ticks_.statistics();
  status.mutable_ticks()->set_late(static_cast<double>(ticks.late));
  status.mutable_ticks()->set_very_late(static_cast<double>(ticks.very_late));
  status.mutable_ticks()->set_longest_ms(static_cast<double>(ticks.longest_delay_ns) / 1e6);
  status.mutable_ticks()->set_stalls(static_cast<double>(lab_.machine_.stalls()));
  std::vector<Lab::DeskPtr> desks;
  for (const auto& desk : lab_.seats_.all())
    if (lab_.seats_.working_at(desk->station) == desk) desks.push_back(desk);  // one entry for each station
  std::ranges::sort(desks, {}, [](const auto& desk) { return desk->station; });
  for (const auto& desk : desks) fill_station(*status.add_stations(), desk);
  send(reply, {item});
}

void Console::fill_station(v1::StationStatus& out, const std::shared_ptr<Desk>& desk) const {
  const auto situation = desk->control.situation();
  out.set_station(static_cast<std::uint32_t>(desk->station));
  out.set_user(desk->person.name);
  out.set_role(desk->person.role);
  out.set_mode(std::string(panel::name_of(situation.mode)));
  out.set_running(desk->control.is_running());
  out.set_connected(desk->is_seated());
  out.set_program(situation.program);
  out.set_block(situation.block);
  out.set_last_key(desk->last_key);
  if (const int hand = lab_.seats_.hand_of(*desk); hand > 0) out.set_meldung(static_cast<std::uint32_t>(hand));
  out.set_locked(desk->is_locked);
  out.set_taken_by(desk->taken_by);
  out.set_remote(desk->control.is_remote());
  out.set_ram_fault(desk->control.has_ram_fault());
  if (const auto line = lab_.lines_.of(*desk)) out.set_line(line->peer->address());
  const std::int64_t a_minute_ago_ns = lab_.clock_.monotonic_ns() - kMinute_ns;
  out.set_errors_last_minute(static_cast<std::uint32_t>(
      std::ranges::count_if(desk->errors_ns, [&](std::int64_t at_ns) { return at_ns > a_minute_ago_ns; })));
}

void Console::decided(const Reply& reply, const Event& event) const {
  const std::string refusal = lab_.decide(event, reply.tongue);
  if (!refusal.empty()) return send_error(reply, refusal);
  send_done(reply);
}

void Console::clear_halt(const Reply& reply) const {
  if (lab_.authority_.is_halted()) return decided(reply, HaltCleared{reply.who()});
  send_done(reply, say(reply.tongue, "Es war kein Halt gedrückt.", "No halt was pressed."));
}

void Console::input(const Reply& reply, const v1::SetInput& request) const {
  const auto number = request.input();
  const bool known = number == 0 || (number >= 11 && number <= 18) || (number >= 21 && number <= 28);
  if (!known)
    return send_error(reply, say(reply.tongue, "Eingänge: 0, 11 bis 18 (Karte 1), 21 bis 28 (Karte 2).",
                                 "Inputs: 0, 11 to 18 (card 1), 21 to 28 (card 2)."));
  lab_.machine_.set_input(static_cast<int>(number / 10), static_cast<int>(number % 10), request.on());
  lab_.journal_.write("input", fmt::format("{} {}", number, request.on() ? "on" : "off"), 0, reply.visit->person.name);
  send_done(reply);
}

void Console::remote(const Reply& reply, const v1::SetRemote& request) const {
  if (!StationId::of(request.station()))
    return send_error(reply,
                      say(reply.tongue, "Plätze haben die Nummern 1 bis 15.", "Stations have the numbers 1 to 15."));
  lab_.lines_.set_remote(static_cast<int>(request.station()), request.on(), reply.visit->person.name);
  send_done(reply);
}

/// A fault of the memory belongs to the control: it ends with the log-out at the latest.
void Console::ram_fault(const Reply& reply, const v1::SetRamFault& request) const {
  const auto desk = desk_at(reply, request.station());
  if (!desk) return;
  desk->control.set_ram_fault(request.on());
  done_at(reply, desk, request.on() ? "ram_fault" : "ram_fault_end");
}

void Console::machine_data(const Reply& reply, const v1::ChangeMachineData& request) const {
  const machine::MachineData newest = lab_.machine_.wished_data();
  // Stored is the whole set: a default must not take a damaged limit's place unseen (AUTH-011).
  const auto is_set = [&](int damaged) {
    return std::ranges::any_of(request.data(),
                               [&](const auto& datum) { return static_cast<int>(datum.number()) == damaged; });
  };
  if (!std::ranges::all_of(lab_.machine_.damaged_data(), is_set))
    return send_error(reply, damage_sentence(lab_.machine_.damaged_data(), reply.tongue));
  if (request.data().empty()) {
    Items items;
    for (const auto& form : machine::datum_forms()) items.push_back(datum_item(form.number, newest.get(form.number)));
    return send(reply, items);
  }
  if (lab_.authority_.phase() != Phase::nobody)
    return send_error(reply,
                      say(reply.tongue, "Maschinendaten lassen sich nur ändern, wenn kein Platz die Maschine hat.",
                          "Machine data can be changed only while no station has the machine."));
  machine::MachineData wished = newest;
  for (const auto& datum : request.data())
    if (const auto set = wished.set(static_cast<int>(datum.number()), datum.value()); !set)
      return send_error(reply, datum_fault(static_cast<int>(datum.number()), datum.value(), set.error(), reply.tongue));
  std::string changes;
  for (const auto& datum : request.data())
    changes += fmt::format("{}{:02}={}", changes.empty() ? "" : " ", datum.number(), datum.value());
  // DEC-25: a stop from F MAX must not take longer than 2 s.
  const auto limits = machine::motion_limits(wished);
  if (limits.f_max_mm_per_s / limits.stop_deceleration_mm_per_s2 > 2.0)
    return send_error(
        reply, say(reply.tongue,
                   "Mit diesen Daten dauert ein Halt aus F MAX über 2 s: RAMPE größer oder F MAX kleiner wählen.",
                   "With these data a stop from F MAX takes over 2 s: choose a greater RAMPE or a smaller F MAX."));
  ask_store(
      reply,
      [wished, author = db::Author{reply.visit->person.name, 0, lab_.clock_.unix_ms()}](db::Database& database) {
        for (const auto& form : machine::datum_forms())
          database.put_machine_datum(db::kLabMachine, stored_datum(form.number, wished.get(form.number)), author);
        return true;
      },
      [reply, wished, changes](const Console& console, bool) {
        console.lab_.machine_.wish_data(wished);
        console.lab_.journal_.write("machine_data", changes, 0, reply.who());
        console.lab_.machine_.data_are_whole();
        console.lab_.settle_machine_data();
        console.send_done(reply);
      });
}

void Console::tools(const Reply& reply, const v1::SetTools& request) const {
  if (request.tape().empty()) {
    v1::InstructorItem item;
    item.mutable_program_text()->set_text(lab_.machine_.tools_tape().empty() ? "P0000\n%"
                                                                             : lab_.machine_.tools_tape() + "%");
    return send(reply, {item});
  }
  if (lab_.authority_.phase() != Phase::nobody)
    return send_error(reply,
                      say(reply.tongue, "Die Werkzeugliste lässt sich nur ändern, wenn kein Platz die Maschine hat.",
                          "The tool list can be changed only while no station has the machine."));
  const language::Tape tape = language::read_tape(request.tape(), language::Reading::file, reply.tongue);
  if (!tape.errors.empty()) return send_error(reply, tape_error(tape.errors.front(), reply.tongue));
  if (tape.programs.size() != 1 || tape.programs.front().program.number != 0)
    return send_error(reply, say(reply.tongue, "Die Datei muss genau das Programm P0000 enthalten.",
                                 "The file must hold the program P0000 and no other."));
  store_value(reply, "tools", language::write_program(tape.programs.front().program),
              [](Lab& lab, const std::string& text) { lab.machine_.use_tools(text); });
}

void Console::workpiece(const Reply& reply, const v1::SetWorkpiece& request) const {
  if (request.print_only()) {
    v1::InstructorItem item;
    const std::array<double, 3> size_mm = lab_.machine_.workpiece().size_mm;
    item.mutable_workpiece()->set_x(size_mm[0]);
    item.mutable_workpiece()->set_y(size_mm[1]);
    item.mutable_workpiece()->set_z(size_mm[2]);
    return send(reply, {item});
  }
  const std::array<double, 3> size_mm{request.x(), request.y(), request.z()};
  if (!std::ranges::all_of(size_mm, [](double mm) { return mm >= kLeastWorkpiece_mm && mm <= kMostWorkpiece_mm; }))
    return send_error(reply, say(reply.tongue, "Ein Werkstück hat Kanten von 1 bis 1000 mm.",
                                 "A workpiece has edges of 1 to 1000 mm."));
  store_value(reply, "workpiece", fmt::format("{} {} {}", size_mm[0], size_mm[1], size_mm[2]),
              [size_mm](Lab& lab, const std::string&) {
                lab.machine_.use_workpiece(size_mm);
                for (const auto& desk : lab.seats_.all()) desk->set_workpiece(lab.machine_.workpiece());
              });
}

void Console::store_value(const Reply& reply, const std::string& key, const std::string& value,
                          std::function<void(Lab&, const std::string&)> then) const {
  ask_store(
      reply,
      [key, value](db::Database& database) {
        database.put_value(key, value);
        return true;
      },
      [reply, key, value, then = std::move(then)](const Console& console, bool) {
        then(console.lab_, value);
        console.lab_.journal_.write(key, value.substr(0, kJournalled), 0, reply.visit->person.name);
        console.send_done(reply);
      });
}

}  // namespace cnclab::lab
