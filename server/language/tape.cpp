// Reading tapes and files: programs out of blocks, every error with its place, nothing lost silently.
#include "language/tape.hpp"

#include "language/block_reader.hpp"
#include "language/machine_data_section.hpp"
#include "language/program_collector.hpp"
#include "language/tape_cursor.hpp"

namespace cnclab::language {

namespace {

class TapeReader {
 public:
  TapeReader(std::string_view text, Reading reading, Tongue tongue)
      : reading_(reading), programs_(tongue), cursor_(text, reading, programs_.errors()), blocks_(cursor_) {}

  Tape read() {
    while (read_next()) {
    }
    return programs_.finish(cursor_.has_lower_case());
  }

 private:
  /// One program head, block, mark or section. False at the end.
  bool read_next() {
    if (const auto program = blocks_.take_next_program()) programs_.open(*program, cursor_.line());
    if (const auto start = blocks_.take_next_start()) {
      read_block_at(*start);
      return true;
    }
    if (blocks_.take_machine_data_mark()) {
      read_machine_data(cursor_, programs_);
      return true;
    }
    switch (cursor_.current()) {
      case TapeCursor::kEnd:
        return false;
      case TapeCursor::kSeparator:
        cursor_.advance();  // the program may go on behind it (DEC-58)
        return true;
      case '%':
        programs_.close();
        cursor_.advance();
        return reading_ == Reading::file;  // a transmission ends here, a file may go on (EXT-055)
      case 'P':
        read_program_head();
        return true;
      default:
        read_block_head();
        return true;
    }
  }

  void read_program_head() {
    const int line = cursor_.line();
    cursor_.advance();
    if (const auto number = cursor_.read_digits(4)) {
      programs_.open(*number, line);
      return;
    }
    programs_.add_unreadable_head(line);
    blocks_.recover(false);
  }

  void read_block_head() {
    const int line = cursor_.line();
    const char found = cursor_.current();
    if (found == 'M' && blocks_.read_machine_data_mark()) return;
    if (!programs_.is_open()) {
      fail_without_program(line, found);
      return;
    }
    const std::string_view head = programs_.head_example();
    if (found != head.front()) {
      programs_.add_error({.code = ErrorCode::text_malformed,
                           .detail = std::string(1, found),
                           .expected = std::string(head),
                           .line = line});
      blocks_.recover(programs_.is_tool_table());
      return;
    }
    if (const auto start = blocks_.read_start()) {
      read_block_at(*start);
      return;
    }
    programs_.add_error(std::move(blocks_.fault()));
    blocks_.recover(programs_.is_tool_table());
  }

  void read_block_at(BlockStart start) {
    if (!programs_.is_open()) {
      fail_without_program(start.line, cursor_.current());
      return;
    }
    if (blocks_.read(programs_.begin_block(start.number), programs_.is_tool_table())) {
      programs_.end_block(start.line);
      return;
    }
    programs_.drop_block(std::move(blocks_.fault()));
    if (!blocks_.is_at_end_of_block()) blocks_.recover(programs_.is_tool_table());
  }

  /// Blocks before the first "P0001".
  void fail_without_program(int line, char found) {
    programs_.add_orphan(found > ' ' ? std::string_view(&found, 1) : std::string_view{}, line);
    blocks_.recover(false);
  }

  Reading reading_;
  ProgramCollector programs_;
  TapeCursor cursor_;
  BlockReader blocks_;
};

}  // namespace

Tape read_tape(std::string_view text, Reading reading, Tongue tongue) {
  return TapeReader(text, reading, tongue).read();
}

std::expected<Block, Error> read_block(std::string_view text, std::uint16_t program) {
  ErrorList errors;
  TapeCursor cursor(text, Reading::file, errors);
  BlockReader reader(cursor);
  const bool is_tool = program == kToolTable;
  Block block;
  const auto fault = [&](Error error) {
    error.program = program;
    error.block = block.number;
    error.in_tool_table = is_tool;
    return std::unexpected(std::move(error));
  };
  if (cursor.current() != (is_tool ? 'T' : 'N'))
    return fault({.code = ErrorCode::text_malformed, .expected = is_tool ? "T001" : "N001", .line = cursor.line()});
  const auto start = reader.read_start();
  if (!start) return fault(std::move(reader.fault()));
  block.number = start->number;
  if (!reader.read(block, is_tool)) return fault(std::move(reader.fault()));
  if (!errors.errors.empty()) return fault(std::move(errors.errors.front()));
  if (cursor.current() != TapeCursor::kEnd || !reader.has_read_block_alone())
    return fault(
        {.code = ErrorCode::text_malformed, .detail = std::string(1, cursor.current()), .line = cursor.line()});
  return block;
}

}  // namespace cnclab::language
