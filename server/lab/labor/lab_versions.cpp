// Programs and machine data that change by other ways than the keys of their control: versions that come back, copies
// of the instructor's.
#include "lab/lab.hpp"
#include "lab/labor/labor_screen.hpp"
#include "lab/labor/program_versions.hpp"
#include "lab/stored_control.hpp"

namespace cnclab::lab {

void Lab::read_versions(const DeskPtr& desk, const Subject& of) {
  store_.run([id = desk->person.id, of](db::Database& database) { return versions_of(database, id, of); },
             [this, weak = std::weak_ptr(desk), of,
              alive = alive_](const std::expected<std::vector<LaborVersion>, db::StoreError>& versions) {
               const DeskPtr owner = weak.lock();
               if (!*alive || !owner || !owner->labor) return;
               if (!versions) return note(*owner, sentence_for(versions.error(), tongue_of(owner->person)));
               owner->labor->show_versions(of, *versions);
               owner->is_dirty = true;
             });
}

void Lab::restore_version(const DeskPtr& desk, const Subject& of, int version) {
  if (std::holds_alternative<MachineDataSet>(of) && desk->on_lab_machine)  // DEC-39
    return note(
        *desk, say(tongue_of(desk->person), "Maschinendaten bleiben, wie sie sind, solange die Maschine verbunden ist.",
                   "Machine data stay as they are while the machine is connected."));
  using Outcome = std::expected<std::optional<machine::MachineData>, Refusal>;
  store_.run(
      [id = desk->person.id, of, version, memory_bytes = configuration_.memory_bytes,
       author = db::Author{desk->person.name, desk->station, clock_.unix_ms()}](db::Database& database) -> Outcome {
        try {
          if (const auto* program = std::get_if<std::uint16_t>(&of)) {
            lab::restore_version(database, id, *program, version, memory_bytes, author);
            return std::nullopt;
          }
          return restore_machine_data_version(database, id, version, author);
        } catch (const Refusal& refusal) {
          return std::unexpected(refusal);
        }
      },
      [this, weak = std::weak_ptr(desk), of, version,
       alive = alive_](const std::expected<Outcome, db::StoreError>& result) {
        const DeskPtr owner = weak.lock();
        if (!*alive || !owner) return;
        const auto tongue = tongue_of(owner->person);
        if (!result) return note(*owner, sentence_for(result.error(), tongue_of(owner->person)));
        if (!*result) return note(*owner, result->error().in(tongue));
        journal_.write("restore", name_of(of, language::Tongue::english) + " version " + std::to_string(version),
                       owner->station, owner->person.name);
        note(*owner, name_of(of, tongue) + say(tongue, ": Version ", ": version ") + std::to_string(version) +
                         say(tongue, " gilt wieder.", " holds again."));
        if (const auto& data = **result)
          owner->control.replace_data(*data);
        else
          reload_programs(owner->person.id);
        owner->settle_machine_data();
      });
}

void Lab::reload_programs(db::PersonId person) {
  if (!seats_.of(person)) return;
  store_.run(
      [person](db::Database& database) { return database.programs(person); },
      [this, alive = alive_, person](const std::expected<std::vector<db::StoredProgram>, db::StoreError>& programs) {
        if (!*alive || !programs) return;
        const DeskPtr desk = seats_.of(person);
        if (!desk) return;
        desk->control.replace_memory(memory_of(*programs, configuration_.memory_bytes));
        desk->is_dirty = true;
      });
}

}  // namespace cnclab::lab
