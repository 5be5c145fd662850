// The roster read from and written to a file (INS-004): everybody of it is added, or nobody.
#include <fmt/format.h>

#include "lab/console/console_ask.hpp"
#include "lab/console/roster_csv.hpp"

namespace cnclab::lab {

namespace {

constexpr std::size_t kMostErrors = 20;

std::string joined(const std::map<int, std::string>& errors) {
  std::string text;
  std::size_t shown = 0;
  for (const auto& [line, error] : errors) {
    if (++shown > kMostErrors) break;
    text += (text.empty() ? "" : "\n") + error;
  }
  return errors.size() > kMostErrors ? text + fmt::format("\n… {}", errors.size() - kMostErrors) : text;
}

/// The file's errors, and those of its people who are on the roster already; nothing where there are none.
std::string faults_of(db::Database& database, const Roster& roster, language::Tongue tongue) {
  std::map<int, std::string> errors = roster.errors;
  for (const auto& entry : roster.entries)
    if (database.person(entry.name))
      errors[entry.line] = line_prefix(entry.line, tongue) + (tongue == language::Tongue::german
                                                                  ? "den Namen " + entry.name + " gibt es schon"
                                                                  : "the name " + entry.name + " exists already");
  return joined(errors);
}

v1::InstructorItem password_item(const RosterEntry& entry) {
  v1::InstructorItem item;
  item.mutable_one_time_password()->set_name(entry.name);
  item.mutable_one_time_password()->set_password(entry.password);
  return item;
}

}  // namespace

/// An import on its way: one password after the other is hashed, then all are added in one job.
struct Console::Import {
  struct Person {
    RosterEntry entry;
    bool one_time = false;
    std::string hash;
  };
  std::shared_ptr<const Roster> roster;
  std::vector<Person> people;
  std::size_t hashed = 0;
};

void Console::import(const Reply& reply, const v1::RosterImport& request) const {
  const auto roster = std::make_shared<const Roster>(read_roster(request.csv(), reply.tongue));
  if (roster->entries.empty() && roster->errors.empty())
    return send_error(reply, say(reply.tongue, "In der Datei steht niemand.", "There is nobody in the file."));
  const auto import = std::make_shared<Import>();
  import->roster = roster;
  for (const auto& entry : roster->entries) import->people.push_back({entry, entry.password.empty(), {}});
  // Every error is told at once, before the passwords are hashed, which takes a while.
  ask_store(
      reply,
      [roster, tongue = reply.tongue](db::Database& database) {
        if (const std::string faults = faults_of(database, *roster, tongue); !faults.empty())
          throw Refusal{faults, faults};
        return true;
      },
      [reply, import](const Console& console, bool) { console.hash_next(reply, import); });
}

void Console::hash_next(const Reply& reply, const std::shared_ptr<Import>& import) const {
  if (import->hashed == import->people.size()) return add_all(reply, import);
  Import::Person& person = import->people[import->hashed++];
  if (person.one_time) person.entry.password = one_time_password();
  with_hash(reply, person.entry.password, [&lab = lab_, reply, import, &person](const std::string& hash) {
    person.hash = hash;
    Console(lab).hash_next(reply, import);
  });
}

void Console::add_all(const Reply& reply, const std::shared_ptr<Import>& import) const {
  ask_store(
      reply,
      [import, tongue = reply.tongue, time_ms = lab_.clock_.unix_ms()](db::Database& database) {
        if (const std::string faults = faults_of(database, *import->roster, tongue); !faults.empty())
          throw Refusal{faults, faults};  // somebody was added meanwhile
        for (const auto& [entry, one_time, hash] : import->people) {
          db::Person added;
          added.name = entry.name;
          added.role = "student";
          added.language = entry.language;
          added.password_hash = hash;
          added.must_change = one_time;
          database.add_person(added, time_ms);
        }
        return true;
      },
      [reply, import](const Console& console, bool) {
        Items items;
        for (const auto& person : import->people) {
          console.lab_.journal_.write("student_add", person.entry.name, 0, reply.visit->person.name);
          if (person.one_time) items.push_back(password_item(person.entry));
        }
        if (items.empty()) return console.send_done(reply, fmt::format("{}", import->people.size()));
        console.send(reply, items);
      });
}

void Console::export_roster(const Reply& reply) const {
  ask_store(
      reply,
      [](db::Database& database) {
        std::vector<RosterEntry> entries;
        for (const auto& person : database.people(false))
          if (person.role == "student") entries.push_back({person.name, {}, person.language, 0});
        return write_roster(entries);
      },
      [reply](const Console& console, const std::string& csv) { console.send_file(reply, csv); });
}

}  // namespace cnclab::lab
