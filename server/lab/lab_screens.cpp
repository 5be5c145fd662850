// Who sees what: screens are drawn when something changed, at most 20 times a second while axes move.
#include <utility>

#include "cnclab/v1/envelope.pb.h"
#include "lab/lab.hpp"
#include "lab/labor/labor_screen.hpp"

namespace cnclab::lab {

namespace {
constexpr std::int64_t kRefresh_ns = 50'000'000;
constexpr std::size_t kMostErrors = 99;
constexpr int kMiddleRow = 11;

/// What binds a computer to a seat is for the student who sits there, not for those who see the screen elsewhere.
void hide(Screen& screen, const std::string& token) {
  const std::u32string sought = from_utf8(token);
  for (int row = 0; row < Screen::kRows && !token.empty(); ++row) {
    const std::size_t column = from_utf8(screen.text(row)).find(sought);
    if (column != std::u32string::npos) screen.write(row, static_cast<int>(column), std::string(token.size(), '*'));
  }
}

}  // namespace

void Lab::draw_due(std::int64_t now_ns) {
  const int second = wall_clock(clock_.unix_ms()).second;
  const bool clock_moved = second != drawn_second_;
  drawn_second_ = second;
  for (const DeskPtr& desk : seats_.all()) {
    const bool is_busy = desk->control.is_busy();
    if (std::exchange(desk->was_busy, is_busy) && !is_busy) desk->is_dirty = true;  // the end shows at once
    const bool moving = is_busy && now_ns - desk->last_drawn_ns >= kRefresh_ns;
    if (desk->notice_until_ns != 0 && now_ns >= desk->notice_until_ns) note(*desk, "");
    // The end of a run shows at once, and with it the state number that the next START is valid for (AUTH-008).
    const bool was_started = desk->situation.started;
    note_situation(*desk);
    if (was_started != desk->situation.started) desk->is_dirty = true;
    // Lamps and counters follow the machine also where no key has changed them: the instructor's power-off, a switch.
    if (!is_busy && std::exchange(desk->indicated, desk->control.indication()) != desk->indicated)
      desk->is_dirty = true;
    if (desk->is_dirty || moving || clock_moved) draw(desk, now_ns);
  }
}

void Lab::draw(const DeskPtr& desk, std::int64_t now_ns) {
  desk->is_dirty = false;
  desk->last_drawn_ns = now_ns;
  note_situation(*desk);
  const panel::SideView side = side_view(*desk, now_ns);
  desk->view = View{desk->control.draw(now(*desk), side), desk->handled(), desk->state, desk->control.alarm_tone()};
  if (desk->labor)
    draw_labor_menu(desk->view.screen, *desk->labor, tongue_of(desk->person),
                    !side.bar.empty() || !side.notice.empty());
  present(desk, desk->control.take_beeps());
  if (desk->station == shown_station_)
    for (const DeskPtr& other : seats_.all())
      if (other != desk) present(other, 0);
  View seen = desk->view;
  seen.handled_key = 0;
  hide(seen.screen, desk->dnc_token);
  if (seats_.shown_at(desk->station) != desk) return;  // somebody else sits there by now
  for (const VisitPtr& visit : visits_) {
    if (visit->stage != Stage::looking_on && visit->stage != Stage::at_console) continue;
    if (visit->watched_station != desk->station) continue;
    visit->feed.offer(seen, 0);
    push(visit);
  }
}

void Lab::present(const DeskPtr& desk, int beeps) {
  const VisitPtr visit = desk->visit.lock();
  if (!visit) return;
  View view = desk->view;
  if (const DeskPtr shown = shown_to(*desk)) {
    view.screen = shown->view.screen;
    hide(view.screen, shown->dnc_token);
    const auto tongue = tongue_of(desk->person);
    const std::string who = say(tongue, " Platz ", " Station ") + std::to_string(shown->station) + ", " +
                            shown->person.name + say(tongue, ", wird allen gezeigt ", ", is shown to all ");
    view.screen.write(0, 2, who, Attribute::inverse);
    // The keys of the shown control act there alone: in their place stands what bars those of this station.
    constexpr int kNoticeRow = Screen::kRows - 2, kBarRow = Screen::kRows - 1;
    view.screen.set_row(kNoticeRow, Screen::Row{});
    view.screen.set_row(kBarRow, Screen::Row{});
    if (desk->notice_until_ns > clock_.monotonic_ns()) view.screen.write(kNoticeRow, 0, desk->notice);
    view.screen.write(kBarRow, 0, bar(*desk).value_or(""), Attribute::inverse);
  }
  visit->feed.offer(view, beeps);
  push(visit);
}

void Lab::push(const VisitPtr& visit) {
  auto update = visit->feed.next(visit->row_form);
  if (!update) return;
  v1::ServerMessage message;
  *message.mutable_screen() = std::move(*update);
  visit->peer->send(message);
}

void Lab::everybody_changed() {
  for (const DeskPtr& desk : seats_.all()) desk->is_dirty = true;
  show_empty_seats();
}

void Lab::show_empty_seats() {
  for (const VisitPtr& visit : visits_) {
    const bool looks = visit->stage == Stage::looking_on || visit->stage == Stage::at_console;
    if (!looks || visit->watched_station == 0) continue;
    if (seats_.shown_at(visit->watched_station)) continue;
    const auto tongue = tongue_of(visit->person);
    View empty;
    empty.screen.write(kMiddleRow, 2,
                       say(tongue, "An Platz ", "Nobody is logged in at station ") +
                           std::to_string(visit->watched_station) + say(tongue, " ist niemand angemeldet.", "."));
    visit->feed.offer(empty, 0);
    push(visit);
  }
}

panel::SideView Lab::side_view(const Desk& desk, std::int64_t now_ns) const {
  panel::SideView side;
  side.station = desk.station;
  side.user = desk.person.name;
  side.on_lab_machine = desk.on_lab_machine;
  side.controlling_station = authority_.selected();
  side.override_percent = desk.control.override_percent();
  side.halted_by = authority_.halted_by();
  side.halted_at = authority_.halted_at();
  side.meldung = seats_.hand_of(desk);
  side.bar = bar(desk).value_or("");
  side.keys_work = side.bar.empty() || !desk.taken_by.empty();
  if (desk.notice_until_ns > now_ns) side.notice = desk.notice;
  if (desk.login != kNoLogin && authority_.asked() == desk.login)
    side.notice = say(tongue_of(desk.person), "Die Lehrkraft bietet die Maschine an: START nimmt an, STOP lehnt ab.",
                      "The instructor offers the machine: START accepts, STOP declines.");
  return side;
}

panel::Now Lab::now(const Desk& desk) const { return control_time(clock_, configuration_.clock, desk.made_ns); }

void Lab::note_situation(Desk& desk) {
  const panel::Situation situation = desk.control.situation();
  if (situation == desk.situation && desk.on_lab_machine == desk.situation_on_lab) return;
  if (situation.alarm && !desk.situation.alarm) desk.errors_ns.push_back(clock_.monotonic_ns());
  if (desk.errors_ns.size() > kMostErrors) desk.errors_ns.pop_front();
  desk.situation = situation;
  desk.situation_on_lab = desk.on_lab_machine;
  ++desk.state;
}

}  // namespace cnclab::lab
