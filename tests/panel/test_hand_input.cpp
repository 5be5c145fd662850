// HANDEINGABE as the machine does it (2.2, MOD-020 to MOD-029, EX-020 to EX-025, D-37, D-39).
#include <gtest/gtest.h>

#include "bench.hpp"

namespace cnclab::panel {
namespace {

/// Keys the function in over what stands there, and goes to its words.
void function(Bench& bench, std::string_view code) {
  for (int i = 0; i < 12 && bench.marks().back() != "6 1 1"; ++i) bench.keys("ENTER");
  bench.type(code);
}

/// G00 X10, and STOP on the way there.
void stop_on_the_way(Bench& bench) {
  bench.keys("HANDEINGABE");
  bench.type("00");
  bench.keys("ENTER");
  bench.type("10");
  bench.keys("START");
  bench.run_for(150);
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
}

/// Keys in the function and START.
void execute(Bench& bench, std::string_view code) {
  function(bench, code);
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
}

TEST(HandInput, EX_020_JoggingRepeatsTheBlockWithEveryStart) {
  Bench bench;
  bench.keys("HANDEINGABE");
  execute(bench, "91");
  function(bench, "00");
  bench.keys("ENTER");
  bench.type("10");
  bench.keys("START");
  bench.run_for(20);
  EXPECT_TRUE(bench.control.is_running());
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 10);
  EXPECT_EQ(bench.monitor(5), "G00 □+..10.000 Y.....,... Z.....,... (EILGANG)") << "the block stays (MOD-024)";
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 20);
}

TEST(HandInput, EX_021_StopThenStartDoesOnlyTheRest) {
  Bench bench;
  stop_on_the_way(bench);
  EXPECT_GT(bench.istwert(0), 0);
  EXPECT_LT(bench.istwert(0), 10);
  bench.keys("CLEAR");
  bench.type("5");
  EXPECT_TRUE(bench.row(18).contains("erst START")) << "what waits is the rest of the block as it was started";
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 10);
}

TEST(HandInput, EX_022_MenuAbandonsTheRestAndThePositionStays) {
  Bench bench;
  stop_on_the_way(bench);
  const double stopped_at = bench.istwert(0);
  bench.keys("MENU");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  bench.keys("HANDEINGABE");
  EXPECT_EQ(bench.monitor(5), "G01 X.....,... Y.....,... Z.....,... F.... S.... T.. M..");
  bench.keys("START");
  bench.run_for(500);
  EXPECT_EQ(bench.istwert(0), stopped_at);
}

TEST(HandInput, EX_023_AbsolutePosition) {
  Bench bench;
  bench.keys("HAND ISTWERT PLUS_X");
  bench.type("12.5");
  bench.keys("MENU HANDEINGABE");
  bench.run_for(10);
  execute(bench, "90");
  function(bench, "00");
  bench.keys("ENTER");
  bench.type("50");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 50);
}

TEST(HandInput, EX_024_DEC_55_HalfCircleWithTheFeedOfAFormerG11) {
  Bench bench;
  bench.keys("HANDEINGABE");
  execute(bench, "91");
  execute(bench, "17");
  function(bench, "02");
  bench.keys("ENTER");
  bench.type("10");
  bench.keys("ENTER");
  bench.type("0");
  bench.keys("ENTER");
  bench.type("5");
  bench.keys("ENTER");
  bench.type("0");
  bench.keys("START");
  EXPECT_EQ(bench.monitor(15), "F fehlt");
  function(bench, "11");
  bench.keys("ENTER");
  bench.type("1000");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  function(bench, "02");
  bench.keys("ENTER");
  for (const std::string_view word : {"10", "0", "5", "0"}) {
    bench.type(word);
    bench.keys("ENTER");
  }
  double top = 0;
  bench.keys("START");
  ASSERT_TRUE(bench.run_until([&] {
    top = std::max(top, bench.istwert(1));
    return !bench.control.is_running();
  }));
  EXPECT_NEAR(bench.istwert(0), 10, 0.005);
  EXPECT_NEAR(bench.istwert(1), 0, 0.005);
  EXPECT_NEAR(top, 5, 0.05) << "clockwise from the left: over the top";
}

TEST(HandInput, MOD_027_ModalFunctionsPersistForTheNextBlocksAndModes) {
  Bench bench;
  bench.keys("HANDEINGABE");
  for (const std::string_view code : {"18", "90"}) execute(bench, code);
  EXPECT_TRUE(bench.monitor(3).starts_with("START  G18 G40 G45 G74 G90 F0000 S0000 T00 M12")) << bench.monitor(3);
  bench.keys("MENU HAND HANDEINGABE");
  EXPECT_TRUE(bench.monitor(3).starts_with("START  G18 G40 G45 G74 G90")) << bench.monitor(3);
  bench.type("02");
  bench.keys("ENTER");
  EXPECT_EQ(bench.monitor(5), "G02 □.....,... Z.....,... I.....,... K.....,...") << "words of the active plane";
}

