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

bool is_needed(const BlockForm& form, std::size_t place) {
  switch (form.needed) {
    case Needed::all:
      return true;
    case Needed::two_axes_and_radius:
      return place < 3;  // they stand first in every plane
    case Needed::cycle:
      return std::ranges::find(form.required_words, form.words[place]) != form.required_words.end();
    case Needed::nothing:
    case Needed::any_axis:
    case Needed::any_word:
      return false;
  }
  return false;
}

/// The largest size that the machine data allow (D-46); nothing where only the format limits.
std::optional<std::int64_t> machine_limit(const Block& block, Address address, const EntryLimits& limits) {
  if (address == Address::F) return limits.f_max;
  if (address == Address::S) return limits.s_max;
  if (is_g(block, 75)) return std::nullopt;  // factors are no ways
  if (address == Address::X || address == Address::I) return limits.x.value;
  if (address == Address::Y || address == Address::J) return limits.y.value;
  if (address == Address::Z || address == Address::K || address == Address::Q) return limits.z.value;
  return std::nullopt;
}

/// The word's format with the limits that hold for this block.
WordFormat allowed_format(const Block& block, const Word& word, const EntryLimits* limits) {
  WordFormat format = format_of(word.address);
  if (word.address == Address::H && (is_g(block, 4) || is_g(block, 64))) format.least = 1;          // BLK-013, DEC-53
  if (word.address == Address::R && block.function.kind == Function::Kind::tool) format.least = 0;  // D-50
  const auto most = limits == nullptr ? std::nullopt : machine_limit(block, word.address, *limits);
  if (most) {
    format.most = std::min(format.most, *most);
    if (format.least < 0) format.least = -format.most;
  }
  return format;
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
    if (cycle < rule.first || cycle > rule.last || word.address != rule.address) continue;
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

Check check_value(const Block& block, const Word& word, const EntryLimits* limits) {
  const WordFormat format = allowed_format(block, word, limits);
  if (word.number < format.least || word.number > format.most)
    return fault(block, ErrorCode::word_out_of_range, letter(word.address), value_text(word), range_text(format));
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

Check check_word(const Block& block, const BlockForm& form, const Word& word, const Vocabulary& vocabulary,
                 const EntryLimits* limits) {
  const Check value = word.is_parameter ? check_parameter(block, word, vocabulary) : check_value(block, word, limits);
  if (!value || form.needed != Needed::cycle) return value;
  return check_cycle_word(block, word);
}

/// Operands have one address for all of them, so they are taken by their place.
Check check_operands(const Block& block, const BlockForm& form, const Vocabulary& vocabulary) {
  for (std::size_t i = 0; i < form.words.size(); ++i) {
    if (i >= block.words.size() || block.words[i].address != form.words[i])
      return fault(block, ErrorCode::word_missing, letter(form.words[i]));
    if (const Check word = check_word(block, form, block.words[i], vocabulary, nullptr); !word) return word;
    if (const Check target = check_target(block); !target) return target;
  }
  if (block.words.size() > form.words.size())
    return fault(block, ErrorCode::word_not_allowed, letter(block.words[form.words.size()].address));
  return {};
}

Check check_present(const Block& block, const BlockForm& form) {
  for (std::size_t i = 0; i < block.words.size(); ++i) {
    const Address address = block.words[i].address;
    const bool is_twice = &block.words[i] != block.find(address);
    if (is_twice || std::ranges::find(form.words, address) == form.words.end())
      return fault(block, ErrorCode::word_not_allowed, letter(address));
  }
  const bool has_axis =
      block.find(Address::X) != nullptr || block.find(Address::Y) != nullptr || block.find(Address::Z) != nullptr;
  if ((form.needed == Needed::any_axis && !has_axis) || (form.needed == Needed::any_word && block.words.empty()))
    return fault(block, ErrorCode::word_missing, letter(form.words.front()));
  return {};
}

Check check_words(const Block& block, const BlockForm& form, const Vocabulary& vocabulary, const EntryLimits* limits) {
  for (std::size_t i = 0; i < form.words.size(); ++i) {
    const Word* word = block.find(form.words[i]);
    if (word == nullptr) {
      if (is_needed(form, i)) return fault(block, ErrorCode::word_missing, letter(form.words[i]));
      continue;
    }
    if (const Check checked = check_word(block, form, *word, vocabulary, limits); !checked) return checked;
  }
  return check_present(block, form);
}

}  // namespace

std::expected<void, Error> check_block(const Block& block, Plane plane, const Vocabulary& vocabulary,
                                       const EntryLimits* limits) {
  const BlockForm* form = find_form(block.function, plane_of_words(block, plane), vocabulary);
  if (form == nullptr) return fault(block, ErrorCode::function_unknown, 'G', function_text(block.function));
  if ((addresses_of(*form) & bit_of(Address::operand)) != 0) return check_operands(block, *form, vocabulary);
  return check_words(block, *form, vocabulary, limits);
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
