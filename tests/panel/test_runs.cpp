// Runs as the machine does them: snapshot at START, abandonment, travel of the lab's machine, loops without motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench.hpp"

namespace cnclab::panel {
namespace {

using machine::StopCause;

TEST(Runs, DEC_28_ChangesActFromTheNextStart) {
  Bench bench({.tape = "P0001N001G11F600N002G01X+2000N003G01X+3000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(50);
  bench.control.replace_memory(memory_of("P0001N001G11F600N002G01X+2000N003G01X+9000%"));
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_NEAR(bench.istwert(0), 5.0, 1e-9);
  bench.keys("MENU AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_NEAR(bench.istwert(0), 16.0, 1e-9);
}

TEST(Runs, AUTH_003_AnotherMachineAbandonsTheRunAndLeadsToTheMenu) {
  Bench bench({.tape = "P0001N001G75X+1000N002G11F600M21N003G01X+50000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(300);
  Bench other;
  bench.control.connect({other.channel, machine::Epoch{1}, true, {}});
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  EXPECT_FALSE(bench.control.is_running());
  bench.run_for(2000);
  EXPECT_FALSE(bench.snapshot().started) << "abandoned, not paused";
  EXPECT_FALSE(bench.snapshot().run_active);
  EXPECT_EQ(other.snapshot().steps[0], 0);
  bench.keys("AUTOMAT");
  EXPECT_TRUE(bench.monitor(2).contains("G40 G45 G74 G91 F0600")) << bench.monitor(2);
  EXPECT_TRUE(bench.monitor(2).contains("X  +0000.000")) << "the Istwert is that of the machine now connected";
}

TEST(Runs, AUTH_003_EntryKeepsItsHalfFilledLine) {
  Bench bench;
  bench.keys("EINGABE ENTER ENTER ENTER");
  bench.type("12");
  const std::string line = bench.monitor(3);
  Bench other;
  bench.control.connect({other.channel, machine::Epoch{1}, true, {}});
  EXPECT_EQ(bench.control.mode(), Mode::editor);
  EXPECT_EQ(bench.monitor(3), line);
}

TEST(Runs, AUTH_009_ARevokedLeaseEndsTheRunAndNothingStartsByItself) {
  Bench bench({.tape = "P0001N001G11F600M03N002G01X+50000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(300);
  bench.channel->revoke(StopCause::lease_ended);
  ASSERT_TRUE(bench.run_to_rest());
  const double stopped_at = bench.istwert(0);
  EXPECT_FALSE(bench.row(18).empty());
  EXPECT_FALSE(bench.control.is_running());
  bench.keys("START");
  bench.run_for(500);
  EXPECT_EQ(bench.istwert(0), stopped_at);
  EXPECT_FALSE(bench.control.is_running());
  EXPECT_EQ(bench.row(18).substr(0, 5), "START");
}

TEST(Runs, DEC_63_AJumpLoopWithoutMotionNeitherBlocksNorDefiesStop) {
  Bench bench({.tape = "P0001N001G20P0001N001%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  const auto before = std::chrono::steady_clock::now();
  bench.run_for(1000);
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(20));
  EXPECT_TRUE(bench.control.is_running());
  bench.keys("STOP");
  EXPECT_TRUE(bench.run_to_rest(1000));
}

TEST(Runs, MENU_AndStartInTheSameMomentBeginAnew) {
  Bench bench({.tape = "P0001N001G11F600N002G01X+2000N003G01Y+1000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(100);
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
  const double rest_at = bench.istwert(0);
  ASSERT_GT(rest_at, 0);
  bench.keys("MENU AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_NEAR(bench.istwert(0), rest_at + 2.0, 1e-9);
  EXPECT_NEAR(bench.istwert(1), 1.0, 1e-9);
}

TEST(Runs, StopRightAfterStartNeverMovesOnByItself) {
  Bench bench({.tape = "P0001N001G00X+100000%"});
  bench.keys("AUTOMAT ENTER ENTER START STOP");
  bench.run_for(2000);
  EXPECT_FALSE(bench.snapshot().started);
  EXPECT_FALSE(bench.control.is_running()) << bench.row(18);
  EXPECT_LT(bench.istwert(0), 1.0);
}

TEST(Runs, MOD_058_DEC_40_ThePotentiometerScalesAndStopsMotion) {
  Bench bench({.tape = "P0001N001G11F1200N002G01X+100000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(1000);
  EXPECT_NEAR(bench.snapshot().speed_mm_per_min, 1200, 1);
  bench.control.set_override(50);
  bench.run_for(500);
  EXPECT_NEAR(bench.snapshot().speed_mm_per_min, 600, 1);
  bench.control.set_override(0);
  bench.run_for(500);
  EXPECT_EQ(bench.snapshot().speed_mm_per_min, 0);
  EXPECT_TRUE(bench.control.is_running());
}

TEST(Runs, SCR_042_DEC_40_TheWindowShowsTheBlockThatWaitsForThePotentiometer) {
  Bench bench({.tape = "P0001N001G11F1200N002G17N003G01X+2000N004G01Y+1000%"});
  bench.control.set_override(0);
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(500);
  EXPECT_EQ(bench.monitor(8), "N003 G01 X+...2.000 Y.....,... Z.....,... F.... S.... T.. M..");
  EXPECT_TRUE(bench.row(18).starts_with("P0001 N003 läuft, aber das Potentiometer steht auf 0.")) << bench.row(18);
  bench.control.set_override(100);
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(0) > 1; }));
  bench.control.set_override(0);
  bench.run_for(500);
  EXPECT_TRUE(bench.monitor(8).starts_with("N003")) << "in the middle of its way";
}

TEST(Runs, SCR_031_ABrokenRunLeavesTheMThatTheMachineHas) {
  Bench bench({.tape = "P0001N001G11F1200M13N002G01X+90000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(0) > 1; }));
  ASSERT_TRUE(bench.monitor(2).contains("M13")) << bench.monitor(2);
  bench.channel->latch(true);
  ASSERT_TRUE(bench.run_to_rest());
  ASSERT_FALSE(bench.snapshot().coolant);
  bench.keys("MENU AUTOMAT");
  EXPECT_TRUE(bench.monitor(2).contains("M12")) << bench.monitor(2);
}

TEST(Runs, DEC_21_ALongBlockIsJoinedToTheNextWithoutAStop) {
  Bench bench({.tape = "P0001N001G11F1200N002G01X+100000N003G01X+100000N004G01X-90000N005G01X-90000N006G01Y+9000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(0) > 95; }));
  double slowest = 1200;
  while (bench.istwert(0) < 105) {
    bench.run_for(1);
    slowest = std::min(slowest, bench.snapshot().speed_mm_per_min);
  }
  EXPECT_NEAR(slowest, 1200, 1) << "what follows is there before the block ends";
}

TEST(Runs, TheModalStateAfterMenuIsThatOfTheBlockReallyExecuted) {
  Bench bench({.tape = "P0001N001G11F600N002G01X+5000F700N003G90N004G01X+50000F800N005G11S900T05M08%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_until([&] { return bench.row(18).contains("N002"); }));
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("MENU AUTOMAT");
  EXPECT_TRUE(bench.monitor(2).contains("G91 F0700 S0000 T00 M12")) << bench.monitor(2);
}

TEST(Runs, AUTH_011_AReferencedLabMachineRefusesABlockThatLeavesItsTravel) {
  machine::MachineData small;
  ASSERT_TRUE(small.set(3, 20'000));
  Bench bench({.data = small,
               .tape = "P0001N001G11F1000N002G01Y+1000N003G01X+15000%",
               .is_lab_machine = true,
               .lab_data = small});
  EXPECT_TRUE(bench.row(7).contains("UNREF."));
  ASSERT_TRUE(bench.channel->command(machine::RunReference{machine::Epoch{1}, {1, 1, 1}}));
  ASSERT_TRUE(bench.run_until([&] { return bench.snapshot().is_referenced && !bench.snapshot().started; }));
  const double x_before = bench.istwert(0), y_before = bench.istwert(1);
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.monitor(15), "Verfahrweg zu gross");
  EXPECT_TRUE(bench.row(18).contains("N003")) << bench.row(18);
  EXPECT_EQ(bench.istwert(0), x_before) << "refused before it moves";
  EXPECT_GT(bench.istwert(1), y_before);
}

TEST(Runs, M_001_AlarmToneUntilStart) {
  Bench bench({.tape = "P0001N001G11F600M01N002G11M15%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(100);
  EXPECT_TRUE(bench.control.alarm_tone());
  (void)bench.control.take_beeps();
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_FALSE(bench.control.alarm_tone());
  EXPECT_EQ(bench.control.take_beeps(), 1) << "M15: one tone";
}

TEST(Runs, AUTH_008_TheSituationFollowsBlocksNotPositions) {
  Bench bench({.tape = std::string(kBild7)});
  EXPECT_EQ(bench.control.situation(), (Situation{.mode = Mode::menu}));
  bench.keys("AUTOMAT ENTER ENTER");
  EXPECT_EQ(bench.control.situation(), (Situation{.mode = Mode::automat, .program = 1, .block = 1}));
  bench.keys("START");
  EXPECT_EQ(bench.control.situation(), (Situation{.mode = Mode::automat, .program = 1, .block = 1, .started = true}));
  bench.run_for(300);
  EXPECT_EQ(bench.control.situation(), (Situation{.mode = Mode::automat, .program = 1, .block = 1, .started = true}));
  bench.run_for(3000);
  EXPECT_NE(bench.control.situation().block, 1);
}

TEST(Runs, DEC_27_TheFirstStartInG90UnderALeaseAsksForTheZero) {
  Bench bench(
      {.tape = "P0001N001G11F1000N002G90N003G01X+2000%P0002N001G11F1000N002G01X+1000%", .is_lab_machine = true});
  bench.keys("AUTOMAT CLEAR 2 ENTER ENTER START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 1) << "without G90 nothing is asked";
  bench.keys("MENU AUTOMAT CLEAR 1 ENTER ENTER START");
  bench.run_for(200);
  EXPECT_FALSE(bench.control.is_running());
  EXPECT_TRUE(bench.row(18).contains("Nullpunkt")) << bench.row(18);
  bench.keys("EINZELSATZ EINZELSATZ START");
  bench.run_for(200);
  EXPECT_FALSE(bench.control.is_running()) << "another key between: asked again";
  bench.keys("HAND START");
  bench.run_for(200);
  EXPECT_FALSE(bench.control.is_running()) << "one without effect is another key, too";
  bench.control.note_labs_key();
  bench.keys("START");
  bench.run_for(200);
  EXPECT_FALSE(bench.control.is_running()) << "and so is one of the lab's";
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 2);
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_TRUE(bench.row(18).contains("beendet")) << "once per lease: " << bench.row(18);
  bench.control.connect({bench.channel, machine::Epoch{1}, true, {}});
  bench.run_for(20);
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(200);
  EXPECT_FALSE(bench.control.is_running()) << "another lease";
}

TEST(Runs, KEY_046_EinzelsatzIsNotActiveInSubprogramsUnderM22) {
  Bench bench({.tape = "P0001N001G11F600M22N002G22P0002N001W00N003G01X+1000%P0002N001G01Y+2000%"});
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(1) > 0.5; }));
  bench.keys("EINZELSATZ");
  EXPECT_TRUE(bench.row(10).contains("○")) << bench.row(10);
  EXPECT_TRUE(bench.row(18).contains("M22")) << bench.row(18);
  ASSERT_TRUE(bench.run_until([&] { return bench.istwert(0) > 0.1; }));
  bench.keys("EINZELSATZ");
  EXPECT_TRUE(bench.row(10).contains("●")) << "in the main program it is";
}

using Clock = std::chrono::steady_clock;

std::chrono::nanoseconds each(Clock::time_point since, int times) { return (Clock::now() - since) / times; }

TEST(Runs, DrawingAndComparingAScreenIsCheap) {
  Bench bench({.tape = std::string(kBild7)});
  bench.keys("AUTOMAT ENTER ENTER START");
  bench.run_for(100);
  constexpr int kDrawings = 200;
  const Screen before = bench.screen();
  std::size_t changed = 0;
  const auto since = Clock::now();
  for (int i = 0; i < kDrawings; ++i) changed += before.changed_rows(bench.screen()).size();
  const auto time = each(since, kDrawings);
  EXPECT_EQ(changed, 0U);
  RecordProperty("ns_per_screen", static_cast<int>(time.count()));
  EXPECT_LT(time, std::chrono::milliseconds(5)) << "50 us on an idle machine; this bound holds on a busy one too";
}

TEST(Runs, AKeyOfEingabemodusIsCheap) {
  Bench bench({.tape = std::string(kBild7)});
  bench.keys("EINGABE ENTER ENTER ENTER");
  constexpr int kPresses = 500;
  const auto since = Clock::now();
  for (int i = 0; i < kPresses; ++i) bench.press(i % 5 == 0 ? Key::ENTER : Key::D7);
  const auto time = each(since, kPresses);
  RecordProperty("ns_per_key", static_cast<int>(time.count()));
  EXPECT_LT(time, std::chrono::milliseconds(20)) << "1 ms on an idle machine; this bound holds on a busy one too";
}

}  // namespace
}  // namespace cnclab::panel