struct Barred {
  std::string_view code, words;  ///< typed with → between
};

constexpr Barred kBarred[] = {
    {"04", "50"},    {"20", "1>1"},   {"21", "1>1"},   {"22", "1>1>0"}, {"64", "50"},
    {"23", "1>1>0"}, {"11", ">>>02"}, {"11", ">>>00"}, {"11", ">>>01"},
};

TEST(HandInput, MOD_028_D_37_BarredFunctionsAreEnteredButNotExecuted) {
  for (const Barred& row : kBarred) {
    SCOPED_TRACE(std::string(row.code));
    Bench bench({.tape = "P0001N001G01X+50000F1000%"});
    bench.keys("HANDEINGABE");
    bench.type(row.code);
    bench.keys("ENTER");
    for (const char key : row.words)
      if (key == '>')
        bench.keys("ENTER");
      else
        bench.type(std::string_view(&key, 1));
    bench.keys("START");
    bench.run_for(100);
    EXPECT_FALSE(bench.snapshot().started);
    EXPECT_EQ(bench.istwert(0), 0);
    EXPECT_TRUE(bench.row(18).contains("nicht ausgeführt")) << bench.row(18);
  }
}

TEST(HandInput, D_37_M02_IsSkippedAndTheMotionOfItsBlockRuns) {
  Bench bench;
  bench.keys("HANDEINGABE ENTER");
  bench.type("2");
  bench.keys("ENTER ENTER ENTER");
  bench.type("1000");
  bench.keys("ENTER ENTER ENTER");
  bench.type("02");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 2);
  EXPECT_TRUE(bench.monitor(3).contains("F1000 S0000 T00 M12")) << bench.monitor(3);
}

TEST(HandInput, KEY_073_MOD_028_DownIsIgnored) {
  Bench bench;
  bench.keys("HANDEINGABE DOWN");
  EXPECT_EQ(bench.monitor(5), "G01 X.....,... Y.....,... Z.....,... F.... S.... T.. M..");
  bench.keys("ENTER DOWN");
  EXPECT_EQ(bench.monitor(5), "G01 □.....,... Y.....,... Z.....,... F.... S.... T.. M..");
}

TEST(HandInput, ERR_001_002_003_FaultsAreTold) {
  Bench bench;
  bench.keys("HANDEINGABE");
  bench.type("99");
  bench.keys("START");
  EXPECT_EQ(bench.monitor(15), "Funktion nicht vorgesehen");
  bench.type("00");
  bench.keys("START");
  EXPECT_EQ(bench.monitor(15), "Satz überprüfen") << "no axis";
  EXPECT_EQ(bench.row(18).find("N001"), std::string::npos) << "it is no block of a program: " << bench.row(18);
  bench.type("9000");
  bench.keys("START");
  EXPECT_EQ(bench.monitor(15), "Satz überprüfen") << "MD 03";
  EXPECT_EQ(bench.monitor(5), "G00 □+9000.000 Y.....,... Z.....,... (EILGANG)");
  EXPECT_FALSE(bench.control.is_running());
}

TEST(HandInput, KEY_013_StartEndsTheWaitOfAnMFunction) {
  Bench bench;
  bench.keys("HANDEINGABE");
  bench.type("11");
  bench.keys("ENTER ENTER ENTER ENTER");
  bench.type("16");
  bench.keys("START");
  bench.run_for(200);
  EXPECT_TRUE(bench.control.is_running());
  EXPECT_TRUE(bench.row(18).contains("wartet")) << bench.row(18);
  bench.keys("MENU START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.control.mode(), Mode::hand_input);
}

TEST(HandInput, DEC_38_SpindleStaysOnBetweenBlocksOnTheLabsMachineToo) {
  Bench bench({.is_lab_machine = true});
  bench.keys("HANDEINGABE");
  bench.type("11");
  bench.keys("ENTER ENTER");
  bench.type("900");
  bench.keys("ENTER ENTER");
  bench.type("03");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.snapshot().spindle, geometry::SpindleTurn::clockwise);
  EXPECT_EQ(bench.snapshot().spindle_rpm, 900);
}

