// A stored block: its number, its function and its words, exactly as keyed in.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <vector>

#include "language/units.hpp"

namespace cnclab::language {

/// Address letters (BLK-002). Two are ours: the operand and the value of a parametric function.
enum class Address : char {
  D = 'D',
  F = 'F',
  H = 'H',
  I = 'I',
  J = 'J',
  K = 'K',
  L = 'L',
  M = 'M',
  N = 'N',
  P = 'P',
  Q = 'Q',
  R = 'R',
  S = 'S',
  T = 'T',
  U = 'U',
  V = 'V',
  W = 'W',
  X = 'X',
  Y = 'Y',
  Z = 'Z',
  operand = '#',  ///< #nn of a parametric function, in the order of its line (first the target); a plain number
  value = '=',    ///< the value of ↓00
};

[[nodiscard]] constexpr char letter(Address address) { return static_cast<char>(address); }

/// The content of a word: a number in the word's own unit, or a parameter that is read at execution (PAR-004).
///
/// Unit of `number` by address (see `WordFormat`): µm for X Y Z I J K U R L Q and `value`; mm for V; mm/min for F;
/// rev/min for S; tenths of a second for H; degrees for D; plain for M N P T W and operands.
struct Word {
  Address address{};
  bool is_parameter = false;
  std::int32_t number = 0;  ///< parameter number 0..69 when `is_parameter`; 32 bits keep a word at 8 bytes
  friend bool operator==(const Word&, const Word&) = default;
};

/// What a block does: a G function, a parametric function (↓), or a row of the tool table P0000.
struct Function {
  enum class Kind : std::uint8_t { g, parametric, tool };
  Kind kind = Kind::g;
  std::uint8_t code = 0;
  friend bool operator==(const Function&, const Function&) = default;
};

/// No function has more, in all its planes together (G05: X Y Z R F S T M).
inline constexpr std::size_t kMostWords = 8;
using Words = boost::container::static_vector<Word, kMostWords>;

struct Block {
  std::uint16_t number = 0;  ///< N001..N999; T001..T099 in P0000
  Function function;
  Words words = {};         ///< only those that have a value, in the order of the block form
  bool is_damaged = false;  ///< its check code did not fit when it was read (STO-003); never executed

  [[nodiscard]] const Word* find(Address address) const {
    for (const Word& word : words)
      if (word.address == address) return &word;
    return nullptr;
  }
  friend bool operator==(const Block&, const Block&) = default;
};

static_assert(sizeof(Block) <= 88, "100 000 blocks are to fit into 9 MB");

/// A program: blocks in ascending order of their numbers, which may have gaps (EDIT-032). P0000 is the tool table.
struct Program {
  std::uint16_t number = 0;
  std::vector<Block> blocks = {};

  /// Position of block `n` in `blocks`, or nothing.
  [[nodiscard]] std::optional<std::size_t> find(std::uint16_t n) const;
  friend bool operator==(const Program&, const Program&) = default;
};

inline constexpr std::uint16_t kToolTable = 0;
inline constexpr std::uint16_t kLastBlock = 999;
inline constexpr std::uint16_t kLastProgram = 9999;

[[nodiscard]] constexpr bool is_reserved_for_cycles(int program) { return program >= 9981 && program <= 9989; }

}  // namespace cnclab::language
