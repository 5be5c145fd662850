// One logged-in person's place: the control, its training machine, the keys that wait, the connection that looks at it.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cnclab/v1/keys.pb.h"
#include "db/types.hpp"
#include "lab/authority.hpp"
#include "lab/labor/labor_menu.hpp"
#include "lab/media/cassettes.hpp"
#include "lab/media/media_order.hpp"
#include "lab/runs/run_recorder.hpp"
#include "lab/screen_feed.hpp"
#include "machine/channel.hpp"
#include "machine/simulated_machine.hpp"
#include "machine/tick_thread.hpp"
#include "machine/workpiece_thread.hpp"
#include "panel/control.hpp"

namespace cnclab::lab {

struct Visit;

/// A key or a turn of the potentiometer on its way to the control.
struct Input {
  std::uint64_t number = 0;  ///< 0: typed at a console, never acknowledged
  std::vector<Key> keys;     ///< empty: potentiometer
  bool pressed = true;
  bool is_repeat = false;
  int percent = 0;
  std::uint64_t beat = 0, state = 0;  ///< what the station had seen (AUTH-008)
};

/// A control lives here from login until log-out, or `keep_minutes` after its line broke (SEAT-004).
struct Desk {
  /// Takes part in the tick from now on, and its workpiece in the cutting; throws std::runtime_error when the tick has
  /// no place left. ticks, workpieces, store   outlive the desk
  Desk(db::Person person, const panel::Settings& settings, panel::Memory memory, const machine::MachineData& data,
       machine::TickThread& ticks, machine::WorkpieceThread& workpieces, db::Store& store);
  ~Desk();
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  /// Connects the control to its own training machine.
  void connect_training();
  /// Training runs stop when the connection ends.
  void stop_training();
  /// No tick and no cutting touches the training machine any more. The lab says so before it forgets the desk: whoever
  /// drops it last, perhaps on another thread, may outlive ticks and workpieces.
  void leave_machines();
  /// The training machine takes up machine data that the student has changed, as soon as it stands still. To be called
  /// again and again.
  void settle_machine_data();
  /// From the next program start and graphic test on (DEC-24).
  void set_workpiece(const machine::WorkpieceSpec& spec);
  /// What the tool of the training machine did wrong since the last call.
  [[nodiscard]] std::vector<machine::MillingEvent> take_milling_news() { return site_->take_news(); }

  [[nodiscard]] bool is_seated() const { return !visit.expired(); }
  [[nodiscard]] const std::shared_ptr<machine::Channel>& training() const { return training_; }

  db::Person person;
  int station = 0;
  LoginId login{};
  std::weak_ptr<Visit> visit;  ///< the connection that types; empty while the line is broken
  std::string ticket;
  std::string dnc_token;           ///< binds a serial line to this login (interfaces.md section 8)
  std::int64_t keep_until_ns = 0;  ///< while the line is broken
  std::int64_t made_ns = 0;        ///< power on of this control (DEC-64)
  panel::Control control;
  bool on_lab_machine = false;
  std::unique_ptr<RunRecorder> recorder;  ///< of the training machine

  // Who else has a hand on the keyboard (lab_keyboards.cpp)
  bool is_locked = false;            ///< but for STOP and MASCHINE HALT (AUTH-016)
  std::string taken_by;              ///< the instructor who types in the student's place, empty if nobody
  std::weak_ptr<Visit> taker;        ///< that instructor's console while its line lives
  std::int64_t station_beat_ns = 0;  ///< when the newest beat that the station answered was sent
  std::int64_t console_beat_ns = 0;  ///< as well, of the console that types

  std::deque<Input> waiting;               ///< keys that came while something was being stored
  std::uint64_t received = 0;              ///< number of the last input that came
  std::optional<std::uint64_t> switching;  ///< number of the input whose order the machine has yet to take
  /// A STOP, and the tick of the channel told to stop that has surely heeded it: until then no screen shows it.
  struct Stopping {
    std::shared_ptr<machine::Channel> channel;
    std::uint64_t heeded_at_tick = 0;
  };
  std::optional<Stopping> stopping;
  std::optional<std::uint64_t> storing;     ///< number of the input whose store is on its way
  bool ignore_start_until_release = false;  ///< the START that accepted an offer (AUTH-005)
  std::optional<LaborMenu> labor;           ///< the lab's menu while it is open (key LABOR)
  std::deque<std::string> messages;         ///< of the instructor since the login, newest first
  std::uint64_t state = 1;                  ///< number of the situation below (AUTH-008)
  panel::Situation situation;
  bool situation_on_lab = false;
  std::string notice;  ///< the lab's own sentence for row 18
  std::int64_t notice_until_ns = 0;
  std::deque<std::shared_ptr<MediaOrder>> media;  ///< files on their way, the first under way (lab_media.cpp)
  std::int64_t media_moved_ns = 0;                ///< when the last of their messages came or went
  CassetteShelf cassettes;
  std::string last_key;
  View view;                           ///< what was drawn last
  std::deque<std::int64_t> errors_ns;  ///< when errors came up in the last minute (INS-001)
  std::int64_t last_drawn_ns = 0, last_saved_ns = 0;
  std::string saved_state;
  bool is_dirty = true;  ///< the screen is to be drawn
  bool was_busy = false;
  panel::Indication indicated;  ///< of the machine at rest, when it was looked at last

  /// The machine has yet to take what the newest input ordered.
  [[nodiscard]] bool awaits_effect() const;
  /// Every input up to this number has had its effect.
  [[nodiscard]] std::uint64_t handled() const;

 private:
  machine::TickThread& ticks_;
  machine::WorkpieceThread& workpieces_;
  std::shared_ptr<machine::MillingSite> site_;  ///< outlives the channel's ticks
  machine::MachineData machine_data_;           ///< that the training machine has
  bool has_left_machines_ = false;
  machine::SimulatedMachine machine_;
  std::shared_ptr<machine::Channel> training_;
};

}  // namespace cnclab::lab
