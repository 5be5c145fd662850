// The control's end of the serial line: who may send, what was received, what the control answers (EXT-043 to EXT-066).
//
//            begin_reading, begin_remote: DC1                      NUL, "%", "*", "#": DC3 DC3
//     off ───────────────────────────────────▶ reader on ─────────────────────────────────────▶ waits for an answer
//      ▲                                            ▲      accept, refuse under REMOTE: DC1             │
//      │ "%" stored, refused, fault, stop           └───────────────────────────────────────────────────┤
//      └─────────────────────────────────────── reading by key 7 ◀──────────────────────────────────────┘
//
// Rules
//  1. What is received while the reader is off is ignored (EXT-053), but "!" under REMOTE: a running control can be
//     asked too (D-98). The line's own time stands still between an event and the next `advance`, so an answer that is
//     given at once loses no character; whoever must wait for a disk gives the answer first and then calls `advance`.
//  2. Under REMOTE the control polls: DC1 follows each transmission, "%" included, and each run that "*" has begun
//     (EXT-060, EXT-064). How it polls is our definition; the manual says nothing of it.
//  3. After a fault under REMOTE the rest of that transmission must not be taken for a new one: the reader stays off
//     until the line has been silent for a second.
//  4. Everything that is sent has even parity: DC3 leaves as 93H (EXT-044).
//  5. Where REMOTE is on, but the control is in no mode that polls (D-110), the line is held: nothing is asked for, "!"
//  is
//     answered all the same.
//
// What it does not do: DC1 and DC3 from the other side do not hold the control's sending; the manual gives them to the
// control alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "transfer/line_input.hpp"
#include "transfer/line_pace.hpp"

namespace cnclab::transfer {

/// What the control answers to "!": PxxxxNxxx, a letter, "%" (D-98).
struct ControlStatus {
  enum class Letter : char { stopped = 'S', running = 'L', failed = 'F' };
  std::uint16_t program = 1, block = 1;
  Letter letter = Letter::stopped;
};

struct SendingDone {};
/// TextReceived, StartReceived and EraseReceived wait for `accept` or `refuse`; the others are news.
using LineEvent = std::variant<TextReceived, StartReceived, EraseReceived, StatusQuery, LineFault, SendingDone>;

class SerialLine {
 public:
  enum class Mode : std::uint8_t { off, reading, remote, sending };
  /// Characters that may wait to be received; whoever brings more keeps it until there is room.
  static constexpr std::size_t kBacklog = 4096;

  explicit SerialLine(LineSpeed speed) : input_(speed), output_(speed) {}

  /// MD 20 was changed.
  void set_speed(LineSpeed speed);

  /// → with key 7 chosen: asks for programs until "%" (EXT-046).
  void begin_reading(Time now);
  /// The REMOTE switch is on, and the control is in a mode that polls (D-110).
  /// program   the active one, which Nxxx goes on with
  /// is_held   it begins in another mode: as after `hold`
  void begin_remote(std::uint16_t program, Time now, bool is_held = false);
  /// Under REMOTE: the mode that polls was left; half received text is dropped and the sender is told by DC3 twice.
  void hold(Time now);
  /// … and entered again. Does nothing where the line is not held.
  void go_on(Time now);
  /// → with key 3 chosen. text: as `line_text`
  void begin_sending(std::string_view text, Time now);
  /// STOP, MENU, switch off: nothing half received is kept (D-107). A sender is told by DC3 twice.
  void stop(Time now);

  /// The cable is pulled: as `stop`, but nothing is told, and what had not left yet goes nowhere.
  void cut(Time now);

  /// Characters from the other side.
  /// returns   how many were taken: no more than there is room for; all, and none of them kept, while the line is off
  std::size_t receive(std::string_view bytes, Time now);
  /// What has left by now, at most so many characters.
  [[nodiscard]] std::string take_output(Time now, std::size_t most = std::string::npos);
  /// Lets time pass up to the next event; call it until there is none.
  [[nodiscard]] std::optional<LineEvent> advance(Time now, const ControlStatus& status);

  /// The program is stored, the memory erased, the run begun: reading goes on, at a run when it has ended.
  void accept();
  /// It could not be done. Reading by key 7 ends; under REMOTE "!" is answered with F until something is accepted.
  void refuse();
  /// The run that "*" began is over.
  void run_ended(Time now);

  /// Is no character on its way, in either direction?
  [[nodiscard]] bool is_idle() const { return input_.waiting() == 0 && output_.waiting() == 0; }
  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] bool is_waiting_for_answer() const { return !std::holds_alternative<std::monostate>(asked_); }
  /// Is what waits for an answer text that "%" ended?
  [[nodiscard]] bool ends_transmission() const;
  /// Has the beginning of a program been recognised? The changing dash is shown (SCR-048).
  [[nodiscard]] bool is_reading() const { return is_reader_on_ && input_rules_.has_begun(); }

 private:
  void begin(Mode mode, Time now);
  void switch_reader_on();
  void switch_reader_off();
  void ask_again();  ///< for the next transmission, unless held
  [[nodiscard]] std::optional<LineEvent> take(char byte, const ControlStatus& status);
  [[nodiscard]] std::optional<LineEvent> take_fault(LineFault fault);
  void answer_query(const ControlStatus& status);
  void send(std::string_view text) { output_.put(with_parity(text), time_); }
  [[nodiscard]] static std::string with_parity(std::string_view text);

  LinePace input_, output_;
  LineInput input_rules_{false, -1};
  Mode mode_ = Mode::off;
  Time time_{};  ///< up to which the line has been followed
  bool is_reader_on_ = false;
  Received asked_;  ///< what waits for an answer
  bool is_held_ = false;
  bool is_running_ = false;           ///< what "*" began
  bool has_failed_ = false;           ///< the last transmission was refused
  std::optional<Time> silent_since_;  ///< after a fault under REMOTE: the last character that was ignored
};

}  // namespace cnclab::transfer
