// Recorded runs and their traces (STO-007); the trace records are described in README.md.
#include "db/statements.hpp"

namespace cnclab::db {

std::int64_t Database::begin_run(const RunRecord& run) {
  Query query(*statements_,
              "INSERT INTO run (person_id, station, machine, lease, started_ms, program, block, setup) "
              "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8) RETURNING id",
              run.person, run.station, run.machine, run.lease, run.started_ms, run.program, run.block, Blob{run.setup});
  query.next();
  return query.integer(0);
}

void Database::end_run(std::int64_t id, double seconds, const std::string& ended) {
  Query(*statements_, "UPDATE run SET seconds = ?2, ended = ?3 WHERE id = ?1", id, seconds, ended).run();
}

void Database::add_trace(std::int64_t run, std::int64_t first_tick, const std::string& data) {
  Query(*statements_, "INSERT INTO run_trace (run_id, first_tick, data) VALUES (?1, ?2, ?3)", run, first_tick,
        Blob{data})
      .run();
}

std::vector<RunRecord> Database::runs(PersonId id) {
  Query query(*statements_,
              "SELECT id, station, machine, lease, started_ms, program, block, setup, seconds, ended FROM run "
              "WHERE person_id = ?1 ORDER BY id DESC",
              id);
  std::vector<RunRecord> found;
  while (query.next()) {
    RunRecord& run = found.emplace_back(RunRecord{.id = query.integer(0),
                                                  .person = id,
                                                  .station = query.small(1),
                                                  .machine = query.text(2),
                                                  .lease = static_cast<std::uint64_t>(query.integer(3)),
                                                  .started_ms = query.integer(4),
                                                  .program = query.small(5),
                                                  .block = query.small(6),
                                                  .setup = query.text(7),
                                                  .seconds = std::nullopt,
                                                  .ended = query.text(9)});
    if (!query.is_null(8)) run.seconds = query.real(8);
  }
  return found;
}

std::string Database::trace(std::int64_t run) {
  Query query(*statements_, "SELECT data FROM run_trace WHERE run_id = ?1 ORDER BY first_tick", run);
  std::string joined;
  while (query.next()) joined += query.text(0);
  return joined;
}

void Database::forget_old_traces(int keep) {
  Query(*statements_,
        "DELETE FROM run_trace WHERE run_id NOT IN (SELECT run_id FROM run_trace GROUP BY run_id ORDER BY run_id DESC "
        "LIMIT ?1)",
        keep)
      .run();
}

}  // namespace cnclab::db
