// Feeds any bytes to the tape reader: it must come to an end without harm, and what it has read must come back equal
// when it is written and read again, as a tape and as a listing. Every other reader and printer of a block sees the
// result too.
#include <cstdint>
#include <string>
#include <string_view>

#include "language/check_block.hpp"
#include "language/listing.hpp"
#include "language/program_text.hpp"
#include "language/screen_form.hpp"
#include "language/tape.hpp"
#include "tape_checks.hpp"

namespace language = cnclab::language;
using cnclab::fuzz::check_errors;
using cnclab::fuzz::require;
using cnclab::fuzz::require_same_programs;

namespace {

void check_stored_blocks(const language::Program& program) {
  for (const language::Block& block : program.blocks) {
    const auto read = language::read_block(language::write_block(block), program.number);
    require(read.has_value() && *read == block);
    require(language::cost_bytes(block) >= 4);
    require(!language::block_line(block, language::Plane::xy, language::Tongue::german).empty());
  }
  static_cast<void>(language::check_program(program, {}, nullptr));
}

/// Programs and machine data as one recording.
std::string written_form(const language::Tape& tape) {
  std::string text;
  for (const language::ReadProgram& read : tape.programs) text += language::write_program(read.program);
  return text + language::write_machine_data(tape.machine_data);
}

void check_listing(const language::Tape& tape) {
  std::string listing;
  for (const language::ReadProgram& read : tape.programs)
    listing += language::write_listing(read.program, "09:00:00 16/06/83", language::Tongue::german);
  require_same_programs(tape, language::read_listing(listing));
  require_same_programs(tape, language::read_programs_text(listing, language::Reading::file));
}

void check_round_trip(std::string_view text, language::Reading reading) {
  const language::Tape first = language::read_tape(text, reading);
  check_errors(first);
  for (const language::ReadProgram& read : first.programs) {
    check_stored_blocks(read.program);
    require(read.lines.size() == read.program.blocks.size());
  }
  const std::string written = written_form(first);
  const language::Tape second = language::read_tape(written, reading);
  require_same_programs(first, second);
  require(written_form(second) == written);
  check_listing(first);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check_round_trip(text, language::Reading::file);
  check_round_trip(text, language::Reading::strict);
  static_cast<void>(language::read_block(text, 1));
  static_cast<void>(language::read_block(text, language::kToolTable));
  return 0;
}
