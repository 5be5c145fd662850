// Programs of everybody collected, and older versions restored (INS-003, STO-005).
#include <fmt/format.h>

#include <utility>

#include "lab/console/console_ask.hpp"
#include "lab/labor/program_versions.hpp"

namespace cnclab::lab {

namespace {

/// A student's part of the collection: a tape file of its own, headed by a comment with the name.
std::string collected(const db::Person& person, const std::vector<db::StoredProgram>& programs,
                      const v1::ProgramCollect& request) {
  std::string text;
  for (const auto& program : programs) {
    if (request.only_that() && program.number != static_cast<int>(request.program())) continue;
    check_sound(program, person.name);
    text += fmt::format("P{:04}\n", program.number);
    for (const auto& block : program.blocks) text += block.text + "\n";
    text += "%\n";
  }
  return text.empty() ? text : fmt::format("({})\n{}", person.name, text);
}

}  // namespace

void Console::program_collect(const Reply& reply, const v1::ProgramCollect& request) const {
  ask_store(
      reply,
      [request](db::Database& database) {
        std::string text;
        for (const auto& person : database.people(false))
          if (person.role == "student") text += collected(person, database.programs(person.id), request);
        if (text.empty()) throw Refusal{"Niemand hat ein solches Programm.", "Nobody has such a program."};
        return text;
      },
      [reply](const Console& console, const std::string& text) { console.send_file(reply, text); });
}

void Console::program_restore(const Reply& reply, const v1::ProgramName& request) const {
  if (request.program() == kMachineDataProgram) return machine_data_restore(reply, request);
  ask_store(
      reply,
      [request, memory = lab_.configuration_.memory_bytes,
       author = db::Author{reply.visit->person.name, 0, lab_.clock_.unix_ms()}](db::Database& database) {
        const db::Person person = person_named(database, request.student());
        restore_version(database, person.id, static_cast<std::uint16_t>(request.program()),
                        static_cast<int>(request.version()), memory, author);
        return person;
      },
      [reply, request](const Console& console, const db::Person& person) {
        console.lab_.reload_programs(person.id);
        const std::string what = fmt::format("P{:04} version {}", request.program(), request.version());
        console.lab_.journal_.write("program_restore", what + " (" + reply.visit->person.name + ")", 0, person.name);
        console.send_done(reply, what);
      });
}

void Console::machine_data_restore(const Reply& reply, const v1::ProgramName& request) const {
  if (const auto desk = lab_.lab_desk_.lock(); desk && desk->person.name == request.student())  // DEC-39
    return send_error(reply, say(reply.tongue, "Nicht, solange dieser Platz die Maschine hat.",
                                 "Not while that station has the machine."));
  using Restored = std::pair<db::Person, machine::MachineData>;
  ask_store(
      reply,
      [request, author = db::Author{reply.visit->person.name, 0, lab_.clock_.unix_ms()}](db::Database& database) {
        const db::Person person = person_named(database, request.student());
        return Restored{person,
                        restore_machine_data_version(database, person.id, static_cast<int>(request.version()), author)};
      },
      [reply, request](const Console& console, const Restored& restored) {
        const auto& [person, data] = restored;
        if (const auto desk = console.lab_.seats_.of(person.id)) {
          desk->control.replace_data(data);
          desk->settle_machine_data();
          desk->is_dirty = true;
        }
        const std::string what = fmt::format("MD version {}", request.version());
        console.lab_.journal_.write("program_restore", what + " (" + reply.visit->person.name + ")", 0, person.name);
        console.send_done(reply, what);
      });
}

}  // namespace cnclab::lab
