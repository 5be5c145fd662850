// TEACH IN as the machine does it (2.3, MOD-035 to MOD-043, EX-120, EX-121, D-38, DEC-61).
#include <gtest/gtest.h>

#include <cmath>

#include "bench.hpp"
#include "language/tape.hpp"

namespace cnclab::panel {
namespace {

/// Drives by hand until the counter of the axis has changed by at least `way`; where it stops decides the ramp.
void jog(Bench& bench, std::string_view key, int axis, double way) {
  const double before = bench.istwert(axis);
  bench.keys(key);
  bench.keys("START");
  ASSERT_TRUE(bench.run_until([&] { return std::abs(bench.istwert(axis) - before) >= std::abs(way); }, 20'000));
  bench.keys("STOP");
  ASSERT_TRUE(bench.run_to_rest());
}

std::string tape_of(const Bench& bench, std::uint16_t program) {
  std::string tape;
  const language::Program* found = bench.control.memory().find(program);
  if (found == nullptr) return tape;
  for (const language::Block& block : found->blocks) tape += language::write_block(block) + " ";
  return tape;
}

std::string um(double mm) { return std::to_string(std::llround(mm * 1000)); }

TEST(TeachIn, EX_120_TheWaySinceTheLastStoredPositionUnderG91) {
  Bench bench;
  bench.control.set_override(20);
  bench.keys("TEACH_IN");
  EXPECT_EQ(bench.monitor(5), "PROGRAMM NR □0001") << "the lowest free number is offered (D-35)";
  bench.keys("ENTER");
  EXPECT_EQ(bench.monitor(6), "N001 G01 X.....,... Y.....,... Z.....,... F.... S.... T.. M..");
  jog(bench, "PLUS_X", 0, 10);
  jog(bench, "PLUS_Z", 2, 5);
  const double x = bench.istwert(0), z = bench.istwert(2);
  bench.keys("EINGABE");
  EXPECT_EQ(tape_of(bench, 1), "N001G01X+" + um(x) + "Z+" + um(z) + " ") << "no difference, no word";
  EXPECT_EQ(bench.monitor(6), "N002 G01 X.....,... Y.....,... Z.....,... F.... S.... T.. M..");
  jog(bench, "PLUS_Y", 1, 20);
  bench.keys("EINGABE");
  EXPECT_TRUE(tape_of(bench, 1).ends_with("N002G01Y+" + um(bench.istwert(1)) + " ")) << tape_of(bench, 1);
  EXPECT_EQ(bench.stores(), 2);
}

TEST(TeachIn, EX_121_MOD_041_ThePlaceOfAllAxesUnderG90) {
  Bench bench;
  bench.keys("HANDEINGABE");
  bench.type("90");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("MENU TEACH_IN ENTER");
  jog(bench, "PLUS_X", 0, 10);
  bench.keys("EINGABE");
  const std::string x = um(bench.istwert(0));
  EXPECT_EQ(tape_of(bench, 1), "N001G01X+" + x + "Y+0Z+0 ");
  jog(bench, "MINUS_Y", 1, 20);
  bench.keys("EINGABE");
  EXPECT_TRUE(tape_of(bench, 1).ends_with("N002G01X+" + x + "Y" + um(bench.istwert(1)) + "Z+0 ")) << tape_of(bench, 1);
}

TEST(TeachIn, MOD_040_MovingOnBeforeEingabeReplacesTheValues) {
  Bench bench;
  bench.keys("TEACH_IN ENTER");
  jog(bench, "PLUS_X", 0, 5);
  const double first = bench.istwert(0);
  jog(bench, "PLUS_X", 0, 5);
  EXPECT_GT(bench.istwert(0), first + 4);
  bench.keys("EINGABE");
  EXPECT_EQ(tape_of(bench, 1), "N001G01X+" + um(bench.istwert(0)) + " ");
}

TEST(TeachIn, MOD_036_KEY_078_WordsAreAddedByKeyboard) {
  Bench bench;
  bench.keys("TEACH_IN ENTER");
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("ENTER ENTER ENTER ENTER");
  bench.type("800");
  bench.keys("ENTER ENTER");
  bench.type("3");
  bench.keys("ENTER");
  bench.type("03");
  EXPECT_TRUE(bench.monitor(6).ends_with("Z.....,... F0800 S.... T03 □03")) << bench.monitor(6);
  bench.keys("EINGABE");
  EXPECT_EQ(tape_of(bench, 1), "N001G01X+" + um(bench.istwert(0)) + "F0800T03M03 ");
  EXPECT_EQ(bench.control.take_beeps(), 1) << "EDIT-027";
}

TEST(TeachIn, EDIT_014_AnEmptyBlockIsRefused) {
  Bench bench;
  bench.keys("TEACH_IN ENTER EINGABE");
  EXPECT_EQ(bench.monitor(15), "Satz überprüfen");
  EXPECT_EQ(bench.stores(), 0);
}

TEST(TeachIn, DEC_61_AnExistingProgramIsContinuedFromTheLastStoredPosition) {
  Bench bench({.tape = "P0007N001G01X+1000F500N005G01X+1000%"});
  bench.keys("TEACH_IN");
  bench.type("7");
  bench.keys("ENTER");
  EXPECT_TRUE(bench.monitor(6).starts_with("N006 G01")) << bench.monitor(6);
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("EINGABE");
  const double stored = bench.istwert(0);
  bench.keys("HAND");
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("TEACH_IN");
  bench.type("7");
  bench.keys("ENTER");
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("EINGABE");
  EXPECT_TRUE(tape_of(bench, 7).ends_with("N007G01X+" + um(bench.istwert(0) - stored) + " ")) << tape_of(bench, 7);
}

TEST(TeachIn, D_38_AnotherProgramBeginsWhereTheModeWasEntered) {
  Bench bench;
  bench.keys("TEACH_IN ENTER");
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("EINGABE HAND");
  jog(bench, "PLUS_X", 0, 5);
  const double entered = bench.istwert(0);
  bench.keys("TEACH_IN");
  EXPECT_EQ(bench.monitor(5), "PROGRAMM NR □0002");
  bench.keys("ENTER");
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("EINGABE");
  EXPECT_EQ(tape_of(bench, 2), "N001G01X+" + um(bench.istwert(0) - entered) + " ");
}

TEST(TeachIn, MOD_043_ATaughtProgramReplaysToTheTaughtPlaces) {
  Bench bench;
  bench.keys("HANDEINGABE");
  bench.type("11");
  bench.keys("ENTER");
  bench.type("1000");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("MENU TEACH_IN ENTER");
  jog(bench, "PLUS_X", 0, 8);
  bench.keys("EINGABE");
  jog(bench, "MINUS_Y", 1, 4);
  bench.keys("EINGABE");
  const double x = bench.istwert(0), y = bench.istwert(1);
  bench.keys("HAND ISTWERT PLUS_X 0 PLUS_Y 0 MENU");
  bench.run_for(10);
  ASSERT_EQ(bench.istwert(0), 0);
  bench.keys("AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_NEAR(bench.istwert(0), x, 1e-9);
  EXPECT_NEAR(bench.istwert(1), y, 1e-9);
}

/// What gives the counters other names between two taught blocks; the axes end where they began, or the way is known.
struct Renaming {
  std::string_view name, keys;
};

constexpr Renaming kRenamings[] = {
    {"ISTWERT", "HAND ISTWERT PLUS_X 1 0 0 PLUS_Y MENU"},
    {"G68 in HANDEINGABE", "MENU HANDEINGABE 6 8 ENTER 5 0 START"},
    {"G68 in AUTOMAT", "MENU AUTOMAT CLEAR 9 ENTER ENTER START"},
};

TEST(TeachIn, MOD_043_MOD_038_ACounterThatIsSetAnewIsNoWay) {
  for (const auto& [name, keys] : kRenamings) {
    SCOPED_TRACE(std::string(name));
    Bench bench({.tape = "P0009N001G68X+77000Y+88000Z+99000%"});
    bench.keys("TEACH_IN CLEAR 6 1 ENTER");
    jog(bench, "PLUS_X", 0, 5);
    bench.keys("EINGABE");
    const double x = bench.istwert(0);
    bench.keys(keys);
    ASSERT_TRUE(bench.run_to_rest());
    ASSERT_GT(std::abs(bench.istwert(0) - x), 1) << "the counter has another value";
    bench.keys("MENU TEACH_IN CLEAR 6 1 ENTER");
    const double y = bench.istwert(1);
    jog(bench, "PLUS_Y", 1, 5);
    bench.keys("EINGABE");
    EXPECT_TRUE(tape_of(bench, 61).ends_with("N002G01Y+" + um(bench.istwert(1) - y) + " ")) << tape_of(bench, 61);
  }
}

TEST(TeachIn, MOD_043_TheWayToTheReferencePointIsTheOneDriven) {
  Bench bench;
  bench.keys("TEACH_IN CLEAR 6 1 ENTER");
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("EINGABE");
  const std::int64_t before = bench.snapshot().steps[1];
  bench.keys("HAND MINUS_Y REFERENZ");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("TEACH_IN CLEAR 6 1 ENTER");
  jog(bench, "PLUS_Y", 1, 5);
  bench.keys("EINGABE");
  constexpr std::int64_t kUmPerStep = 5;
  const std::string way = std::to_string((bench.snapshot().steps[1] - before) * kUmPerStep);
  EXPECT_TRUE(tape_of(bench, 61).ends_with("N002G01Y" + way + " ")) << tape_of(bench, 61);
}

TEST(TeachIn, MOD_043_SEAT_002_TheLastStoredPositionOutlivesALogin) {
  Bench before;
  before.keys("TEACH_IN CLEAR 6 1 ENTER");
  jog(before, "PLUS_X", 0, 5);
  before.keys("EINGABE HAND ISTWERT PLUS_X 1 0 0 MENU");
  before.run_for(20);
  const std::string tape = "P0061" + language::write_block(before.control.memory().find(61)->blocks.front()) + "%";
  Bench after({.tape = tape});
  after.control.restore_state(before.control.save_state());
  after.run_for(20);
  after.keys("TEACH_IN CLEAR 6 1 ENTER");
  jog(after, "PLUS_X", 0, 5);
  after.keys("EINGABE");
  EXPECT_TRUE(tape_of(after, 61).ends_with("N002G01X+" + um(after.istwert(0) - 100) + " ")) << tape_of(after, 61);
}

TEST(TeachIn, DEC_06_D_50_NumbersThatCannotBeTaught) {
  for (const auto& [number, monitor] : {std::pair{"9983", "Reserviert fuer Zyklen"}, {"0", "Programmnummer falsch"}}) {
    Bench bench;
    bench.keys("TEACH_IN");
    bench.type(number);
    bench.keys("ENTER");
    EXPECT_EQ(bench.monitor(15), monitor);
    EXPECT_TRUE(bench.monitor(6).empty());
  }
}

TEST(TeachIn, DEC_07_FullMemoryLosesNothing) {
  Bench::Setup setup;
  setup.settings.memory_bytes = 94 + 9;
  Bench bench(setup);
  bench.keys("TEACH_IN ENTER");
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("EINGABE");
  ASSERT_EQ(bench.stores(), 1);
  jog(bench, "PLUS_X", 0, 5);
  const std::string line = bench.monitor(6);
  bench.keys("EINGABE");
  EXPECT_EQ(bench.monitor(15), "Speicher voll");
  EXPECT_EQ(bench.monitor(6), line) << "what was taught still stands there";
}

TEST(TeachIn, SCR_011_MOD_041_APlaceThatNoWordHoldsIsToldAndNotStored) {
  Bench bench;
  bench.keys("HANDEINGABE");
  bench.type("90");
  bench.keys("START");
  ASSERT_TRUE(bench.run_to_rest());
  bench.keys("HAND ISTWERT PLUS_X");
  bench.type("9999.9");
  bench.keys("ISTWERT TEACH_IN ENTER");
  jog(bench, "PLUS_X", 0, 5);
  EXPECT_EQ(bench.monitor(6), "N001 G01 X.....,... Y.....,... Z.....,... F.... S.... T.. M..");
  EXPECT_TRUE(bench.row(18).starts_with("Der Istwert X ist größer als jedes Wort")) << bench.row(18);
  bench.keys("EINGABE");
  EXPECT_EQ(bench.stores(), 0);
  bench.keys("HAND ISTWERT PLUS_X 1 0 ISTWERT TEACH_IN ENTER");
  jog(bench, "PLUS_X", 0, 5);
  bench.keys("EINGABE");
  EXPECT_EQ(tape_of(bench, 1), "N001G01X+" + um(bench.istwert(0)) + "Y+0Z+0 ") << "the remedy that was named";
}

TEST(TeachIn, MOD_041_MOD_043_UnderG90AndG46ThePlaceIsTheProgrammedOne) {
  Bench bench({.tape = "P0000T001R+5000L+2000%"});
  for (const char* keys : {"HANDEINGABE 1 1 ENTER 6 0 0 ENTER ENTER 0 1 START", "MENU HANDEINGABE 9 0 START",
                           "MENU HANDEINGABE 4 6 START", "MENU HANDEINGABE 0 1 ENTER ENTER ENTER 1 0 START"}) {
    bench.keys(keys);
    ASSERT_TRUE(bench.run_to_rest()) << keys;
  }
  ASSERT_EQ(bench.istwert(2), 12) << "programmed 10, the tool is 2 longer";
  bench.keys("MENU TEACH_IN ENTER");
  jog(bench, "PLUS_Z", 2, 5);
  bench.keys("EINGABE");
  const double taught = bench.istwert(2);
  EXPECT_EQ(tape_of(bench, 1), "N001G01X+0Y+0Z+" + um(taught - 2) + " ");
  jog(bench, "MINUS_Z", 2, 8);
  bench.keys("MENU AUTOMAT ENTER ENTER START");
  ASSERT_TRUE(bench.run_to_rest());
  EXPECT_NEAR(bench.istwert(2), taught, 1e-9) << "the same place again, G46 still in force";
}

}  // namespace
}  // namespace cnclab::panel
