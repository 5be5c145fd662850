// One emulated control: keys in, screens out, motion through a channel, stores as requests.
//
//   lab ── press / poll / connect ──▶ Control ── StoreRequest ──▶ lab ──▶ db ──▶ store_done ──▶ Control
//                                        └──── commands, path ──▶ machine::Channel
//
// A Control does no I/O and knows no clock: time comes in, effects go out. It belongs to one student and lives as long
// as the login; what outlives it is `save_state`.
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "language/block.hpp"
#include "language/block_form.hpp"
#include "machine/channel.hpp"
#include "machine/machine_data.hpp"
#include "machine/milling.hpp"
#include "panel/connection.hpp"
#include "panel/media.hpp"
#include "panel/memory.hpp"
#include "panel/mode.hpp"
#include "panel/run/long_work.hpp"
#include "panel/run/serial_port.hpp"
#include "shared/key.hpp"
#include "shared/screen.hpp"
#include "transfer/cassette.hpp"

namespace cnclab::panel {

struct RunOrder;

/// Configuration of one control (interfaces.md [control], decisions.md DEC-08).
struct Settings {
  language::Vocabulary vocabulary{};
  language::Tongue tongue = language::Tongue::german;
  bool hints = true;                     ///< row 18 says why a key was ignored
  bool start_in_middle_rebuilds = true;  ///< DEC-26
  int memory_bytes = 16384;
  bool remote = false;       ///< the rear switch REMOTE lights the menu's field of EXTERNE DATEN (SCR-022)
  std::string student{};     ///< who stands on printed pages
  bool keys_19inch = false;  ///< the memory test is called by 1+4+7 instead of 3+6+9 (D-17)
  std::array<bool, 3> io_cards{true, true, true};  ///< which are fitted (D-124)
  bool rests_accumulate = false;                   ///< rests below one step add up as on the original (DEC-05)
  LongWork long_work = do_at_once;                 ///< who does what a START waits for
  LongWork picture_work = do_at_once;              ///< … and what may take its time: test runs, printed pages
  machine::WorkpieceSpec workpiece{};              ///< that GRAFIK cuts (DEC-24)
};

/// Local date and time for the header line (DEC-10).
struct WallClock {
  int hour = 0, minute = 0, second = 0, day = 0, month = 0, year = 0;  ///< year of the century
};

/// Both clocks as they are handed in with every call.
struct Now {
  std::int64_t monotonic_ns = 0;
  WallClock wall;
};

// What the control wants stored. The lab stores it, then calls `store_done`; until then it hands in no key but STOP.
struct PutBlock {
  std::uint16_t program = 0;
  language::Block block;
};
struct InsertBlock {
  std::uint16_t program = 0;
  language::Block block;
};
struct DeleteBlock {
  std::uint16_t program = 0;
  std::uint16_t block = 0;
};
struct RemovePrograms {
  std::vector<std::uint16_t> programs;
};
struct PutMachineData {
  machine::MachineData data;
};
/// The whole memory at once: these programs, and the machine data become `data` (MOD-077). The versions stay (STO-005).
struct EraseMemory {
  std::vector<std::uint16_t> programs;
  machine::MachineData data;
};
/// What was read from outside, all of it at once: the programs replace those of their numbers, `removed` go before, and
/// the machine data become `data` where there are any (EXT-023, EXT-024, EXT-026).
struct PutPrograms {
  std::vector<language::Program> programs;
  std::vector<std::uint16_t> removed;
  std::optional<machine::MachineData> data;
  std::string notice{};  ///< what of it was left out, for row 18
};
using StoreRequest =
    std::variant<PutPrograms, PutBlock, InsertBlock, DeleteBlock, RemovePrograms, PutMachineData, EraseMemory>;

/// What a key press led to besides a changed screen.
struct Outcome {
  std::optional<StoreRequest> store;
  std::optional<MediaRequest> media{};        ///< to be answered by `media_done`, sooner or later
  std::optional<PutFiles> picture{};          ///< what `order_picture` asked for
  std::optional<RemoteStart> remote_start{};  ///< to be answered by `answer_remote_start` at once
  std::vector<std::string> line_news{};       ///< what went over the serial line, for the journal
  bool is_from_line = false;                  ///< `store` is what the line has brought
  bool mode_changed = false;                  ///< the lab keeps the control's state (SEAT-004)
  bool was_reset = false;                     ///< RESET, alone or in a chord: a lease ends (DEC-39)
  [[nodiscard]] bool is_anything() const {
    return store || media || picture || remote_start || !line_news.empty() || mode_changed || was_reset;
  }
};

/// What stands on a screen and decides whether a START pressed before it is still meant (AUTH-008).
struct Situation {
  Mode mode = Mode::menu;
  std::uint16_t program = 0, block = 0;
  bool started = false, alarm = false;
  friend bool operator==(const Situation&, const Situation&) = default;
};

/// What lamps and counters show of the machine that is connected; while nothing runs it changes without a key too.
struct Indication {
  std::array<double, 4> istwert_mm{};
  std::array<bool, 4> limit{};
  geometry::SpindleTurn spindle{};
  bool coolant = false, is_referenced = false;
  machine::MotionState state{};
  std::uint64_t pictures = 0;  ///< of GRAFIK, whose test run rests: the picture that a key has asked for came behind it
  friend bool operator==(const Indication&, const Indication&) = default;
};

/// What the lab adds to the screen: the right-hand column and, when it has something to say, rows 18 and 19.
struct SideView {
  int station = 0;
  std::string user;
  bool on_lab_machine = false;
  int controlling_station = 0;  ///< 0 nobody
  int override_percent = 0;
  int meldung = 0;          ///< place in the order of raised hands, 0 none
  std::string halted_by{};  ///< who pressed MASCHINE HALT, empty if nobody
  int halted_at = 0;        ///< … at which station; 0: at none
  /// Who bars the keyboard; stands above whatever else there is to say, as long as it holds (INS-002).
  std::string bar{};
  bool keys_work = true;  ///< false: nobody's keys but STOP and MASCHINE HALT act, none are listed
  std::string notice{};   ///< e.g. the offer of control; before the control's own sentence
};

class Control {
 public:
  Control(const Settings& settings, Memory memory, machine::MachineData data);
  ~Control();
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;

