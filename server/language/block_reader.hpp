// Reads one block from its function to its last word, and finds the next one after an error. Private to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "language/block.hpp"
#include "language/block_form.hpp"
#include "language/error.hpp"
#include "language/tape_cursor.hpp"

namespace cnclab::language {

/// A block's beginning, "N003", that has been read, and its line.
struct BlockStart {
  std::uint16_t number = 0;
  int line = 0;
};

class BlockReader {
 public:
  explicit BlockReader(TapeCursor& cursor) : cursor_(cursor) {}

  /// Reads "N003" (rows of P0000: "T003"); the cursor stands on the letter.
  [[nodiscard]] std::optional<BlockStart> read_start();

  /// Reads function and words into `block`, whose number is set; `is_tool` in P0000. On a fault: false, see `fault`.
  /// The beginning of the next block may have been read already: see `take_next_start`.
  [[nodiscard]] bool read(Block& block, bool is_tool);

  /// After a fault: the whole block has been read, so that nothing need be skipped.
  [[nodiscard]] bool is_at_end_of_block() const { return is_at_end_ || !has_read_block_alone(); }

  /// Goes on to the next beginning of a block or program, to a separator, "%" or the end.
  void recover(bool is_tool);

  /// Nothing of what follows has been read together with the block.
  [[nodiscard]] bool has_read_block_alone() const { return !next_start_ && !has_machine_data_mark_; }
  [[nodiscard]] std::optional<BlockStart> take_next_start() { return std::exchange(next_start_, std::nullopt); }
  /// A program's number that `recover` has read together with its first block's beginning.
  [[nodiscard]] std::optional<std::uint16_t> take_next_program() { return std::exchange(next_program_, std::nullopt); }

  /// The cursor stands on "M": reads it and, where it is "MD", the mark of the machine data. False for another M.
  [[nodiscard]] bool read_machine_data_mark();
  /// A mark "MD" has been read behind a block or by `recover`.
  [[nodiscard]] bool take_machine_data_mark() { return std::exchange(has_machine_data_mark_, false); }

  /// What was wrong with the last read; program and block are the caller's to fill in.
  [[nodiscard]] Error& fault() { return fault_; }

 private:
  struct Number {
    std::int64_t value = 0;  ///< never above kSaturated
    int digits = 0;
  };

  [[nodiscard]] bool read_function(Block& block, bool is_tool);
  [[nodiscard]] bool read_operands(Block& block, const BlockForm& form);
  [[nodiscard]] bool read_words(Block& block, bool is_tool);
  [[nodiscard]] bool ends_block(AddressSet missing, bool is_tool) const;
  [[nodiscard]] bool may_have(Function function, char c, AddressSet allowed, AddressSet found);
  [[nodiscard]] bool read_word(Block& block, Address address, bool is_tool);
  [[nodiscard]] bool read_parameter_number(Word& word);
  [[nodiscard]] bool read_length(Word& word);
  [[nodiscard]] bool read_decimals(std::int64_t& value_um);
  [[nodiscard]] bool read_plain_number(Word& word);
  [[nodiscard]] bool read_target(Word& word);
  [[nodiscard]] bool take_number(Word& word, std::int64_t value);
  [[nodiscard]] bool find_program();
  [[nodiscard]] bool find_start(bool is_tool);
  /// None of the planes has all the words of the block.
  [[nodiscard]] bool refuse_foreign_word(const Block& block, AddressSet found);
  [[nodiscard]] bool finish(Block& block, AddressSet found);
  [[nodiscard]] Number read_number();
  [[nodiscard]] bool starts_function() const { return cursor_.current() == 'G' || cursor_.current() == '\\'; }
  bool fail(ErrorCode code, char word, std::string detail = {}, std::string expected = {});

  TapeCursor& cursor_;
  std::optional<BlockStart> next_start_;
  std::optional<std::uint16_t> next_program_;
  bool has_machine_data_mark_ = false;
  int block_line_ = 0;
  int word_line_ = 0;
  bool is_at_end_ = false;
  Error fault_;
};

}  // namespace cnclab::language
