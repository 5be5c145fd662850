// Reading tapes and files: programs out of blocks, every error with its place, nothing lost silently.
#include "language/tape.hpp"

#include <algorithm>
#include <array>
#include <bitset>

#include "language/block_reader.hpp"
#include "language/tape_cursor.hpp"
#include "language/value_text.hpp"

namespace cnclab::language {

namespace {

class TapeReader {
 public:
  TapeReader(std::string_view text, Reading reading, Tongue tongue)
      : reading_(reading), tongue_(tongue), cursor_(text, reading, errors_), blocks_(cursor_) {}

  Tape read() {
    while (read_next()) {
    }
    close_program();
    if (cursor_.has_lower_case()) tape_.programs.clear();
    tape_.errors = std::move(errors_.errors);
    note_dropped_errors();
    return std::move(tape_);
  }

 private:
  /// One program head, block or mark. False at the end.
  bool read_next() {
    if (const auto program = blocks_.take_next_program()) open_program(*program);
    if (const auto start = blocks_.take_next_start()) {
      read_block_at(*start);
      return true;
    }
    switch (cursor_.current()) {
      case TapeCursor::kEnd:
        return false;
      case TapeCursor::kSeparator:
        cursor_.advance();  // the program may go on behind it (DEC-58)
        return true;
      case '%':
        close_program();
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
    if (const auto number = blocks_.read_digits(4)) {
      open_program(*number);
      line_of_program_ = line;
      return;
    }
    close_program();
    is_known_orphan_ = true;
    errors_.add({.code = ErrorCode::program_number_wrong, .word = 'P', .expected = "P0000..P9999", .line = line});
    blocks_.recover(false);
  }

  void read_block_head() {
    const int line = cursor_.line();
    if (!is_open_) {
      fail_without_program(line);
      return;
    }
    const std::string_view head = is_tool_table() ? "T001" : "N001";
    if (cursor_.current() != head.front()) {
      add_error({.code = ErrorCode::text_malformed,
                 .detail = std::string(1, cursor_.current()),
                 .expected = std::string(head),
                 .line = line});
      blocks_.recover(is_tool_table());
      return;
    }
    if (const auto start = blocks_.read_start()) {
      read_block_at(*start);
      return;
    }
    add_error(std::move(blocks_.fault()));
    blocks_.recover(is_tool_table());
  }

  void read_block_at(BlockStart start) {
    if (!is_open_) {
      fail_without_program(start.line);
      return;
    }
    Block& block = read_.program.blocks.emplace_back();
    block.number = start.number;
    if (!blocks_.read(block, is_tool_table())) {
      Error error = std::move(blocks_.fault());
      error.block = start.number;
      fail_block(std::move(error));
    } else if (seen_.test(start.number)) {
      read_.program.blocks.pop_back();
      add_error({.code = ErrorCode::block_number_wrong,
                 .block = start.number,
                 .word = 'N',
                 .detail = "2×",
                 .line = start.line});
    } else {
      seen_.set(start.number);
      read_.lines.push_back(start.line);
    }
  }

  void fail_block(Error error) {
    read_.program.blocks.pop_back();
    add_error(std::move(error));
    if (!blocks_.is_at_end_of_block()) blocks_.recover(is_tool_table());
  }

  /// Blocks before the first "P0001": one error for all of them (D-102).
  void fail_without_program(int line) {
    if (!is_known_orphan_)
      errors_.add({.code = ErrorCode::transfer_wrong,
                   .detail = std::string(cursor_.current() > ' ' ? 1 : 0, cursor_.current()),
                   .expected = "P0001N001",
                   .line = line});
    is_known_orphan_ = true;
    blocks_.recover(false);
  }

  void open_program(std::uint16_t number) {
    close_program();
    is_open_ = true;
    line_of_program_ = cursor_.line();
    read_.program.number = number;
  }

  void close_program() {
    if (is_open_) {
      if (read_.program.blocks.empty() && !is_bad_)
        add_error({.code = ErrorCode::transfer_wrong,
                   .expected = is_tool_table() ? "T001" : "N001",
                   .line = line_of_program_});
      if (is_reserved_for_cycles(read_.program.number))
        note_reserved();
      else if (!is_bad_)
        keep_program();
    }
    is_open_ = is_bad_ = is_known_orphan_ = false;
    read_ = {};
    seen_.reset();
  }

  void keep_program() {
    sort_blocks();
    std::uint16_t& place = places_[read_.program.number];
    if (place != 0) {
      tape_.programs[place - 1U] = std::move(read_);
    } else {
      tape_.programs.push_back(std::move(read_));
      place = static_cast<std::uint16_t>(tape_.programs.size());
    }
  }

  /// Ascending numbers (EDIT-032); tapes nearly always have them so.
  void sort_blocks() {
    std::vector<Block>& blocks = read_.program.blocks;
    if (std::ranges::is_sorted(blocks, {}, &Block::number)) return;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < blocks.size(); ++i) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return blocks[i].number; });
    ReadProgram sorted{.program = {.number = read_.program.number, .blocks = {}}, .lines = {}};
    for (const std::size_t i : order) {
      sorted.program.blocks.push_back(blocks[i]);
      sorted.lines.push_back(read_.lines[i]);
    }
    read_ = std::move(sorted);
  }

  void add_error(Error error) {
    is_bad_ = true;
    if (is_open_) error.program = read_.program.number;
    error.in_tool_table = is_tool_table();
    if (is_open_ && is_reserved_for_cycles(read_.program.number)) return;  // left out with a notice anyway
    errors_.add(std::move(error));
  }

  void note_reserved() {
    const Error reserved{.code = ErrorCode::reserved_for_cycles, .program = read_.program.number};
    if (tape_.notices.size() < kMostErrors) tape_.notices.push_back(explain(reserved, tongue_));
  }

  void note_dropped_errors() {
    if (errors_.dropped == 0) return;
    const std::string count = std::to_string(errors_.dropped);
    tape_.notices.push_back(tongue_ == Tongue::german ? count + " weitere Fehler sind nicht aufgeführt."
                                                      : count + " more errors are not listed.");
  }

  [[nodiscard]] bool is_tool_table() const { return is_open_ && read_.program.number == kToolTable; }

  Reading reading_;
  Tongue tongue_;
  ErrorList errors_;
  TapeCursor cursor_;
  BlockReader blocks_;
  Tape tape_;
  ReadProgram read_;              ///< the program that is being read
  bool is_open_ = false;          ///< there is one
  bool is_bad_ = false;           ///< it has an error, so it is not kept
  bool is_known_orphan_ = false;  ///< there is none, and the error has been noted
  int line_of_program_ = 0;
  std::bitset<kLastBlock + 1> seen_;                      ///< its block numbers
  std::array<std::uint16_t, kLastProgram + 1> places_{};  ///< of each program in tape_.programs plus 1
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
  if (cursor.current() != TapeCursor::kEnd || reader.has_next_start())
    return fault(
        {.code = ErrorCode::text_malformed, .detail = std::string(1, cursor.current()), .line = cursor.line()});
  return block;
}

}  // namespace cnclab::language
