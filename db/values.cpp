// Single values of the lab, and the state that a control keeps between two logins.
#include "db/statements.hpp"

namespace cnclab::db {

std::optional<std::string> Database::value(const std::string& key) {
  Query query(*statements_, "SELECT value FROM lab WHERE key = ?1", key);
  if (!query.next()) return std::nullopt;
  return query.text(0);
}

void Database::put_value(const std::string& key, const std::string& value) {
  Query(*statements_,
        "INSERT INTO lab (key, value) VALUES (?1, ?2) ON CONFLICT (key) DO UPDATE SET value = excluded.value", key,
        Blob{value})
      .run();
}

std::string Database::control_state(PersonId id) {
  Query query(*statements_, "SELECT state FROM control_state WHERE person_id = ?1", id);
  return query.next() ? query.text(0) : std::string{};
}

void Database::put_control_state(PersonId id, const std::string& state, std::int64_t now_ms) {
  Query(*statements_,
        "INSERT INTO control_state (person_id, state, time_ms) VALUES (?1, ?2, ?3) "
        "ON CONFLICT (person_id) DO UPDATE SET state = excluded.state, time_ms = excluded.time_ms",
        id, Blob{state}, now_ms)
      .run();
}

}  // namespace cnclab::db
