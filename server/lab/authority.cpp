// The rules of control authority, and the table that says which rule holds in which phase.
#include "lab/authority.hpp"

#include <algorithm>

namespace cnclab::lab {

using language::Tongue;
using machine::StopCause;

namespace {

/// The reason of AUTH-004 why the selector may not move now. A program runs also while a dwell moves nothing.
Refuse busy(const MachineView& machine) {
  if (machine.run_active && !machine.manual_motion)
    return {"Auf der Maschine läuft noch ein Programm.", "A program is still running."};
  if (machine.moving) return {"Die Achsen bewegen sich noch.", "The axes are still moving."};
  return {"Die Spindel dreht noch.", "The spindle is still turning."};
}

Refuse nobody_at(int station) {
  const std::string number = std::to_string(station);
  return {"An Platz " + number + " ist niemand angemeldet.", "Nobody is logged in at station " + number + "."};
}

Refuse locked_at(int station) {
  const std::string number = std::to_string(station);
  return {"Die Tastatur von Platz " + number + " ist gesperrt.", "The keyboard of station " + number + " is locked."};
}

std::string at_station(const HaltPressed& press, Tongue tongue) {
  if (press.station == 0) return press.who;
  const char* place = tongue == Tongue::german ? "Platz " : "station ";
  return place + std::to_string(press.station) + ", " + press.who;
}

/// For the journal: what was done, and which instructor ordered it.
std::string by(const std::string& what, const std::string& who) {
  if (who.empty()) return what;
  return what.empty() ? who : what + " (" + who + ")";
}

}  // namespace

std::string Authority::halted_by(Tongue tongue) const {
  std::string all;
  for (const HaltPressed& press : halts_) all += (all.empty() ? "" : "; ") + at_station(press, tongue);
  return all;
}

bool Authority::holds_halt(db::PersonId person) const {
  return std::ranges::find(halts_, person, &HaltPressed::person) != halts_.end();
}

const Authority::Table& Authority::table() {
  using A = Authority;
  // Columns: LoggedIn, LoggedOut, Select, ReleaseIt, Accept, Decline, Heard, HaltPressed, HaltReleased, HaltCleared,
  //          PowerSwitched, Locked, Deprived, Polled
  static const Table kTable{{
      /* nobody   */
      {&A::note_login, &A::leave, &A::select, &A::release_nothing, &A::ignore, &A::ignore, &A::ignore, &A::halt,
       &A::release_halt, &A::clear_halt, &A::switch_power, &A::lock, &A::deprive, &A::ignore},
      /* offered  */
      {&A::note_login, &A::offer_withdrawn_by_leaving, &A::select, &A::withdraw_offer, &A::accept, &A::decline,
       &A::ignore, &A::halt, &A::release_halt, &A::clear_halt, &A::switch_power, &A::lock, &A::deprive,
       &A::expire_offer},
      /* granted  */
      {&A::note_login, &A::lease_lost_by_leaving, &A::select_another, &A::release_lease, &A::ignore, &A::ignore,
       &A::hear, &A::halt, &A::release_halt, &A::clear_halt, &A::switch_power, &A::lock, &A::deprive,
       &A::watch_silence},
      /* stopping */
      {&A::note_login, &A::leave, &A::select_next, &A::release_next, &A::ignore, &A::ignore, &A::ignore, &A::halt,
       &A::release_halt, &A::clear_halt, &A::switch_power, &A::lock, &A::deprive, &A::finish_stopping},
  }};
  return kTable;
}

Actions Authority::apply(const Event& event, const MachineView& machine, std::int64_t now_ns) {
  Actions actions;
  const Rule rule = table()[static_cast<std::size_t>(phase_)][event.index()];
  (this->*rule)(Step{event, machine, now_ns, actions});
  return actions;
}

// --- logins -----------------------------------------------------------------------------------------------------

void Authority::note_login(const Step& step) {
  const auto& in = std::get<LoggedIn>(step.event);
  const LoginId former = login_at(in.station);
  if (former != in.login) {
    take_away(former, "another login", step);
    locked_.erase(former);
  }
  logins_[in.station] = in.login;
}

void Authority::leave(const Step& step) {
  const LoginId gone = std::get<LoggedOut>(step.event).login;
  if (next_station_ != 0 && login_at(next_station_) == gone) next_station_ = 0;
  std::erase_if(logins_, [gone](const auto& seat) { return seat.second == gone; });
  locked_.erase(gone);
}

void Authority::offer_withdrawn_by_leaving(const Step& step) {
  const auto& out = std::get<LoggedOut>(step.event);
  leave(step);
  if (out.login != login_) return;
  journal(step, "offer_void", out.why, station_, Epoch{});
  to_nobody();
}

void Authority::lease_lost_by_leaving(const Step& step) {
  const auto& out = std::get<LoggedOut>(step.event);
  leave(step);
  if (out.login == login_) end_lease(StopCause::lease_ended, out.why, step);
}

// --- the selector -----------------------------------------------------------------------------------------------

void Authority::select(const Step& step) {
  const auto& wish = std::get<Select>(step.event);
  if (!refuses_station(wish.station, step)) offer(wish.station, login_at(wish.station), wish.who, step);
}

void Authority::select_another(const Step& step) {
  const auto& wish = std::get<Select>(step.event);
  const std::string number = std::to_string(wish.station);
  if (refuses_station(wish.station, step)) return;
  if (wish.station == station_) {
    step.actions.emplace_back(
        Refuse{"Platz " + number + " hat die Maschine schon.", "Station " + number + " has the machine already."});
  } else if (!wish.force && !step.machine.at_rest()) {
    const Refuse reason = busy(step.machine);
    journal(step, "refused", by(reason.english, wish.who), wish.station, newest_, wish.who);
    step.actions.emplace_back(reason);
  } else {
    end_lease(StopCause::lease_ended, wish.force ? "selected by force" : "selected", step, wish.who);
    next_station_ = wish.station;
    next_ordered_by_ = wish.who;
  }
}

void Authority::select_next(const Step& step) {
  const auto& wish = std::get<Select>(step.event);
  if (refuses_station(wish.station, step)) return;
  next_station_ = wish.station;
  next_ordered_by_ = wish.who;
}

void Authority::release_nothing(const Step&) {}

void Authority::withdraw_offer(const Step& step) {
  const std::string& who = std::get<ReleaseIt>(step.event).who;
  journal(step, "offer_void", by("released", who), station_, Epoch{}, who);
  to_nobody();
}

void Authority::release_lease(const Step& step) {
  const auto& wish = std::get<ReleaseIt>(step.event);
  if (!wish.force && !step.machine.at_rest()) {
    const Refuse reason = busy(step.machine);
    journal(step, "refused", by(reason.english, wish.who), station_, newest_, wish.who);
    step.actions.emplace_back(reason);
    return;
  }
  end_lease(StopCause::lease_ended, "released", step, wish.who);
}

void Authority::release_next(const Step&) { next_station_ = 0; }

void Authority::accept(const Step& step) {
  if (std::get<Accept>(step.event).login == login_) grant(step);
}

void Authority::decline(const Step& step) {
  if (std::get<Decline>(step.event).login != login_) return;
  journal(step, "declined", "", station_, Epoch{});
  to_nobody();
}

void Authority::expire_offer(const Step& step) {
  if (step.now_ns < offered_until_ns_) return;
  journal(step, "offer_void", "not accepted in time", station_, Epoch{});
  to_nobody();
}

// --- the lease --------------------------------------------------------------------------------------------------

void Authority::hear(const Step& step) {
  const auto& sign = std::get<Heard>(step.event);
  if (sign.login != login_) return;
  is_console_behind_ = sign.is_console_behind;
  if (sign.beat_sent_ns <= last_beat_ns_ || step.machine.lease_dead) return;
  last_beat_ns_ = std::min(sign.beat_sent_ns, step.now_ns);
  step.actions.emplace_back(Grant{newest_, expiry_ns(step.machine)});
}

void Authority::watch_silence(const Step& step) {
  if (step.now_ns <= expiry_ns(step.machine) && !step.machine.lease_dead) return;
  end_lease(StopCause::lease_expired, is_console_behind_ ? "console silent" : "station silent", step);
  if (is_console_behind_) step.actions.emplace_back(GiveKeysBack{login_});
}

void Authority::finish_stopping(const Step& step) {
  if (!step.machine.at_rest()) return;
  step.actions.emplace_back(Connect{login_, false});
  const int next = next_station_;
  const LoginId next_login = next == 0 ? kNoLogin : login_at(next);
  to_nobody();
  if (next_login != kNoLogin) offer(next, next_login, next_ordered_by_, step);
}

// --- halt and power ---------------------------------------------------------------------------------------------

void Authority::halt(const Step& step) {
  const auto& press = std::get<HaltPressed>(step.event);
  step.actions.emplace_back(Latch{true});  // the stop acts every time, whoever holds it already
  if (!holds_halt(press.person)) halts_.push_back(press);
  journal(step, "halt", at_station(press, Tongue::english), selected(), newest_);
}

void Authority::release_halt(const Step& step) {
  const db::PersonId person = std::get<HaltReleased>(step.event).person;
  if (halts_.empty()) return;
  const auto own = std::ranges::find(halts_, person, &HaltPressed::person);
  if (own == halts_.end()) {
    step.actions.emplace_back(
        Refuse{"MASCHINE HALT löst nur, wer gedrückt hat (" + halted_by(Tongue::german) + "), oder die Lehrkraft.",
               "MASCHINE HALT is released by " + halted_by(Tongue::english) + " or the instructor only."});
    return;
  }
  const std::string released = at_station(*own, Tongue::english);
  halts_.erase(own);
  const bool is_over = halts_.empty();
  journal(step, "halt_cleared", is_over ? released : released + "; still halted by " + halted_by(Tongue::english),
          selected(), newest_);
  if (is_over) step.actions.emplace_back(Latch{false});
}

void Authority::clear_halt(const Step& step) {
  if (halts_.empty()) return;
  const std::string& who = std::get<HaltCleared>(step.event).who;
  journal(step, "halt_cleared", by(halted_by(Tongue::english), who), selected(), newest_, who);
  halts_.clear();
  step.actions.emplace_back(Latch{false});
}

void Authority::switch_power(const Step& step) {
  const auto& order = std::get<PowerSwitched>(step.event);
  powered_ = order.on;
  step.actions.emplace_back(SwitchPower{powered_});
  journal(step, powered_ ? "power_on" : "power_off", order.who, selected(), newest_, order.who);
}

// --- keyboards --------------------------------------------------------------------------------------------------

void Authority::lock(const Step& step) {
  const auto& event = std::get<Locked>(step.event);
  if (!event.on) {
    locked_.erase(event.login);
    return;
  }
  locked_.insert(event.login);
  take_away(event.login, "locked", step);
}

void Authority::deprive(const Step& step) {
  const auto& event = std::get<Deprived>(step.event);
  take_away(event.login, event.why, step);
}

void Authority::take_away(LoginId login, const std::string& why, const Step& step) {
  if (login == kNoLogin) return;
  if (login == holder()) return end_lease(StopCause::lease_ended, why, step);
  if (next_station_ != 0 && login == login_at(next_station_)) next_station_ = 0;
  if (login != asked()) return;
  journal(step, "offer_void", why, station_, Epoch{});
  to_nobody();
}

void Authority::ignore(const Step&) {}

// --- parts of rules ---------------------------------------------------------------------------------------------

bool Authority::refuses_station(int station, const Step& step) const {
  const LoginId login = login_at(station);
  const bool is_locked = locked_.contains(login);
  if (login != kNoLogin && !is_locked) return false;
  const std::string& who = std::get<Select>(step.event).who;
  journal(step, "refused", by(is_locked ? "keyboard locked" : "nobody logged in", who), station, Epoch{}, who);
  step.actions.emplace_back(is_locked ? locked_at(station) : nobody_at(station));
  return true;
}

void Authority::offer(int station, LoginId login, const std::string& who, const Step& step) {
  if (phase_ == Phase::offered)
    journal(step, "offer_void", by(station == station_ ? "offered anew" : "another station selected", who), station_,
            Epoch{}, who);
  phase_ = Phase::offered;
  station_ = station;
  login_ = login;
  next_station_ = 0;
  offered_until_ns_ = step.now_ns + rules_.offer_ns;
  journal(step, "offer", who, station, Epoch{}, who);
  if (!rules_.accept_needed) grant(step);
}

void Authority::grant(const Step& step) {
  phase_ = Phase::granted;
  newest_ = Epoch{static_cast<std::uint64_t>(newest_) + 1};
  last_beat_ns_ = step.now_ns;
  is_console_behind_ = false;
  step.actions.emplace_back(Grant{newest_, expiry_ns(step.machine)});
  step.actions.emplace_back(Connect{login_, true});
  journal(step, "grant", "", station_, newest_);
}

void Authority::end_lease(StopCause cause, const std::string& why, const Step& step, const std::string& who) {
  step.actions.emplace_back(Revoke{cause});
  journal(step, "lease_ended", by(why, who), station_, newest_, who);
  phase_ = Phase::stopping;
}

void Authority::to_nobody() {
  phase_ = Phase::nobody;
  station_ = 0;
  login_ = kNoLogin;
  next_station_ = 0;
}

LoginId Authority::login_at(int station) const {
  const auto seat = logins_.find(station);
  return seat == logins_.end() ? kNoLogin : seat->second;
}

std::int64_t Authority::expiry_ns(const MachineView& machine) const {
  return last_beat_ns_ + (machine.manual_motion ? rules_.silence_manual_ns : rules_.silence_lease_ns);
}

void Authority::journal(const Step& step, std::string kind, std::string detail, int station, Epoch lease,
                        std::string who) const {
  const LoginId login = station != 0 && station == station_ ? login_ : login_at(station);
  step.actions.emplace_back(Journal{std::move(kind), std::move(detail), station, lease, login, std::move(who)});
}

}  // namespace cnclab::lab
