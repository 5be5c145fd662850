// Who may move the machine: one table-driven state machine without I/O, clock or threads (AUTH-001 to AUTH-016).
//
//   nobody ──select──▶ offered ──accept──▶ granted ──release, loss, force──▶ stopping ──standstill──▶ nobody
//      ▲                  │                                                     │
//      └─decline, time-out┘                         the next station waits here └──standstill──▶ offered
//
// Events go in with the time, actions come out; the lab carries them out in their order. Rules that hold at all times:
//  1. A lease exists only in `granted`, for exactly one login; its number is greater than all before.
//  2. The way from one lease to the next leads through `stopping` and the machine's standstill.
//  3. A halt is no phase of its own: it latches the channel, whatever the phase, until each of those who have pressed
//  it
//     has released it, or the instructor has cleared it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "db/types.hpp"
#include "language/units.hpp"
#include "machine/channel.hpp"

namespace cnclab::lab {

/// One login at one station over one connection; a new one for each (AUTH-002). 0 is none.
enum class LoginId : std::uint64_t {};
inline constexpr LoginId kNoLogin{0};

using machine::Epoch;

enum class Phase : std::uint8_t {
  nobody,    ///< selector 0
  offered,   ///< a station has been asked and has 30 s for START (AUTH-005)
  granted,   ///< a lease exists
  stopping,  ///< a lease has ended; the next phase comes after standstill
};
inline constexpr std::size_t kPhases = 4;

/// What the machine is doing, as far as authority cares (AUTH-004).
struct MachineView {
  bool moving = false;
  bool run_active = false;
  bool spindle_on = false;
  bool lease_dead = false;     ///< the tick itself has seen the newest lease expire: it never comes back
  bool manual_motion = false;  ///< axes follow the operator's hand: silence is judged more strictly (AUTH-007)
  [[nodiscard]] bool at_rest() const { return !moving && !run_active && !spindle_on; }
};

// Events
struct LoggedIn {
  int station = 0;
  LoginId login{};
};
struct LoggedOut {
  LoginId login{};
  std::string why;
};  ///< log-out, take-over, expulsion, closed connection
struct Select {
  int station = 0;
  bool force = false;
  std::string who{};  ///< the instructor, for the journal
};
struct ReleaseIt {
  bool force = false;
  std::string who{};
};
struct Accept {
  LoginId login{};
};  ///< START while offered
struct Decline {
  LoginId login{};
};  ///< STOP while offered
struct Heard {
  LoginId login{};
  std::int64_t beat_sent_ns = 0;
  bool is_console_behind = false;  ///< of station and console that types there, the console answered the older beat
};  ///< a sign of life and the beat that it answers
struct HaltPressed {
  db::PersonId person{};
  std::string who;
  int station = 0;  ///< where it was pressed; 0: at no station
};
struct HaltReleased {
  db::PersonId person{};
};  ///< who has pressed takes back the own press, at whatever station (AUTH-006)
struct HaltCleared {
  std::string who;
};  ///< the instructor takes back everybody's
struct PowerSwitched {
  bool on = false;
  std::string who{};
};
struct Locked {
  LoginId login{};
  bool on = false;
};  ///< the instructor locks or unlocks that login's keyboard: what it has of the machine ends first (AUTH-016)
struct Deprived {
  LoginId login{};
  std::string why;
};  ///< what that login has of the machine ends, the login stays: the console that typed for it is lost (AUTH-016)
struct Polled {};  ///< time passed
using Event = std::variant<LoggedIn, LoggedOut, Select, ReleaseIt, Accept, Decline, Heard, HaltPressed, HaltReleased,
                           HaltCleared, PowerSwitched, Locked, Deprived, Polled>;
inline constexpr std::size_t kEvents = std::variant_size_v<Event>;

// Actions
struct Grant {
  Epoch epoch{};
  std::int64_t expiry_ns = 0;
};  ///< to the channel: new or renewed
struct Revoke {
  machine::StopCause cause{};
};  ///< ramp stop, spindle off, run abandoned
struct Connect {
  LoginId login{};
  bool to_lab_machine = false;
};  ///< the control's connection changes now
/// MASCHINE HALT in the channel: stop and refuse every start command until it is off again (AUTH-006).
struct Latch {
  bool on = false;
};
struct SwitchPower {
  bool on = false;
};
/// The console that types for that login has fallen silent: the station has its keys back (AUTH-016).
struct GiveKeysBack {
  LoginId login{};
};
struct Refuse {
  std::string german, english;
};
struct Journal {
  std::string kind, detail;
  int station = 0;
  Epoch lease{};
  LoginId login{};    ///< whom it concerns, also where that login ends with this very step
  std::string who{};  ///< the instructor who ordered it, empty if nobody did
};  ///< AUTH-015
using Action = std::variant<Grant, Revoke, Connect, Latch, SwitchPower, GiveKeysBack, Refuse, Journal>;
using Actions = std::vector<Action>;

struct AuthorityRules {
  bool accept_needed = true;  ///< [lab] accept
  std::int64_t offer_ns = 30'000'000'000;
  std::int64_t silence_manual_ns = 300'000'000;  ///< AUTH-007
  std::int64_t silence_lease_ns = 1'000'000'000;
};

class Authority {
 public:
  /// newest    the greatest number that was ever granted (kept in the database; it only grows)
  Authority(const AuthorityRules& rules, Epoch newest) : rules_(rules), newest_(newest) {}

