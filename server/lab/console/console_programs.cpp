// Requests about students' programs: list, show, versions, send (INS-003, STO-005).
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lab/console/console_ask.hpp"
#include "lab/labor/program_versions.hpp"
#include "lab/stored_control.hpp"
#include "language/tape.hpp"

namespace cnclab::lab {

namespace {

constexpr std::size_t kLargestTape = 4'000'000;  ///< more than the programs of the largest memory take as text

std::string program_name(std::uint32_t number) { return fmt::format("P{:04}", number); }

std::optional<int> version_in(const v1::ProgramName& request) {
  return request.version() == 0 ? std::nullopt : std::optional(static_cast<int>(request.version()));
}

/// The tape text: one block per line, in pieces that each fit a frame; of machine data the lines of their file.
std::vector<v1::InstructorItem> text_items(std::uint32_t number, const std::vector<std::string>& blocks) {
  constexpr std::size_t kPiece = 32'000;
  std::vector<v1::InstructorItem> items(1);
  const bool is_program = number != kMachineDataProgram;
  std::string text = is_program ? program_name(number) + "\n" : "";
  for (const auto& block : blocks) {
    if (text.size() + block.size() > kPiece) {
      items.back().mutable_program_text()->set_text(text);
      items.emplace_back();
      text.clear();
    }
    text += block + "\n";
  }
  items.back().mutable_program_text()->set_text(is_program ? text + "%\n" : text);
  return items;
}

/// The blocks of a version, as it was stored; of the newest as they stand there, so that damage is told.
std::vector<std::string> program_lines(db::Database& database, const db::Person& person, int program,
                                       std::optional<int> version) {
  const auto texts = version_texts(database, person.id, program, version.value_or(0));
  if (!texts)
    throw Refusal{fmt::format("{} hat kein Programm P{:04} in dieser Version.", person.name, program),
                  fmt::format("{} has no program P{:04} of that version.", person.name, program)};
  if (!version)
    for (const db::StoredProgram& stored : database.programs(person.id))
      if (stored.number == program) check_sound(stored, person.name);
  std::vector<std::string> lines;
  for (const auto& [number, text] : *texts) lines.push_back(text);
  return lines;
}

std::string change_text(const db::ProgramVersion& version) {
  return version.block == 0 ? version.kind : fmt::format("{} N{:03}", version.kind, version.block);
}

std::string numbers_text(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += fmt::format("{}{:02}", text.empty() ? "" : " ", number);
  return text;
}

v1::InstructorItem version_item(int version, const db::Author& author, const std::string& change) {
  v1::InstructorItem item;
  auto& info = *item.mutable_version();
  info.set_version(static_cast<std::uint32_t>(version));
  info.set_time(iso_time(author.time_ms));
  info.set_by(author.name);
  info.set_station(static_cast<std::uint32_t>(author.station));
  info.set_change(change);
  return item;
}

/// How many people have the programs, and what of the file none of them has (DEC-06).
std::string sent_text(std::size_t people, const language::Tape& tape, language::Tongue tongue) {
  std::string text = std::to_string(people);
  for (const std::string& notice : tape.notices) text += "; " + notice;
  if (!tape.machine_data.empty())
    text += "; " + say(tongue, "die Maschinendaten (MD) der Datei werden nicht übernommen",
                       "the machine data (MD) of the file are not taken");
  return text;
}

/// The people a program is sent to.
std::vector<db::Person> receivers(db::Database& database, const v1::ProgramSend& request) {
  std::vector<db::Person> people;
  if (request.all()) {
    for (auto& person : database.people(false))
      if (person.role == "student") people.push_back(person);
  }
  for (const auto& name : request.students()) people.push_back(person_named(database, name));
  if (people.empty())
    throw Refusal{"Niemand genannt, der das Programm bekommen soll.", "Nobody is named to receive the program."};
  return people;
}

/// All or none: what exists already is refused before anything is written.
void check_room(db::Database& database, const std::vector<db::Person>& people, const language::Tape& tape, bool replace,
                int memory_bytes) {
  for (const auto& person : people) {
    auto memory = memory_of(database.programs(person.id), memory_bytes);
    for (const auto& read : tape.programs) {
      const auto number = read.program.number;
      if (!replace && memory.find(number) != nullptr)
        throw Refusal{fmt::format("{} hat schon ein Programm P{:04}; --replace ersetzt es.", person.name, number),
                      fmt::format("{} has a program P{:04} already; --replace replaces it.", person.name, number)};
      memory.put_program(read.program);
    }
    if (used_bytes(memory) > language::empty_memory_bytes(memory_bytes))
      throw Refusal{fmt::format("Der Speicher von {} reicht dafür nicht.", person.name),
                    fmt::format("The memory of {} is too small for this.", person.name)};
  }
}

}  // namespace

std::string tape_error(const language::Error& error, language::Tongue tongue) {
  return fmt::format("{}: {}", error.line, language::explain(error, tongue));
}

int stored_cost(int program, const db::StoredBlock& block) {
  const auto read = language::read_block(block.text, static_cast<std::uint16_t>(program));
  return read ? language::cost_bytes(*read) : 4;
}

void Console::programs(const Reply& reply, const v1::StudentName& request) const {
  ask_store(
      reply,
      [name = request.name()](db::Database& database) { return database.programs(person_named(database, name).id); },
      [reply](const Console& console, const std::vector<db::StoredProgram>& programs) {
        Items items;
        for (const auto& program : programs) {
          v1::InstructorItem item;
          auto& info = *item.mutable_program();
          info.set_program(program_name(static_cast<std::uint32_t>(program.number)));
          info.set_blocks(static_cast<std::uint32_t>(program.blocks.size()));
          int bytes = 0;
          for (const auto& block : program.blocks) bytes += stored_cost(program.number, block);
          info.set_bytes(static_cast<std::uint32_t>(bytes));
          info.set_changed(iso_time(program.changed_ms));
          info.set_version(static_cast<std::uint32_t>(program.version));
          items.push_back(item);
        }
        console.send(reply, items);
      });
}

void Console::program_show(const Reply& reply, const v1::ProgramName& request) const {
  ask_store(
      reply,
      [request](db::Database& database) {
        const auto person = person_named(database, request.student());
        if (request.program() == kMachineDataProgram)
          return machine_data_lines(database, person.id, version_in(request));
        return program_lines(database, person, static_cast<int>(request.program()), version_in(request));
      },
      [reply, number = request.program()](const Console& console, const std::vector<std::string>& blocks) {
        console.send(reply, text_items(number, blocks));
      });
}

void Console::program_versions(const Reply& reply, const v1::ProgramName& request) const {
  ask_store(
      reply,
      [request](db::Database& database) {
        const db::PersonId id = person_named(database, request.student()).id;
        Items items;
        if (request.program() == kMachineDataProgram) {
          for (const auto& version : database.machine_data_versions(id))
            items.push_back(version_item(version.version, version.author, numbers_text(version.numbers)));
        } else {
          for (const auto& version : database.versions(id, static_cast<int>(request.program())))
            items.push_back(version_item(version.version, version.author, change_text(version)));
        }
        return items;
      },
      [reply](const Console& console, const Items& items) { console.send(reply, items); });
}

void Console::program_send(const Reply& reply, const v1::ProgramSend& request) const {
  std::string& begun = reply.visit->tape;
  if (begun.size() + request.tape().size() > kLargestTape) {
    begun.clear();
    return send_error(reply, say(reply.tongue, "Die Datei ist zu groß (höchstens 4000000 Zeichen).",
                                 "The file is too large (at most 4000000 characters)."));
  }
  begun += request.tape();
  if (request.more()) return send_done(reply);
  const auto tape = std::make_shared<const language::Tape>(
      language::read_tape(std::exchange(begun, {}), language::Reading::file, reply.tongue));
  if (!tape->errors.empty()) return send_error(reply, tape_error(tape->errors.front(), reply.tongue));
  if (tape->programs.empty())  // or none but what belongs to the cycles, as the notice says (DEC-06)
    return send_error(reply, !tape->notices.empty() ? tape->notices.front()
                                                    : say(reply.tongue, "In der Datei steht kein Programm.",
                                                          "There is no program in the file."));
  ask_store(
      reply,
      [request, tape, memory = lab_.configuration_.memory_bytes,
       author = db::Author{reply.visit->person.name, 0, lab_.clock_.unix_ms()}](db::Database& database) {
        const auto people = receivers(database, request);
        check_room(database, people, *tape, request.replace(), memory);
        std::vector<db::PersonId> ids;
        for (const auto& person : people) {
          for (const auto& read : tape->programs)
            database.replace_program(person.id, read.program.number, stored_blocks(read.program), author);
          ids.push_back(person.id);
        }
        return ids;
      },
      [reply, tape](const Console& console, const std::vector<db::PersonId>& ids) {
        for (const auto id : ids) console.lab_.reload_programs(id);
        console.send_done(reply, sent_text(ids.size(), *tape, reply.tongue));
      });
}

}  // namespace cnclab::lab
