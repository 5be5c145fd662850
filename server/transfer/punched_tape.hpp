// What leaves on tape, line and diskette: programs as text, and the same text as rows of holes.
//
//   row    = 8 holes: ISO 7-bit code and even parity (D-103)
//   tape   = leader text trailer                leader and trailer: 100 rows of NUL, 254 mm of feed holes only
//   text   = program { NUL×6 program } "%"      a block per line, lines end with CR LF, which every reader ignores
//
// A diskette file, and the ".txt" twin of a tape, is the same text as people read it: without NUL, lines end with LF.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "language/block.hpp"

namespace cnclab::transfer {

/// A file that claims to be a tape or a diskette is read up to here, the size of a cassette.
inline constexpr std::size_t kLargestFile = 1'048'576;

/// Text of the line and of tapes: "P0001\r\nN001G00X+12\r\n" NUL×6 "P0002…%". Machine data are not among it (D-111).
[[nodiscard]] std::string line_text(std::span<const language::Program> programs);

/// A diskette file: all programs one after another, the machine data section (language::write_machine_data; empty
/// where there is none) behind them, "%" (DEC-34).
[[nodiscard]] std::string disk_text(std::span<const language::Program> programs, std::string_view machine_data = {});

/// `text` of 7-bit characters as a punched tape. Others have no hole pattern and are left out.
[[nodiscard]] std::string punch(std::string_view text);

/// What a tape reader passes on: all rows with bit 8 masked, leader and trailer cut off. Whatever the bytes are, the
/// result is 7-bit text that `language::read_tape` can judge. A tape longer than kLargestFile ends there.
[[nodiscard]] std::string read_punched(std::string_view rows);

/// A tape as text to look at: one block per line, runs of NUL as an empty line; read again it gives the same programs.
[[nodiscard]] std::string twin_text(std::string_view rows);

}  // namespace cnclab::transfer
