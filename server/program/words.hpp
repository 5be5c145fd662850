// Words on their way into execution: parameters become numbers, and the finished block is checked (PAR-004, DEC-13).
#pragma once

#include <array>

#include "program/block_run.hpp"

namespace cnclab::program {

inline constexpr std::array kAxisWords{language::Address::X, language::Address::Y, language::Address::Z};

/// 1/1 000 000 mm to 1/1000 mm, rounded to nearest, halves away from zero (DEC-52).
[[nodiscard]] std::int64_t rounded_to_um(std::int64_t value);

/// The value of a parameter in 1/1 000 000 mm; #64..#68 come from the state (PAR-035, PAR-036, D-95).
[[nodiscard]] std::int64_t parameter_value(int number, const Parameters& parameters, const ExecutionState& state,
                                           const ProgramSet& programs);

/// Does any word of the block name a parameter?
[[nodiscard]] bool has_parameters(const language::Block& block);
/// Does the block read #67 or #68, radius and length of the tool in force, in a word or as an operand?
[[nodiscard]] bool reads_tool(const language::Block& block);

/// The block with its parameters read now: mm words rounded to 1/1000, others their whole part (DEC-52, D-94).
[[nodiscard]] language::Block read_parameters(language::Block block, const Parameters& parameters,
                                              const ExecutionState& state, const ProgramSet& programs);

/// An error about a word that a parameter gave: what was found now names the parameter too, "#04 = 9000.000".
[[nodiscard]] language::Error naming_parameter(language::Error error, const language::Block& stored);

/// G04, G64 whose H came out as 0: no dwell, and no error either (DEC-53).
[[nodiscard]] bool is_dwell_of_nothing(const language::Block& block);

/// Form, plane and limits of a block about to be executed.
/// errors: plane_wrong (D-54), feed_above_limit, word_missing, word_out_of_range, word_not_allowed, m_unknown
[[nodiscard]] Outcome check_words(const language::Block& block, geometry::SourceBlock source, geometry::Plane plane,
                                  const Settings& settings);

/// The same for a stored block whose words stand in `plane`, parameters and all.
[[nodiscard]] Outcome check_form_and_limits(const language::Block& block, geometry::SourceBlock source,
                                            language::Plane plane, const Settings& settings);

/// The value of a word, or `otherwise`.
[[nodiscard]] std::int64_t value_of(const language::Block& block, language::Address address, std::int64_t otherwise);

/// The same plane as the language knows it.
[[nodiscard]] language::Plane as_language(geometry::Plane plane);

}  // namespace cnclab::program
