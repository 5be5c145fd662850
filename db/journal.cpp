// The journal: only ever appended to, and cut off at its old end (STO-006).
#include "db/statements.hpp"

namespace cnclab::db {

void Database::add_journal(const std::vector<JournalEntry>& entries) {
  transaction([&] {
    for (const JournalEntry& entry : entries)
      Query(*statements_,
            "INSERT INTO journal (time_ms, station, person, kind, detail, lease) VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
            entry.time_ms, entry.station, entry.person, entry.kind, entry.detail, entry.lease)
          .run();
  });
}

std::vector<JournalEntry> Database::journal(const std::string& person, std::int64_t since_ms) {
  Query query(*statements_,
              "SELECT time_ms, station, person, kind, detail, lease FROM journal "
              "WHERE (?1 = '' OR person = ?1) AND time_ms >= ?2 ORDER BY id",
              person, since_ms);
  std::vector<JournalEntry> found;
  while (query.next())
    found.push_back({query.integer(0), query.small(1), query.text(2), query.text(3), query.text(4),
                     static_cast<std::uint64_t>(query.integer(5))});
  return found;
}

void Database::forget_journal_before(std::int64_t time_ms) {
  Query(*statements_, "DELETE FROM journal WHERE time_ms < ?1", time_ms).run();
}

}  // namespace cnclab::db
