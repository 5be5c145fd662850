// The lab: connections, seats, controls, the selector and the machine, on one thread.
//
//   net ── welcome, receive, lost ──▶ Lab ──▶ Desk (Control) ──▶ training channel
//                                      │ └──▶ Authority ──▶ LabMachine (channel)
//                                      └──▶ Store, PasswordWorker (their answers come back through `post`)
//
// Everything here runs on the lab thread; nothing waits. `poll` is called every 10 ms.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "lab/authority.hpp"
#include "lab/backup_copy.hpp"
#include "lab/beats.hpp"
#include "lab/clock.hpp"
#include "lab/configuration.hpp"
#include "lab/journal_book.hpp"
#include "lab/lab_machine.hpp"
#include "lab/login_guard.hpp"
#include "lab/media/cassettes.hpp"
#include "lab/media/serial_lines.hpp"
#include "lab/passwords.hpp"
#include "lab/seats.hpp"
#include "lab/sentences.hpp"
#include "lab/visit.hpp"
#include "lab/worker_thread.hpp"

namespace cnclab::v1 {
class ClientMessage;
class InstructorRequest;
class InstructorAnswer;
class Status;
}  // namespace cnclab::v1

namespace cnclab::lab {

/// What a lab takes over from the database when it starts.
struct Inheritance {
  Epoch newest_epoch{};  ///< AUTH-002: numbers only grow, over restarts too
  MachineInheritance machine;
  std::filesystem::path database;  ///< the file, for backups while the lab works; empty: none are made
};

class Lab {
 public:
  /// store, ticks   outlive the lab; post runs a function on the lab thread
  Lab(Configuration configuration, db::Store& store, machine::TickThread& ticks, db::Post post, Clock clock,
      const Inheritance& inheritance);
  ~Lab();
  Lab(const Lab&) = delete;
  Lab& operator=(const Lab&) = delete;

  /// A connection was made.
  [[nodiscard]] std::shared_ptr<Visit> welcome(std::shared_ptr<Peer> peer);
  /// A message came. One that is wrong in form or order hangs up (SEC-006).
  void receive(const std::shared_ptr<Visit>& visit, const v1::ClientMessage& message);
  /// The connection is closed.
  void lost(const std::shared_ptr<Visit>& visit);

  /// For those who carry the bytes of serial lines.
  [[nodiscard]] SerialLines& lines() { return lines_; }

  /// The time passed.
  void poll();
  /// The lease ends and the machine comes to rest on the ramp; `at_rest` tells when.
  void release_machine();
  /// States saved, farewell to everybody (exit code 10).
  void close();
  [[nodiscard]] bool at_rest() const;
  /// Counters as Prometheus text, names cnclab_….
  [[nodiscard]] std::string metrics() const;

 private:
  friend class Console;
  using VisitPtr = std::shared_ptr<Visit>;
  using DeskPtr = std::shared_ptr<Desk>;

  // lab.cpp
  void hang_up(const VisitPtr& visit, const std::string& reason);
  void farewell(const VisitPtr& visit, int exit_code, const std::string& text);
  void watch_connections(std::int64_t now_ns);
  void send_beats(std::int64_t now_ns);
  /// The newest beat at once, to who may press START next: those without the machine hear one in a second only, and a
  /// START in answer to that one would be too old (AUTH-008).
  void send_beat(const VisitPtr& visit);
  /// Forgets what is older than the configuration keeps it: journal, people long off the roster.
  void keep_house(std::int64_t now_ns);
  [[nodiscard]] language::Tongue tongue_of(const db::Person& person) const;
  /// Until the login is done a visit speaks the lab's language, as the form does at the station.
  [[nodiscard]] language::Tongue tongue_with(const Visit& visit) const;

  // lab_login.cpp
  void greet(const VisitPtr& visit, const v1::ClientMessage& message);
  void log_in(const VisitPtr& visit, const v1::Login& login);
  void password_checked(const VisitPtr& visit, const std::optional<db::Person>& person, bool fits);
  void admit(const VisitPtr& visit);
  void admit_station(const VisitPtr& visit);
  void admit_elsewhere(const VisitPtr& visit, const DeskPtr& mine, int station);
  void load_desk(const VisitPtr& visit);
  void restore_machine_data(const DeskPtr& desk);  ///< ERR-014
  void resume(const VisitPtr& visit, const v1::Resume& resume);
  void sit_down(const VisitPtr& visit, const DeskPtr& desk, int station);
  void refuse(const VisitPtr& visit, v1::LoginResult result, const std::string& text);
  void vacate(const VisitPtr& visit, const std::string& why);   ///< the desk stays for a while
  void log_out(const VisitPtr& visit, const std::string& why);  ///< the desk goes
  void dismiss(const DeskPtr& desk);
  void expel(const DeskPtr& desk);
  /// Who looks on at their own control saw it at the seat that it leaves now.
  void end_looking_on(const DeskPtr& desk);

