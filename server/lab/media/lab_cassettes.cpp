// Cassettes between database and recorder: put in at login, saved when the motor stops, on ejecting, and at latest with
// the control's state (DEC-33).
//
//   store ── list, tape ──▶ desk ──▶ Control's recorder ── is_changed ──▶ tape ──▶ store
#include <spdlog/spdlog.h>

#include <algorithm>

#include "lab/lab.hpp"

namespace cnclab::lab {

void Lab::take_up_cassettes(const DeskPtr& desk, StoredCassettes stored) {
  CassetteShelf& shelf = desk->cassettes;
  shelf.list = std::move(stored.list);
  const auto found = std::ranges::find(shelf.list, true, &db::StoredCassette::is_inserted);
  if (found == shelf.list.end() || !stored.tape) return;
  put_into_recorder(desk, found->id, *stored.tape);
}

void Lab::put_into_recorder(const DeskPtr& desk, db::CassetteId id, const std::string& tape) {
  auto cassette = transfer::Cassette::deserialize(tape);
  if (!cassette) {
    spdlog::error("{}: cassette: {}", desk->person.name, cassette.error());
    return note(*desk, say(tongue_of(desk->person), "Die Kassette ist beschädigt, der Rekorder nimmt sie nicht an.",
                           "The cassette is damaged, the recorder does not take it."));
  }
  desk->control.insert_cassette(std::move(*cassette), now(*desk));
  desk->cassettes.inserted = id;
  desk->cassettes.is_changed = false;
  desk->is_dirty = true;
}

void Lab::watch_recorder(const DeskPtr& desk) {
  CassetteShelf& shelf = desk->cassettes;
  if (!shelf.inserted) return;
  const bool runs = desk->control.recorder_runs();
  if (runs) shelf.is_changed = true;
  if (runs || shelf.has_run) cassettes_changed(desk);  // the counter turns
  if (shelf.has_run && !runs) save_cassette(desk);
  shelf.has_run = runs;
}

void Lab::save_cassette(const DeskPtr& desk) {
  CassetteShelf& shelf = desk->cassettes;
  if (!shelf.inserted || !shelf.is_changed) return;
  const auto cassette = desk->control.cassette();
  if (!cassette) return;
  shelf.is_changed = false;
  store_.run([person = desk->person.id, id = *shelf.inserted, tape = cassette->serialized(),
              time = clock_.unix_ms()](db::Database& database) { database.put_tape(person, id, tape, time); },
             [this, alive = alive_, weak = std::weak_ptr(desk)](const std::expected<void, db::StoreError>& result) {
               if (result) return;
               spdlog::error("cassette not stored: {}", result.error().detail);
               const DeskPtr owner = weak.lock();
               if (!*alive || !owner) return;
               owner->cassettes.is_changed = true;  // with the next state, when there may be room again
               const auto tongue = tongue_of(owner->person);
               note(*owner, say(tongue, "Die Kassette ist nicht gesichert: ", "The cassette is not saved: ") +
                                sentence_for(result.error(), tongue));
             });
}

/// Runs a change of the list and reads the list anew; what it refuses stands in row 18.
void Lab::change_cassettes(const DeskPtr& desk, std::function<bool(db::Database&)> change, const std::string& refusal) {
  using Answer = std::pair<bool, std::vector<db::StoredCassette>>;
  store_.run(
      [person = desk->person.id, change = std::move(change)](db::Database& database) {
        const bool is_done = change(database);
        return Answer{is_done, database.cassettes(person)};
      },
      [this, alive = alive_, weak = std::weak_ptr(desk), refusal](const std::expected<Answer, db::StoreError>& answer) {
        const DeskPtr owner = weak.lock();
        if (!*alive || !owner) return;
        if (!answer) return note(*owner, sentence_for(answer.error(), tongue_of(owner->person)));
        if (!answer->first) note(*owner, refusal);
        owner->cassettes.list = answer->second;
        cassettes_changed(owner);
      });
}

/// What lies in the recorder is saved and taken out, `next` is put in. All of it is done, or nothing.
void Lab::change_recorder(const DeskPtr& desk, std::optional<db::CassetteId> next,
                          std::optional<db::CassetteId> removed) {
  CassetteShelf& shelf = desk->cassettes;
  if (desk->control.recorder_runs())
    return note(*desk,
                say(tongue_of(desk->person), "Der Rekorder läuft: erst STOP.", "The recorder runs: STOP first."));
  const auto former = desk->control.cassette();
  store_.run(
      [person = desk->person.id, former_id = shelf.inserted, former = former ? former->serialized() : std::string(),
       next, removed, time = clock_.unix_ms()](db::Database& database) {
        if (former_id && !former.empty()) database.put_tape(person, *former_id, former, time);
        if (removed) database.remove_cassette(person, *removed);
        database.insert_cassette(person, next);
        return StoredCassettes{database.cassettes(person), next ? database.tape(person, *next) : std::nullopt};
      },
      [this, alive = alive_, weak = std::weak_ptr(desk)](const std::expected<StoredCassettes, db::StoreError>& stored) {
        const DeskPtr owner = weak.lock();
        if (!*alive || !owner) return;
        if (!stored) return note(*owner, sentence_for(stored.error(), tongue_of(owner->person)));
        owner->control.press_recorder(panel::Control::RecorderKey::stop, now(*owner));
        owner->control.eject_cassette();
        owner->cassettes.inserted.reset();
        take_up_cassettes(owner, *stored);
        cassettes_changed(owner);
      });
}

void Lab::wish_cassette(const DeskPtr& desk, const CassetteWish& wish) {
  const auto person = desk->person.id;
  const auto tongue = tongue_of(desk->person);
  const std::string taken = say(tongue, "Diesen Namen hat schon eine Kassette.", "A cassette has that name already.");
  if (std::holds_alternative<NewCassette>(wish))
    return change_cassettes(
        desk,
        [person, name = free_cassette_name(desk->cassettes.list), time = clock_.unix_ms()](db::Database& database) {
          return database.add_cassette(person, name, transfer::Cassette().serialized(), time).has_value();
        },
        say(tongue, "Zehn Kassetten sind da: erst eine löschen.", "There are ten cassettes: remove one first."));
  if (const auto* rename = std::get_if<RenameCassette>(&wish))
    return change_cassettes(
        desk,
        [person, id = rename->id, name = cassette_name(rename->number)](db::Database& database) {
          return database.rename_cassette(person, id, name);
        },
        taken);
  if (const auto* key = std::get_if<PressRecorder>(&wish)) {
    desk->control.press_recorder(key->key, now(*desk));
    desk->cassettes.is_changed = true;
    return cassettes_changed(desk);
  }
  if (const auto* insert = std::get_if<InsertCassette>(&wish)) return change_recorder(desk, insert->id, std::nullopt);
  if (std::holds_alternative<EjectCassette>(wish)) return change_recorder(desk, std::nullopt, std::nullopt);
  const db::CassetteId id = std::get<RemoveCassette>(wish).id;
  if (desk->cassettes.inserted == id) return change_recorder(desk, std::nullopt, id);
  change_cassettes(desk,
                   [person, id](db::Database& database) {
                     database.remove_cassette(person, id);
                     return true;
                   },
                   {});
}

void Lab::act_on_cassette(const DeskPtr& desk, const ActOnCassette& order) {
  using Key = panel::Control::RecorderKey;
  const auto& list = desk->cassettes.list;
  if (order.index >= list.size()) return;
  const db::CassetteId id = list[order.index].id;
  switch (order.act) {
    case CassetteAct::insert:
      return wish_cassette(desk, InsertCassette{id});
    case CassetteAct::eject:
      return wish_cassette(desk, EjectCassette{});
    case CassetteAct::rewind:
      return wish_cassette(desk, PressRecorder{Key::rewind});
    case CassetteAct::wind_on:
      return wish_cassette(desk, PressRecorder{Key::wind_on});
    case CassetteAct::stop:
      return wish_cassette(desk, PressRecorder{Key::stop});
    case CassetteAct::zero_counter:
      return wish_cassette(desk, PressRecorder{Key::zero_counter});
    case CassetteAct::rename:
      return wish_cassette(desk, RenameCassette{id, order.number});
    case CassetteAct::remove:
      return wish_cassette(desk, RemoveCassette{id});
  }
}

std::vector<std::string> Lab::cassette_lines(const Desk& desk) const {
  std::vector<std::string> lines;
  const auto deck = desk.control.cassette();
  for (const db::StoredCassette& cassette : desk.cassettes.list)
    lines.push_back(cassette_line(cassette, deck, tongue_of(desk.person)));
  return lines;
}

void Lab::show_cassette(const DeskPtr& desk, std::size_t index) {
  const auto& list = desk->cassettes.list;
  if (!desk->labor || index >= list.size()) return;
  desk->labor->show_cassette(index, cassette_line(list[index], desk->control.cassette(), tongue_of(desk->person)),
                             list[index].is_inserted && desk->cassettes.inserted == list[index].id);
  desk->is_dirty = true;
}

void Lab::cassettes_changed(const DeskPtr& desk) {
  desk->is_dirty = true;
  if (!desk->labor) return;
  if (const auto* page = std::get_if<CassettePage>(&desk->labor->page())) return show_cassette(desk, page->index);
  const auto* list = std::get_if<ListPage>(&desk->labor->page());
  if (list != nullptr && list->list == LaborList::cassettes)
    desk->labor->show_list(LaborList::cassettes, cassette_lines(*desk));
}

}  // namespace cnclab::lab
