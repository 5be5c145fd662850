// What all operating modes of one control share: memory, modal state, machine, run, messages. The modes are functions
// that work on it; nothing here knows which of them is active.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "language/check_block.hpp"
#include "language/error.hpp"
#include "panel/control.hpp"
#include "panel/panel_clock.hpp"
#include "panel/run/run.hpp"
#include "panel/run/serial_port.hpp"
#include "panel/screen/texts.hpp"
#include "program/modal_state.hpp"
#include "transfer/cassette_deck.hpp"

namespace cnclab::panel {

/// What stands on the monitor's last line until the next key that has an effect (D-117, D-119), and its sentence below.
struct Message {
  std::string monitor;
  int column = 0;  ///< D-118
  std::string sentence;
};

/// X, Y, Z in whole steps of the connected machine, counted from where its channel began (run/machine_place.hpp).
struct MachinePlace {
  std::array<std::int64_t, 3> steps{};
};

/// Where TEACH IN stopped last: continuing that program goes on from there (DEC-61).
struct TaughtPosition {
  std::uint16_t program = 0;  ///< 0: none
  MachinePlace place;
};

struct ControlState {
  ControlState(const Settings& configuration, Memory stored, machine::MachineData own_data)
      : settings(configuration), memory(std::move(stored)), data(std::move(own_data)) {}

  Settings settings;
  Memory memory;
  machine::MachineData data;  ///< the student's own
  program::ModalState modal;
  program::Parameters parameters{};
  std::array<double, 3> compensation_mm{};  ///< Istwert minus Sollwert that the last run has left (D-75)
  Connection connection;
  int override_percent = 100;
  Run run;
  geometry::SpindleTurn last_turn = geometry::SpindleTurn::clockwise;  ///< for the key FRÄSER (D-12)

  std::optional<machine::MachineData> applied_data;  ///< that the connected machine has been given

  std::uint16_t editor_program = 1;   ///< last worked on (D-35)
  std::uint16_t automat_program = 1;  ///< last run in AUTOMAT (MOD-050)
  TaughtPosition taught;
  Message message;
  std::string hint;  ///< why the last key was ignored; row 18 only
  std::optional<StoreRequest> storing;
  std::optional<transfer::CassetteDeck> recorder;  ///< with a cassette in it
  bool has_media = false;                          ///< the station has a place for files
  bool has_printer = false;                        ///< the lab has a printer
  std::optional<MediaRequest> media;               ///< to be handed out
  bool is_media_pending = false;                   ///< handed out, the answer is awaited …
  bool is_media_stale = false;                     ///< … and nobody wants it any more
  std::optional<PutFiles> picture;                 ///< to be handed out, nobody awaits an answer
  SerialPort port;
  int beeps = 0;
  bool is_switching = false;       ///< the newest key has ordered a switch or a counter: see Control::awaits_effect
  bool is_zero_confirmed = false;  ///< under the present lease (DEC-27)
  PanelClock clock;
  bool is_ram_faulty = false;     ///< injected: the memory test finds it (ERR-034)
  Now now;                        ///< of the newest call
  std::optional<Mode> next_mode;  ///< a mode asks for another one to be opened after this key or poll

  [[nodiscard]] language::Tongue tongue() const { return settings.tongue; }
  /// Monitor text and sentence of an error.
  void complain(const language::Error& error);
  /// The error's monitor text with an own, more fitting sentence.
  void complain(language::ErrorCode code, std::string sentence);
  /// Nothing of that number can run: it is not stored, or it is the tool table.
  void complain_cannot_run(std::uint16_t number);
  /// The data of the machine that is connected now (DEC-25).
  [[nodiscard]] machine::MachineData effective_data() const;
  /// Gives the machine the data that hold now; false where it has others and does not stand still.
  [[nodiscard]] bool apply_data();
  /// What EINGABE compares word values with (D-46, DEC-56).
  [[nodiscard]] language::EntryLimits entry_limits() const;
  /// The request that erases everything, machine data included.
  [[nodiscard]] EraseMemory whole_memory() const;
  /// As after switching on (MOD-078): modal state, parameters and offered numbers, spindle and coolant off; the axes'
  /// counters stay.
  void initialise();
  /// The modal state of switching on, and the machine's outputs with it: its M12 is what they are.
  void reset_modal_state();
  /// Takes over what a run has left behind.
  void take_over(const RunEnd& end);
  /// Does a way wait for nothing but the potentiometer (DEC-40)?
  [[nodiscard]] bool awaits_potentiometer() const;
  [[nodiscard]] language::Plane plane() const;      ///< of the modal state
  [[nodiscard]] machine::Snapshot machine() const;  ///< all at rest where none is connected
};

/// The state where something else than a block has switched spindle and coolant off: an M that says they are on gives
/// way to M12.
[[nodiscard]] program::ModalState with_tools_off(program::ModalState modal);

/// "0001", "001" for sentences; "P0001", "N001" as words.
[[nodiscard]] std::string program_text(int number);
[[nodiscard]] std::string block_text(int number);
[[nodiscard]] std::string program_word(int number);
[[nodiscard]] std::string block_word(int number);
/// "G01", "↓16".
[[nodiscard]] std::string function_text(language::Function function);

}  // namespace cnclab::panel