  // lab_keys.cpp
  void take_key(const VisitPtr& visit, const v1::KeyEvent& event);
  void take_potentiometer(const VisitPtr& visit, const v1::Potentiometer& turn);
  void take_input(const VisitPtr& visit, Input input);
  /// STOP and MASCHINE HALT act at once, whatever else is held and whatever waits.
  [[nodiscard]] bool take_urgent(const VisitPtr& visit, const DeskPtr& desk, const Input& input);
  void stop_pressed(const DeskPtr& desk, std::uint64_t number);
  void halt_key_pressed(const VisitPtr& visit, const DeskPtr& desk);
  void pump(const DeskPtr& desk);
  void act(const DeskPtr& desk, const Input& input);
  void start_pressed(const DeskPtr& desk, const Input& input);
  void outcome(const DeskPtr& desk, panel::Outcome outcome, std::uint64_t number);
  /// The machine has taken what a key ordered: the key is handled, and those that waited behind it follow.
  void heed_switched(const DeskPtr& desk);
  void store(const DeskPtr& desk, panel::StoreRequest request, std::uint64_t number, const std::string& author);
  [[nodiscard]] bool is_fresh(const Desk& desk, const Input& input) const;
  void note(Desk& desk, const std::string& sentence);
  void save_state(const DeskPtr& desk);

  // lab_dnc.cpp
  void judge_remote_start(const DeskPtr& desk, const panel::RemoteStart& start);

  // lab_labor.cpp
  /// The lab's menu gets the key: LABOR, and every other one while it is open, but for RESET, which acts in every state
  /// (DEC-39), and the START that accepts an offer.
  [[nodiscard]] bool takes_for_menu(const Desk& desk, Key key) const;
  void labor_key(const DeskPtr& desk, Key key);
  /// A message of the instructor: on the menu's list and in row 18, at once or as soon as the line is back.
  void deliver(Desk& desk, const std::string& message);
  void choose_language(const DeskPtr& desk, language::Tongue tongue);
  [[nodiscard]] LaborFacilities labor_facilities(const Desk& desk) const;
  struct LaborOrders;  ///< what each order does

  // lab_password.cpp
  void change_password(const VisitPtr& visit, const v1::ChangePassword& change);
  void refuse_same_password(const VisitPtr& visit) const;
  void change_expired_password(const VisitPtr& visit, const std::string& wish);
  void change_own_password(const VisitPtr& visit, const v1::ChangePassword& change);
  void keep_password(const VisitPtr& visit, const std::string& wish, std::function<void()> kept);
  void answer_password(const VisitPtr& visit, v1::LoginResult result, const std::string& text) const;

  // lab_versions.cpp
  /// Behind key LABOR (STO-005): the menu gets the list; an older version becomes the newest and row 18 tells.
  void read_versions(const DeskPtr& desk, const Subject& of);
  void restore_version(const DeskPtr& desk, const Subject& of, int version);
  /// The control takes up what the database has of its programs.
  void reload_programs(db::PersonId person);

  // lab_media.cpp
  void order_media(const DeskPtr& desk, panel::MediaRequest request, MediaOrder::From from);
  void print(const DeskPtr& desk, const std::shared_ptr<MediaOrder>& order, const panel::MediaFile& pdf);
  [[nodiscard]] bool controls_machine(const Desk& desk) const;
  void go_on_with_media(const DeskPtr& desk);
  void media_step(const VisitPtr& visit, const DeskPtr& desk, MediaTransfer::Step step);
  void fail_media(const DeskPtr& desk, MediaProblem problem);
  void media_over(const DeskPtr& desk, const MediaOrder& order);
  void take_media(const VisitPtr& visit, const v1::ClientMessage& message);
  void watch_media(const DeskPtr& desk, std::int64_t now_ns);
  void seat_media(const VisitPtr& visit, const DeskPtr& desk);
  /// The line is gone: what is under way goes on at the next one.
  static void pause_media(Desk& desk);
  /// Behind key LABOR: a hardcopy of the control's screen, and of the picture in GRAFIK (SYS-013).
  void print_screen(const DeskPtr& desk);

  // lab_cassettes.cpp
  void take_up_cassettes(const DeskPtr& desk, StoredCassettes stored);
  void put_into_recorder(const DeskPtr& desk, db::CassetteId id, const std::string& tape);
  void watch_recorder(const DeskPtr& desk);
  void save_cassette(const DeskPtr& desk);
  void change_cassettes(const DeskPtr& desk, std::function<bool(db::Database&)> change, const std::string& refusal);
  void change_recorder(const DeskPtr& desk, std::optional<db::CassetteId> next, std::optional<db::CassetteId> removed);
  /// Behind key LABOR.
  void wish_cassette(const DeskPtr& desk, const CassetteWish& wish);
  void act_on_cassette(const DeskPtr& desk, const ActOnCassette& order);
  [[nodiscard]] std::vector<std::string> cassette_lines(const Desk& desk) const;
  void show_cassette(const DeskPtr& desk, std::size_t index);
  /// Where the menu shows them, it shows them as they are now.
  void cassettes_changed(const DeskPtr& desk);

