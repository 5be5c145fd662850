// Who may move the machine: one table-driven state machine without I/O, clock or threads (AUTH-001 to AUTH-016).
//
//   nobody ──select──▶ offered ──accept──▶ granted ──release, loss, halt …──▶ stopping ──standstill──▶ nobody
//
// Events go in with the time, actions come out; the lab carries them out. docs/architecture.md draws the whole table.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "machine/channel.hpp"

namespace cnclab::lab {

/// One login at one station over one connection; a new one for each (AUTH-002). 0 is none.
enum class LoginId : std::uint64_t {};

using machine::Epoch;

enum class Phase : std::uint8_t {
  nobody,    ///< selector 0
  offered,   ///< a station has been asked and has 30 s for START (AUTH-005)
  granted,   ///< a lease exists
  stopping,  ///< a lease has ended or is taken; the next phase comes after standstill
};

/// What the machine is doing, as far as authority cares (AUTH-004).
struct MachineView {
  bool moving = false;
  bool run_active = false;
  bool spindle_on = false;
  bool powered = true;
  [[nodiscard]] bool at_rest() const { return !moving && !run_active && !spindle_on; }
};

// Events
struct LoggedIn { int station = 0; LoginId login{}; };
struct LoggedOut { LoginId login{}; std::string why; };     ///< log-out, take-over, expulsion, closed connection
struct Select { int station = 0; bool force = false; };
struct ReleaseIt { bool force = false; };
struct Accept { LoginId login{}; };                          ///< START while offered
struct Decline { LoginId login{}; };                         ///< STOP while offered
struct Heard { LoginId login{}; std::int64_t beat_sent_ns = 0; };  ///< a key or sign of life with the beat it answers
struct HaltPressed { LoginId login{}; std::string who; bool by_instructor = false; };
struct HaltCleared { LoginId login{}; bool by_instructor = false; };
struct PowerSwitched { bool on = false; };
struct Polled { MachineView machine; bool manual_motion = false; };  ///< the time passed; the machine as it is
using Event = std::variant<LoggedIn, LoggedOut, Select, ReleaseIt, Accept, Decline, Heard, HaltPressed, HaltCleared,
                           PowerSwitched, Polled>;

// Actions
struct Grant { int station = 0; LoginId login{}; Epoch epoch{}; std::int64_t expiry_ns = 0; };
struct Renew { Epoch epoch{}; std::int64_t expiry_ns = 0; };
struct Revoke { machine::StopCause cause{}; };               ///< ramp stop, spindle off, run abandoned
struct Connect { LoginId login{}; bool to_lab_machine = false; };  ///< the control's connection changes now
struct StopMachine { machine::StopCause cause{}; };          ///< also without a lease (halt)
struct SwitchPower { bool on = false; };
struct Refuse { std::string reason_de, reason_en; };
struct Journal { std::string kind, detail; int station = 0; Epoch lease{}; };  ///< AUTH-015
using Action = std::variant<Grant, Renew, Revoke, Connect, StopMachine, SwitchPower, Refuse, Journal>;

struct AuthorityRules {
  bool accept_needed = true;                             ///< [lab] accept
  std::int64_t offer_ns = 30'000'000'000;
  std::int64_t silence_manual_ns = 300'000'000;          ///< AUTH-007
  std::int64_t silence_lease_ns = 1'000'000'000;
};

class Authority {
 public:
  /// epoch    the greatest that was ever granted (kept in the database; it only grows)
  Authority(const AuthorityRules& rules, Epoch newest);

  /// One event at a time; the actions are to be carried out in their order.
  [[nodiscard]] std::vector<Action> apply(const Event& event, std::int64_t now_ns);

  [[nodiscard]] Phase phase() const;
  [[nodiscard]] int selected() const;      ///< station with a lease, 0 nobody
  [[nodiscard]] int offered() const;       ///< station that was asked, 0 none
  [[nodiscard]] LoginId holder() const;
  [[nodiscard]] LoginId asked() const;
  [[nodiscard]] Epoch newest() const;
  [[nodiscard]] bool is_halted() const;
  [[nodiscard]] const std::string& halted_by() const;

 private:
  AuthorityRules rules_;
  Epoch newest_;
};

}  // namespace cnclab::lab
