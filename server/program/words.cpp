// Reading parameters into words, and the checks that a block passes before it acts.
#include "program/words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "language/check_block.hpp"

namespace cnclab::program {

namespace {

constexpr int kFirstStateParameter = 64;  // #64 #65 #66: Sollwert of X, Y, Z; #67, #68: radius and length of the tool

/// #64..#66 may be larger than any word; what no word can hold is out of range in any case.
std::int32_t narrowed(std::int64_t number) {
  using Limits = std::numeric_limits<std::int32_t>;
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(number, Limits::min(), Limits::max()));
}

/// A ROM program's words are its cycle's, which were checked at the call, and places, which are as far from zero as the
/// operator has put zero: only the range of a word limits them.
std::array<double, 3> longest_words_mm(geometry::SourceBlock source, const Settings& settings) {
  constexpr double kLongest_mm = language::to_mm({language::kLargestWord_um});
  if (language::is_reserved_for_cycles(source.program)) return {kLongest_mm, kLongest_mm, kLongest_mm};
  return settings.travel_mm;
}

/// The plane check is needed only where a form depends on the plane and its words fit another one.
bool is_of_another_plane(const language::Block& block, language::Plane plane) {
  return language::is_plane_dependent(block.function) && language::plane_of_words(block, plane) != plane;
}

}  // namespace

std::int64_t rounded_to_um(std::int64_t value) {
  constexpr std::int64_t kPerMicrometre = kParameterUnit / 1000;
  return (value >= 0 ? value + kPerMicrometre / 2 : value - kPerMicrometre / 2) / kPerMicrometre;
}

std::int64_t parameter_value(int number, const Parameters& parameters, const ExecutionState& state,
                             const ProgramSet& programs) {
  constexpr std::int64_t kPerMicrometre = kParameterUnit / 1000;
  if (number < kFirstStateParameter || number > kFirstStateParameter + 4)
    return parameters.at(static_cast<std::size_t>(number));
  if (number < kFirstStateParameter + 3)
    return state.programmed_nm[static_cast<std::size_t>(number - kFirstStateParameter)];
  const ToolData tool = programs.tool(state.modal.tool).value_or(ToolData{});
  return (number == kFirstStateParameter + 3 ? tool.radius : tool.length).value * kPerMicrometre;
}

bool has_parameters(const language::Block& block) {
  for (const language::Word& word : block.words)
    if (word.is_parameter) return true;
  return false;
}

bool reads_tool(const language::Block& block) {
  constexpr int kRadius = kFirstStateParameter + 3, kLength = kRadius + 1;
  const bool has_operands = block.function.kind == language::Function::Kind::parametric;
  return std::ranges::any_of(block.words, [&](const language::Word& word) {
    const bool names_parameter = word.is_parameter || (has_operands && word.address == language::Address::operand);
    return names_parameter && (word.number == kRadius || word.number == kLength);
  });
}

language::Block read_parameters(language::Block block, const Parameters& parameters, const ExecutionState& state,
                                const ProgramSet& programs) {
  for (language::Word& word : block.words) {
    if (!word.is_parameter) continue;
    const std::int64_t value = parameter_value(static_cast<int>(word.number), parameters, state, programs);
    const bool is_length = language::format_of(word.address).kind == language::WordFormat::Kind::millimetres;
    word = {.address = word.address,
            .is_parameter = false,
            .number = narrowed(is_length ? rounded_to_um(value) : value / kParameterUnit)};
  }
  return block;
}

language::Error naming_parameter(language::Error error, const language::Block& stored) {
  for (const language::Word& word : stored.words)
    if (word.is_parameter && language::letter(word.address) == error.word)
      error.detail = fmt::format("#{:02} = {}", word.number, error.detail);
  return error;
}

bool is_dwell_of_nothing(const language::Block& block) {
  const language::Function function = block.function;
  const bool dwells = function.kind == language::Function::Kind::g && (function.code == 4 || function.code == 64);
  return dwells && value_of(block, language::Address::H, 1) == 0;
}

Outcome check_words(const language::Block& block, geometry::SourceBlock source, geometry::Plane plane,
                    const Settings& settings) {
  const language::Plane words_plane = as_language(plane);
  if (is_of_another_plane(block, words_plane))
    return error_at(language::ErrorCode::plane_wrong, source, 'G', fmt::format("G{:02}", block.function.code));
  return check_form_and_limits(block, source, words_plane, settings);
}

Outcome check_form_and_limits(const language::Block& block, geometry::SourceBlock source, language::Plane plane,
                              const Settings& settings) {
  const auto as_um = [](double mm) { return language::Micrometres{std::llround(mm * 1000)}; };
  const std::array<double, 3> longest_mm = longest_words_mm(source, settings);
  const language::EntryLimits limits{.x = as_um(longest_mm[0]),
                                     .y = as_um(longest_mm[1]),
                                     .z = as_um(longest_mm[2]),
                                     .f_max = std::llround(settings.f_max_mm_per_min),
                                     .s_max = std::llround(settings.s_max_rpm)};
  const language::Word* feed = block.find(language::Address::F);
  if (feed != nullptr && !feed->is_parameter && feed->number > limits.f_max)
    return feed_above_limit(source, feed->number, settings);
  Outcome checked = language::check_block(block, plane, settings.vocabulary, &limits);
  if (!checked) checked.error().program = source.program;
  return checked;
}

std::int64_t value_of(const language::Block& block, language::Address address, std::int64_t otherwise) {
  const language::Word* word = block.find(address);
  return word == nullptr ? otherwise : word->number;
}

language::Plane as_language(geometry::Plane plane) {
  switch (plane) {
    case geometry::Plane::xy:
      return language::Plane::xy;
    case geometry::Plane::xz:
      return language::Plane::xz;
    case geometry::Plane::yz:
      return language::Plane::yz;
  }
  return language::Plane::xy;
}

}  // namespace cnclab::program