  // lab_keyboards.cpp
  /// Why the person's own keys are barred but for STOP and MASCHINE HALT; nothing while they are not (AUTH-016).
  [[nodiscard]] std::optional<std::string> bar(const Desk& desk) const;
  void set_locked(const DeskPtr& desk, bool on);
  void take_keyboard(const VisitPtr& console, const DeskPtr& desk);
  void give_back(const DeskPtr& desk);
  void give_back_from_lost_console(const DeskPtr& desk);
  /// A console goes: what it typed for stops where it is the machine's, else everything stays as it is.
  void let_go_of_keyboard(const VisitPtr& console);
  void show_to_all(int station);
  /// The desk whose screen this one's station shows in place of its own; nullptr: its own.
  [[nodiscard]] DeskPtr shown_to(const Desk& desk) const;
  [[nodiscard]] DeskPtr typed_at(const Visit& visit) const;  ///< own seat, or the keyboard taken over

  // lab_authority.cpp
  /// Returns the reason of a refusal, empty if none.
  std::string decide(const Event& event, language::Tongue tongue);
  void carry_out(const Action& action);
  void connect_lab_machine(LoginId login);
  void disconnect_lab_machine();
  [[nodiscard]] MachineView machine_view() const;
  void heard(const VisitPtr& visit, std::uint64_t beat);
  /// The beat stood still and the watchdog has cut the current: the machine stays off until power-on.
  void heed_watchdog();
  /// Ticks more than 5 ms late are told in the log, at once, so that it shows what else happened then (LOAD-003).
  void tell_late_ticks();
  /// New data of the machine hold while nobody has it and it stands still.
  void settle_machine_data();
  void keep_epoch();

  // lab_runs.cpp
  /// Begins, follows and ends the record of what the desk's control runs.
  void record_run(const DeskPtr& desk);
  void begin_recording(const DeskPtr& desk, RunRecorder& recorder, const std::shared_ptr<const panel::RunOrder>& order,
                       const machine::Snapshot& snapshot);
  [[nodiscard]] bool is_hand_recorded(const Desk& desk) const;
  /// For the instructor: in the journal, as soon as there is room for it, and counted.
  [[nodiscard]] std::function<void(const db::StoreError&)> loss_teller(const std::string& what, const Desk& desk,
                                                                       Epoch lease);
  void end_recording(const DeskPtr& desk, RunRecorder& recorder, machine::StopCause cause);
  /// Whatever the tools did wrong: told to the student, written down, counted as an error.
  void tell_milling(const DeskPtr& desk);
  void tell_milling(const DeskPtr& desk, const std::vector<machine::MillingEvent>& news, Epoch lease);

  // lab_screens.cpp
  void draw_due(std::int64_t now_ns);
  void draw(const DeskPtr& desk, std::int64_t now_ns);
  void present(const DeskPtr& desk, int beeps);
  void push(const VisitPtr& visit);
  [[nodiscard]] bool watches(const Visit& visit, const DeskPtr& desk) const;
  /// Who watches a seat at which nobody is any more, or yet, is told so instead of an old screen.
  void show_empty_seats();
  void everybody_changed();
  [[nodiscard]] panel::SideView side_view(const Desk& desk, std::int64_t now_ns) const;
  /// The clocks as this control has them (DEC-10).
  [[nodiscard]] panel::Now now(const Desk& desk) const;
  void note_situation(Desk& desk);

  Configuration configuration_;
  db::Store& store_;
  machine::TickThread& ticks_;
  db::Post post_;
  Clock clock_;
  PasswordWorker passwords_;
  // What a START waits for never waits behind a test run, nor that behind a printer.
  WorkerThread long_work_;   ///< checks before a start
  WorkerThread pictures_;    ///< test runs of GRAFIK, portion by portion in turn; printed pages
  WorkerThread background_;  ///< replays, the printer
  LoginGuard guard_;
  Beats beats_;
  Authority authority_;
  std::uint64_t kept_epoch_;  ///< numbers up to this one are reserved in the database
  BackupCopy backup_;
  JournalBook journal_;
  machine::WorkpieceThread workpieces_;
  LabMachine machine_;
  std::vector<VisitPtr> visits_;
  Seats seats_;
  std::weak_ptr<Desk> lab_desk_;      ///< whose control is connected to the lab machine
  std::deque<std::string> expelled_;  ///< tickets of those who were expelled while their line was broken
  std::set<db::PersonId> locked_;     ///< whose keyboards are locked, wherever they sit (SEC-007)
  int shown_station_ = 0;             ///< whose screen all see, 0 nobody's (INS-002)
  SerialLines lines_;
  std::uint64_t logins_ = 0;
  std::uint64_t runs_lost_ = 0;  ///< whose record the store could not take (STO-009)
  std::uint64_t late_ticks_told_ = 0;
  std::int64_t house_kept_ns_ = 0;  ///< 0: not yet
  int drawn_second_ = -1;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  ///< late answers of other threads find it gone
};

}  // namespace cnclab::lab