  /// Connects to a machine; the run on the former one is abandoned (AUTH-003): it must stand still.
  void connect(Connection connection);

  /// A key went down. While a store is pending only STOP is accepted; the caller queues the others.
  Outcome press(Key key, const Now& now);
  /// A key that is the lab's alone (MELDUNG, LABOR, MASCHINE HALT, keys of the lab's menu): it comes between what waits
  /// to be confirmed and the key that would confirm it.
  void note_labs_key();
  /// Keys pressed together (→+RESET, ↓+RESET, 3+6+9).
  Outcome press_chord(const std::vector<Key>& keys, const Now& now);
  void release(Key key, const Now& now);
  void set_override(int percent);

  [[nodiscard]] bool is_storing() const;
  /// The answer to the pending request; `error` is the sentence for row 18, empty when it is on disk.
  void store_done(const std::string& error);

  /// To be called every 10 to 20 ms: feeds the run (at most 2 ms of work), follows the machine. Stores nothing but what
  /// EXTERNE DATEN has read.
  Outcome poll(const Now& now);

  /// Is there a place for files at the station? Without it printer, tape and diskette are not fitted (D-109).
  void connect_media(bool is_connected);
  /// Has the lab a printer? Then there is one without a place for files, too.
  void connect_printer(bool is_connected);
  /// Is the answer to a MediaRequest still wanted? After STOP it is not, though it is to be given all the same.
  [[nodiscard]] bool awaits_media() const;
  /// GRAFIK's picture at full resolution, as SVG and PDF: it comes with the outcome of a later `poll`. In other modes
  /// nothing comes.
  void order_picture();
  /// The answer to the newest MediaRequest: the bytes that were read (empty where files were written), or a sentence.
  void media_done(const std::expected<std::string, std::string>& answer);

