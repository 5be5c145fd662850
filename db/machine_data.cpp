// Machine data of each person's control and of the lab machine, with what they were before (STO-005).
#include "db/statements.hpp"

namespace cnclab::db {
namespace {

bool is_of(const DataVersion& version, const Author& author) {
  return version.author.time_ms == author.time_ms && version.author.name == author.name &&
         version.author.station == author.station;
}

}  // namespace

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

std::vector<DataVersion> Database::machine_data_versions(PersonId id) {
  Query query(*statements_,
              "SELECT number, by_whom, station, time_ms FROM machine_datum_change WHERE person_id = ?1 ORDER BY id",
              id);
  std::vector<DataVersion> versions;
  while (query.next()) {
    const Author author{query.text(1), query.small(2), query.integer(3)};
    if (versions.empty() || !is_of(versions.back(), author))
      versions.push_back({static_cast<int>(versions.size()) + 1, {}, author});
    versions.back().numbers.push_back(query.small(0));
  }
  return versions;
}

std::optional<std::map<int, std::int64_t>> Database::machine_data_at(PersonId id, int version) {
  const std::vector<DataVersion> versions = machine_data_versions(id);
  if (version < 0 || version > static_cast<int>(versions.size())) return std::nullopt;
  std::size_t changes = 0;  // that made the version; what stands there now may be damaged and has no part in it
  for (const DataVersion& change : versions)
    if (change.version <= version) changes += change.numbers.size();
  std::map<int, std::int64_t> values;
  Query query(*statements_, "SELECT number, after FROM machine_datum_change WHERE person_id = ?1 ORDER BY id", id);
  for (; changes > 0 && query.next(); --changes) values[query.small(0)] = query.integer(1);
  return values;
}

}  // namespace cnclab::db
