// What each machine datum does to motion, against profiles worked out by hand (MD-103 to MD-117, MD-132, DEC-20).
//
// Base: F MAX 3000 = 50 mm/s, F START/STOP 300 = 5 mm/s, RAMPE 100 = 166.667 mm/s².
#include <gtest/gtest.h>

#include "channel_rig.hpp"

namespace cnclab::machine {
namespace {

struct TimeRow {
  const char* name;
  std::vector<std::pair<int, std::int64_t>> data;
  double way_mm, feed;
  bool exact_stop;
  double seconds;  ///< from START to rest
};

MachineData set_all(const std::vector<std::pair<int, std::int64_t>>& values) {
  MachineData data;
  for (const auto& [number, value] : values) {
    if (!data.set(number, value)) std::abort();
  }
  return data;
}

TEST(DataEffects, MachineTimeIsThatOfTheHandWorkedProfile) {
  const std::vector<TimeRow> rows{
      // ramps of 0.27 s and 7.425 mm, 85.15 mm at 50 mm/s
      {"base: 100 mm rapid", {}, 100, 9999, false, 0.27 + 0.27 + 1.703},
      // 25 mm/s: ramps of 0.12 s and 1.8 mm
      {"MD 06 F MAX 1500", {{6, 1500}}, 100, 9999, false, 0.12 + 0.12 + 96.4 / 25},
      // from 10 mm/s: ramps of 0.24 s and 7.2 mm
      {"MD 10 F START/STOP 600", {{10, 600}}, 100, 9999, false, 0.24 + 0.24 + 85.6 / 50},
      {"MD 10 F START/STOP = F MAX: no ramp", {{10, 3000}}, 100, 9999, false, 2.0},
      // 83.333 mm/s²: ramps of 0.54 s and 14.85 mm
      {"MD 12 RAMPE 50: flat", {{12, 50}}, 100, 9999, false, 0.54 + 0.54 + 70.3 / 50},
      // 16665 mm/s²: ramps of 2.7 ms and 0.07426 mm
      {"MD 12 RAMPE 9999: steep", {{12, 9999}}, 100, 9999, false, 0.0027 + 0.0027 + 99.85148 / 50},
      // 16.667 mm/s: up 0.07 s, 0.75833 mm; down to 2.5 mm/s 0.085 s, 0.81458 mm; 0.5 mm at 2.5 mm/s
      {"MD 11 SCHLEICHWEG 500", {}, 20, 1000, true, 0.07 + 0.085 + 17.927083 / 16.666667 + 0.2},
      {"MD 11 SCHLEICHWEG 0: no creeping", {{11, 0}}, 20, 1000, true, 0.07 + 0.07 + 18.483333 / 16.666667},
      {"MD 11 SCHLEICHWEG 9999", {{11, 9999}}, 20, 1000, true, 0.07 + 0.085 + 8.428083 / 16.666667 + 9.999 / 2.5},
      {"MD 11 creeping all the way", {{11, 9999}}, 5, 1000, true, 5 / 2.5},
      {"MD 10 halves the creeping speed too", {{10, 150}, {11, 9999}}, 5, 1000, true, 5 / 1.25}};
  for (const auto& row : rows) {
    ChannelRig rig(set_all(row.data));
    geometry::PathItem item;
    item.what = geometry::Line{{}, {0, row.way_mm, 0, 0}, row.feed, false};
    item.exact_stop = row.exact_stop;
    item.sequence = 1;
    rig.run({item});
    int ticks = 1;
    while (rig.channel.queue().waiting() > 0 && ticks < 100'000) {
      rig.tick();
      ++ticks;
    }
    EXPECT_NEAR(ticks * kTick_s, row.seconds, 1.01e-3) << row.name;
    EXPECT_EQ(rig.machine.sum[1], std::llround(row.way_mm * 200)) << row.name;
  }
}

struct StopRow {
  const char* name;
  std::vector<std::pair<int, std::int64_t>> data;
  double seconds, way_mm;
};

TEST(DataEffects, MD109StopTakesTheTimeAndTheWayOfItsOwnRamp) {
  const std::vector<StopRow> rows{// 45 mm/s by 166.667/1.2 = 138.889 mm/s²; (2500 − 25)/(2·138.889)
                                  {"STOPVERZÖGERUNG 2", {}, 0.324, 8.91},
                                  {"STOPVERZÖGERUNG 10", {{9, 10}}, 0.54, 14.85},
                                  {"STOPVERZÖGERUNG 99", {{9, 99}}, 2.943, 80.9325},
                                  {"with RAMPE 200 half of it", {{12, 200}}, 0.162, 4.455},
                                  {"with F START/STOP 1500 only down to 25 mm/s", {{10, 1500}}, 0.18, 6.75},
                                  {"from F START/STOP itself at once", {{10, 3000}}, 0, 0}};
  for (const auto& row : rows) {
    ChannelRig rig(set_all(row.data));
    Items items;
    items.line_to({400, 0, 0, 0}, 3000);
    rig.run(items);
    ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.path_mm[0] > 100; })) << row.name;
    const double from = rig.channel.snapshot().path_mm[0];
    rig.channel.stop(StopCause::operator_stop);
    int ticks = 0;
    while (rig.tick().state != MotionState::standstill) ++ticks;
    EXPECT_NEAR(ticks * kTick_s, row.seconds, 2e-3) << row.name;
    EXPECT_NEAR(rig.channel.snapshot().path_mm[0] - from, row.way_mm, 1e-6) << row.name;
  }
}

