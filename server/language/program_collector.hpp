// Makes programs out of the blocks that a reader finds: their order, numbers given twice, reserved numbers, and every
// error with its place. Private to this folder; tapes and listings share it.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string_view>
#include <vector>

#include "language/error_list.hpp"
#include "language/tape.hpp"

namespace cnclab::language {

class ProgramCollector {
 public:
  explicit ProgramCollector(Tongue tongue) : tongue_(tongue) {}

  [[nodiscard]] bool is_open() const { return is_open_; }
  [[nodiscard]] bool is_tool_table() const { return is_open_ && number_ == kToolTable; }
  /// "N001", in P0000 "T001": what a block begins with.
  [[nodiscard]] std::string_view head_example() const { return is_tool_table() ? "T001" : "N001"; }

  /// A program begins on `line`; the one before it ends.
  void open(std::uint16_t number, int line);
  /// The open program ends, if there is one. Without an error it is kept, in place of an earlier one of its number.
  void close();

  /// Room for a block of the open program, with its number; the caller fills it and then ends or drops it.
  [[nodiscard]] Block& begin_block(std::uint16_t number);
  void end_block(int line);
  /// `error` needs no program number.
  void drop_block(Error error);

  /// An error of the open program, which is not kept then; or of no program.
  void add_error(Error error);
  /// What stands before the first program's number: one error for all of it (D-102).
  void add_orphan(std::string_view found, int line);
  /// A program's number that cannot be read: what follows belongs to no program and is not reported again.
  void add_unreadable_head(int line);

  /// Machine data read without an error; they replace earlier ones.
  void put_machine_data(std::vector<MachineDatum> data) { tape_.machine_data = std::move(data); }

  /// Every error of the text, in its order.
  [[nodiscard]] ErrorList& errors() { return errors_; }

  /// Everything read. has_lower_case: the text is refused as a whole (DEC-30).
  [[nodiscard]] Tape finish(bool has_lower_case);

 private:
  void keep();
  [[nodiscard]] ReadProgram sorted() const;
  void note_dropped_errors();

  Tongue tongue_;
  Tape tape_;
  ErrorList errors_;
  std::uint16_t number_ = 0;  ///< the open program
  int line_of_program_ = 0;
  std::vector<Block> blocks_;  ///< its blocks; the memory is used again for the next program
  std::vector<int> lines_;     ///< the line of each
  std::bitset<kLastBlock + 1> seen_;
  bool is_open_ = false;
  bool is_bad_ = false;                                   ///< it has an error, so it is not kept
  bool is_known_orphan_ = false;                          ///< there is none, and the error has been noted
  std::array<std::uint16_t, kLastProgram + 1> places_{};  ///< of each program in tape_.programs plus 1
};

}  // namespace cnclab::language
