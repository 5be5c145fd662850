// Requests about people: add, archive, restore, rename, passwords (INS-004, SEC-002).
#include <algorithm>

#include "lab/console/console_ask.hpp"
#include "lab/console/roster_csv.hpp"
#include "language/check_block.hpp"
#include "shared/credential_limits.hpp"

namespace cnclab::lab {

namespace {

Refusal bad_name(const std::string& name) {
  return {"Kein gültiger Name: „" + name + "“ (Buchstaben, Ziffern, . - _, höchstens 32 Bytes, ein Umlaut hat zwei).",
          "Not a valid name: \"" + name + "\" (letters, digits, . - _, at most 32 bytes, an umlaut has two)."};
}

v1::InstructorItem password_item(const std::string& name, const std::string& password) {
  v1::InstructorItem item;
  item.mutable_one_time_password()->set_name(name);
  item.mutable_one_time_password()->set_password(password);
  return item;
}

struct RosterLine {
  db::Person person;
  int programs = 0, bytes = 0;
};

}  // namespace

void Console::with_hash(const Reply& reply, const std::string& password, std::function<void(std::string)> then) const {
  if (password.size() < kShortestPassword || password.size() > kLongestPassword)
    return send_error(reply, say(reply.tongue, "Das Passwort muss 8 bis 256 Zeichen haben.",
                                 "The password must have 8 to 256 characters."));
  lab_.passwords_.hash(password, [alive = lab_.alive_, reply, then = std::move(then)](const std::string& hash) {
    if (*alive && reply.visit->stage == Stage::at_console) then(hash);
  });
}

void Console::passwd(const Reply& reply, const v1::NewPassword& request) const {
  with_hash(reply, request.new_password(), [&lab = lab_, reply](const std::string& hash) {
    Console(lab).ask_store(
        reply,
        [id = reply.visit->person.id, hash](db::Database& database) {
          database.set_password(id, hash, false);
          return true;
        },
        [reply](const Console& console, bool) {
          console.lab_.journal_.write("password_changed", "", 0, reply.visit->person.name);
          console.send_done(reply);
        });
  });
}

void Console::students(const Reply& reply) const {
  ask_store(
      reply,
      [](db::Database& database) {
        std::vector<RosterLine> lines;
        for (const auto& person : database.people(true)) {
          RosterLine line{person, 0, 0};
          for (const auto& program : database.programs(person.id)) {
            ++line.programs;
            for (const auto& block : program.blocks) line.bytes += stored_cost(program.number, block);
          }
          lines.push_back(line);
        }
        return lines;
      },
      [reply](const Console& console, const std::vector<RosterLine>& lines) {
        Items items;
        const Lab& lab = console.lab_;
        for (const auto& line : lines) {
          v1::InstructorItem item;
          auto& student = *item.mutable_student();
          student.set_name(line.person.name);
          student.set_role(line.person.role);
          student.set_language(lab.tongue_of(line.person) == language::Tongue::german ? "de" : "en");
          const bool small = lab.configuration_.model == language::Model::cnc3250;
          student.set_model(!line.person.model.empty() ? line.person.model : small ? "3250" : "3300");
          if (const auto desk = lab.seats_.of(line.person.id); desk && desk->is_seated())
            student.set_station(static_cast<std::uint32_t>(desk->station));
          student.set_programs(static_cast<std::uint32_t>(line.programs));
          const int free = language::empty_memory_bytes(lab.configuration_.memory_bytes) - line.bytes;
          student.set_memory_free(static_cast<std::uint32_t>(std::max(0, free)));
          if (line.person.last_seen_ms != 0) student.set_last_seen(iso_time(line.person.last_seen_ms));
          student.set_archived(line.person.archived_ms.has_value());
          items.push_back(item);
        }
        console.send(reply, items);
      });
}

void Console::student_add(const Reply& reply, const v1::StudentAdd& request) const {
  const Refusal bad = bad_name(request.name());
  if (!is_name(request.name()))
    return send_error(reply, reply.tongue == language::Tongue::german ? bad.german : bad.english);
  const std::string role = request.role().empty() ? "student" : request.role();
  if (role != "student" && role != "observer" && role != "instructor")
    return send_error(
        reply, say(reply.tongue, "Rollen: student, observer, instructor.", "Roles: student, observer, instructor."));
  const bool one_time = request.password().empty();
  const std::string password = one_time ? one_time_password() : request.password();
  db::Person person;
  person.name = request.name();
  person.role = role;
  person.language = request.language();
  person.must_change = one_time || request.must_change();
  with_hash(reply, password, [&lab = lab_, reply, person, one_time, password](const std::string& hash) {
    db::Person complete = person;
    complete.password_hash = hash;
    Console(lab).ask_store(
        reply,
        [complete, time = lab.clock_.unix_ms()](db::Database& database) {
          if (!database.add_person(complete, time))
            throw Refusal{"Den Namen " + complete.name + " gibt es schon.",
                          "The name " + complete.name + " exists already."};
          return true;
        },
        [reply, one_time, password, name = complete.name](const Console& console, bool) {
          console.lab_.journal_.write("student_add", name, 0, reply.visit->person.name);
          if (one_time) return console.send(reply, {password_item(name, password)});
          console.send_done(reply, name);
        });
  });
}

void Console::student_remove(const Reply& reply, const v1::StudentName& request) const {
  if (request.name() == reply.visit->person.name)
    return send_error(reply, say(reply.tongue, "Das eigene Konto lässt sich nicht entfernen.",
                                 "You cannot remove your own account."));
  ask_store(
      reply,
      [name = request.name(), erase = request.erase(), time = lab_.clock_.unix_ms()](db::Database& database) {
        const db::Person person = person_named(database, name);
        if (erase)
          database.erase(person.id);
        else
          database.archive(person.id, time);
        return person.id;
      },
      [reply, name = request.name(), erase = request.erase()](const Console& console, db::PersonId id) {
        Lab& lab = console.lab_;
        if (const auto desk = lab.seats_.of(id)) {
          const auto visit = desk->visit.lock();
          if (visit) lab.vacate(visit, "removed from the roster");
          lab.dismiss(desk);
          if (visit)
            lab.farewell(visit, 9,
                         say(lab.tongue_of(desk->person), "Das Konto wurde entfernt.", "The account was removed."));
        }
        lab.journal_.write(erase ? "student_erase" : "student_remove", name, 0, reply.visit->person.name);
        console.send_done(reply, name);
      });
}

void Console::student_restore(const Reply& reply, const v1::StudentName& request) const {
  ask_store(
      reply,
      [name = request.name()](db::Database& database) {
        const db::Person person = person_named(database, name);
        if (!person.archived_ms) throw Refusal{name + " ist nicht archiviert.", name + " is not archived."};
        database.unarchive(person.id);
        return true;
      },
      [reply, name = request.name()](const Console& console, bool) {
        console.lab_.journal_.write("student_restore", name, 0, reply.visit->person.name);
        console.send_done(reply, name);
      });
}

void Console::student_rename(const Reply& reply, const v1::StudentRename& request) const {
  ask_store(
      reply,
      [from = request.name(), to = request.new_name()](db::Database& database) {
        if (!is_name(to)) throw bad_name(to);
        const db::Person person = person_named(database, from);
        if (!database.rename(person.id, to))
          throw Refusal{"Den Namen " + to + " gibt es schon.", "The name " + to + " exists already."};
        return person.id;
      },
      [reply, to = request.new_name()](const Console& console, db::PersonId id) {
        if (const auto desk = console.lab_.seats_.of(id)) desk->person.name = to;
        console.lab_.everybody_changed();
        console.send_done(reply, to);
      });
}

/// Model and language; a control that is at work keeps its model until the next log-in (DEC-08, MODEL).
void Console::student_set(const Reply& reply, const v1::StudentSettings& request) const {
  const auto is_one_of = [](const std::string& value, std::initializer_list<std::string_view> allowed) {
    return value.empty() || std::ranges::find(allowed, value) != allowed.end();
  };
  if (!is_one_of(request.model(), {"3300", "3250", "lab"}) || !is_one_of(request.language(), {"de", "en", "lab"}))
    return send_error(reply, say(reply.tongue, "Modelle: 3300, 3250, lab. Sprachen: de, en, lab.",
                                 "Models: 3300, 3250, lab. Languages: de, en, lab."));
  ask_store(
      reply,
      [name = request.name(), model = request.model(), language = request.language()](db::Database& database) {
        const db::Person person = person_named(database, name);
        if (!model.empty()) database.set_model(person.id, model == "lab" ? "" : model);
        if (!language.empty()) database.set_language(person.id, language == "lab" ? "" : language);
        return true;
      },
      [reply, name = request.name(), model = request.model(), language = request.language()](const Console& console,
                                                                                             bool) {
        console.lab_.journal_.write("student_set", name + " " + model + " " + language, 0, reply.visit->person.name);
        console.send_done(reply, name);
      });
}

void Console::student_password(const Reply& reply, const v1::StudentName& request) const {
  const std::string password = one_time_password();
  with_hash(reply, password, [&lab = lab_, reply, password, name = request.name()](const std::string& hash) {
    Console(lab).ask_store(
        reply,
        [name, hash](db::Database& database) {
          database.set_password(person_named(database, name).id, hash, true);
          return true;
        },
        [reply, password, name](const Console& console, bool) {
          console.lab_.journal_.write("password_reset", name, 0, reply.visit->person.name);
          console.send(reply, {password_item(name, password)});
        });
  });
}

}  // namespace cnclab::lab
