// The checks that a block passes before it is stored, in the order of its words, so that the marker stands right.
#include "language/check_block.hpp"

#include <algorithm>

#include "language/value_text.hpp"

namespace cnclab::language {

namespace {

using Check = std::expected<void, Error>;

std::unexpected<Error> fault(const Block& block, ErrorCode code, char word, std::string detail = {},
                             std::string expected = {}) {
  return std::unexpected(Error{.code = code,
                               .block = block.number,
                               .word = word,
                               .detail = std::move(detail),
                               .expected = std::move(expected),
                               .in_tool_table = block.function.kind == Function::Kind::tool});
}

bool is_g(const Block& block, int code) {
  return block.function.kind == Function::Kind::g && block.function.code == code;
}

std::string function_text(Function function) {
  if (function.kind == Function::Kind::tool) return "T";
  std::string text(function.kind == Function::Kind::g ? "G" : "↓");
  append_digits(text, function.code, 2);
  return text;
}

struct Range {
  std::int64_t least = 0, most = 0;
  [[nodiscard]] bool holds(std::int64_t value) const { return value >= least && value <= most; }
};

/// The largest size that the machine data allow (D-46); the format's where only that limits.
std::int64_t machine_limit(const Block& block, Address address, std::int64_t most, const EntryLimits& limits) {
  switch (address) {
    case Address::F:
      return std::min(most, limits.f_max);
    case Address::S:
      return std::min(most, limits.s_max);
    case Address::X:
    case Address::I:
      return is_g(block, 75) ? most : std::min(most, limits.x.value);  // factors are no ways
    case Address::Y:
    case Address::J:
      return is_g(block, 75) ? most : std::min(most, limits.y.value);
    case Address::Z:
    case Address::K:
    case Address::Q:
      return is_g(block, 75) ? most : std::min(most, limits.z.value);
    default:
      return most;
  }
}

/// The word's range as its format, its function and the machine data have it.
Range allowed_range(const Block& block, Address address, const EntryLimits* limits) {
  const WordFormat& format = format_of(address);
  Range range{format.least, format.most};
  if (limits != nullptr) {
    range.most = machine_limit(block, address, format.most, *limits);
    if (range.least < 0) range.least = -range.most;
  }
  if (address == Address::H && (is_g(block, 4) || is_g(block, 64))) range.least = 1;          // BLK-013, DEC-53
  if (address == Address::R && block.function.kind == Function::Kind::tool) range.least = 0;  // D-50
  if (address == Address::R && is_g(block, 10)) range.least = 1;                              // a radius to round with
  return range;
}

/// What a cycle needs of a word's value.
struct CycleRule {
  int first, last;  ///< G functions
  Address address;
  bool is_negative;
  std::string_view expected;
};

/// D-89, ROM-03; words that a cycle ignores have no row.
constexpr CycleRule kCycleRules[] = {
    {81, 86, Address::Z, true, "Z < 0"},   {82, 82, Address::Q, true, "Q < 0"},  {84, 86, Address::Q, true, "Q < 0"},
    {85, 85, Address::X, false, "X > 0"},  {85, 85, Address::Y, false, "Y > 0"}, {86, 86, Address::R, false, "R > 0"},
    {86, 86, Address::W, false, "01..99"},
};

std::string_view expected_in_cycle(int cycle, const Word& word) {
  for (const CycleRule& rule : kCycleRules) {
    if (word.address != rule.address || cycle < rule.first || cycle > rule.last) continue;
    if (rule.is_negative ? word.number >= 0 : word.number <= 0) return rule.expected;
  }
  return {};
}

/// G84: the slot lies along X or along Y, the other word is 0 (CYC-084, DEC-53).
Check check_slot(const Block& block) {
  const Word* x = block.find(Address::X);
  const Word* y = block.find(Address::Y);
  if (x == nullptr || y == nullptr || x->is_parameter || y->is_parameter) return {};
  for (const Word* word : {x, y})
    if (word->number < 0)
      return fault(block, ErrorCode::cycle_value_wrong, letter(word->address), value_text(*word), "> 0");
  if ((x->number == 0) == (y->number == 0))
    return fault(block, ErrorCode::cycle_value_wrong, 'Y', value_text(*y), x->number == 0 ? "Y > 0" : "Y = 0");
  return {};
}

Check check_cycle_word(const Block& block, const Word& word) {
  if (word.is_parameter) return {};
  if (is_g(block, 84) && word.address == Address::Y) return check_slot(block);
  const std::string_view expected = expected_in_cycle(block.function.code, word);
  if (expected.empty()) return {};
  return fault(block, ErrorCode::cycle_value_wrong, letter(word.address), value_text(word), std::string(expected));
}

Check check_parameter(const Block& block, const Word& word, const Vocabulary& vocabulary) {
  const bool is_allowed = format_of(word.address).takes_parameter && block.function.kind != Function::Kind::tool &&
                          vocabulary.model == Model::cnc3300;  // PAR-003, MODEL-006
  if (!is_allowed) return fault(block, ErrorCode::word_not_allowed, letter(word.address), value_text(word));
  if (word.number < 0 || word.number > format_of(Address::operand).most)
    return fault(block, ErrorCode::word_out_of_range, letter(word.address), value_text(word), "#00..#69");
  return {};
}

Check check_value(const Block& block, const Word& word, const Range& range) {
  if (!range.holds(word.number)) {
    WordFormat format = format_of(word.address);
    format.least = range.least;
    format.most = range.most;
    return fault(block, ErrorCode::word_out_of_range, letter(word.address), value_text(word), range_text(format));
  }
  if (word.address == Address::M && !is_known_m(word.number))
    return fault(block, ErrorCode::m_unknown, 'M', value_text(word));
  return {};
}

/// #64 to #68 follow the machine and cannot be a target (D-93).
Check check_target(const Block& block) {
  const Word& target = block.words.front();
  if (target.address != Address::operand || target.number < 64 || target.number > 68) return {};
  return fault(block, ErrorCode::parameter_read_only, '#', '#' + value_text(target), "#00..#63, #69");
}

/// A target among the programs of the cycles can be neither jumped to nor called (DEC-64).
Check check_program_target(const Block& block, const Word& word) {
  if (word.address != Address::P || !is_reserved_for_cycles(word.number)) return {};
  return fault(block, ErrorCode::reserved_for_cycles, 'P', 'P' + value_text(word));
}

Check check_word(const Block& block, const BlockForm& form, const Word& word, const Vocabulary& vocabulary,
                 const EntryLimits* limits) {
  if (word.is_parameter) return check_parameter(block, word, vocabulary);
  if (Check value = check_value(block, word, allowed_range(block, word.address, limits)); !value) return value;
  if (form.needed == Needed::cycle) return check_cycle_word(block, word);
  return check_program_target(block, word);
}

/// No rule of its cycle speaks against the value. The two ways of a slot are judged together, see `check_slot`.
bool is_plainly_right_in_cycle(const Block& block, const Word& word) {
  return expected_in_cycle(block.function.code, word).empty() && !(word.address == Address::Y && is_g(block, 84));
}

/// The same answer for nearly every word that a program executes, in a few nanoseconds: nothing is wrong with it.
bool is_plainly_right(const Block& block, const BlockForm& form, const Word& word, const EntryLimits* limits) {
  return !word.is_parameter && word.address != Address::P &&
         allowed_range(block, word.address, limits).holds(word.number) &&
         (word.address != Address::M || is_known_m(word.number)) &&
         (form.needed != Needed::cycle || is_plainly_right_in_cycle(block, word));
}

/// Operands have one address for all of them, so they are taken by their place.
Check check_operands(const Block& block, const BlockForm& form, const Vocabulary& vocabulary) {
  for (std::size_t i = 0; i < form.words.size(); ++i) {
    if (i >= block.words.size() || block.words[i].address != form.words[i])
      return fault(block, ErrorCode::word_missing, letter(form.words[i]));
    if (!is_plainly_right(block, form, block.words[i], nullptr))
      if (Check word = check_word(block, form, block.words[i], vocabulary, nullptr); !word) return word;
  }
  if (block.words.size() > form.words.size())
    return fault(block, ErrorCode::word_not_allowed, letter(block.words[form.words.size()].address));
  return check_target(block);
}

/// The addresses of a block's words.
struct Found {
  AddressSet set = 0;
  bool has_one_twice = false;
};

Found found_in(const Block& block) {
  Found found;
  for (const Word& word : block.words) {
    const AddressSet bit = bit_of(word.address);
    found.has_one_twice |= (found.set & bit) != 0;
    found.set |= bit;
  }
  return found;
}

/// A word that the form does not have, or has once only.
Check refuse_foreign_word(const Block& block, AddressSet allowed) {
  AddressSet seen = 0;
  for (const Word& word : block.words) {
    const AddressSet bit = bit_of(word.address);
    if ((bit & allowed & ~seen) == 0) return fault(block, ErrorCode::word_not_allowed, letter(word.address));
    seen |= bit;
  }
  return {};
}

/// One word of several is enough (D-45).
bool has_any_needed(const BlockForm& form, AddressSet found) {
  constexpr AddressSet kAxes = bit_of(Address::X) | bit_of(Address::Y) | bit_of(Address::Z);
  if (form.needed == Needed::any_axis) return (found & kAxes) != 0;
  return form.needed != Needed::any_word || found != 0;
}

Check check_words(const Block& block, const BlockForm& form, const Found& found, const Vocabulary& vocabulary,
                  const EntryLimits* limits) {
  const AddressSet required = required_addresses_of(form);
  std::size_t next = 0;  // words nearly always have the order of their form
  for (const Address address : form.words) {
    if ((found.set & bit_of(address)) == 0) {
      if ((required & bit_of(address)) != 0) return fault(block, ErrorCode::word_missing, letter(address));
      continue;
    }
    const Word* word = block.words[next].address == address ? &block.words[next] : block.find(address);
    ++next;
    if (word == nullptr || is_plainly_right(block, form, *word, limits)) continue;
    if (Check checked = check_word(block, form, *word, vocabulary, limits); !checked) return checked;
  }
  const AddressSet allowed = addresses_of(form);
  if (found.has_one_twice || (found.set & ~allowed) != 0) return refuse_foreign_word(block, allowed);
  if (!has_any_needed(form, found.set)) return fault(block, ErrorCode::word_missing, letter(form.words.front()));
  return {};
}

}  // namespace

std::expected<void, Error> check_block(const Block& block, Plane plane, const Vocabulary& vocabulary,
                                       const EntryLimits* limits) {
  const Found found = found_in(block);
  const BlockForm* form = find_form(block.function, plane_of_words(block.function, found.set, plane), vocabulary);
  if (form == nullptr) return fault(block, ErrorCode::function_unknown, 'G', function_text(block.function));
  if ((addresses_of(*form) & bit_of(Address::operand)) != 0) return check_operands(block, *form, vocabulary);
  return check_words(block, *form, found, vocabulary, limits);
}

std::vector<Error> check_program(const Program& program, const Vocabulary& vocabulary, const EntryLimits* limits) {
  std::vector<Error> errors;
  Plane plane = Plane::xy;
  for (const Block& block : program.blocks) {
    plane = plane_behind(block, plane);
    auto checked = check_block(block, plane, vocabulary, limits);
    if (checked) continue;
    checked.error().program = program.number;
    errors.push_back(std::move(checked.error()));
  }
  return errors;
}

int cost_bytes(const Block& block) {
  constexpr int kBlock = 4;     // number 2, function 1, check code 1
  constexpr int kToolRow = 12;  // DEC-66: radius and length always have their place
  if (block.function.kind == Function::Kind::tool) return kToolRow;
  int cost = kBlock;
  for (const Word& word : block.words) cost += format_of(word.address).cost_bytes;
  return cost;
}

}  // namespace cnclab::language
