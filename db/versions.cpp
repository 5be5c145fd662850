// The versions of a program: written with each change, read back from what the changes themselves brought (STO-005).
// The blocks as they stand now have no part in it: a damaged one would make every version before it a damaged one.
#include "db/block_list.hpp"
#include "db/change.hpp"
#include "db/statements.hpp"

namespace cnclab::db {
namespace {

int newest_version(Connection& connection, PersonId id, int program) {
  Query query(connection, "SELECT coalesce(max(version), 0) FROM program_change WHERE person_id = ?1 AND program = ?2",
              id, program);
  query.next();
  return query.small(0);
}

bool has_version(Connection& connection, PersonId id, int program, int version) {
  return Query(connection, "SELECT 1 FROM program_change WHERE person_id = ?1 AND program = ?2 AND version = ?3", id,
               program, version)
      .next();
}

// Turns the state before a change into the state after it.
void redo(BlockTexts& texts, const std::string& kind, int block, std::string after, const Renumber& renumber) {
  if (kind == "replace" || kind == "remove") {
    texts = read_list(after);
  } else if (kind == "delete") {
    texts.erase(block);
  } else if (kind == "insert") {
    BlockTexts moved;
    for (auto& [number, text] : texts)
      moved.emplace_hint(moved.end(), number < block ? number : number + 1,
                         number < block ? std::move(text) : renumber(text, number + 1));
    moved.emplace(block, std::move(after));
    texts = std::move(moved);
  } else {
    texts[block] = std::move(after);
  }
}

}  // namespace

void record_change(Connection& connection, const Change& change) {
  const int version = newest_version(connection, change.person, change.program) + 1;
  Query(connection,
        "INSERT INTO program (person_id, number, position, version, changed_ms) "
        "SELECT ?1, ?2, coalesce(max(position), 0) + 1, ?3, ?4 FROM program WHERE person_id = ?1 "
        "ON CONFLICT (person_id, number) DO UPDATE SET version = excluded.version, changed_ms = excluded.changed_ms",
        change.person, change.program, version, change.author.time_ms)
      .run();
  Query(
      connection,
      "INSERT INTO program_change (person_id, program, version, kind, block, before, after, time_ms, by_whom, station) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10)",
      change.person, change.program, version, change.kind, change.block, change.before, change.after,
      change.author.time_ms, change.author.name, change.author.station)
      .run();
}

std::vector<ProgramVersion> Database::versions(PersonId id, int program) {
  Query query(*statements_,
              "SELECT version, kind, block, by_whom, station, time_ms FROM program_change "
              "WHERE person_id = ?1 AND program = ?2 ORDER BY version",
              id, program);
  std::vector<ProgramVersion> found;
  while (query.next())
    found.push_back({query.small(0), query.text(1), query.small(2), {query.text(3), query.small(4), query.integer(5)}});
  return found;
}

std::optional<BlockTexts> Database::program_at(PersonId id, int program, int version, const Renumber& renumber) {
  const int wanted = version == 0 ? newest_version(*statements_, id, program) : version;
  if (!has_version(*statements_, id, program, wanted)) return std::nullopt;
  // From the last change that holds the whole program, or from the first of all.
  Query changes(*statements_,
                "SELECT kind, block, after FROM program_change WHERE person_id = ?1 AND program = ?2 "
                "AND version <= ?3 AND version >= (SELECT coalesce(max(version), 0) FROM program_change WHERE "
                "person_id = ?1 AND program = ?2 AND version <= ?3 AND kind IN ('replace', 'remove')) ORDER BY version",
                id, program, wanted);
  BlockTexts texts;
  while (changes.next()) redo(texts, changes.text(0), changes.small(1), changes.text(2), renumber);
  return texts;
}

}  // namespace cnclab::db
