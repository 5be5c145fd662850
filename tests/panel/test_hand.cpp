// HANDBETRIEB as the machine does it (2.1, MOD-005 to MOD-016, D-10 to D-13, D-117).
#include <gtest/gtest.h>

#include "bench.hpp"

namespace cnclab::panel {
namespace {

using machine::StopCause;

TEST(Hand, MOD_005_006_008_StartMovesTheChosenAxesStopClearsThem) {
  Bench bench;
  bench.keys("HAND PLUS_X MINUS_Z START");
  bench.run_for(1000);
  EXPECT_TRUE(bench.control.is_running());
  EXPECT_NEAR(bench.snapshot().speed_mm_per_min, 3000, 1) << "F MAX is the path speed of all axes together";
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
  const double x = bench.istwert(0), z = bench.istwert(2);
  EXPECT_GT(x, 10);
  EXPECT_NEAR(z, -x, 0.01);
  EXPECT_EQ(bench.istwert(1), 0);
  bench.keys("START");
  bench.run_for(500);
  EXPECT_EQ(bench.istwert(0), x) << "a new START without a new selection does nothing";
  EXPECT_FALSE(bench.snapshot().started);
}

TEST(Hand, MOD_007_DEC_40_ThePotentiometerSetsTheSpeedAtOnce) {
  Bench bench;
  bench.control.set_override(50);
  bench.keys("HAND PLUS_Y START");
  bench.run_for(1000);
  EXPECT_NEAR(bench.snapshot().speed_mm_per_min, 1500, 1);
  bench.control.set_override(10);
  bench.run_for(1000);
  EXPECT_NEAR(bench.snapshot().speed_mm_per_min, 300, 1);
  bench.control.set_override(0);
  bench.run_for(1000);
  const double slow = bench.istwert(1);
  bench.run_for(1000);
  EXPECT_GT(bench.istwert(1), slow) << "slow single steps";
  EXPECT_LT(bench.istwert(1), slow + 0.1);
}

TEST(Hand, D_10_OppositeKeyReplacesSameKeyDeselects) {
  Bench bench;
  bench.keys("HAND PLUS_X MINUS_X PLUS_Y PLUS_Y START");
  bench.run_for(500);
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_LT(bench.istwert(0), 0);
  EXPECT_EQ(bench.istwert(1), 0);
}

TEST(Hand, MOD_009_D_12_SpindleAndCoolantToggleAndStayOnDuringMotion) {
  Bench bench({.tape = "P0001N001G11S0800M04N002G11M05%"});
  bench.keys("HAND FRAESER KUEHLMITTEL");
  bench.run_for(10);
  EXPECT_EQ(bench.snapshot().spindle, geometry::SpindleTurn::clockwise) << "clockwise where nothing was programmed";
  bench.keys("PLUS_X START");
  bench.run_for(200);
  bench.keys("FRAESER KUEHLMITTEL");
  bench.run_for(10);
  EXPECT_NE(bench.snapshot().spindle, geometry::SpindleTurn::off) << "ignored in START state (KEY-039)";
  EXPECT_TRUE(bench.snapshot().coolant);
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("FRAESER KUEHLMITTEL");
  bench.run_for(10);
  EXPECT_EQ(bench.snapshot().spindle, geometry::SpindleTurn::off);
  EXPECT_FALSE(bench.snapshot().coolant);
  bench.keys("MENU AUTOMAT ENTER ENTER EINZELSATZ START");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("MENU HAND FRAESER");
  bench.run_for(10);
  EXPECT_EQ(bench.snapshot().spindle, geometry::SpindleTurn::counterclockwise) << "as last programmed";
  EXPECT_EQ(bench.snapshot().spindle_rpm, 800);
}

TEST(Hand, MOD_011_012_ReferenceDrivesTheChosenAxesToTheirSwitchesAndOneMillimetreBack) {
  machine::MachineData small;
  ASSERT_TRUE(small.set(3, 20'000));
  ASSERT_TRUE(small.set(4, 20'000));
  Bench bench({.data = small});
  bench.keys("HAND MINUS_X PLUS_Y REFERENZ");
  bench.run_for(100);
  EXPECT_TRUE(bench.control.is_running());
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 0);
  EXPECT_EQ(bench.istwert(1), 0);
  const auto& steps = bench.machine.position_steps();
  EXPECT_NEAR(static_cast<double>(steps[0]) / 200, -9, 0.02) << "10 mm to the switch, 1 mm back";
  EXPECT_NEAR(static_cast<double>(steps[1]) / 200, 9, 0.02);
  EXPECT_EQ(steps[2], 0) << "only chosen axes";
  EXPECT_EQ(bench.control.mode(), Mode::hand);
  bench.keys("REFERENZ");
  bench.run_for(50);
  EXPECT_FALSE(bench.snapshot().started) << "nothing chosen: ignored (D-11)";
}

TEST(Hand, MOD_013_KEY_029_StopDuringTheReferenceRunLeadsToTheMenu) {
  Bench bench;
  bench.keys("HAND PLUS_X REFERENZ");
  bench.run_for(500);
  bench.keys("STOP");
  EXPECT_EQ(bench.control.mode(), Mode::hand) << "START state until the axes stand still";
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  EXPECT_FALSE(bench.snapshot().started);
}

TEST(Hand, D_117_ERR_021_AtALimitSwitchOnlyTheWayBackIsFree) {
  machine::MachineData small;
  ASSERT_TRUE(small.set(4, 10'000));
  Bench bench({.data = small});
  bench.keys("HAND PLUS_Y START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.snapshot().cause, StopCause::limit_switch);
  EXPECT_NEAR(bench.istwert(1), 5, 0.1) << "no zeroing by hand";
  EXPECT_EQ(bench.monitor(15), std::string(16, ' ') + "Endschalter");
  bench.keys("PLUS_Y START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_NEAR(bench.istwert(1), 5, 0.1);
  EXPECT_FALSE(bench.row(18).empty());
  bench.keys("MINUS_Y START");
  bench.run_for(100);
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_LT(bench.istwert(1), 4.9);
  EXPECT_EQ(bench.monitor(15), "") << "the message stands only while the switch is active";
}

TEST(Hand, AUTH_009_ALostLeaseStopsAndNothingStartsWithoutANewOne) {
  Bench bench;
  bench.keys("HAND PLUS_X START");
  bench.run_for(300);
  bench.channel->revoke(StopCause::lease_ended);
  ASSERT_TRUE(bench.run_to_rest());
  const double x = bench.istwert(0);
  EXPECT_TRUE(bench.row(18).contains("genommen")) << bench.row(18);
  bench.keys("PLUS_X START");
  bench.run_for(300);
  EXPECT_EQ(bench.istwert(0), x);
  EXPECT_FALSE(bench.control.is_running());
  EXPECT_TRUE(bench.row(18).contains("START")) << bench.row(18);
}

TEST(Hand, AUTH_003_AnotherMachineDropsTheChosenDirections) {
  Bench bench, other;
  bench.keys("HAND PLUS_X");
  bench.control.connect({other.channel, machine::Epoch{1}, true, {}});
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  bench.keys("HAND START");
  other.run_for(300);
  EXPECT_EQ(other.istwert(0), 0);
}

struct IstwertCase {
  std::string_view name, typed, shown;
};

constexpr IstwertCase kIstwerte[] = {
    {"D_13 whole millimetres", "12", "+0012.000"},
    {"D_13 decimals", "1.25", "+0001.250"},
    {"D_13 sign", "7-", "-0007.000"},
    {"D_13 sign first", "-7.5", "-0007.500"},
    {"surplus figures are ignored", "12345", "+1234.000"},
    {"DEC_12 the first digit replaces", "", "+0002.500"},
};

TEST(Hand, MOD_010_KEY_060_TheTypedValueStandsInTheCounterAtOnce) {
  for (const IstwertCase& row : kIstwerte) {
    SCOPED_TRACE(std::string(row.name));
    Bench bench;
    bench.keys("HAND ISTWERT MINUS_Y");
    bench.type("2.5");
    bench.run_for(10);
    bench.keys("PLUS_Y");  // either sign key chooses the axis (KEY-033)
    bench.type(row.typed);
    EXPECT_TRUE(bench.monitor(3).ends_with(row.shown)) << bench.monitor(3);
    bench.run_for(10);
    EXPECT_TRUE(bench.monitor(3).ends_with(row.shown)) << "and the machine counts from it";
    bench.keys("CLEAR");
    bench.run_for(10);
    EXPECT_EQ(bench.istwert(1), 0) << "KEY-074";
  }
}

TEST(Hand, D_13_StartIsIgnoredInsideIstwertAndMenuKeepsTheValues) {
  Bench bench;
  bench.keys("HAND PLUS_X ISTWERT START");
  bench.run_for(100);
  EXPECT_FALSE(bench.snapshot().started);
  bench.keys("PLUS_Z");
  bench.type("40");
  bench.keys("START");
  bench.run_for(100);
  EXPECT_FALSE(bench.snapshot().started);
  bench.keys("MENU HAND");
  EXPECT_EQ(bench.istwert(2), 40);
  EXPECT_EQ(bench.monitor(4).substr(51), "Z  +0040.000");
}

TEST(Hand, SCR_010_ACounterBehindTheLargestWordKeepsItsPlace) {
  Bench bench;
  bench.keys("HAND ISTWERT MINUS_Y");
  bench.type("-9999.9");
  bench.keys("ISTWERT MINUS_Y START");
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(1) < -10'000; }, 20'000));
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_TRUE(bench.monitor(3).substr(51).starts_with("Y -100")) << bench.monitor(3);
  EXPECT_EQ(bench.monitor(3).size(), bench.monitor(2).size()) << "X and Y end in the same column";
}

}  // namespace
}  // namespace cnclab::panel
