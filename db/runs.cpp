// Recorded runs and their traces (STO-007); the trace records are described in README.md.
#include "db/statements.hpp"

namespace cnclab::db {
namespace {

#define CNCLAB_RUN_COLUMNS                                                                                           \
  "SELECT id, person_id, station, machine, lease, started_ms, program, block, setup, seconds, ended, ticks, digest " \
  "FROM run "

RunRecord run_of(const Query& row) {
  RunRecord run{.id = row.integer(0),
                .person = PersonId{row.integer(1)},
                .station = row.small(2),
                .machine = row.text(3),
                .lease = static_cast<std::uint64_t>(row.integer(4)),
                .started_ms = row.integer(5),
                .program = row.small(6),
                .block = row.small(7),
                .setup = row.text(8),
                .seconds = std::nullopt,
                .ended = row.text(10),
                .ticks = row.integer(11),
                .digest = row.text(12)};
  if (!row.is_null(9)) run.seconds = row.real(9);
  return run;
}

}  // namespace

std::int64_t Database::begin_run(const RunRecord& run) {
  Query query(*statements_,
              "INSERT INTO run (person_id, station, machine, lease, started_ms, program, block, setup) "
              "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8) RETURNING id",
              run.person, run.station, run.machine, run.lease, run.started_ms, run.program, run.block, Blob{run.setup});
  query.next();
  return query.integer(0);
}

void Database::end_run(std::int64_t id, const RunRecord& run) {
  Query(*statements_, "UPDATE run SET seconds = ?2, ended = ?3, ticks = ?4, digest = ?5 WHERE id = ?1", id,
        run.seconds.value_or(0), run.ended, run.ticks, run.digest)
      .run();
}

void Database::add_run_events(std::int64_t run, const std::vector<RunEvent>& events) {
  transaction([&] {
    Query last(*statements_, "SELECT coalesce(max(number), 0) FROM run_event WHERE run_id = ?1", run);
    last.next();
    std::int64_t number = last.integer(0);
    for (const RunEvent& event : events)
      Query(*statements_, "INSERT INTO run_event (run_id, number, tick, kind, value) VALUES (?1, ?2, ?3, ?4, ?5)", run,
            ++number, event.tick, event.kind, event.value)
          .run();
  });
}

std::vector<RunEvent> Database::run_events(std::int64_t run) {
  Query query(*statements_, "SELECT tick, kind, value FROM run_event WHERE run_id = ?1 ORDER BY number", run);
  std::vector<RunEvent> found;
  while (query.next()) found.push_back({query.integer(0), query.text(1), query.real(2)});
  return found;
}

void Database::add_trace(std::int64_t run, std::int64_t first_tick, const std::string& data) {
  Query(*statements_, "INSERT INTO run_trace (run_id, first_tick, data) VALUES (?1, ?2, ?3)", run, first_tick,
        Blob{data})
      .run();
}

std::vector<RunRecord> Database::runs(PersonId id) {
  Query query(*statements_, CNCLAB_RUN_COLUMNS "WHERE person_id = ?1 ORDER BY id DESC", id);
  std::vector<RunRecord> found;
  while (query.next()) found.push_back(run_of(query));
  return found;
}

std::optional<RunRecord> Database::run(std::int64_t id) {
  Query query(*statements_, CNCLAB_RUN_COLUMNS "WHERE id = ?1", id);
  if (!query.next()) return std::nullopt;
  return run_of(query);
}

void Database::forget_old_runs(std::int64_t before_ms, int keep) {
  Query(*statements_,
        "DELETE FROM run WHERE started_ms < ?1 OR id IN (SELECT id FROM (SELECT id, row_number() OVER "
        "(PARTITION BY person_id ORDER BY id DESC) AS place FROM run) WHERE place > ?2)",
        before_ms, keep)
      .run();
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
