// Machining cycles: everything is checked, the parameters are loaded, then the ROM program runs as a subprogram.
//
//   G82 Z-10 Q-4 V2 H5  ──▶ Z < 0? Q < 0? F there? …  ──▶ #60 #61 #62 #63  ──▶ call of P9982 from its first block
//
// (CYC-001 to CYC-009, CYC-100 to CYC-110; D-76, D-85, D-89, D-90, DEC-03, DEC-53, DEC-54; ROM-01 to ROM-04)
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "program/rom_programs.hpp"
#include "program/ways.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

using language::Address;
using language::ErrorCode;

constexpr int kSlot = 84, kPocket = 85;

/// Which parameter gets a word. A word that the block does not have leaves it as the row before has set it.
struct Load {
  Address word;
  std::size_t parameter;
};

// G81 drills at once, so that Q is Z (D-76); so does G86 without Q.
constexpr Load kDrilling[] = {{Address::Z, 60}, {Address::Z, 61}, {Address::V, 62}, {Address::H, 63}};
constexpr Load kDeepDrilling[] = {{Address::Z, 60}, {Address::Q, 61}, {Address::V, 62}, {Address::H, 63}};
constexpr Load kThread[] = {{Address::Z, 60}, {Address::V, 62}, {Address::H, 63}};
constexpr Load kMilling[] = {{Address::X, 58}, {Address::Y, 59}, {Address::Z, 60},
                             {Address::Q, 61}, {Address::V, 62}, {Address::H, 63}};
constexpr Load kHoles[] = {{Address::R, 58}, {Address::D, 59}, {Address::W, 46}, {Address::Z, 60},
                           {Address::Z, 61}, {Address::Q, 61}, {Address::V, 62}, {Address::H, 63}};
constexpr std::array<std::span<const Load>, 6> kLoads{kDrilling, kDeepDrilling, kThread, kMilling, kMilling, kHoles};

std::span<const Load> loads_of(int cycle) { return kLoads.at(static_cast<std::size_t>(cycle - 81)); }

/// A word's value as a parameter holds it: mm, or plain numbers (tenths of a second, degrees, holes).
std::int64_t as_parameter(const language::Word& word) {
  const bool is_length = language::format_of(word.address).kind == language::WordFormat::Kind::millimetres;
  return word.number * (is_length ? kParameterUnit / 1000 : kParameterUnit);
}

std::string um_in_mm(std::int64_t um) { return in_mm(language::to_mm({um})); }

std::unexpected<language::Error> wrong_value(const BlockRun& run, Address word, std::string expected) {
  return error_at(ErrorCode::cycle_value_wrong, run.source, language::letter(word),
                  um_in_mm(value_of(run.block, word, 0)), std::move(expected));
}

/// G84: the slot is at least as long as the cutter is wide; the other word is 0 (CYC-084, DEC-53).
Outcome check_slot(const BlockRun& run, std::int64_t diameter_um) {
  const Address along = value_of(run.block, Address::X, 0) != 0 ? Address::X : Address::Y;
  if (value_of(run.block, along, 0) >= diameter_um) return {};
  return wrong_value(run, along, fmt::format("{} >= {} (2R)", language::letter(along), um_in_mm(diameter_um)));
}

/// G85: the pocket is wider than the cutter, and the cutter clears what the rows leave of 0.5 mm (CYC-090, D-85).
Outcome check_pocket(const BlockRun& run, std::int64_t diameter_um) {
  constexpr std::int64_t kLeastDiameter_um = 1000;
  if (diameter_um <= kLeastDiameter_um)
    return error_at(ErrorCode::cycle_value_wrong, run.source, 'T', "R " + um_in_mm(diameter_um / 2), "R > 0.500");
  for (const Address side : {Address::X, Address::Y})
    if (value_of(run.block, side, 0) <= diameter_um)
      return wrong_value(run, side, fmt::format("{} > {} (2R)", language::letter(side), um_in_mm(diameter_um)));
  return {};
}

/// The ROM programs read #67 and #68, whatever of them this cycle needs: a damaged row stops before the first block.
Outcome check_cutter(const BlockRun& run) {
  if (Outcome row = check_tool_row(run.programs, run.state.modal.tool, run.source); !row) return row;
  const ToolData tool = run.programs.tool(run.state.modal.tool).value_or(ToolData{});
  const std::int64_t diameter_um = 2 * tool.radius.value;
  if (diameter_um < 0)
    return error_at(ErrorCode::word_out_of_range, run.source, 'T', "R " + um_in_mm(tool.radius.value), "R >= 0");
  if (run.block.function.code == kSlot) return check_slot(run, diameter_um);
  if (run.block.function.code == kPocket) return check_pocket(run, diameter_um);
  return {};
}

