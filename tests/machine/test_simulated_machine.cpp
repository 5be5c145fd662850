// The simulated axes: travel, switches, over-travel (DEC-23), inputs.
#include <gtest/gtest.h>

#include "channel_rig.hpp"

namespace cnclab::machine {
namespace {

TEST(SimulatedMachine, DEC23SwitchesAtBothEndsAndTwentyMillimetresBehind) {
  SimulatedMachine machine(data_with({{3, 100'000}}));
  Outputs outputs;
  EXPECT_FALSE(machine.exchange(outputs).limit_plus[0]);
  outputs.steps[0] = 50 * 200 - 1;
  EXPECT_FALSE(machine.exchange(outputs).limit_plus[0]);
  outputs.steps[0] = 1;
  EXPECT_TRUE(machine.exchange(outputs).limit_plus[0]);
  outputs.steps[0] = 100'000;
  EXPECT_TRUE(machine.exchange(outputs).limit_plus[0]);
  EXPECT_EQ(machine.position_steps()[0], 70 * 200);
  outputs.steps[0] = -1'000'000;
  const Inputs low = machine.exchange(outputs);
  EXPECT_TRUE(low.limit_minus[0]);
  EXPECT_FALSE(low.limit_plus[0]);
  EXPECT_EQ(machine.position_steps()[0], -70 * 200);
}

TEST(SimulatedMachine, WithoutCurrentNothingMoves) {
  SimulatedMachine machine({});
  Outputs outputs;
  outputs.drives_on = false;
  outputs.steps = {5, 5, 5, 5};
  (void)machine.exchange(outputs);
  EXPECT_EQ(machine.position_steps(), (std::array<std::int64_t, 4>{}));
}

TEST(SimulatedMachine, InputsAreWhatWasSet) {
  SimulatedMachine machine({});
  machine.set_input(0, 0, true);
  machine.set_input(1, 1, true);
  machine.set_input(2, 8, true);
  for (const auto& [card, line] : {std::pair{1, 0}, {1, 9}, {3, 1}, {-1, 1}}) machine.set_input(card, line, true);
  const Inputs inputs = machine.exchange({});
  EXPECT_TRUE(inputs.input_1);
  EXPECT_EQ(inputs.cards, (std::array<std::uint8_t, 2>{0x01, 0x80}));
  machine.set_input(0, 0, false);
  EXPECT_FALSE(machine.exchange({}).input_1);
}

}  // namespace
}  // namespace cnclab::machine
