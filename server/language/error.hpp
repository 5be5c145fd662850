// Every way in which a program can be wrong: one table gives monitor text, explanation and remedy in both languages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "language/units.hpp"

namespace cnclab::language {

/// What was wrong. The monitor text of each is the manual's where it has one, else an own one (DEC-02, DEC-50).
enum class ErrorCode : std::uint8_t {
  function_unknown,         ///< Funktion nicht vorgesehen (ERR-001)
  word_missing,             ///< Satz überprüfen: block incomplete (ERR-002)
  word_out_of_range,        ///< Satz überprüfen: above the machine data or the format (ERR-003)
  word_not_allowed,         ///< a word that this function does not have (tape, files)
  program_missing,          ///< Programm fehlt
  block_missing,            ///< Satz fehlt: jump target, start block, SATZ SUCHEN
  memory_full,              ///< Speicher voll (DEC-07)
  nesting_too_deep,         ///< Zu tief verschachtelt: 16 levels, of whatever programs (D-58)
  feed_missing,             ///< F fehlt: a way or arc while F0000 is active (D-59)
  plane_wrong,              ///< Falsche Ebene (D-54, D-69, DEC-64)
  arc_wrong,                ///< Kreis falsch (D-55, D-65, D-66)
  radius_too_small,         ///< the same: R of G05, G06 is less than half the way (D-66)
  arc_without_way,          ///< the same: G05, G06 end where they begin
  compensation_impossible,  ///< Korrektur nicht moeglich: not while a compensation is active (D-64)
  arc_at_entry_or_exit,     ///< the same: a compensated contour is entered and left on lines (D-71)
  offset_not_left,          ///< the same: compensation is off, the tool still stands in its offset (D-64)
  arc_under_axis_offset,    ///< the same: an arc where G43 or G44 shift an axis of its plane (D-72)
  inside_arc_too_small,     ///< the same: the tool does not fit into an inside arc (D-71)
  no_intersection,          ///< the same: the paths of two elements do not meet at an inside corner (D-71)
  runs_backwards,           ///< the same: an element would be run against its direction (DEC-09)
  too_close,                ///< the same: the path cuts into another block's element, `detail` names it (DEC-09)
  entry_too_close,          ///< the same, on the way that enters a contour: a wall is crossed or brushed (COMP-007)
  exit_too_close,           ///< the same, on the way that leaves it
  contour_unchecked,        ///< the same: on the lab machine a contour that depends on Input 1 (DEC-09)
  rounding_without_lines,   ///< Kreis falsch: G10 not between two lines of the plane (D-66)
  rounding_too_large,       ///< Kreis falsch: the radius of G10 does not fit into both lines (D-66)
  rounding_way_back,        ///< the same: the second line leads back over the first
  scale_not_allowed,        ///< Skalenfaktor unzulaessig (D-68)
  scale_unequal,            ///< the same: an arc while the factors of its plane differ in size
  m_unknown,                ///< M nicht vorgesehen (D-51)
  cycle_value_wrong,        ///< Zykluswert falsch (D-85, D-89)
  parameter_read_only,      ///< Parameter nur lesbar (D-93)
  transfer_wrong,           ///< Uebertragung falsch (D-100, D-102)
  reserved_for_cycles,      ///< Reserviert fuer Zyklen: P9981..P9989 (DEC-06)
  checksum_wrong,           ///< CHECKSUM FEHLER (ERR-004)
  feed_above_limit,         ///< Satz überprüfen: F above F MAX at execution
  travel_exceeded,          ///< the lab machine's travel (DEC-27, AUTH-011)
  tool_not_listed,          ///< the lab machine's tool list has no such tool (DEC-29)
  tool_differs,             ///< R or L of P0000 is not that of the list (DEC-29)
  block_number_wrong,       ///< outside 001..999, twice, or no room behind N999 (D-47)
  program_number_wrong,     ///< outside 0000..9999
  program_empty,            ///< a number and no block behind it (tape, files)
  text_malformed,           ///< a character or number that is no word (tape, files)
  machine_datum_wrong,      ///< a recording's machine data: not N03=500000 (DEC-62)
  lower_case,               ///< a file with small letters outside comments (DEC-30)
  helix_too_steep,          ///< G07, G08: Z has as many steps as X and Y together, or more (D-65)
  plane_locked,             ///< G17 to G19 under G41 to G44, G46 (D-69)
};

/// The last of the codes, so that a table can be checked for completeness.
inline constexpr ErrorCode kLastErrorCode = ErrorCode::plane_locked;

/// One error with its place. `word` is the address letter, 0 where no word is to blame.
struct Error {
  ErrorCode code{};
  std::uint16_t program = 0;
  std::uint16_t block = 0;
  char word = 0;
  std::string detail = {};     ///< what was found, e.g. "4000"; may be empty
  std::string expected = {};   ///< what would be right, e.g. "0001..3000"; may be empty
  int line = 0;                ///< line of the file, from 1; 0 where there is none
  bool in_tool_table = false;  ///< `block` is a row of P0000: T001 instead of N001
  friend bool operator==(const Error&, const Error&) = default;
};

/// The short text on the 64×16 monitor, exactly as the manual prints it where it does.
[[nodiscard]] std::string_view monitor_text(ErrorCode code, Tongue tongue);

/// A full sentence for row 18 and logs: block, word, value, limit and what to do. It is `place_of`, ": " and
/// `message_of`; where program and block are unknown only the latter.
[[nodiscard]] std::string explain(const Error& error, Tongue tongue);

/// The same without the place, for those who print the place themselves (`check`: FILE:LINE: P0001 N003: message).
[[nodiscard]] std::string message_of(const Error& error, Tongue tongue);

/// "P0001 N003" as far as known; empty where neither is.
[[nodiscard]] std::string place_of(const Error& error);

}  // namespace cnclab::language
