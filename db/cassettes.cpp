// The cassettes of each person's recorder (DEC-33).
#include "db/statements.hpp"

namespace cnclab::db {

std::vector<StoredCassette> Database::cassettes(PersonId id) {
  Query query(*statements_,
              "SELECT id, name, inserted, changed_ms, length(tape) FROM cassette WHERE person_id = ?1 ORDER BY name",
              id);
  std::vector<StoredCassette> found;
  while (query.next())
    found.push_back({.id = CassetteId{query.integer(0)},
                     .name = query.text(1),
                     .is_inserted = query.small(2) != 0,
                     .changed_ms = query.integer(3),
                     .bytes = static_cast<std::size_t>(query.integer(4))});
  return found;
}

std::optional<CassetteId> Database::add_cassette(PersonId id, const std::string& name, const std::string& tape,
                                                 std::int64_t now_ms) {
  Query query(*statements_,
              "INSERT INTO cassette (person_id, name, tape, changed_ms) SELECT ?1, ?2, ?3, ?4 "
              "WHERE (SELECT count(*) FROM cassette WHERE person_id = ?1) < ?5 "
              "ON CONFLICT (person_id, name) DO NOTHING RETURNING id",
              id, name, Blob{tape}, now_ms, kMostCassettes);
  if (!query.next()) return std::nullopt;
  return CassetteId{query.integer(0)};
}

std::optional<std::string> Database::tape(PersonId id, CassetteId cassette) {
  Query query(*statements_, "SELECT tape FROM cassette WHERE person_id = ?1 AND id = ?2", id, cassette);
  if (!query.next()) return std::nullopt;
  return query.text(0);
}

void Database::put_tape(PersonId id, CassetteId cassette, const std::string& tape, std::int64_t now_ms) {
  Query(*statements_, "UPDATE cassette SET tape = ?3, changed_ms = ?4 WHERE person_id = ?1 AND id = ?2", id, cassette,
        Blob{tape}, now_ms)
      .run();
}

void Database::insert_cassette(PersonId id, std::optional<CassetteId> cassette) {
  Query(*statements_, "UPDATE cassette SET inserted = (id = ?2) WHERE person_id = ?1", id,
        cassette.value_or(CassetteId{0}))
      .run();
}

bool Database::rename_cassette(PersonId id, CassetteId cassette, const std::string& name) {
  Query query(*statements_,
              "UPDATE cassette SET name = ?3 WHERE person_id = ?1 AND id = ?2 "
              "AND NOT EXISTS (SELECT 1 FROM cassette WHERE person_id = ?1 AND name = ?3 AND id <> ?2) RETURNING id",
              id, cassette, name);
  return query.next();
}

void Database::remove_cassette(PersonId id, CassetteId cassette) {
  Query(*statements_, "DELETE FROM cassette WHERE person_id = ?1 AND id = ?2", id, cassette).run();
}

}  // namespace cnclab::db
