// Counts steps, closes limit switches, stops dead at the end of the over-travel.
#include "machine/simulated_machine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cnclab::machine {

SimulatedMachine::SimulatedMachine(const MachineData& data) : travel_(travel_of(data)), seen_(travel_of(data)) {}

SimulatedMachine::Travel SimulatedMachine::travel_of(const MachineData& data) {
  constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max() / 4;
  Travel travel;
  travel.polarity = switch_polarity(data.get(19));
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const bool has_switches = axis < 3;  // no travel is given for U
    const int number = static_cast<int>(axis);
    const double half_travel_mm = has_switches ? static_cast<double>(data.get(3 + number)) / 2000 : 0;
    const auto steps_per_mm = static_cast<double>(data.get(14 + number));
    const auto steps = [&](double way_mm) { return has_switches ? std::llround(way_mm * steps_per_mm) : kNever; };
    travel.to_switch[axis] = steps(half_travel_mm);
    travel.to_end[axis] = steps(half_travel_mm + kOvertravel_mm);
  }
  return travel;
}

Inputs SimulatedMachine::exchange(const Outputs& outputs) noexcept {
  if (const auto newest = travel_.try_load()) seen_ = *newest;
  if (!outputs.drives_on) is_cut_.store(false, std::memory_order_relaxed);
  const bool has_current = outputs.drives_on && !is_cut_.load(std::memory_order_acquire);
  Inputs inputs;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    if (has_current) {
      const std::int64_t end = seen_.to_end[axis];
      position_[axis] = std::clamp(position_[axis] + outputs.steps[axis], -end, end);
    }
    if (axis == 3) continue;  // U has no switches
    const bool at_plus = position_[axis] >= seen_.to_switch[axis], at_minus = position_[axis] <= -seen_.to_switch[axis];
    inputs.limit_plus[axis] = is_damped(!at_plus, seen_.polarity);
    inputs.limit_minus[axis] = is_damped(!at_minus, seen_.polarity);
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