  /// One event at a time, with the machine as it is now.
  [[nodiscard]] Actions apply(const Event& event, const MachineView& machine, std::int64_t now_ns);

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] int selected() const { return phase_ == Phase::granted ? station_ : 0; }  ///< 0 nobody
  [[nodiscard]] int offered() const { return phase_ == Phase::offered ? station_ : 0; }   ///< 0 none
  [[nodiscard]] LoginId holder() const { return phase_ == Phase::granted ? login_ : kNoLogin; }
  [[nodiscard]] LoginId asked() const { return phase_ == Phase::offered ? login_ : kNoLogin; }
  [[nodiscard]] int next_station() const { return next_station_; }  ///< waits for standstill, 0 none
  [[nodiscard]] Epoch newest() const { return newest_; }
  [[nodiscard]] bool is_halted() const { return !halts_.empty(); }
  /// Who holds the halt, in the order of pressing; each person once, empty if nobody.
  [[nodiscard]] const std::vector<HaltPressed>& halts() const { return halts_; }
  [[nodiscard]] bool holds_halt(db::PersonId person) const;
  /// All of them in words: "Platz 2, otto", "station 2, otto; lehrer".
  [[nodiscard]] std::string halted_by(language::Tongue tongue) const;
  [[nodiscard]] bool is_powered() const { return powered_; }

 private:
  /// One event being handled.
  struct Step {
    const Event& event;
    const MachineView& machine;
    std::int64_t now_ns;
    Actions& actions;
  };
  using Rule = void (Authority::*)(const Step&);
  using Table = std::array<std::array<Rule, kEvents>, kPhases>;
  static const Table& table();

  // The rules, named by what happens; which holds when stands in the table alone.
  void note_login(const Step& step);
  void leave(const Step& step);
  void offer_withdrawn_by_leaving(const Step& step);
  void lease_lost_by_leaving(const Step& step);
  void select(const Step& step);
  void select_another(const Step& step);
  void select_next(const Step& step);
  void release_nothing(const Step& step);
  void withdraw_offer(const Step& step);
  void release_lease(const Step& step);
  void release_next(const Step& step);
  void accept(const Step& step);
  void decline(const Step& step);
  void hear(const Step& step);
  void halt(const Step& step);
  void release_halt(const Step& step);
  void clear_halt(const Step& step);
  void switch_power(const Step& step);
  void lock(const Step& step);
  void deprive(const Step& step);
  void expire_offer(const Step& step);
  void watch_silence(const Step& step);
  void finish_stopping(const Step& step);
  void ignore(const Step& step);

  void offer(int station, LoginId login, const std::string& who, const Step& step);
  void grant(const Step& step);
  void end_lease(machine::StopCause cause, const std::string& why, const Step& step, const std::string& who = {});
  void take_away(LoginId login, const std::string& why, const Step& step);
  /// Notes that the station cannot be selected: nobody is there, or the keyboard is locked.
  [[nodiscard]] bool refuses_station(int station, const Step& step) const;
  void to_nobody();
  [[nodiscard]] LoginId login_at(int station) const;
  [[nodiscard]] std::int64_t expiry_ns(const MachineView& machine) const;
  void journal(const Step& step, std::string kind, std::string detail, int station, Epoch lease,
               std::string who = {}) const;

  AuthorityRules rules_;
  Phase phase_ = Phase::nobody;
  int station_ = 0;  ///< asked, holding, or the one whose lease is ending
  LoginId login_ = kNoLogin;
  int next_station_ = 0;  ///< to be asked after standstill, 0 none
  std::string next_ordered_by_;
  Epoch newest_{};
  std::int64_t offered_until_ns_ = 0;
  std::int64_t last_beat_ns_ = 0;   ///< when the newest beat that the holder answered was sent
  bool is_console_behind_ = false;  ///< what keeps that beat from being newer is the console, not the station
  std::map<int, LoginId> logins_;
  std::set<LoginId> locked_;
  std::vector<HaltPressed> halts_;
  bool powered_ = true;
};

}  // namespace cnclab::lab
