// The simulated machine: axes that count steps, limit switches at both ends with over-travel behind (DEC-23), inputs
// that the instructor or a lesson sets.
//
// Its switches are wired as the manual proposes: damped gives 0 V (HW-009). With MD 19 at 51503 they read the other way
// round, as they would on the original: free switches count as damped.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "machine/connectors.hpp"
#include "machine/machine.hpp"
#include "machine/machine_data.hpp"
#include "machine/seqlock.hpp"

namespace cnclab::machine {

class SimulatedMachine final : public Machine {
 public:
  static constexpr double kOvertravel_mm = 20;

  /// Axes stand in the middle of their travel.
  explicit SimulatedMachine(const MachineData& data);

  Inputs exchange(const Outputs& outputs) noexcept override;

  void cut() noexcept override { is_cut_.store(true, std::memory_order_release); }

  /// One thread besides the tick: travel, steps/mm and switch polarity from the next tick on. The axes keep their
  /// steps.
  void set_data(const MachineData& data) noexcept { travel_.store(travel_of(data)); }

  /// Any thread: sets an input. card 0 = Input 1, cards 1 and 2 lines 1..8.
  void set_input(int card, int line, bool active) noexcept;

  /// Puts the axes elsewhere, steps from the middle of the travel; before the first tick.
  void place(const std::array<std::int64_t, 4>& steps) { position_ = steps; }

  /// Steps from the middle of the travel; tick side.
  [[nodiscard]] const std::array<std::int64_t, 4>& position_steps() const { return position_; }

 private:
  /// In steps from the middle, the same to both sides.
  struct Travel {
    std::array<std::int64_t, 4> to_switch{}, to_end{};
    SwitchPolarity polarity = SwitchPolarity::damped_is_low;
  };
  [[nodiscard]] static Travel travel_of(const MachineData& data);

  SeqLock<Travel> travel_;
  Travel seen_;  ///< tick side
  std::array<std::int64_t, 4> position_{};
  std::atomic<bool> is_cut_{false};
  std::atomic<std::uint32_t> inputs_{0};  ///< bit 0 Input 1, 8..15 card 1, 16..23 card 2
};

}  // namespace cnclab::machine
