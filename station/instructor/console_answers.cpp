// What the console says when a command was carried out: one sentence for each command, or the lines of its answer.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "instructor/console_model.hpp"
#include "instructor/item_text.hpp"

namespace cnclab::instructor {
namespace {

using station::Language;
using station::Text;
using R = v1::InstructorRequest;

std::string on_off(bool is_on, Language language) {
  return std::string((is_on ? Text{"ein", "on"} : Text{"aus", "off"}).in(language));
}

/// What a command was about: what the server says of it, else the station or the switch.
std::string subject_of(const R& request, const std::string& detail, Language language) {
  if (!detail.empty()) return detail;
  if (request.has_select()) return std::to_string(request.select().station());
  if (request.has_expel()) return std::to_string(request.expel().station());
  if (request.has_input()) return fmt::format("{} {}", request.input().input(), on_off(request.input().on(), language));
  if (request.has_remote())
    return fmt::format("{} {}", request.remote().station(), on_off(request.remote().on(), language));
  if (request.has_ram_fault())
    return fmt::format("{} {}", request.ram_fault().station(), on_off(request.ram_fault().on(), language));
  return {};
}

struct Done {
  R::WhatCase what;
  Text text;  ///< {}: its subject
};

constexpr std::array<Done, 30> kDone{{
    {R::kSelect,
     {"Platz {}: Steuerung angeboten; der Platz nimmt mit START an.",
      "Station {}: control offered; it is accepted there with START."}},
    {R::kRelease, {"Niemand hat die Steuerung.", "Nobody has control."}},
    {R::kHalt, {"MASCHINE HALT. c hebt ihn auf.", "MACHINE HALT. c clears it."}},
    {R::kClearHalt, {"Halt aufgehoben.", "Halt cleared."}},
    {R::kPowerOff, {"Antriebe stromlos. p schaltet ein.", "Drives off. p switches on."}},
    {R::kPowerOn, {"Antriebe eingeschaltet.", "Drives on."}},
    {R::kInput, {"Eingang {}.", "Input {}."}},
    {R::kRemote, {"REMOTE an Platz {}.", "REMOTE at station {}."}},
    {R::kRamFault, {"Speicherfehler an Platz {}.", "Memory fault at station {}."}},
    {R::kMachineData, {"Maschinendaten übernommen.", "Machine data taken over."}},
    {R::kTools, {"Werkzeugliste übernommen.", "Tool list taken over."}},
    {R::kWorkpiece, {"Werkstück übernommen.", "Workpiece taken over."}},
    {R::kMessage, {"Nachricht gesendet.", "Message sent."}},
    {R::kShow, {"Alle sehen dieses Bild. v beendet es.", "All see this screen. v ends it."}},
    {R::kGive, {"Tastatur zurückgegeben.", "Keyboard given back."}},
    {R::kLock, {"Tastatur gesperrt. l gibt sie frei.", "Keyboard locked. l unlocks it."}},
    {R::kUnlock, {"Tastatur frei.", "Keyboard unlocked."}},
    {R::kExpel, {"Platz {} ist abgemeldet.", "Station {} is logged out."}},
    {R::kStudentAdd, {"Angelegt: {}.", "Added: {}."}},
    {R::kStudentRemove, {"Entfernt: {}. student restore holt zurück.", "Removed: {}. student restore brings it back."}},
    {R::kStudentRestore, {"Zurückgeholt: {}.", "Brought back: {}."}},
    {R::kStudentRename, {"Heißt jetzt {}.", "Is called {} now."}},
    {R::kStudentSet, {"{}: gilt ab der nächsten Anmeldung.", "{}: holds from the next login on."}},
    {R::kImport, {"Angelegt, Personen: {}.", "Added, people: {}."}},
    {R::kExport, {"Geschrieben: {}", "Written: {}"}},
    {R::kRunTrace, {"Geschrieben: {}", "Written: {}"}},
    {R::kProgramSend, {"Gesendet, Empfänger: {}", "Sent, receivers: {}"}},
    {R::kProgramCollect, {"Eingesammelt, Dateien in {}", "Collected, files in {}"}},
    {R::kProgramRestore, {"Wieder gültig: {}", "Holds again: {}"}},
    {R::kBackup, {"Geschrieben: {}", "Written: {}"}},
}};

/// Texts that depend on more than the command's name.
Text special_text(const ConsoleModel& model, const R& request, const Text& usual) {
  if (request.has_halt() && model.overlay == Overlay::watching)  // c is another key there
    return {"MASCHINE HALT. In der Tafel hebt c ihn auf.", "MACHINE HALT. In the table c clears it."};
  if (request.has_show() && request.show().station() == 0)
    return {"Jeder Platz zeigt wieder sein eigenes Bild.", "Every station shows its own screen again."};
  if (request.has_student_remove() && request.student_remove().erase())
    return {"Endgültig gelöscht: {}.", "Deleted for good: {}."};
  return usual;
}

Message done_message(const ConsoleModel& model, const R& request, const std::string& detail) {
  const auto* const row = std::ranges::find(kDone, request.what_case(), &Done::what);
  const bool is_explained = request.has_clear_halt() && !detail.empty();  // there was none
  if (is_explained || (row == kDone.end() && !detail.empty())) return {.text = detail};
  const Text usual = row == kDone.end() ? Text{"Erledigt.", "Done."} : row->text;
  const Text text = special_text(model, request, usual);
  return {.text = fmt::format(fmt::runtime(text.in(model.language)), subject_of(request, detail, model.language)),
          .is_of_halt = request.has_halt()};
}

/// A line that is wider than the screen goes on in the next one.
void append_lines(const std::string& text, std::vector<std::string>& lines) {
  constexpr std::size_t kWidth = Screen::kColumns - 2;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::u32string rest = from_utf8(line);
    do {
      lines.push_back(to_utf8(rest.substr(0, kWidth)));
      rest.erase(0, kWidth);
    } while (!rest.empty());
  }
}

/// Holds at once, so that the same key pressed again means the opposite: the next status may be a moment away.
void note_lock(v1::Status& status, const R& request) {
  if (!request.has_lock() && !request.has_unlock()) return;
  const auto seat = request.has_lock() ? request.lock().station() : request.unlock().station();
  for (auto& entry : *status.mutable_stations())
    if (entry.station() == seat) entry.set_locked(request.has_lock());
}

}  // namespace

ConsoleModel with_answer(ConsoleModel model, const R& request, const v1::InstructorAnswer& answer) {
  if (!answer.error().empty()) {
    model.message = {.text = answer.error(), .is_error = true};
    return model;
  }
  const bool ends_watching = request.has_watch() && request.watch().station() == 0;
  if (ends_watching) return model;  // the table came back with the key
  if (request.has_watch() || request.has_take()) {
    model.overlay = Overlay::watching;
    model.watched.station =
        static_cast<int>(request.has_watch() ? request.watch().station() : request.take().station());
    model.watched.is_typing = request.has_take();
    return model;
  }
  if (model.status) note_lock(*model.status, request);
  const bool is_line = answer.items_size() == 1 && answer.items(0).has_done();
  if (answer.items().empty()) {
    model.message = {.text = std::string(Text{"Keine Einträge.", "No entries."}.in(model.language))};
  } else if (is_line) {
    model.message = done_message(model, request, answer.items(0).done().detail());
  } else {
    model.overlay = Overlay::page;
    model.page.clear();
    model.page_top = 0;
    for (const auto& item : answer.items()) append_lines(text_of(item), model.page);
  }
  return model;
}

}  // namespace cnclab::instructor
