// The cassette recorder at the control: motor, head, counter and LED in injected time (EXT-010 to EXT-026, DEC-33).
//
//   write   → pressed                   → released            1 s                 all sent
//           motor, leader as long as held ──────▶ leader goes on ──▶ LED, bytes ──────▶ motor and LED off
//   read    → pressed                   start mark that fits             its end
//           motor, tape is searched ─────────────▶ reading indicator ──────────▶ motor off
//
// Rules
//  1. Everything happens in `advance`, at the moment it is due, however late it is called. One transfer gives one
//  event.
//  2. What was recorded before a stop stays on the tape, cut off: read again it is found damaged (D-107).
//  3. Each recording that passes the head from its start mark on is looked at; one whose mark is unreadable ends the
//     reading as damaged, since it may be the one that is sought.
//  4. A recording that was begun on the transparent part is lost (D-105), which the recorder cannot know: `Written`
//     says so for whoever explains it.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "transfer/cassette.hpp"
#include "transfer/cassette_recording.hpp"
#include "transfer/time.hpp"

namespace cnclab::transfer {

/// A transfer to the tape has ended.
struct Written {
  bool is_lost = false;  ///< it began on the transparent part
};
/// A recording was read completely and correctly.
struct WasRead {
  Payload payload;
  bool adopts_machine_data = false;  ///< "+/-" was pressed meanwhile (EXT-026)
};
enum class DeckFault : std::uint8_t {
  damaged,      ///< CHECKSUM FEHLER (D-107)
  end_of_tape,  ///< nothing (more) to read, or no room to write
};
struct DeckFailed {
  DeckFault fault{};
};
using DeckEvent = std::variant<Written, WasRead, DeckFailed>;

class CassetteDeck {
 public:
  enum class State : std::uint8_t { still, leader, pause, sending, searching, reading, rewinding, winding };

  explicit CassetteDeck(Cassette cassette, Time now) : cassette_(std::move(cassette)), now_(now) {}

  /// → pressed with key 2 chosen. Takes effect only while the tape stands still, as do the next three.
  void begin_writing(const Payload& payload, Time now);
  /// → released: bytes follow a second later (EXT-012). Ignored unless the leader is being recorded.
  void end_leader(Time now);
  /// → pressed with key 6 chosen.
  /// program   only this one; nothing: the next recording, be it a program or a whole memory (D-105)
  void begin_reading(std::optional<std::uint16_t> program, Time now);
  /// The recorder's own keys: fast winding, 20 times the speed of play.
  void rewind(Time now);
  void wind_on(Time now);
  /// STOP, at the control or at the recorder: at once, nothing is taken over.
  void stop(Time now);
  /// "+/-" (KEY-066). Counts only while reading.
  void adopt_machine_data();
  void zero_counter() { cassette_.zero_counter(); }

  /// Lets time pass.
  /// now   not before the last call's
  [[nodiscard]] std::optional<DeckEvent> advance(Time now);

  [[nodiscard]] const Cassette& cassette() const { return cassette_; }
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool motor_runs() const { return state_ != State::still; }
  [[nodiscard]] bool led_is_on() const { return state_ == State::sending; }
  /// The start mark was recognised: the changing dash is shown (SCR-048).
  [[nodiscard]] bool is_reading() const { return state_ == State::reading; }
  [[nodiscard]] bool adopts_machine_data() const { return adopts_machine_data_; }
  [[nodiscard]] int counter() const { return cassette_.counter(); }
  /// Done of what is being sent or read, 0..1.
  [[nodiscard]] double progress() const;

 private:
  void start(State state, Time now);
  [[nodiscard]] std::optional<DeckEvent> play_to(std::uint32_t position_ms);
  [[nodiscard]] std::optional<DeckEvent> send_to(std::uint32_t position_ms);
  [[nodiscard]] std::optional<DeckEvent> search_to(std::uint32_t position_ms);
  [[nodiscard]] std::optional<DeckEvent> read_to(std::uint32_t position_ms);
  [[nodiscard]] DeckEvent finish(DeckEvent event, std::uint32_t position_ms);
  void cut_off();

  Cassette cassette_;
  Time now_;
  State state_ = State::still;
  Time began_{};               ///< the state, or the tape's movement within the transfer
  std::uint32_t from_ms_ = 0;  ///< position at that moment
  std::uint32_t data_ms_ = 0;  ///< where the bytes of what is sent or read begin
  std::string bytes_;          ///< of what is sent
  std::optional<std::uint16_t> sought_;
  bool adopts_machine_data_ = false;
};

/// The changing dash at the top right (D-106): "|", "/", "-", "\", four per second.
[[nodiscard]] char reading_dash(Time now);

}  // namespace cnclab::transfer
