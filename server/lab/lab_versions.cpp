// Programs that change by other ways than the keys of their control: restored versions, copies of the instructor's.
#include "lab/lab.hpp"
#include "lab/program_versions.hpp"
#include "lab/stored_control.hpp"

namespace cnclab::lab {

void Lab::restore_version(const DeskPtr& desk, std::uint16_t program, int version) {
  using Outcome = std::expected<void, Refusal>;
  store_.run(
      [id = desk->person.id, program, version, memory_bytes = configuration_.memory_bytes,
       author = db::Author{desk->person.name, desk->station, clock_.unix_ms()}](db::Database& database) -> Outcome {
        try {
          lab::restore_version(database, id, program, version, memory_bytes, author);
          return {};
        } catch (const Refusal& refusal) {
          return std::unexpected(refusal);
        }
      },
      [this, weak = std::weak_ptr(desk), alive = alive_](const std::expected<Outcome, db::StoreError>& result) {
        const DeskPtr owner = weak.lock();
        if (!*alive || !owner) return;
        const auto tongue = tongue_of(owner->person);
        if (!result) return note(*owner, sentence_for(result.error(), tongue_of(owner->person)));
        if (!*result) return note(*owner, result->error().in(tongue));
        note(*owner, say(tongue, "Die Version ist wieder die neueste.", "That version is the newest again."));
        reload_programs(owner->person.id);
      });
}

void Lab::reload_programs(db::PersonId person) {
  if (!desk_of(person)) return;
  store_.run(
      [person](db::Database& database) { return database.programs(person); },
      [this, alive = alive_, person](const std::expected<std::vector<db::StoredProgram>, db::StoreError>& programs) {
        if (!*alive || !programs) return;
        const DeskPtr desk = desk_of(person);
        if (!desk) return;
        desk->control.replace_memory(memory_of(*programs, configuration_.memory_bytes));
        desk->is_dirty = true;
      });
}

}  // namespace cnclab::lab
