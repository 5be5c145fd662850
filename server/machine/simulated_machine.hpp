// The simulated machine: axes that count steps, limit switches at both ends with over-travel behind (DEC-23), inputs
// that the instructor or a lesson sets.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "machine/machine.hpp"
#include "machine/machine_data.hpp"

namespace cnclab::machine {

class SimulatedMachine final : public Machine {
 public:
  static constexpr double kOvertravel_mm = 20;

  /// Axes stand in the middle of their travel.
  explicit SimulatedMachine(const MachineData& data);

  Inputs exchange(const Outputs& outputs) noexcept override;

  /// Any thread: sets an input. card 0 = Input 1, cards 1 and 2 lines 1..8.
  void set_input(int card, int line, bool active) noexcept;

  /// Puts the axes elsewhere, steps from the middle of the travel; before the first tick.
  void place(const std::array<std::int64_t, 4>& steps) { position_ = steps; }

  /// Steps from the middle of the travel; tick side.
  [[nodiscard]] const std::array<std::int64_t, 4>& position_steps() const { return position_; }

 private:
  std::array<std::int64_t, 4> position_{};
  std::array<std::int64_t, 4> switch_plus_{}, switch_minus_{}, end_plus_{}, end_minus_{};
  std::atomic<std::uint32_t> inputs_{0};  ///< bit 0 Input 1, 8..15 card 1, 16..23 card 2
};

}  // namespace cnclab::machine
