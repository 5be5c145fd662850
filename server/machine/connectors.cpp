// Polarities, in one place.
#include "machine/connectors.hpp"

namespace cnclab::machine {

OutputLevels levels_of(const Outputs& outputs) {
  const bool is_left = outputs.spindle == geometry::SpindleTurn::counterclockwise;
  OutputLevels levels;
  levels.no_current = outputs.drives_on;
  levels.coolant = !outputs.coolant;
  levels.spindle_on = outputs.spindle == geometry::SpindleTurn::off;
  levels.spindle_left = !is_left;
  levels.start = !outputs.start;
  for (std::size_t card = 0; card < 2; ++card) levels.cards[card] = static_cast<std::uint8_t>(~outputs.cards[card]);
  return levels;
}

std::array<std::uint8_t, 4> digits_of_s(std::int32_t rpm) {
  std::array<std::uint8_t, 4> digits{};
  for (std::uint8_t& digit : digits) {
    digit = static_cast<std::uint8_t>(rpm % 10);
    rpm /= 10;
  }
  return digits;
}

SwitchPolarity switch_polarity(std::int64_t endschalter_pol) {
  constexpr std::int64_t kLowActive = 201;
  return endschalter_pol == kLowActive ? SwitchPolarity::damped_is_low : SwitchPolarity::damped_is_high;
}

bool is_damped(bool is_high, SwitchPolarity polarity) {
  return is_high == (polarity == SwitchPolarity::damped_is_high);
}

Inputs InputReader::read(const InputLevels& levels, const motion::AxisSteps& steps) noexcept {
  Inputs inputs;
  inputs.input_1 = !levels.input_1;
  inputs.cards = levels.cards;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    if (steps[axis] != 0) last_direction_[axis] = steps[axis] > 0 ? 1 : -1;
    if (!is_damped(levels.limit_lines[axis], polarity_)) {
      side_[axis] = Side::none;
      continue;
    }
    if (side_[axis] == Side::none) {
      const std::int8_t direction = last_direction_[axis];
      side_[axis] = direction > 0 ? Side::plus : direction < 0 ? Side::minus : Side::unknown;
    }
    inputs.limit_plus[axis] = side_[axis] != Side::minus;
    inputs.limit_minus[axis] = side_[axis] != Side::plus;
  }
  return inputs;
}

}  // namespace cnclab::machine
