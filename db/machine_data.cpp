// Machine data of each person's control and of the lab machine, with what they were before (STO-005).
#include "db/statements.hpp"

namespace cnclab::db {

std::vector<StoredDatum> Database::machine_data(PersonId id) {
  Query query(*statements_, "SELECT number, value, check_code FROM machine_datum WHERE person_id = ?1 ORDER BY number",
              id);
  std::vector<StoredDatum> found;
  while (query.next())
    found.push_back({query.small(0), query.integer(1), static_cast<std::uint32_t>(query.integer(2))});
  return found;
}

void Database::put_machine_datum(PersonId id, const StoredDatum& datum, const Author& author) {
  transaction([&] {
    Query(*statements_,
          "INSERT INTO machine_datum_change (person_id, number, before, after, time_ms, by_whom, station) VALUES (?1, "
          "?2, "
          "(SELECT value FROM machine_datum WHERE person_id = ?1 AND number = ?2), ?3, ?4, ?5, ?6)",
          id, datum.number, datum.value, author.time_ms, author.name, author.station)
        .run();
    Query(*statements_,
          "INSERT INTO machine_datum (person_id, number, value, check_code) VALUES (?1, ?2, ?3, ?4) "
          "ON CONFLICT (person_id, number) DO UPDATE SET value = excluded.value, check_code = excluded.check_code",
          id, datum.number, datum.value, datum.check_code)
        .run();
  });
}

}  // namespace cnclab::db
