// Values are drawn so that a checked program comes out: signs of cycles, known M codes, targets that can be written.
#include "random_program.hpp"

#include <algorithm>
#include <set>

#include "language/tape.hpp"

namespace cnclab::language {

namespace {

using Kind = Function::Kind;

bool is_needed(const BlockForm& form, std::size_t place) {
  switch (form.needed) {
    case Needed::all:
      return true;
    case Needed::two_axes_and_radius:
      return place < 3;
    case Needed::cycle:
      return std::ranges::find(form.required_words, form.words[place]) != form.required_words.end();
    case Needed::any_axis:
    case Needed::any_word:
      return place == 0;
    case Needed::nothing:
      return false;
  }
  return false;
}

std::int32_t random_number(const BlockForm& form, std::size_t place) {
  const Address address = form.words[place];
  const WordFormat& format = format_of(address);
  const bool is_cycle = form.needed == Needed::cycle;
  auto least = static_cast<std::int32_t>(format.least), most = static_cast<std::int32_t>(format.most);
  if (is_cycle && (address == Address::Z || address == Address::Q)) most = -1;
  if (is_cycle && (address == Address::X || address == Address::R || address == Address::W)) least = 1;
  if (is_cycle && address == Address::Y) least = form.function.code == 84 ? 0 : 1;
  if (is_cycle && address == Address::Y && form.function.code == 84) most = 0;
  if (address == Address::H && !is_cycle) least = 1;
  if (form.function.kind == Kind::tool && address == Address::R) least = 0;
  if (form.function == Function{Kind::g, 10}) least = 1;
  if (address == Address::P) most = 9980;
  if (address == Address::operand && place == 0) most = 63;
  if (address != Address::M) return *rc::gen::inRange<std::int32_t>(least, most + 1);
  return *rc::gen::suchThat(rc::gen::inRange<std::int32_t>(0, 99), is_known_m);
}

Word random_word(const BlockForm& form, std::size_t place) {
  const Address address = form.words[place];
  const bool may_be_parameter = format_of(address).takes_parameter && form.function.kind != Kind::tool;
  if (may_be_parameter && *rc::gen::inRange(0, 5) == 0)
    return {.address = address, .is_parameter = true, .number = *rc::gen::inRange<std::int32_t>(0, 70)};
  return {.address = address, .number = random_number(form, place)};
}

}  // namespace

rc::Gen<Block> random_block(const BlockForm& form, std::uint16_t number) {
  return rc::gen::exec([&form, number] {
    Block block{.number = number, .function = form.function};
    for (std::size_t place = 0; place < form.words.size(); ++place)
      if (is_needed(form, place) || *rc::gen::arbitrary<bool>()) block.words.push_back(random_word(form, place));
    return block;
  });
}

rc::Gen<Program> random_program() {
  return rc::gen::exec([] {
    Program program{.number = static_cast<std::uint16_t>(*rc::gen::weightedOneOf<int>(
                        {{1, rc::gen::just(0)}, {5, rc::gen::inRange(1, 9981)}, {1, rc::gen::inRange(9990, 10'000)}}))};
    const bool is_tool_table = program.number == kToolTable;
    const auto numbers = *rc::gen::container<std::set<int>>(rc::gen::inRange(1, is_tool_table ? 100 : 1000));
    for (const int number : numbers) {
      const auto place = *rc::gen::inRange<std::size_t>(0, all_forms().size() - 1);
      const BlockForm& form = is_tool_table ? all_forms().back() : all_forms()[place];
      program.blocks.push_back(*random_block(form, static_cast<std::uint16_t>(number)));
    }
    if (program.blocks.empty())
      program.blocks.push_back(*random_block(is_tool_table ? all_forms().back() : all_forms()[0], 1));
    return program;
  });
}

void showValue(const Block& block, std::ostream& out) { out << write_block(block); }

void showValue(const Program& program, std::ostream& out) { out << write_program(program); }

}  // namespace cnclab::language
