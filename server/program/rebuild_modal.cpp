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
Outcome take_radius_compensation(int code, ModalState& modal, const ProgramSet& programs,
                                 geometry::SourceBlock source) {
  constexpr std::array kRadius{RadiusCompensation::off, RadiusCompensation::left, RadiusCompensation::right,
                               RadiusCompensation::plus, RadiusCompensation::minus};
  if (code < 40 || code > 44) return {};
  modal.radius = kRadius[static_cast<std::size_t>(code - 40)];
  modal.tool_radius = {};
  return code == 40 ? Outcome{} : take_radius(modal, programs, source);
}

Outcome take_length_compensation(int code, ModalState& modal, const ProgramSet& programs,
                                 geometry::SourceBlock source) {
  if (code != 45 && code != 46) return {};
  modal.length_compensation = code == 46;
  modal.tool_length = {};
  return code == 45 ? Outcome{} : take_length(modal, programs, source);
}

/// What a cycle's ROM program leaves behind (CYC-007, D-82); it is a call, but one whose end is known.
void take_cycle(int code, ModalState& modal) {
  if (code >= 81 && code <= 86) modal.dimension = Dimension::incremental;
  if (code != 81 && code != 82) return;
  modal.length_compensation = false;
  modal.tool_length = {};
}

Outcome take_group(const language::Block& block, ModalState& modal, const ProgramSet& programs,
                   geometry::SourceBlock source) {
  if (block.function.kind != language::Function::Kind::g) return {};
  const int code = block.function.code;
  take_plane_or_dimension(code, modal);
  if (Outcome radius = take_radius_compensation(code, modal, programs, source); !radius) return radius;
  if (Outcome length = take_length_compensation(code, modal, programs, source); !length) return length;
  if (code == 75) take_scale(block, modal);
  take_cycle(code, modal);
  if (code != 74) return {};
  modal.scale_on = false;
  modal.scale = {1000, 1000, 1000};
  return {};
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

void take_feed_speed_tool(const language::Block& block, ModalState& modal) {
  if (const std::int32_t* feed = known_number(block, Address::F)) modal.feed_mm_per_min = static_cast<int>(*feed);
  if (const std::int32_t* speed = known_number(block, Address::S)) modal.spindle_rpm = static_cast<int>(*speed);
  if (const std::int32_t* tool = known_number(block, Address::T)) modal.tool = static_cast<int>(*tool);
}

bool has_g(int code, const language::Vocabulary& vocabulary) {
  const language::Function function{language::Function::Kind::g, static_cast<std::uint8_t>(code)};
  return language::find_form(function, language::Plane::xy, vocabulary) != nullptr;
}

}  // namespace

std::expected<ModalState, language::Error> rebuild_modal(const ProgramSet& programs, const language::Program& program,
                                                         std::uint16_t start_block, ModalState modal) {
  for (const language::Block& block : program.blocks) {
    if (block.number >= start_block) break;
    const geometry::SourceBlock source{.program = program.number, .block = block.number};
    if (block.is_damaged) return error_at(language::ErrorCode::checksum_wrong, source, 0);
    if (Outcome taken = take_group(block, modal, programs, source); !taken) return std::unexpected(taken.error());
    take_feed_speed_tool(block, modal);
    if (const std::int32_t* m = known_number(block, Address::M)) take_m(*m, modal);
  }
  return modal;
}

ModalState within(ModalState modal, const language::Vocabulary& vocabulary) {
  constexpr int kFirstPlane = 17, kFirstRadius = 40, kLength = 46, kScale = 75, kAbsolute = 90;
  const ModalState power_on;
  if (!has_g(kFirstPlane + static_cast<int>(modal.plane), vocabulary)) modal.plane = power_on.plane;
  if (!has_g(kFirstRadius + static_cast<int>(modal.radius), vocabulary)) {
    modal.radius = power_on.radius;
    modal.tool_radius = {};
  }
  if (!has_g(kLength, vocabulary)) {
    modal.length_compensation = false;
    modal.tool_length = {};
  }
  if (!has_g(kScale, vocabulary)) {
    modal.scale_on = false;
    modal.scale = power_on.scale;
  }
  if (!has_g(kAbsolute, vocabulary)) modal.dimension = power_on.dimension;
  return modal;
}

}  // namespace cnclab::program
