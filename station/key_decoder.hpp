// The bytes that ncurses took for no key: characters, and escape sequences that this terminal's description lacks.
//
// A keyboard sends what is no character as Escape and more: Alt and a letter, Ctrl and an arrow, the marks around
// pasted text. Whatever is not known means nothing, as a whole: taken apart, its letters would be keys, and one of them
// START.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "station/terminal_event.hpp"

namespace cnclab::station {

/// How the terminal's coding makes characters of bytes.
enum class Coding : std::uint8_t {
  utf8,         ///< also for plain ASCII: what is no UTF-8 there is nothing
  single_byte,  ///< ISO 8859-1 and its like, by the C library's locale
};
[[nodiscard]] Coding coding_of_locale();

class KeyDecoder {
 public:
  using Clock = std::chrono::steady_clock;
  /// stops  ASCII characters that stop the machine: they count in the midst of anything; outlive the decoder
  KeyDecoder(std::string_view stops, Coding coding) : stops_(stops), coding_(coding) {}

  /// The next byte. What is no valid character is dropped alone, whatever comes with it counts.
  [[nodiscard]] std::optional<TerminalEvent> take(unsigned char byte, Clock::time_point now);
  /// A key that ncurses has recognised: itself, or nothing where it is a part of something (Alt and F5, pasted text).
  [[nodiscard]] std::optional<TerminalEvent> take(Special key);
  /// Nothing more has arrived: an Escape alone is the key. It also ends a pasted text whose end mark was lost.
  [[nodiscard]] std::optional<TerminalEvent> pause();

 private:
  enum class State : std::uint8_t {
    ground,
    escape,          ///< behind Escape
    escape_was_key,  ///< behind an Escape that stood alone, perhaps on a slow line
    control,         ///< behind Escape [
    function,        ///< behind Escape [ [, the linux console's F1 to F5
    single_shift,    ///< behind Escape O
    string,          ///< up to BEL or Escape backslash: an answer of the terminal
  };
  std::optional<TerminalEvent> take_ground(unsigned char byte);
  std::optional<TerminalEvent> take_escape(unsigned char byte);
  std::optional<TerminalEvent> take_control(unsigned char byte);
  std::optional<TerminalEvent> take_in_sequence(unsigned char byte);
  std::optional<TerminalEvent> finish_control(char final);
  std::optional<TerminalEvent> take_high(unsigned char byte);
  std::optional<TerminalEvent> character(char32_t code);
  [[nodiscard]] bool is_stop(unsigned char byte) const;

  std::string_view stops_;
  Coding coding_;
  State state_ = State::ground;
  bool is_pasting_ = false;
  bool is_with_alt_ = false;  ///< the character that begins belongs to the Escape before it
  std::string begun_;         ///< bytes of a UTF-8 character
  std::string parameters_;    ///< of a control sequence
  Clock::time_point last_{};
};

}  // namespace cnclab::station
