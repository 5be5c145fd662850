// The release of a remote start on the screen EXTERNE DATEN (AUTH-013, AUTH-008, DEC-27, DEC-39).
#include <gmock/gmock.h>

#include "serial_rig.hpp"

namespace cnclab::panel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Release : public SerialPortTest {
 public:
  Release() : SerialPortTest(true, true, "P0001N001G04H0001N005G04H0001P0007N003G04H0001P0008N001G90N002G04H0001%") {
    bench.keys("EXTERNE_DATEN");
  }
};

TEST_F(Release, StartReleasesTheProgramShownFromItsFirstBlock) {
  EXPECT_FALSE(bench.control.armed());
  bench.keys("START");
  const auto armed = bench.control.armed();
  ASSERT_TRUE(armed);
  EXPECT_EQ(armed->program, 1);
  EXPECT_EQ(armed->block, 1);
  EXPECT_EQ(armed->lease, machine::Epoch{1});
  EXPECT_EQ(armed->at_ns, bench.now.monotonic_ns);
  EXPECT_EQ(bench.monitor(13), "REMOTE  FERNSTART P0001 N001");
  EXPECT_THAT(bench.row(18), HasSubstr("P0001 N001 einmal starten, noch 60 s"));
  EXPECT_THAT(bench.line_news, ElementsAre("released P0001 N001"));
}

TEST_F(Release, OtherNumbersAreTypedAndReleasedAnew) {
  bench.keys("START CLEAR 7");
  EXPECT_FALSE(bench.control.armed()) << "what is typed is not released yet";
  bench.keys("START");
  ASSERT_TRUE(bench.control.armed());
  EXPECT_EQ(bench.control.armed()->program, 7);
  EXPECT_EQ(bench.control.armed()->block, 3);
  bench.keys("CLEAR 1 ENTER CLEAR 5 START");
  ASSERT_TRUE(bench.control.armed());
  EXPECT_EQ(bench.control.armed()->block, 5);
  bench.keys("CLEAR 6 START");
  EXPECT_FALSE(bench.control.armed());
  EXPECT_THAT(bench.monitor(15), HasSubstr("Satz fehlt"));
}

TEST_F(Release, IsOverAfter60Seconds) {
  bench.keys("START");
  bench.run_for(59'980);
  EXPECT_TRUE(bench.control.armed());
  bench.run_for(30);
  EXPECT_FALSE(bench.control.armed());
}

TEST_F(Release, StopMenuResetAndAnotherLeaseWithdrawIt) {
  for (const char* key : {"STOP", "MENU", "RESET"}) {
    bench.keys("MENU EXTERNE_DATEN START");
    ASSERT_TRUE(bench.control.armed()) << key;
    bench.keys(key);
    EXPECT_FALSE(bench.control.armed()) << key;
  }
  bench.keys("EXTERNE_DATEN START");
  bench.control.connect({bench.channel, machine::Epoch{2}, true, {}});
  EXPECT_FALSE(bench.control.armed());
}

TEST_F(Release, IsUsedUpByTheStart) {
  bench.keys("START");
  say("P0001N001*");
  EXPECT_TRUE(bench.control.is_running());
  EXPECT_FALSE(bench.control.armed());
  bench.run_to_rest();
  bench.run_for(30);
  EXPECT_EQ(bench.control.mode(), Mode::external_data);
  EXPECT_FALSE(bench.control.armed());
}

TEST_F(Release, ARefusedStartLeavesIt) {
  bench.keys("START");
  bench.remote_refusal = "Nein.";
  say("P0001N005*");
  EXPECT_TRUE(bench.control.armed());
}

TEST_F(Release, DEC_27_AsksForTheZeroWhereTheProgramMeasuresFromIt) {
  bench.keys("START CLEAR 8 START");
  EXPECT_FALSE(bench.control.armed());
  EXPECT_THAT(bench.row(18), HasSubstr("stimmt der Nullpunkt"));
  bench.keys("START");
  EXPECT_TRUE(bench.control.armed());
  say("P0008N001*");
  EXPECT_TRUE(bench.control.is_running());
}

TEST_F(Release, AUTH_008_WhatWouldBeReleasedIsPartOfTheSituation) {
  EXPECT_EQ(bench.control.situation().program, 1);
  say("P0007N001G04H0001\0"sv);
  EXPECT_EQ(bench.control.situation().program, 7) << "a START pressed before is stale";
}

TEST_F(Release, DEC_39_TheMemoryIsNotErasedOnTheLabMachine) {
  const std::string before = memory();
  heard();
  say("#!");
  EXPECT_EQ(memory(), before);
  EXPECT_THAT(heard(), testing::EndsWith("F%"));
}

}  // namespace
}  // namespace cnclab::panel
