// Counts steps, closes limit switches, stops dead at the end of the over-travel.
#include "machine/simulated_machine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cnclab::machine {

SimulatedMachine::SimulatedMachine(const MachineData& data) {
  constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max() / 4;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const bool has_switches = axis < 3;  // no travel is given for U
    const int number = static_cast<int>(axis);
    const double half_travel_mm = has_switches ? static_cast<double>(data.get(3 + number)) / 2000 : 0;
    const auto steps_per_mm = static_cast<double>(data.get(14 + number));
    const auto steps = [&](double way_mm) { return has_switches ? std::llround(way_mm * steps_per_mm) : kNever; };
    switch_plus_[axis] = steps(half_travel_mm);
    end_plus_[axis] = steps(half_travel_mm + kOvertravel_mm);
    switch_minus_[axis] = -switch_plus_[axis];
    end_minus_[axis] = -end_plus_[axis];
  }
}

Inputs SimulatedMachine::exchange(const Outputs& outputs) noexcept {
  Inputs inputs;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    if (outputs.drives_on) {
      position_[axis] = std::clamp(position_[axis] + outputs.steps[axis], end_minus_[axis], end_plus_[axis]);
    }
    inputs.limit_plus[axis] = position_[axis] >= switch_plus_[axis];
    inputs.limit_minus[axis] = position_[axis] <= switch_minus_[axis];
  }
  const std::uint32_t set = inputs_.load(std::memory_order_relaxed);
  inputs.input_1 = (set & 1U) != 0;
  inputs.cards = {static_cast<std::uint8_t>(set >> 8U), static_cast<std::uint8_t>(set >> 16U)};
  return inputs;
}

void SimulatedMachine::set_input(int card, int line, bool active) noexcept {
  const bool is_input_1 = card == 0;
  if (!is_input_1 && (card < 1 || card > 2 || line < 1 || line > 8)) return;
  const std::uint32_t bit = is_input_1 ? 1U : 1U << static_cast<unsigned>(card * 8 + line - 1);
  if (active) {
    inputs_.fetch_or(bit, std::memory_order_relaxed);
  } else {
    inputs_.fetch_and(~bit, std::memory_order_relaxed);
  }
}

}  // namespace cnclab::machine
