// Reading a block in one pass, without look-ahead buffer and without allocation as long as nothing is wrong.
//
//   A block ends where a letter stands that it cannot have any more: N, P, "%", a separator, the end (in P0000 also T).
//   G20 to G23 and the jumps have words N and P themselves. There "N" and three digits are the next block's beginning
//   exactly when a function follows, since behind a target none can stand.
//   "M" is a word or, before a "D", the mark of the machine data.
#include "language/block_reader.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "language/value_text.hpp"

namespace cnclab::language {

namespace {

constexpr std::int64_t kSaturated = 1'000'000'000'000;  // far above every word, far below overflow
constexpr int kMostDecimals = 3;                        // BLK-005
constexpr int kHighestParameter = 69;                   // BLK-016

bool is_number(std::uint16_t number, bool is_tool) { return number >= 1 && number <= (is_tool ? 99 : kLastBlock); }

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

std::string code_text(Function function) {
  std::string text(function.kind == Function::Kind::parametric ? "\\" : "G");
  append_digits(text, function.code, 2);
  return text;
}

/// "X Y Z F": what a function may have, in the order of its form.
std::string letters_of(Function function, Plane plane) {
  std::string text;
  const BlockForm* form = find_form(function, plane, {});
  if (form == nullptr) return text;
  for (const Address address : form->words) {
    if (!text.empty()) text += ' ';
    text += letter(address);
  }
  return text;
}

/// Puts the words into the order of the form; on tapes they nearly always are.
void sort_words(Block& block, const BlockForm& form) {
  const auto place = [&](const Word& word) { return std::ranges::find(form.words, word.address); };
  const auto is_before = [&](const Word& a, const Word& b) { return place(a) < place(b); };
  if (!std::ranges::is_sorted(block.words, is_before)) std::ranges::sort(block.words, is_before);
}

}  // namespace

bool BlockReader::fail(ErrorCode code, char word, std::string detail, std::string expected) {
  if (code == ErrorCode::word_missing) word_line_ = block_line_;  // the cursor may stand on a line further down
  fault_ = {
      .code = code, .word = word, .detail = std::move(detail), .expected = std::move(expected), .line = word_line_};
  return false;
}

BlockReader::Number BlockReader::read_number() {
  Number number;
  for (; cursor_.is_digit(); cursor_.advance()) {
    number.value = std::min(number.value * 10 + (cursor_.current() - '0'), kSaturated);
    number.digits = std::min(number.digits + 1, kMostDecimals + 1);
  }
  return number;
}

std::optional<BlockStart> BlockReader::read_start() {
  const char letter_of_block = cursor_.current();
  word_line_ = cursor_.line();
  cursor_.advance();
  const auto number = cursor_.read_digits(3);
  if (!number || !is_number(*number, letter_of_block == 'T')) {
    std::string found;
    if (number) append_digits(found, *number, 3);
    fail(ErrorCode::block_number_wrong, letter_of_block, std::move(found),
         letter_of_block == 'T' ? "T001..T099" : "N001..N999");
    return std::nullopt;
  }
  return BlockStart{*number, word_line_};
}

bool BlockReader::read(Block& block, bool is_tool) {
  is_at_end_ = false;
  block_line_ = cursor_.line();
  if (!read_function(block, is_tool)) return false;
  return read_words(block, is_tool);
}

bool BlockReader::read_function(Block& block, bool is_tool) {
  if (is_tool) {
    block.function = {Function::Kind::tool, 0};
    return true;
  }
  word_line_ = cursor_.line();
  if (!starts_function()) {
    return fail(ErrorCode::word_missing, 'G', "", "G00..G91");
  }
  const auto kind = cursor_.current() == 'G' ? Function::Kind::g : Function::Kind::parametric;
  cursor_.advance();
  const auto code = cursor_.read_digits(2);
  if (!code) return fail(ErrorCode::text_malformed, 'G', "", kind == Function::Kind::g ? "G00..G91" : "\\00..\\54");
  block.function = {kind, static_cast<std::uint8_t>(*code)};
  if (find_form(block.function, Plane::xy, {}) == nullptr)
    return fail(ErrorCode::function_unknown, 'G', code_text(block.function));
  return true;
}

bool BlockReader::ends_block(AddressSet missing, bool is_tool) const {
  switch (cursor_.current()) {
    case TapeCursor::kEnd:
    case TapeCursor::kSeparator:
    case '%':
      return true;
    case 'N':
      return (missing & bit_of(Address::N)) == 0;
    case 'P':
      return (missing & bit_of(Address::P)) == 0;
    case 'T':
      return is_tool;
    default:
      return false;
  }
}

bool BlockReader::read_words(Block& block, bool is_tool) {
  const AddressSet allowed = addresses_in_any_plane(block.function);
  if ((allowed & bit_of(Address::operand)) != 0) return read_operands(block, *find_form(block.function, Plane::xy, {}));
  AddressSet found = 0;
  while (has_read_block_alone() && !ends_block(allowed & ~found, is_tool)) {
    const char c = cursor_.current();
    word_line_ = cursor_.line();
    if (c == 'M') {
      if (read_machine_data_mark()) break;
    } else {
      cursor_.advance();
    }
    if (!may_have(block.function, c, allowed, found)) return false;
    const auto address = static_cast<Address>(c);
    if (!read_word(block, address, is_tool)) return false;
    if (!next_start_) found |= bit_of(address);
  }
  return finish(block, found);
}

bool BlockReader::may_have(Function function, char c, AddressSet allowed, AddressSet found) {
  if (!is_letter(c)) return fail(ErrorCode::text_malformed, 0, std::string(1, c));
  const AddressSet bit = bit_of(static_cast<Address>(c));
  if ((allowed & bit) == 0) return fail(ErrorCode::word_not_allowed, c, "", letters_of(function, Plane::xy));
  if ((found & bit) != 0) return fail(ErrorCode::word_not_allowed, c, "2×");
  return true;
}

bool BlockReader::read_machine_data_mark() {
  cursor_.advance();
  if (cursor_.current() != 'D') return false;
  cursor_.advance();
  has_machine_data_mark_ = true;
  return true;
}

/// The plane is the one that leaves the fewest words over; the first of these is to blame.
bool BlockReader::refuse_foreign_word(const Block& block, AddressSet found) {
  constexpr std::array kPlanes{Plane::xy, Plane::xz, Plane::yz};
  const auto foreign = [&](Plane plane) {
    const BlockForm* form = find_form(block.function, plane, {});
    return form == nullptr ? found : static_cast<AddressSet>(found & ~addresses_of(*form));
  };
  const Plane plane = *std::ranges::min_element(kPlanes, {}, [&](Plane it) { return std::popcount(foreign(it)); });
  const auto word =
      std::ranges::find_if(block.words, [&](const Word& it) { return (foreign(plane) & bit_of(it.address)) != 0; });
  return fail(ErrorCode::word_not_allowed, letter(word->address), "", letters_of(block.function, plane));
}

bool BlockReader::finish(Block& block, AddressSet found) {
  is_at_end_ = true;
  const Plane plane = plane_of_words(block.function, found, Plane::xy);
  const BlockForm& form = *find_form(block.function, plane, {});
  if ((found & ~addresses_of(form)) != 0) return refuse_foreign_word(block, found);
  // A jump without its target cannot be told from the next block's beginning, so it is no readable block.
  for (const Address address : {Address::P, Address::N})
    if ((addresses_of(form) & ~found & bit_of(address)) != 0) return fail(ErrorCode::word_missing, letter(address));
  if (found != 0) sort_words(block, form);
  return true;
}

bool BlockReader::read_operands(Block& block, const BlockForm& form) {
  for (const Address address : form.words) {
    Word word{.address = address};
    word_line_ = cursor_.line();
    if (address == Address::operand) {
      if (cursor_.current() != '#') return fail(ErrorCode::word_missing, '#');
      if (!read_parameter_number(word)) return false;
    } else if (cursor_.current() != '+' && cursor_.current() != '-' && cursor_.current() != '.' &&
               !cursor_.is_digit()) {
      return fail(ErrorCode::word_missing, '=');
    } else if (!read_length(word)) {
      return false;
    }
    word.is_parameter = false;  // an operand's number is the parameter itself, not a value read through it
    block.words.push_back(word);
  }
  if (ends_block(0, false)) return true;
  word_line_ = cursor_.line();
  const char c = cursor_.current();
  if (c == 'M' && read_machine_data_mark()) return true;
  return fail(ErrorCode::word_not_allowed, c);
}

bool BlockReader::read_word(Block& block, Address address, bool is_tool) {
  Word word{.address = address};
  const WordFormat& format = format_of(address);
  if (cursor_.current() == '#') {
    if (!format.takes_parameter || is_tool) return fail(ErrorCode::word_not_allowed, letter(address), "#");
    if (!read_parameter_number(word)) return false;
  } else if (format.kind == WordFormat::Kind::millimetres) {
    if (!read_length(word)) return false;
  } else if (address == Address::N || address == Address::P) {
    if (!read_target(word)) return false;
    if (next_start_) return true;
  } else if (!read_plain_number(word)) {
    return false;
  }
  block.words.push_back(word);
  return true;
}

/// "#04": two digits, 00 to 69.
bool BlockReader::read_parameter_number(Word& word) {
  cursor_.advance();
  const auto number = cursor_.read_digits(2);
  if (!number) return fail(ErrorCode::text_malformed, letter(word.address), "#", "#00..#69");
  if (*number > kHighestParameter) {
    std::string found = "#";
    append_digits(found, *number, 2);
    return fail(ErrorCode::word_out_of_range, letter(word.address), std::move(found), "#00..#69");
  }
  word.is_parameter = true;
  word.number = *number;
  return true;
}

/// Integer 1/1000 mm, or mm with a decimal point (D-101).
bool BlockReader::read_length(Word& word) {
  const bool is_negative = cursor_.current() == '-';
  if (is_negative || cursor_.current() == '+') cursor_.advance();
  Number number = read_number();
  std::int64_t value_um = number.value;
  if (cursor_.current() == '.') {
    value_um = number.value * 1000;
    cursor_.advance();
    std::int64_t decimals_um = 0;
    if (!cursor_.is_digit() && number.digits == 0)
      return fail(ErrorCode::text_malformed, letter(word.address), ".", "1.5");
    if (!read_decimals(decimals_um)) return fail(ErrorCode::text_malformed, letter(word.address), "", "0.001");
    value_um += decimals_um;
  } else if (number.digits == 0) {
    return fail(ErrorCode::text_malformed, letter(word.address));
  }
  return take_number(word, is_negative ? -value_um : value_um);
}

/// At most three digits behind the point: more could not be stored.
bool BlockReader::read_decimals(std::int64_t& value_um) {
  int decimals = 0;
  for (; cursor_.is_digit(); cursor_.advance()) {
    if (++decimals > kMostDecimals) return false;
    value_um = value_um * 10 + (cursor_.current() - '0');
  }
  for (; decimals < kMostDecimals; ++decimals) value_um *= 10;
  return true;
}

bool BlockReader::read_plain_number(Word& word) {
  const Number number = read_number();
  if (number.digits == 0) {
    const char found = cursor_.current();
    const bool is_sign = found == '+' || found == '-' || found == '.';
    return fail(ErrorCode::text_malformed, letter(word.address), is_sign ? std::string(1, found) : std::string{},
                range_text(format_of(word.address)));
  }
  return take_number(word, number.value);
}

/// P and N of jumps and calls have all their digits, since blocks and programs begin with the same letters.
bool BlockReader::read_target(Word& word) {
  const WordFormat& format = format_of(word.address);
  const auto number = cursor_.read_digits(format.digits);
  if (!number) return fail(ErrorCode::text_malformed, letter(word.address), "", range_text(format));
  if (word.address == Address::N && starts_function()) {
    if (*number == 0) return fail(ErrorCode::block_number_wrong, 'N', "000", "N001..N999");
    next_start_ = BlockStart{*number, word_line_};
  }
  return take_number(word, *number);
}

bool BlockReader::take_number(Word& word, std::int64_t value) {
  const WordFormat& format = format_of(word.address);
  if (value < format.least || value > format.most)
    return fail(ErrorCode::word_out_of_range, letter(word.address), value_text(word.address, value),
                range_text(format));
  word.number = static_cast<std::int32_t>(value);
  return true;
}

void BlockReader::recover(bool is_tool) {
  while (!ends_block(~AddressSet{0}, false)) {
    const char c = cursor_.current();
    if (c == 'P') {
      if (find_program()) return;
    } else if (c == (is_tool ? 'T' : 'N')) {
      if (find_start(is_tool)) return;
    } else if (c == 'M') {
      if (read_machine_data_mark()) return;
    } else {
      cursor_.advance();
    }
  }
}

/// "P0001N001G": a program's beginning, not a target.
bool BlockReader::find_program() {
  cursor_.advance();
  const auto program = cursor_.read_digits(4);
  if (!program) return false;
  const bool is_tool = *program == kToolTable;
  if (cursor_.current() != (is_tool ? 'T' : 'N') || !find_start(is_tool)) return false;
  next_program_ = program;
  return true;
}

/// "N001G", in P0000 "T001".
bool BlockReader::find_start(bool is_tool) {
  const int line = cursor_.line();
  cursor_.advance();
  const auto number = cursor_.read_digits(3);
  if (!number || !is_number(*number, is_tool) || (!is_tool && !starts_function())) return false;
  next_start_ = BlockStart{*number, line};
  return true;
}

}  // namespace cnclab::language
