// Reads the blocks before a start block for what they leave in force.
#include "program/rebuild_modal.hpp"

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

void take_compensation(int code, ModalState& modal) {
  switch (code) {
    case 40:
      modal.radius = RadiusCompensation::off;
      break;
    case 41:
      modal.radius = RadiusCompensation::left;
      break;
    case 42:
      modal.radius = RadiusCompensation::right;
      break;
    case 43:
      modal.radius = RadiusCompensation::plus;
      break;
    case 44:
      modal.radius = RadiusCompensation::minus;
      break;
    case 45:
      modal.length_compensation = false;
      break;
    case 46:
      modal.length_compensation = true;
      break;
    default:
      break;  // another group, or none
  }
}

/// What a cycle's ROM program leaves behind (CYC-007, D-82); it is a call, but one whose end is known.
void take_cycle(int code, ModalState& modal) {
  if (code >= 81 && code <= 86) modal.dimension = Dimension::incremental;
  if (code == 81 || code == 82) modal.length_compensation = false;
}

void take_group(const language::Block& block, ModalState& modal) {
  if (block.function.kind != language::Function::Kind::g) return;
  take_plane_or_dimension(block.function.code, modal);
  take_compensation(block.function.code, modal);
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

ModalState rebuild_modal(const language::Program& program, std::uint16_t start_block, ModalState modal) {
  for (const language::Block& block : program.blocks) {
    if (block.number >= start_block) break;
    if (block.is_damaged) continue;
    take_group(block, modal);
    if (const std::int32_t* feed = known_number(block, Address::F)) modal.feed_mm_per_min = static_cast<int>(*feed);
    if (const std::int32_t* speed = known_number(block, Address::S)) modal.spindle_rpm = static_cast<int>(*speed);
    if (const std::int32_t* tool = known_number(block, Address::T)) modal.tool = static_cast<int>(*tool);
    if (const std::int32_t* m = known_number(block, Address::M)) take_m(*m, modal);
  }
  return modal;
}

}  // namespace cnclab::program
