// Keyboards that are locked, taken over by a console, or idle while another station's screen is shown to all (INS-002).
//
// Whatever of this holds, STOP and MASCHINE HALT of the station act: `Lab::take_urgent` comes before all of it
// (AUTH-016).
#include <algorithm>

#include "lab/lab.hpp"

namespace cnclab::lab {

std::optional<std::string> Lab::bar(const Desk& desk) const {
  const auto tongue = tongue_of(desk.person);
  if (!desk.taken_by.empty())
    return desk.taken_by + say(tongue, " hat diese Tastatur übernommen: nur STOP und MASCHINE HALT wirken.",
                               " has taken this keyboard over: only STOP and MASCHINE HALT act.");
  if (desk.is_locked)
    return say(tongue, "Die Lehrkraft hat die Tastatur gesperrt: nur STOP und MASCHINE HALT wirken.",
               "The instructor has locked the keyboard: only STOP and MASCHINE HALT act.");
  if (shown_to(desk))
    return say(tongue, "Während ein Bild allen gezeigt wird, wirken hier nur STOP und MASCHINE HALT.",
               "While a screen is shown to all, only STOP and MASCHINE HALT act here.");
  return std::nullopt;
}

void Lab::set_locked(const DeskPtr& desk, bool on) {
  if (on)
    locked_.insert(desk->person.id);
  else
    locked_.erase(desk->person.id);
  if (desk->login != kNoLogin) static_cast<void>(decide(Locked{desk->login, on}, configuration_.tongue));
  desk->is_locked = on;
  if (on) desk->waiting.clear();
  desk->is_dirty = true;
}

void Lab::take_keyboard(const VisitPtr& console, const DeskPtr& desk) {
  if (const DeskPtr former = console->keyboard.lock(); former && former != desk) give_back(former);
  if (const VisitPtr other = desk->taker.lock()) other->keyboard.reset();
  console->keyboard = desk;
  desk->taker = console;
  desk->taken_by = console->person.name;
  desk->console_beat_ns = clock_.monotonic_ns();
  desk->waiting.clear();
  desk->is_dirty = true;
  send_beat(console);
}

void Lab::give_back(const DeskPtr& desk) {
  if (const VisitPtr console = desk->taker.lock()) console->keyboard.reset();
  desk->taker.reset();
  desk->taken_by.clear();
  desk->ignore_start_until_release = false;
  desk->is_dirty = true;
}

void Lab::let_go_of_keyboard(const VisitPtr& console) {
  const DeskPtr desk = console->keyboard.lock();
  console->keyboard.reset();
  if (!desk) return;
  const bool controls = desk->login != kNoLogin && desk->login == authority_.holder();
  if (!controls) return;  // still taken: the instructor's next console goes on, or gives it back
  static_cast<void>(decide(Deprived{desk->login, "console lost"}, configuration_.tongue));
  give_back_from_lost_console(desk);
}

void Lab::give_back_from_lost_console(const DeskPtr& desk) {
  journal_.write("keyboard_given", "console lost", desk->station, desk->person.name);
  give_back(desk);
  note(*desk, say(tongue_of(desk->person), "Die Konsole ist fort: die Maschine hält, die Tastatur ist wieder frei.",
                  "The console is gone: the machine stops, the keyboard is yours again."));
}

void Lab::show_to_all(int station) {
  shown_station_ = station;
  everybody_changed();
}

Lab::DeskPtr Lab::shown_to(const Desk& desk) const {
  if (shown_station_ == 0 || desk.station == shown_station_) return nullptr;
  // Whoever has the machine, or is asked to take it, must see the own screen (AUTH-016).
  const bool has_machine =
      desk.on_lab_machine ||
      (desk.login != kNoLogin && (desk.login == authority_.holder() || desk.login == authority_.asked()));
  return has_machine ? nullptr : seats_.at(shown_station_);
}

Lab::DeskPtr Lab::typed_at(const Visit& visit) const { return visit.desk ? visit.desk : visit.keyboard.lock(); }

}  // namespace cnclab::lab
