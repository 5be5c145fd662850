// EXTERNE DATEN: programs leave and enter the memory (2.5, MOD-070, section EXT).
//
//   device ──1 to 9──▶ program prompt ──→──▶ transfer ──end, fault, STOP──▶ device
//     │                  └──C──▶ → everything ──┘
//     └──START, under REMOTE──▶ release: program and block that a computer may start (AUTH-013) ──STOP──▶ device
//
// Cassettes turn in the control's recorder (transfer::CassetteDeck). Tapes, diskettes and printed pages are files at
// the station: without a place for them their keys are ignored, as those of devices that are not fitted are (D-109).
// With a serial line 5 and 9 are fitted, and 3 and 7 use it too (DEC-36, DEC-62). While a transfer is under way only
// STOP has an effect, for an input "+/-" and for the cassette's leader → (D-107). "+/-" takes machine data along; it
// can be pressed at the prompt already, since a file is read at once (KEY-066, EXT-026).
#pragma once

#include <expected>
#include <optional>
#include <string>

#include "language/tape.hpp"
#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"
#include "panel/modes/print_job.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

enum class Device : std::uint8_t {
  printer = 1,
  cassette_out,
  tape_out,
  disk_out,
  computer_out,
  cassette_in,
  tape_in,
  disk_in,
  computer_in,
};

struct ExternalDataMode {
  enum class Phase : std::uint8_t { device, program, transfer, release };
  Phase phase = Phase::device;
  std::optional<Device> device;
  DigitField program{4, {}, 0};
  bool takes_all = false;            ///< C was the last key: → means everything, or the next recording (D-105)
  bool adopts_machine_data = false;  ///< chosen by "+/-" at the prompt or while reading (KEY-066)
  bool is_on_line = false;           ///< the transfer goes over the serial line
  std::optional<PrintJob> print;
  // Phase::release
  DigitField block{3, {}, 0};
  bool is_at_block = false;  ///< the marker stands on the block's number
  bool asks_zero = false;    ///< START once more: the zero is right (DEC-27)
  std::optional<Armed> armed;
  std::string files;  ///< names of those that are being written at the station, for row 18
  std::string done;   ///< what the last transfer has brought, for row 18
};

[[nodiscard]] ExternalDataMode open_external_data(const ControlState& state);
/// What is under way is broken off.
void close(ExternalDataMode& mode, ControlState& state);
[[nodiscard]] Place place_of(const ExternalDataMode& mode, const ControlState& state);
void press(ExternalDataMode& mode, ControlState& state, Effect effect, int figure);
/// Does the figure choose a device that is connected, or belong to a number?
[[nodiscard]] bool is_of_use(const ExternalDataMode& mode, const ControlState& state, int figure);
/// → was released: the cassette's leader is long enough (EXT-012).
void release_enter(ExternalDataMode& mode, ControlState& state);
void follow(ExternalDataMode& mode, ControlState& state);
/// The station's answer to a MediaRequest: what was read, or a sentence.
void media_answered(ExternalDataMode& mode, ControlState& state, const std::expected<std::string, std::string>& answer);
void stored(ExternalDataMode& mode, ControlState& state, const StoreRequest& request);
void draw(const ExternalDataMode& mode, const ControlState& state, Monitor& monitor);
/// The transfer is over; `done` says for row 18 what it has brought.
void end_transfer(ExternalDataMode& mode, std::string done);

// The transfer over the serial line (external_line.cpp)
/// Key 3, 5, 7 or 9 and →: begins as soon as somebody is at the other end.
void begin_line_transfer(ExternalDataMode& mode, ControlState& state, const std::vector<language::Program>& leaving);
void take_line_event(ExternalDataMode& mode, ControlState& state, const transfer::LineEvent& event);
void line_stored(ExternalDataMode& mode, ControlState& state, bool is_stored);
/// The other end has gone in the middle of it.
void line_broke(ExternalDataMode& mode, ControlState& state);
void abort_line_transfer(ExternalDataMode& mode, ControlState& state);

// The release of a remote start (external_release.cpp)
/// START: what the prompt shows may be started once by the computer (AUTH-013).
void release_start(ExternalDataMode& mode, ControlState& state);
void press_release(ExternalDataMode& mode, ControlState& state, Effect effect, int figure);
void follow_release(ExternalDataMode& mode, ControlState& state);
[[nodiscard]] std::string release_sentence(const ExternalDataMode& mode, const ControlState& state);

[[nodiscard]] std::string sentence_of(const ExternalDataMode& mode, const ControlState& state);

/// Received text becomes a request to store it, or a complaint (external_intake.cpp). True where it is to be stored.
///
/// is_whole_memory   the recording says so: everything stored before goes (EXT-024, DEC-57)
/// sought            only this program counts; nothing: all
struct ReceivedText {
  std::string text;
  language::Reading reading = language::Reading::strict;
  bool is_whole_memory = false, adopts_machine_data = false;
  bool is_continuation = false;  ///< its blocks join those of the stored program (EXT-061)
  std::optional<std::uint16_t> sought;
  std::string notice{};  ///< to be told once it is stored
};
/// What the control sees of a file: small letters it overlooks, outside comments (EXT-049, DEC-30).
[[nodiscard]] std::string without_small_letters(std::string_view text);
[[nodiscard]] bool take_in(ControlState& state, const ReceivedText& received);

/// What leaves: one program, or everything with machine data.
[[nodiscard]] std::string machine_data_text(const machine::MachineData& data);

}  // namespace cnclab::panel
