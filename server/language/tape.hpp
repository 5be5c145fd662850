// The tape format (section EXT, EX-050): how programs leave and enter the control, and how blocks are stored on disk.
//
//   tape     = program { separator program } [ machine ] [ "%" ]
//   program  = "P" 4digit block { block }
//   block    = "N" 3digit ( "G" 2digit | "\" 2digit ) { word }        in P0000: "T" 3digit { word }
//   word     = letter [ "+" | "-" ] digits [ "." digits ]             mm words: integer 1/1000 mm, or mm with a point
//            | letter "#" 2digit                                      a parameter in place of the number
//   operands = "#" 2digit …                                           N002\01#01#02#03, N005\00#00+0, N033\51N040
//   machine  = "MD" datum { datum }                                   only in recordings of a whole memory (DEC-34)
//   datum    = "N" 2digit "=" digits                                  N03=500000; 01 and 02 are not stored (DEC-62)
//
// P and N have all their digits, since programs and blocks begin with the same letters: in G20 to G23 and the jumps
// they are words as long as the block has none yet, and "N" with three digits and a function behind it always begins a
// block. Words may stand in any order; other numbers may have fewer digits than they are written with.
//
// Characters below 21H and above 5FH are ignored by the control (EXT-049). Files may break lines anywhere and carry
// comments in ( ); see DEC-30 to DEC-32. Example: P0001N001G00X+12Y-1500000Z+4150N999G01Z+500M05%
#pragma once

#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "language/block.hpp"
#include "language/error.hpp"

namespace cnclab::language {

/// One block without its program number, e.g. "N003G01X+25000Y+10000Z+4000F1000M03". This is also the stored form.
[[nodiscard]] std::string write_block(const Block& block);

/// Reads what `write_block` writes. `program` says whether a tool row is expected (P0000).
[[nodiscard]] std::expected<Block, Error> read_block(std::string_view text, std::uint16_t program);

/// "P0001" and its blocks, one per line, without "%".
[[nodiscard]] std::string write_program(const Program& program);

/// One machine datum as a recording holds it: what the number means and which values are right is the machine's.
struct MachineDatum {
  std::uint16_t number = 0;  ///< 3..99
  std::int64_t value = 0;    ///< 0..9 999 999, in the datum's own unit
  int line = 0;              ///< of the file it was read from; without meaning when written
};

/// "MD" and its data, one per line; nothing where there are none.
[[nodiscard]] std::string write_machine_data(std::span<const MachineDatum> data);

/// How forgiving a reader is.
enum class Reading : std::uint8_t {
  file,    ///< comments allowed, small letters refused with a hint (DEC-30)
  strict,  ///< as the control: small letters ignored
};

/// A block with the line of the file it began on.
struct ReadProgram {
  Program program;
  std::vector<int> lines;  ///< of each block
};

/// What a tape held: all programs that could be read, and every error (not only the first).
struct Tape {
  std::vector<ReadProgram> programs;
  /// What could be read of programs with an error, for those who look for more of them: the blocks without one.
  std::vector<ReadProgram> faulty_programs;
  std::vector<MachineDatum> machine_data;  ///< of a whole memory's recording; else none
  std::vector<Error> errors;
  std::vector<std::string> notices;  ///< e.g. P9981 left out (DEC-06)
};

/// Reads a tape or a file of the cnc3300 dialect. A program of the same number again replaces the earlier one.
///
/// A program with an error is not among the programs, machine data with one are not there at all; a file with small
/// letters gives none at all (DEC-30). At most 1000 errors are listed, a notice gives the number of the others. Time
/// and memory are linear in the text's length. Words are checked for their form only (D-46, DEC-13): completeness and
/// limits are `check_program`'s.
///
/// tongue      of the notices
[[nodiscard]] Tape read_tape(std::string_view text, Reading reading, Tongue tongue = Tongue::german);

/// The check code appended to every stored block (SYS-018): CRC-32 (IEEE 802.3) of "P0001" and its stored form.
[[nodiscard]] std::uint32_t check_code(std::uint16_t program, std::string_view stored_block);

/// That of a stored machine datum (ERR-014), the same over "P0000" and "03=500000". `value` is in the datum's own unit.
[[nodiscard]] std::uint32_t datum_check_code(int number, std::int64_t value);

}  // namespace cnclab::language
