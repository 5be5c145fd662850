// Students, instructors and observers.
#include "db/statements.hpp"

namespace cnclab::db {
namespace {

#define CNCLAB_PERSON_COLUMNS \
  "SELECT id, name, role, language, model, password_hash, must_change, last_seen_ms, archived_ms FROM person "

Person person_of(const Query& row) {
  Person person{.id = PersonId{row.integer(0)},
                .name = row.text(1),
                .role = row.text(2),
                .language = row.text(3),
                .model = row.text(4),
                .password_hash = row.text(5),
                .must_change = row.small(6) != 0,
                .last_seen_ms = row.integer(7),
                .archived_ms = std::nullopt};
  if (!row.is_null(8)) person.archived_ms = row.integer(8);
  return person;
}

}  // namespace

std::vector<Person> Database::people(bool with_archived) {
  Query query(*statements_, CNCLAB_PERSON_COLUMNS "WHERE ?1 OR archived_ms IS NULL ORDER BY name", with_archived);
  std::vector<Person> found;
  while (query.next()) found.push_back(person_of(query));
  return found;
}

std::optional<Person> Database::person(const std::string& name) {
  Query query(*statements_, CNCLAB_PERSON_COLUMNS "WHERE name = ?1", name);
  if (!query.next()) return std::nullopt;
  return person_of(query);
}

std::optional<PersonId> Database::add_person(const Person& person, std::int64_t now_ms) {
  Query query(*statements_,
              "INSERT INTO person (name, role, language, model, password_hash, must_change, created_ms) "
              "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7) ON CONFLICT (name) DO NOTHING RETURNING id",
              person.name, person.role, person.language, person.model, person.password_hash, person.must_change,
              now_ms);
  if (!query.next()) return std::nullopt;
  return PersonId{query.integer(0)};
}

void Database::set_password(PersonId id, const std::string& hash, bool must_change) {
  Query(*statements_, "UPDATE person SET password_hash = ?2, must_change = ?3 WHERE id = ?1", id, hash, must_change)
      .run();
}

void Database::set_language(PersonId id, const std::string& language) {
  Query(*statements_, "UPDATE person SET language = ?2 WHERE id = ?1", id, language).run();
}

void Database::set_model(PersonId id, const std::string& model) {
  Query(*statements_, "UPDATE person SET model = ?2 WHERE id = ?1", id, model).run();
}

void Database::set_last_seen(PersonId id, std::int64_t now_ms) {
  Query(*statements_, "UPDATE person SET last_seen_ms = ?2 WHERE id = ?1", id, now_ms).run();
}

void Database::archive(PersonId id, std::int64_t now_ms) {
  Query(*statements_, "UPDATE person SET archived_ms = ?2 WHERE id = ?1 AND archived_ms IS NULL", id, now_ms).run();
}

void Database::unarchive(PersonId id) {
  Query(*statements_, "UPDATE person SET archived_ms = NULL WHERE id = ?1", id).run();
}

void Database::erase(PersonId id) {
  transaction([&] {
    Query(*statements_, "DELETE FROM journal WHERE person = (SELECT name FROM person WHERE id = ?1)", id).run();
    Query(*statements_, "DELETE FROM machine_datum WHERE person_id = ?1", id).run();
    Query(*statements_, "DELETE FROM machine_datum_change WHERE person_id = ?1", id).run();
    Query(*statements_, "DELETE FROM person WHERE id = ?1", id).run();  // the rest goes by ON DELETE CASCADE
  });
}

bool Database::rename(PersonId id, const std::string& name) {
  Query query(*statements_,
              "UPDATE person SET name = ?2 WHERE id = ?1 "
              "AND NOT EXISTS (SELECT 1 FROM person WHERE name = ?2 AND id <> ?1) RETURNING id",
              id, name);
  return query.next();
}

}  // namespace cnclab::db
