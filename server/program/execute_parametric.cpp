// Parametric functions: values, calculations, jumps on the result register (PAR-010 to PAR-036; D-91 to D-96, DEC-52).
#include <fmt/core.h>

#include <array>

#include "program/fixed_point.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

/// What the second and third operand of a calculation hold; one that works on the second alone ignores the third.
struct Operands {
  std::int64_t a = 0, b = 0;
};

/// One calculation. Nothing comes out of a division by zero.
struct Calculation {
  std::size_t code;
  std::optional<Limited> (*act)(Operands);
  bool sets_result = false;  ///< marked * in the manual (PAR-030)
};

constexpr std::array kCalculations{
    Calculation{1, [](Operands of) { return std::optional(sum(of.a, of.b)); }, true},
    Calculation{2, [](Operands of) { return std::optional(difference(of.a, of.b)); }, true},
    Calculation{3, [](Operands of) { return std::optional(product(of.a, of.b)); }, true},
    Calculation{4, [](Operands of) { return quotient(of.a, of.b); }, true},
    Calculation{10, [](Operands of) { return std::optional(limited(of.a)); }},
    Calculation{11, [](Operands of) { return std::optional(sum(of.a, kParameterUnit)); }, true},
    Calculation{12, [](Operands of) { return std::optional(difference(of.a, kParameterUnit)); }, true},
    Calculation{13, [](Operands of) { return std::optional(difference(0, of.a)); }},
    Calculation{14, [](Operands of) { return std::optional(of.a < 0 ? difference(0, of.a) : limited(of.a)); }},
    Calculation{15, [](Operands of) { return std::optional(Limited{square_root(of.a)}); }},
    Calculation{16, [](Operands of) { return std::optional(Limited{sine(of.a)}); }},
    Calculation{17, [](Operands of) { return std::optional(Limited{cosine(of.a)}); }},
};

const Calculation& calculation_of(std::size_t code) {
  std::size_t row = 0;
  while (kCalculations.at(row).code != code) ++row;
  return kCalculations[row];
}

/// The operand words all have the same address; their place tells them apart. The target stands first.
std::size_t target_of(const BlockRun& run) { return static_cast<std::size_t>(run.block.words.front().number); }

std::int64_t operand(const BlockRun& run, std::size_t place) {
  if (place >= run.block.words.size()) return 0;
  return parameter_value(static_cast<int>(run.block.words[place].number), run.parameters, run.state, run.programs);
}

ResultFlags flags_of(std::int64_t value, bool carry) {
  return {.zero = value == 0, .positive = value > 0, .negative = value < 0, .carry = carry};
}

bool is_fulfilled(int code, const ResultFlags& result) {
  constexpr int kIfZero = 50, kIfPositive = 51, kIfNegative = 52, kIfCarry = 54;
  if (code == kIfZero) return result.zero;
  if (code == kIfPositive) return result.positive;
  if (code == kIfNegative) return result.negative;
  if (code == kIfCarry) return result.carry;
  return true;  // ↓53
}

}  // namespace

Outcome assign_value(BlockRun& run) {
  constexpr std::int64_t kPerMicrometre = kParameterUnit / 1000;
  run.parameters.at(target_of(run)) = limited(value_of(run.block, language::Address::value, 0) * kPerMicrometre).value;
  return {};
}

Outcome calculate(BlockRun& run) {
  const Calculation& calculation = calculation_of(run.block.function.code);
  std::int64_t& target = run.parameters.at(target_of(run));
  const std::optional<Limited> result = calculation.act({.a = operand(run, 1), .b = operand(run, 2)});
  if (result) target = result->value;
  // After a division by zero the register tells of the target, which keeps its value, and of CARRY.
  if (calculation.sets_result) run.result = flags_of(target, !result || result->carry);
  return {};
}

Outcome jump_on_result(BlockRun& run) {
  if (!is_fulfilled(run.block.function.code, run.result)) return {};
  const std::int64_t number = value_of(run.block, language::Address::N, 0);
  const language::Program* own = run.levels.back().program;
  const std::optional<std::size_t> target = own->find(static_cast<std::uint16_t>(number));
  if (!target)  // D-96
    return error_at(language::ErrorCode::block_missing, run.source, 'N',
                    fmt::format("N{:03} in P{:04}", number, own->number));
  run.flow = {.kind = Flow::Kind::jump, .program = own, .index = *target, .repeats = 0};
  return {};
}

}  // namespace cnclab::program
