// Programs of everybody collected, and older versions restored (INS-003, STO-005).
#include <fmt/format.h>

#include "lab/console_ask.hpp"
#include "lab/program_versions.hpp"

namespace cnclab::lab {

namespace {

/// A student's part of the collection: a tape file of its own, headed by a comment with the name.
std::string collected(const db::Person& person, const std::vector<db::StoredProgram>& programs,
                      const v1::ProgramCollect& request) {
  std::string text;
  for (const auto& program : programs) {
    if (request.only_that() && program.number != static_cast<int>(request.program())) continue;
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
        console.lab_.write_journal("program_restore", what + " (" + reply.visit->person.name + ")", 0, person.name);
        console.send_done(reply, what);
      });
}

void Console::machine_data_restore(const Reply& reply, const v1::ProgramName& request) const {
  for (const auto& [id, desk] : lab_.desks_) {
    if (desk->person.name != request.student()) continue;
    if (desk->is_seated() || desk->on_lab_machine)
      return send_error(reply,
                        lab_.say(reply.tongue, "Erst abmelden: die Maschinendaten gelten ab der nächsten Anmeldung.",
                                 "Log out first: machine data act from the next log-in on."));
    lab_.dismiss(desk);  // a control that waits for its line would go on with the old ones
    break;
  }
  ask_store(
      reply,
      [request, author = db::Author{reply.visit->person.name, 0, lab_.clock_.unix_ms()}](db::Database& database) {
        const db::Person person = person_named(database, request.student());
        restore_machine_data(database, person, static_cast<int>(request.version()), author);
        return person;
      },
      [reply, request](const Console& console, const db::Person& person) {
        const std::string what = fmt::format("MD version {}", request.version());
        console.lab_.write_journal("program_restore", what + " (" + reply.visit->person.name + ")", 0, person.name);
        console.send_done(reply, what);
      });
}

}  // namespace cnclab::lab
