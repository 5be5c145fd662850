// Reads the blocks before a start block for what they leave in force.
#include "program/rebuild_modal.hpp"

#include "program/compensation.hpp"

namespace cnclab::program {

namespace {

using language::Address;

/// The number of a word that can be known without executing anything.
const std::int32_t* known_number(const language::Block& block, Address address) {
  const language::Word* word = block.find(address);
  return word == nullptr || word->is_parameter ? nullptr : &word->number;
}

std::int64_t factor(const language::Block& block, Address address) {
  const std::int32_t* number = known_number(block, address);
  return number == nullptr ? 1000 : *number;  // G-754
}

void take_scale(const language::Block& block, ModalState& modal) {
  modal.scale_on = true;
  modal.scale = {factor(block, Address::X), factor(block, Address::Y), factor(block, Address::Z)};
}

void take_plane_or_dimension(int code, ModalState& modal) {
  switch (code) {
    case 17:
      modal.plane = geometry::Plane::xy;
      break;
    case 18:
      modal.plane = geometry::Plane::xz;
      break;
    case 19:
      modal.plane = geometry::Plane::yz;
      break;
    case 90:
      modal.dimension = Dimension::absolute;
      break;
    case 91:
      modal.dimension = Dimension::incremental;
      break;
    default:
      break;  // another group, or none
  }
}

/// G40 to G44 with the tool that is active there (D-74).
void take_radius_compensation(int code, ModalState& modal, const ProgramSet& programs) {
  constexpr std::array kRadius{RadiusCompensation::off, RadiusCompensation::left, RadiusCompensation::right,
                               RadiusCompensation::plus, RadiusCompensation::minus};
  if (code < 40 || code > 44) return;
  modal.radius = kRadius[static_cast<std::size_t>(code - 40)];
  modal.tool_radius = {};
  if (code != 40) take_radius(modal, programs);
}

void take_length_compensation(int code, ModalState& modal, const ProgramSet& programs) {
  if (code != 45 && code != 46) return;
  modal.length_compensation = code == 46;
  modal.tool_length = {};
  if (code == 46) take_length(modal, programs);
}

/// What a cycle's ROM program leaves behind (CYC-007, D-82); it is a call, but one whose end is known.
void take_cycle(int code, ModalState& modal) {
  if (code >= 81 && code <= 86) modal.dimension = Dimension::incremental;
  if (code != 81 && code != 82) return;
  modal.length_compensation = false;
  modal.tool_length = {};
}

void take_group(const language::Block& block, ModalState& modal, const ProgramSet& programs) {
  if (block.function.kind != language::Function::Kind::g) return;
  take_plane_or_dimension(block.function.code, modal);
  take_radius_compensation(block.function.code, modal, programs);
  take_length_compensation(block.function.code, modal, programs);
  if (block.function.code == 75) take_scale(block, modal);
  take_cycle(block.function.code, modal);
  if (block.function.code != 74) return;
  modal.scale_on = false;
  modal.scale = {1000, 1000, 1000};
}

void take_m(std::int64_t code, ModalState& modal) {
  switch (code) {
    case 20:
      modal.blocks_hidden = modal.subprogram_blocks_hidden = modal.potentiometer_off = modal.test_run = false;
      break;
    case 21:
      modal.blocks_hidden = true;
      break;
    case 22:
      modal.subprogram_blocks_hidden = true;
      break;
    case 23:
      modal.potentiometer_off = true;
      break;
    case 24:
      modal.test_run = true;
      break;
    default:
      return;  // nothing is switched
  }
  modal.m = static_cast<int>(code);
}

}  // namespace

ModalState rebuild_modal(const ProgramSet& programs, const language::Program& program, std::uint16_t start_block,
                         ModalState modal) {
  for (const language::Block& block : program.blocks) {
    if (block.number >= start_block) break;
    if (block.is_damaged) continue;
    take_group(block, modal, programs);
    if (const std::int32_t* feed = known_number(block, Address::F)) modal.feed_mm_per_min = static_cast<int>(*feed);
    if (const std::int32_t* speed = known_number(block, Address::S)) modal.spindle_rpm = static_cast<int>(*speed);
    if (const std::int32_t* tool = known_number(block, Address::T)) modal.tool = static_cast<int>(*tool);
    if (const std::int32_t* m = known_number(block, Address::M)) take_m(*m, modal);
  }
  return modal;
}

}  // namespace cnclab::program
