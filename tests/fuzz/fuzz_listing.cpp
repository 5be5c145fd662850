// Feeds any bytes to the reader of printed listings: it must come to an end without harm, and what it has read must
// come back equal when it is printed and read again, and as a tape where no block is damaged.
#include <cstdint>
#include <string>
#include <string_view>

#include "language/check_block.hpp"
#include "language/listing.hpp"
#include "language/program_text.hpp"
#include "tape_checks.hpp"

namespace language = cnclab::language;
using cnclab::fuzz::check_errors;
using cnclab::fuzz::require;
using cnclab::fuzz::require_same_programs;

namespace {

constexpr std::string_view kTime = "09:00:00 16/06/83";

std::string printed(const language::Tape& tape, language::Tongue tongue) {
  std::string text;
  for (const language::ReadProgram& read : tape.programs) text += language::write_listing(read.program, kTime, tongue);
  return text;
}

/// A tape has no mark for damaged blocks.
void check_tape_form(const language::Tape& tape) {
  for (const language::ReadProgram& read : tape.programs) {
    language::Program program = read.program;
    for (language::Block& block : program.blocks) block.is_damaged = false;
    const language::Tape again = language::read_tape(language::write_program(program), language::Reading::file);
    require(again.errors.empty() && again.programs.size() == 1 && again.programs[0].program == program);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const language::Tape tape = language::read_listing(text);
  check_errors(tape);
  for (const language::Tongue tongue : {language::Tongue::german, language::Tongue::english}) {
    const std::string listing = printed(tape, tongue);
    const language::Tape again = language::read_listing(listing);
    require_same_programs(tape, again);
    require(printed(again, tongue) == listing);
    require_same_programs(tape, language::read_programs_text(listing, language::Reading::file));
  }
  check_tape_form(tape);
  for (const language::ReadProgram& read : tape.programs)
    static_cast<void>(language::check_program(read.program, {}, nullptr));
  check_errors(language::read_programs_text(text, language::Reading::file));
  return 0;
}