  /// The recorder's flap: without a cassette keys 2 and 6 are not fitted. Not while its motor runs.
  void insert_cassette(transfer::Cassette cassette, const Now& now);
  /// Takes it out, and throws it away: `cassette` gives it before. Not while its motor runs.
  void eject_cassette();
  /// As it is now, to be kept; nothing while there is none. It changes only while `recorder_runs`.
  [[nodiscard]] std::optional<transfer::Cassette> cassette() const;
  [[nodiscard]] bool recorder_runs() const;
  /// The recorder's own keys.
  enum class RecorderKey : std::uint8_t { rewind, wind_on, stop, zero_counter };
  void press_recorder(RecorderKey key, const Now& now);

  // The serial line (panel/run/serial_port.hpp)
  void fit_line(LineFitting fitting);
  /// The switch at the back (KEY-008).
  void set_remote(bool is_on);
  [[nodiscard]] bool is_remote() const;
  /// Somebody is at the line's other end, or nobody any more.
  void connect_line(bool is_connected, const Now& now);
  /// Characters from the other end; as transfer::SerialLine::receive.
  std::size_t line_received(std::string_view bytes, const Now& now);
  [[nodiscard]] std::string take_line_output(const Now& now, std::size_t most);
  /// Nothing on its way in either direction, and nothing of it being worked on.
  [[nodiscard]] bool is_line_idle() const;
  [[nodiscard]] int line_baud() const;         ///< MD 20
  [[nodiscard]] bool is_line_reading() const;  ///< the dash turns (SCR-048)
  /// What is released for a remote start now; nothing where that is over or used up (AUTH-013).
  [[nodiscard]] std::optional<Armed> armed() const;
  /// The lab's word: empty, the run begins; else a sentence that says why not, and "!" is answered with F (DEC-35).
  Outcome answer_remote_start(const std::string& refusal, const Now& now);

  [[nodiscard]] Screen draw(const Now& now, const SideView& side) const;
  [[nodiscard]] Situation situation() const;
  [[nodiscard]] Mode mode() const;
  [[nodiscard]] bool is_running() const;  ///< START state
  /// Does the screen change without a key: a run, a test run of GRAFIK, a transfer, the recorder?
  [[nodiscard]] bool is_busy() const;
  /// The newest key has given the machine an order that it has not taken, some milliseconds long, or asked GRAFIK for a
  /// picture that is still being drawn: what the screen shows is not the key's effect before. Further keys wait until
  /// then; STOP does not.
  [[nodiscard]] bool awaits_effect() const;
  [[nodiscard]] Indication indication() const;
  /// What the run that is present was begun with, also while it rests; nullptr where there is none (STO-007).
  [[nodiscard]] std::shared_ptr<const RunOrder> run_order() const;
  /// Short tones since the last call; and whether the repeated tone of M01 sounds.
  [[nodiscard]] int take_beeps();
  [[nodiscard]] bool alarm_tone() const;

  /// The workpiece of the next graphic test (DEC-24).
  void set_workpiece(const machine::WorkpieceSpec& spec);
  [[nodiscard]] const machine::WorkpieceSpec& workpiece() const;
  /// Row 18 tells what the tool did that it must not.
  void tell_milling(const machine::MillingEvent& event);

  /// A fault of the CMOS RAM for the memory test to find (ERR-034).
  void set_ram_fault(bool is_faulty);
  [[nodiscard]] bool has_ram_fault() const;
  /// The stored machine data had a wrong check code: those of the ROM hold now, and the screen says so (ERR-014).
  void tell_data_restored();

  [[nodiscard]] const Memory& memory() const;
  [[nodiscard]] const machine::MachineData& data() const;  ///< the student's own
  [[nodiscard]] int override_percent() const;
  /// Modal state, parameters, Istwert, mode, half-filled line as JSON (SEAT-002, SEAT-004), and back: always in STOP.
  [[nodiscard]] std::string save_state() const;
  void restore_state(const std::string& json);
  /// Programs changed from outside (instructor, restore): the memory's copy is replaced.
  void replace_memory(Memory memory);
  /// Machine data changed from outside (restore): they act as if they had been entered (DEC-28).
  void replace_data(machine::MachineData data);
  /// Another language from now on; what row 18 and the monitor's last line said before goes.
  void set_tongue(language::Tongue tongue);
  /// The key that was ignored had an effect after all, in the lab: row 18 does not say that it had none.
  void drop_hint();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cnclab::panel