struct TravelRow {
  const char* name;
  int number;
  std::size_t axis;
};

TEST(DataEffects, MD103To105SwitchesStandAtHalfTheTravel) {
  for (const auto& row : {TravelRow{"X", 3, 0}, {"Y", 4, 1}, {"Z", 5, 2}}) {
    ChannelRig rig(data_with({{row.number, 30'000}}));
    Jog jog{kLease, {}};
    jog.direction[row.axis] = -1;
    ASSERT_TRUE(rig.channel.command(jog));
    ASSERT_TRUE(rig.tick_until([&](const Snapshot& s) { return s.limit[row.axis]; })) << row.name;
    EXPECT_NEAR(static_cast<double>(rig.machine.sum[row.axis]), -15 * 200, 10) << row.name << ": within one tick's way";
  }
}

TEST(DataEffects, MD103TravelAndMD114StepsMoveTheSimulatedSwitchesWhenTheyAreChanged) {
  ChannelRig rig;
  const MachineData data = data_with({{3, 10'000}, {14, 100}});
  ASSERT_TRUE(rig.channel.set_data(data));
  rig.machine.simulated.set_data(data);
  ASSERT_TRUE(rig.channel.command(Jog{kLease, {1, 0, 0}}));
  ASSERT_TRUE(rig.tick_until([](const Snapshot& s) { return s.limit[0]; }));
  EXPECT_NEAR(static_cast<double>(rig.machine.sum[0]), 5 * 100, 6);
}

TEST(DataEffects, MD106FMaxBoundsHandMotionAndReferenceRuns) {
  for (const std::int64_t f_max : {600, 2400}) {
    for (const bool by_hand : {true, false}) {
      ChannelRig rig(data_with({{6, f_max}, {3, 300'000}}));
      const bool taken =
          by_hand ? rig.channel.command(Jog{kLease, {1, 0, 0}}) : rig.channel.command(RunReference{kLease, {1, 0, 0}});
      ASSERT_TRUE(taken);
      double fastest = 0;
      for (int i = 0; i < 1000; ++i) fastest = std::max(fastest, rig.tick().speed_mm_per_min);
      EXPECT_NEAR(fastest, static_cast<double>(f_max), 1e-6) << by_hand;
    }
  }
}

}  // namespace
}  // namespace cnclab::machine
