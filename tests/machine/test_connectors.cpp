// Levels at the original's connectors (HW, M-904, MD 19).
#include <gtest/gtest.h>

#include "channel_rig.hpp"
#include "machine/connectors.hpp"

namespace cnclab::machine {
namespace {

TEST(Connectors, HW006SmSignalsAreLowActive) {
  const OutputLevels rest = levels_of({.drives_on = true});
  EXPECT_TRUE(rest.no_current && rest.coolant && rest.spindle_on && rest.spindle_left && rest.start);
  EXPECT_FALSE(levels_of({.drives_on = false}).no_current) << "HW-004";
  EXPECT_FALSE(levels_of({.start = true}).start) << "HW-005";
  EXPECT_FALSE(levels_of({.coolant = true}).coolant) << "HW-021";
  const OutputLevels right = levels_of({.spindle = geometry::SpindleTurn::clockwise});
  EXPECT_FALSE(right.spindle_on);
  EXPECT_TRUE(right.spindle_left);
  const OutputLevels left = levels_of({.spindle = geometry::SpindleTurn::counterclockwise});
  EXPECT_FALSE(left.spindle_on);
  EXPECT_FALSE(left.spindle_left);
}

TEST(Connectors, M904CardOutputsPullToGroundAndInputsAreHighActive) {
  EXPECT_EQ(levels_of({.cards = {0x04, 0x80}}).cards, (std::array<std::uint8_t, 2>{0xFB, 0x7F}));
  InputReader reader(SwitchPolarity::damped_is_low);
  EXPECT_EQ(reader.read({.cards = {0x21, 0x00}}, {}).cards, (std::array<std::uint8_t, 2>{0x21, 0x00}));
  EXPECT_FALSE(reader.read({.input_1 = true}, {}).input_1);
  EXPECT_TRUE(reader.read({.input_1 = false}, {}).input_1) << "HW-022: a line of the SM interface";
}

TEST(Connectors, FST004SpeedGoesOutDigitByDigitUnitsFirst) {
  using Digits = std::array<std::uint8_t, 4>;
  EXPECT_EQ(digits_of_s(1234), (Digits{4, 3, 2, 1}));
  EXPECT_EQ(digits_of_s(500), (Digits{0, 0, 5, 0}));
  EXPECT_EQ(digits_of_s(9999), (Digits{9, 9, 9, 9}));
  EXPECT_EQ(digits_of_s(0), Digits{});
}

struct PolarityRow {
  const char* name;
  std::int64_t endschalter_pol;
  bool is_high, is_damped;
};

TEST(Connectors, MD119SaysWhichLevelMeansDamped) {
  for (const auto& row : {PolarityRow{"201, 0 V", 201, false, true},
                          {"201, 24 V", 201, true, false},
                          {"51503, 0 V", 51503, false, false},
                          {"51503, 24 V", 51503, true, true}}) {
    EXPECT_EQ(is_damped(row.is_high, switch_polarity(row.endschalter_pol)), row.is_damped) << row.name;
  }
}

TEST(Connectors, HW008OneLinePerAxisIsToldApartByTheLastMotion) {
  InputReader reader(SwitchPolarity::damped_is_low);
  const InputLevels free;
  InputLevels damped;
  damped.limit_lines = {false, true, true, false};
  Inputs inputs = reader.read(free, {3, 0, 0, -1});
  EXPECT_FALSE(inputs.limit_plus[0] || inputs.limit_minus[3]);
  inputs = reader.read(damped, {2, 0, 0, -1});
  EXPECT_TRUE(inputs.limit_plus[0]);
  EXPECT_FALSE(inputs.limit_minus[0]);
  EXPECT_TRUE(inputs.limit_minus[3]) << "U has a line too";
  EXPECT_FALSE(inputs.limit_plus[3]);
  inputs = reader.read(damped, {-1, 0, 0, 0});
  EXPECT_TRUE(inputs.limit_plus[0] && !inputs.limit_minus[0]) << "backing off does not change the side";
  inputs = reader.read(free, {-1, 0, 0, 0});
  EXPECT_FALSE(inputs.limit_plus[0] || inputs.limit_minus[0]);
  inputs = reader.read(damped, {0, 0, 0, 0});
  EXPECT_TRUE(inputs.limit_minus[0]) << "the last motion was that way";
}

TEST(Connectors, AxisThatNeverMovedIsReportedOnBothSides) {
  InputReader reader(SwitchPolarity::damped_is_low);
  const Inputs inputs = reader.read({.limit_lines = {false, true, true, true}}, {});
  EXPECT_TRUE(inputs.limit_plus[0] && inputs.limit_minus[0]);
}

TEST(Connectors, MD119WrongPolarityOnTheSimulatedMachineReadsFreeSwitchesAsDamped) {
  ChannelRig rig(data_with({{19, 51503}}));
  EXPECT_TRUE(rig.channel.snapshot().limit[0]);
  EXPECT_FALSE(rig.channel.snapshot().limit[3]);
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {1, 0, 0}}));
  rig.tick(50);
  EXPECT_EQ(rig.machine.moving_ticks, 0) << "D-117: not towards a switch that is active";
  rig.machine.simulated.set_data({});
  EXPECT_FALSE(rig.tick().limit[0]);
}

}  // namespace
}  // namespace cnclab::machine