/// The program computes with parameters, which end at 9999.999: its ways and places must stay below, or it would go
/// wrong in the middle instead of being refused here.
Outcome check_range(const BlockRun& run) {
  constexpr std::int64_t kHalf_um = 500, kMicrometresPerMm = 1000;
  const std::int64_t safety_um = value_of(run.block, Address::V, 0) * kMicrometresPerMm;
  std::int64_t farthest_um = 0;
  for (const std::int64_t place_nm : run.state.programmed_nm)
    farthest_um = std::max(farthest_um, std::abs(rounded_to_um(place_nm)));
  for (const Load& load : loads_of(run.block.function.code)) {
    const std::int64_t size_um = std::abs(value_of(run.block, load.word, 0));
    const bool is_depth = load.word == Address::Z || load.word == Address::Q;
    const bool is_side = load.word == Address::X || load.word == Address::Y || load.word == Address::R;
    if (is_depth && size_um + safety_um + kHalf_um > language::kLargestWord_um)
      return wrong_value(run, load.word, fmt::format("{} - V > -9999.500", language::letter(load.word)));
    if (is_side && size_um + farthest_um > language::kLargestWord_um)
      return wrong_value(run, load.word,
                         fmt::format("{} + {} < 10000", um_in_mm(farthest_um), language::letter(load.word)));
  }
  if (farthest_um <= language::kLargestWord_um) return {};
  return error_at(ErrorCode::word_out_of_range, run.source, 0, um_in_mm(farthest_um), "-9999.999..9999.999");
}

/// The cutter must stand where the program says: G40 alone does not move it, the next way in the plane does (G-400).
Outcome check_radius_compensation(const BlockRun& run) {
  const auto [first, second] = indices_of(run.state.modal.plane).in_plane;
  const bool is_on = run.state.modal.radius != RadiusCompensation::off;
  const auto beside = static_cast<AxisSet>(run.state.shifted_axes | run.state.contour_axes);
  const bool is_still_beside = (beside & (axis_bit(first) | axis_bit(second))) != 0;
  if (!is_on && !is_still_beside) return {};
  return error_at(ErrorCode::compensation_impossible, run.source, 'G', fmt::format("G{:02}", run.block.function.code),
                  is_on ? "G40" : "G00, G01");
}

/// ROM-03: whatever could stop the program in the middle stops it before the first block. What a word must be by
/// itself (Z < 0, Q < 0, …) has been checked with the block's form.
Outcome check_before(const BlockRun& run) {
  if (Outcome radius = check_radius_compensation(run); !radius) return radius;
  if (Outcome feed = check_feed(run); !feed) return feed;
  if (Outcome cutter = check_cutter(run); !cutter) return cutter;
  return check_range(run);
}

/// The place of the call to 1/1000 mm, which is what the words #55..#57 will say (DEC-51).
std::array<std::int64_t, 3> place_um(const ExecutionState& state) {
  std::array<std::int64_t, 3> place{};
  for (std::size_t axis = 0; axis < place.size(); ++axis) place[axis] = rounded_to_um(state.programmed_nm[axis]);
  return place;
}

}  // namespace

Outcome execute_cycle(BlockRun& run) {
  const int cycle = run.block.function.code;
  const language::Program* rom = rom_program_of(run.block.function);
  if (run.levels.size() > static_cast<std::size_t>(kDeepestCall))  // D-58
    return error_at(ErrorCode::nesting_too_deep, run.source, 'G', fmt::format("G{:02}", cycle),
                    std::to_string(kDeepestCall));
  if (Outcome outcome = check_before(run); !outcome) return outcome;
  for (const Load& load : loads_of(cycle))
    if (const language::Word* word = run.block.find(load.word)) run.parameters.at(load.parameter) = as_parameter(*word);
  run.state.unscaled_um = place_um(run.state);
  run.flow = {.kind = Flow::Kind::call, .program = rom, .index = 0, .repeats = 0};
  return {};
}

}  // namespace cnclab::program