TEST(HandInput, D_117_LimitSwitchFreesAndZeroesTheAxis) {
  machine::MachineData small;
  ASSERT_TRUE(small.set(3, 20'000));
  Bench bench({.data = small});
  bench.keys("HANDEINGABE");
  bench.type("00");
  bench.keys("ENTER");
  bench.type("15");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  ASSERT_TRUE(bench.run_until([&] { return bench.snapshot().state == machine::MotionState::standstill; }));
  EXPECT_EQ(bench.monitor(15), "Endschalter");
  EXPECT_EQ(bench.istwert(0), 0);
  bench.keys("ENTER");
  EXPECT_EQ(bench.monitor(15), "") << "until the next key";
}

TEST(HandInput, DEC_53_CyclesRunAsOneFunction) {
  Bench bench;
  bench.keys("HANDEINGABE");
  function(bench, "11");
  bench.keys("ENTER");
  bench.type("1000");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  function(bench, "81");
  bench.keys("ENTER");
  EXPECT_EQ(bench.monitor(5), "G81 □.....,... Y.....,... Z.....,... Q.....,... V... H....");
  bench.keys("ENTER ENTER");
  bench.type("-3");
  bench.keys("ENTER ENTER");
  bench.type("5");
  bench.keys("ENTER");
  bench.type("500");
  bench.keys("START");
  double deepest = 0;
  ASSERT_TRUE(bench.run_until([&] {
    deepest = std::min(deepest, bench.istwert(2));
    return !bench.control.is_running();
  })) << bench.picture();
  EXPECT_TRUE(bench.monitor(15).empty()) << bench.picture();
  EXPECT_NEAR(deepest, -8, 0.1) << "V above the surface, Z below it";
  EXPECT_EQ(bench.istwert(2), 0) << "back at the point of call";
}

TEST(HandInput, D_75_CompensationIsCarriedFromBlockToBlock) {
  Bench bench({.tape = "P0000T001R+5000L+2000%"});
  bench.keys("HANDEINGABE");
  function(bench, "11");
  bench.keys("ENTER");
  bench.type("1000");
  bench.keys("ENTER ENTER 0 1 START");
  ASSERT_TRUE(bench.run_to_rest());
  execute(bench, "41");
  function(bench, "01");
  bench.keys("ENTER");
  bench.type("20");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest()) << bench.picture();
  EXPECT_EQ(bench.istwert(0), 20);
  EXPECT_EQ(bench.istwert(1), 5) << "left of the way +X: the normal offset of its own end";
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_EQ(bench.istwert(0), 40) << "the second way begins where the first has ended, beside it";
  EXPECT_EQ(bench.istwert(1), 5);
  Bench after({.tape = "P0000T001R+5000L+2000%"});
  after.control.restore_state(bench.control.save_state());
  after.run_for(20);
  after.keys("START");
  ASSERT_TRUE(after.run_to_rest());
  EXPECT_EQ(after.istwert(0), 60) << "and goes on after a log-out";
  EXPECT_EQ(after.istwert(1), 5);
}

TEST(HandInput, MODEL_007_TheReducedModelHasNeitherG90NorArcs) {
  for (const std::string_view code : {"90", "02", "03", "17", "41"}) {
    Bench::Setup setup;
    setup.settings.vocabulary.model = language::Model::cnc3250;
    Bench bench(setup);
    bench.keys("HANDEINGABE");
    bench.type(code);
    bench.keys("START");
    EXPECT_EQ(bench.monitor(15), "Funktion nicht vorgesehen") << code;
  }
}

TEST(HandInput, DEC_27_AMachineThatRequiresAReferenceMovesOnlyByHand) {
  Bench bench;
  bench.control.connect({bench.channel, machine::Epoch{1}, true, {}, true});
  bench.keys("HANDEINGABE");
  bench.type("00");
  bench.keys("ENTER");
  bench.type("5");
  bench.keys("START");
  bench.run_for(300);
  EXPECT_EQ(bench.istwert(0), 0);
  EXPECT_TRUE(bench.row(18).contains("referenziert")) << bench.row(18);
  bench.keys("HAND PLUS_X START");
  bench.run_for(300);
  EXPECT_GT(bench.istwert(0), 0);
}

TEST(HandInput, DEC_01_AnErrorOfTheLineSpeaksOfItsBlock) {
  Bench bench;
  bench.keys("HANDEINGABE 1 1 ENTER 6 0 0 START");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("MENU HANDEINGABE 1 0 ENTER 5 START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_TRUE(bench.row(18).starts_with("Der Satz: G10 rundet nur zwischen zwei G01 der Ebene.")) << bench.row(18);
}

}  // namespace
}  // namespace cnclab::panel
