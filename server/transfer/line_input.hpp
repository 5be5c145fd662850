// What the control makes of received characters, one after another: the rules of section EXT without time and line.
//
//   transmission = text NUL | text "%"         text begins with PxxxxNxxx, P0000Txxx, MDN, or Nxxx where it may go on
//                | PxxxxNxxx "*" | "#" | "!"    only under REMOTE
//
// Rules
//  1. Bit 8 is masked (D-103). NUL before the first character is skipped (EXT-047); characters below 21H and above 5FH
//     are ignored everywhere (EXT-049), so that they do not begin a transmission either.
//  2. At most 4096 characters are kept (EXT-048); one more is an overflow (D-100).
//  3. The first nine characters are program and block number (EXT-051); a character that breaks the rule is rejected at
//     once. Nxxx continues the program of the last transmission: under REMOTE, or in the same reading (DEC-58).
//  4. "#" and "!" are commands only as the first character (D-97), "*" only behind the ninth (EXT-060).
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "transfer/time.hpp"

namespace cnclab::transfer {

inline constexpr std::size_t kLineBuffer = 4096;  ///< 1000H

/// A part of the tape format came to its end.
///
/// `text` is empty where "%" follows a separator: nothing to store, the transmission is over. Machine data ("MDN…") are
/// no continuation and say nothing of `program`.
struct TextReceived {
  std::uint16_t program = 0;     ///< the one it begins with, or goes on with
  bool is_continuation = false;  ///< began with Nxxx: its blocks join those of `program` (EXT-061)
  bool is_last = false;          ///< ended by "%", not by NUL
  std::string text{};            ///< as `language::read_tape` takes it; a continuation has its "Pxxxx" put before it
};
struct StartReceived {
  std::uint16_t program = 0, block = 0;
  Time came{};  ///< when its last character had arrived; set by the line
};  ///< PxxxxNxxx*
struct EraseReceived {};  ///< #
struct StatusQuery {};    ///< !
/// Against the rules: nothing of the transmission is kept.
enum class LineFault : std::uint8_t {
  beginning_wrong,  ///< not PxxxxNxxx (D-102)
  overflow,         ///< the 4097th character (D-100)
};
using Received = std::variant<std::monostate, TextReceived, StartReceived, EraseReceived, StatusQuery, LineFault>;

class LineInput {
 public:
  /// remote     commands are understood
  /// program    what Nxxx goes on with, as long as nothing was transmitted; -1: nothing, Nxxx is wrong
  LineInput(bool remote, int program) : is_remote_(remote), program_(program) {}

  /// The next character of the line. Anything but std::monostate ends a transmission; the next one begins behind it.
  [[nodiscard]] Received take(char byte);
  /// Forgets the beginning of a transmission.
  void forget() { buffer_.clear(); }
  /// Has a transmission begun?
  [[nodiscard]] bool has_begun() const { return !buffer_.empty(); }
  void set_program(int program) { program_ = program; }

 private:
  [[nodiscard]] Received take_character(char c);
  [[nodiscard]] Received take_end(char c);
  [[nodiscard]] bool begins_well() const;

  bool is_remote_;
  int program_;
  std::string buffer_;
};

}  // namespace cnclab::transfer
