// The roster read from and written to a file (INS-004): everybody of it is added, or nobody.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lab/console/console_ask.hpp"
#include "lab/console/roster_csv.hpp"

namespace cnclab::lab {

namespace {

constexpr std::size_t kMostErrors = 20;

std::string joined(const std::vector<std::string>& errors) {
  const std::size_t shown = std::min(errors.size(), kMostErrors);
  std::string text =
      fmt::format("{}", fmt::join(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(shown), "\n"));
  return errors.size() > shown ? text + fmt::format("\n… {}", errors.size() - shown) : text;
}

/// Those of the file who are on the roster already, with their lines.
Refusal known_names(db::Database& database, const std::vector<RosterEntry>& entries) {
  std::vector<std::string> german, english;
  for (const auto& entry : entries) {
    if (!database.person(entry.name)) continue;
    german.push_back(line_prefix(entry.line, language::Tongue::german) + "den Namen " + entry.name + " gibt es schon");
    english.push_back(line_prefix(entry.line, language::Tongue::english) + "the name " + entry.name +
                      " exists already");
  }
  return {joined(german), joined(english)};
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
  std::vector<Person> people;
  std::size_t hashed = 0;
};

void Console::import(const Reply& reply, const v1::RosterImport& request) const {
  const Roster roster = read_roster(request.csv(), reply.tongue);
  if (!roster.errors.empty()) return send_error(reply, joined(roster.errors));
  if (roster.entries.empty())
    return send_error(reply, say(reply.tongue, "In der Datei steht niemand.", "There is nobody in the file."));
  const auto import = std::make_shared<Import>();
  for (const auto& entry : roster.entries) import->people.push_back({entry, entry.password.empty(), {}});
  // Names that exist are told before the passwords are hashed, which takes a while.
  ask_store(
      reply,
      [entries = roster.entries](db::Database& database) {
        if (Refusal known = known_names(database, entries); !known.german.empty()) throw known;
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
      [import, time_ms = lab_.clock_.unix_ms()](db::Database& database) {
        std::vector<RosterEntry> entries;
        for (const auto& person : import->people) entries.push_back(person.entry);
        if (Refusal known = known_names(database, entries); !known.german.empty()) throw known;
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
