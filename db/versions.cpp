// The versions of a program: written with each change, read back by undoing from the newest (STO-005).
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

BlockTexts newest_texts(Connection& connection, PersonId id, int program) {
  Query query(connection, "SELECT number, text FROM block WHERE person_id = ?1 AND program = ?2 ORDER BY number", id,
              program);
  BlockTexts texts;
  while (query.next()) texts.emplace_hint(texts.end(), query.small(0), query.text(1));
  return texts;
}

// Turns the state after a change into the state before it.
void undo(BlockTexts& texts, const std::string& kind, int block, std::string before) {
  if (kind == "replace" || kind == "remove") {
    texts = read_list(before);
  } else if (kind == "insert") {
    texts.erase(texts.lower_bound(block), texts.end());
    texts.merge(read_list(before));
  } else if (before.empty()) {
    texts.erase(block);
  } else {
    texts[block] = std::move(before);
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

std::optional<std::vector<std::string>> Database::program_at(PersonId id, int program, int version) {
  const int wanted = version == 0 ? newest_version(*statements_, id, program) : version;
  if (!has_version(*statements_, id, program, wanted)) return std::nullopt;
  BlockTexts texts = newest_texts(*statements_, id, program);
  Query later(*statements_,
              "SELECT kind, block, before FROM program_change WHERE person_id = ?1 AND program = ?2 AND version > ?3 "
              "ORDER BY version DESC",
              id, program, wanted);
  while (later.next()) undo(texts, later.text(0), later.small(1), later.text(2));
  std::vector<std::string> blocks;
  for (auto& [number, text] : texts) blocks.push_back(std::move(text));
  return blocks;
}

}  // namespace cnclab::db
