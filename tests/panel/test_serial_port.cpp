// The serial line at a control: keys 3, 5, 7 and 9, REMOTE, and the release of a remote start (EXT-040 to EXT-066,
// AUTH-013, D-98, D-110, DEC-35, DEC-36, DEC-58, DEC-62). The bytes themselves: tests/transfer/test_serial_line.cpp.
#include <gmock/gmock.h>

#include "serial_rig.hpp"

namespace cnclab::panel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// --- keys -------------------------------------------------------------------------------------------------------

TEST_F(SerialPortTest, DEC_36_WithoutALineFiveAndNineAreIgnored) {
  bench.control.fit_line({});
  bench.keys("EXTERNE_DATEN");
  for (const char* key : {"5", "9"}) {
    bench.keys(key);
    EXPECT_THAT(bench.row(18), HasSubstr("nicht angeschlossen")) << key;
  }
}

TEST_F(SerialPortTest, EXT_054_055_AllProgramsAreReadUntilThePercentSign) {
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(20);
  EXPECT_EQ(heard(), "<1>");
  say("P0003N001G04H0001\0\0\0\0\0\0P0001N009G04H0002%"sv);
  EXPECT_EQ(heard(), "<3><3><1><3><3>");
  EXPECT_THAT(bench.row(18), HasSubstr("Gelesen und gespeichert, Programme: 2."));
  EXPECT_THAT(memory(), HasSubstr("P0003\nN001G04H0001\n"));
  EXPECT_THAT(memory(), HasSubstr("P0001\nN009G04H0002\n")) << "EXT-054: the old one is deleted";
  EXPECT_THAT(memory(), Not(HasSubstr("N002G04H0010")));
}

TEST_F(SerialPortTest, D_105_ANumberIsSoughtAmongWhatComes) {
  bench.keys("EXTERNE_DATEN 9 CLEAR 3 ENTER");
  bench.run_for(20);
  say("P0002N001G04H0001\0P0003N001G04H0003%"sv);
  EXPECT_THAT(memory(), Not(HasSubstr("P0002")));
  EXPECT_THAT(memory(), HasSubstr("P0003\nN001G04H0003\n"));
  bench.keys("9 CLEAR 4 ENTER");
  bench.run_for(20);
  say("P0002N001G04H0001%"sv);
  EXPECT_THAT(bench.monitor(15), HasSubstr("Programm fehlt"));
}

TEST_F(SerialPortTest, DEC_58_APartIsContinuedInTheSameReading) {
  bench.keys("EXTERNE_DATEN 7 CLEAR ENTER");
  bench.run_for(20);
  say("P0003N001G04H0001\0N002G04H0002\0N001G04H0009%"sv);
  EXPECT_THAT(memory(), HasSubstr("P0003\nN001G04H0009\nN002G04H0002\n"));
}

TEST_F(SerialPortTest, DEC_62_MachineDataAreAdoptedOnlyWithTheSign) {
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(20);
  say("P0003N001G04H0001\0MDN20=300%"sv);
  EXPECT_EQ(bench.control.line_baud(), 1200);
  bench.keys("9 CLEAR ENTER SIGN");
  bench.run_for(20);
  say("P0003N001G04H0001\0MDN20=300%"sv);
  EXPECT_EQ(bench.control.line_baud(), 300);
}

TEST_F(SerialPortTest, D_102_AWrongBeginningStoresNothingAndEndsTheReading) {
  const std::string before = memory();
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(20);
  say("N001G04H0001%");
  EXPECT_EQ(heard(), "<1><3><3>");
  EXPECT_THAT(bench.monitor(15), HasSubstr("Uebertragung falsch"));
  EXPECT_EQ(memory(), before);
}

TEST_F(SerialPortTest, AProgramThatDoesNotFitOrIsWrongEndsTheReading) {
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(20);
  say("P0003N001G99H0001\0P0004N001G04H0001%"sv);
  EXPECT_EQ(heard(), "<1><3><3>");
  EXPECT_THAT(memory(), Not(HasSubstr("P0004")));
  EXPECT_FALSE(bench.monitor(15).empty());
}

TEST_F(SerialPortTest, EXT_031_KeyFiveSendsAndKeyThreeToo_DEC_62) {
  for (const char* keys : {"5 CLEAR 1 ENTER", "3 CLEAR 1 ENTER"}) {
    bench.keys("EXTERNE_DATEN");
    bench.keys(keys);
    bench.run_for(20);
    EXPECT_EQ(heard(), "P0001\r\nN001G04H0010\r\nN002G04H0010\r\n%");
    bench.run_for(20);
    EXPECT_THAT(bench.row(18), HasSubstr("Ausgabe beendet"));
    bench.keys("MENU");
  }
  EXPECT_TRUE(bench.media.empty()) << "no tape file where there is a line";
}

TEST_F(SerialPortTest, EXT_045_SendsInTheTimeOfMachineDatum20) {
  bench.control.fit_line({.is_fitted = true, .is_paced = true, .binding = ""});
  bench.keys("EXTERNE_DATEN 5 CLEAR 7 ENTER");
  bench.run_for(10);
  heard();
  bench.run_for(100);  // 1200 baud: 12 characters in 100 ms
  EXPECT_EQ(heard().size(), 12U);
}

TEST_F(SerialPortTest, ATransferWaitsUntilSomebodyIsAtTheLine) {
  bench.control.connect_line(false, bench.now);
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(100);
  EXPECT_THAT(bench.row(18), HasSubstr("noch kein Rechner"));
  EXPECT_EQ(heard(), "");
  bench.control.connect_line(true, bench.now);
  bench.run_for(20);
  EXPECT_EQ(heard(), "<1>");
  bench.control.connect_line(false, bench.now);
  bench.run_for(20);
  EXPECT_THAT(bench.monitor(15), HasSubstr("Uebertragung falsch"));
  EXPECT_THAT(bench.row(18), HasSubstr("nicht mehr an der Leitung"));
}

TEST_F(SerialPortTest, D_107_StopAbortsAndTellsTheSender) {
  const std::string before = memory();
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(20);
  say("P0003N001G04H00");
  bench.keys("STOP");
  EXPECT_EQ(heard(), "<1><3><3>");
  say("01%");
  EXPECT_EQ(memory(), before);
  EXPECT_THAT(bench.row(18), HasSubstr("abgebrochen"));
}

TEST_F(SerialPortTest, SCR_048_ADashTurnsWhileAProgramIsRead) {
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(20);
  EXPECT_EQ(bench.monitor(0).size(), 63U);
  say("P0003N001");
  EXPECT_EQ(bench.monitor(0).size(), 64U);
  EXPECT_TRUE(bench.control.is_line_reading());
}

TEST_F(SerialPortTest, AStoreThatFailsEndsTheReading) {
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(20);
  bench.fail_next_store("Platte voll");
  say("P0003N001G04H0001\0P0004N001G04H0001%"sv);
  EXPECT_EQ(heard(), "<1><3><3>");
  EXPECT_THAT(bench.row(18), HasSubstr("Platte voll"));
  EXPECT_THAT(memory(), Not(HasSubstr("P0004")));
}

TEST_F(SerialPortTest, TheScreenShowsWhatBindsAConnection) {
  bench.keys("EXTERNE_DATEN");
  EXPECT_EQ(bench.monitor(12), "LEITUNG ● STATION 7 ABCD-EFGH-2345");
  EXPECT_EQ(bench.monitor(13), "") << "REMOTE is off";
}

TEST_F(SerialPortTest, EXT_066_WithoutRemoteNothingIsPolled) {
  say("!");
  say("P0001N001*");
  say("#");
  EXPECT_EQ(heard(), "");
  EXPECT_THAT(bench.remote_starts, IsEmpty());
  EXPECT_EQ(bench.stores(), 0);
}

// --- REMOTE -----------------------------------------------------------------------------------------------------

class Remote : public SerialPortTest {
 public:
  Remote() : SerialPortTest(true) {}
};

TEST_F(Remote, D_110_TheLineIsPolledInTheMenuAndInExternalData) {
  EXPECT_EQ(heard(), "<1>");
  bench.keys("EXTERNE_DATEN");
  bench.run_for(20);
  EXPECT_EQ(heard(), "") << "polled on";
  for (const char* mode : {"HAND", "EINGABE", "AUTOMAT", "SPEICHER_LOESCHEN"}) {
    bench.keys("MENU");
    bench.keys(mode);
    bench.run_for(20);
    EXPECT_EQ(heard(), "<3><3>") << mode;
    say("P0003N001G04H0001%");
    EXPECT_THAT(memory(), Not(HasSubstr("P0003"))) << mode;
    bench.keys("MENU");
    bench.run_for(20);
    EXPECT_EQ(heard(), "<1>") << mode;
  }
}

TEST_F(Remote, WhatComesWithTheConnectionIsHeard) {
  bench.control.connect_line(false, bench.now);
  bench.control.connect_line(true, bench.now);
  heard();
  say("!");
  EXPECT_EQ(heard(), "P0001N001S%");
}

TEST_F(Remote, EXT_063_D_98_TheQueryIsAnsweredInEveryMode) {
  heard();
  say("!");
  EXPECT_EQ(heard(), "P0001N001S%");
  bench.keys("AUTOMAT CLEAR 7 ENTER ENTER");
  bench.run_for(20);
  heard();
  say("!");
  EXPECT_EQ(heard(), "P0007N005S%");
  bench.keys("START");
  say("!");
  EXPECT_EQ(heard(), "P0007N005L%");
  bench.run_to_rest();
  bench.keys("MENU");
  bench.run_for(20);
  heard();
  say("!");
  EXPECT_EQ(heard(), "P0007N005S%");
}

TEST_F(Remote, MD_120_AnotherBaudRateHoldsFromTheNextPollOn) {
  bench.control.fit_line({.is_fitted = true, .is_paced = true, .binding = ""});
  bench.keys("ENTER+RESET");
  for (int datum = 0; datum < 16; ++datum) bench.keys("ENTER");  // 20 is the seventeenth
  bench.keys("CLEAR 3 0 0 ENTER MENU");
  ASSERT_EQ(bench.control.line_baud(), 300);
  bench.run_for(1000);
  heard();
  ASSERT_EQ(bench.control.line_received("!", bench.now), 1U);
  bench.run_for(400);  // 1 character there and 10 back last 367 ms
  EXPECT_EQ(heard(), "P0001N001S%");
}

TEST_F(Remote, EXT_060_AStartRunsAndFurtherDataAreAwaitedBehindIt) {
  heard();
  say("P0001N002*");
  EXPECT_EQ(bench.control.mode(), Mode::automat);
  EXPECT_TRUE(bench.control.is_running());
  EXPECT_EQ(heard(), "<3><3>");
  say("!");
  EXPECT_EQ(heard(), "P0001N002L%");
  bench.run_to_rest();
  bench.run_for(30);
  EXPECT_EQ(heard(), "<1>");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  EXPECT_THAT(bench.row(18), HasSubstr("P0001 ist zu Ende"));
  say("P0009N001G04H0001\0P0009N001*"sv);
  EXPECT_TRUE(bench.control.is_running());
}

TEST_F(Remote, DEC_35_ARefusedStartAnswersWithF) {
  heard();
  bench.remote_refusal = "Fernstart abgelehnt.";
  say("P0001N001*");
  EXPECT_EQ(heard(), "<3><3><1>");
  say("!");
  EXPECT_EQ(heard(), "P0001N001F%");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  EXPECT_EQ(bench.row(18), "Fernstart abgelehnt.");
  bench.remote_refusal.clear();
  say("P0001N001G04H0001\0!"sv);
  EXPECT_EQ(heard(), "<3><3><1>P0001N001S%");
}

TEST_F(Remote, AStartOfWhatIsNotThereIsRefused) {
  heard();
  for (const char* start : {"P0002N001*", "P0001N009*", "P9981N001*", "P0000N001*"}) {
    say(start);
    say("!");
    EXPECT_THAT(heard(), testing::EndsWith("F%")) << start;
    EXPECT_EQ(bench.control.mode(), Mode::menu) << start;
    EXPECT_FALSE(bench.monitor(15).empty()) << start;
  }
}

TEST_F(Remote, AUTH_008_TheMomentOfItsArrivalIsHandedOut) {
  bench.run_for(1000);
  const std::int64_t before_ns = bench.now.monotonic_ns;
  say("P0001N001*");
  ASSERT_EQ(bench.remote_starts.size(), 1U);
  EXPECT_EQ(bench.remote_starts[0].came_ns, before_ns);
}

TEST_F(Remote, D_110_StopAndEinzelsatzRemainEffective) {
  say("P0005N001G01X+2000F0600N002G01X-2000\0"sv);
  heard();
  say("P0005N001*");
  bench.keys("EINZELSATZ");
  bench.run_to_rest();
  EXPECT_EQ(bench.control.situation().block, 2);
  say("!");
  EXPECT_EQ(heard(), "<3><3>P0005N002S%");
  bench.keys("START");
  bench.run_for(100);
  bench.keys("STOP");
  bench.run_to_rest();
  EXPECT_EQ(heard(), "") << "the rest waits: the run is not over";
  bench.keys("MENU");
  bench.run_for(30);
  EXPECT_EQ(heard(), "<1>");
}

TEST_F(Remote, EXT_061_FollowingBlocksJoinTheActiveProgram) {
  say("N003G04H0007\0"sv);
  EXPECT_THAT(memory(), HasSubstr("P0001\nN001G04H0010\nN002G04H0010\nN003G04H0007\n"));
  say("P0007N001G04H0002\0"sv);
  say("N002G04H0003\0"sv);
  EXPECT_THAT(memory(), HasSubstr("P0007\nN001G04H0002\nN002G04H0003\n"));
}

TEST_F(Remote, EXT_062_TheMemoryIsErased) {
  heard();
  say("#");
  EXPECT_EQ(memory(), "");
  EXPECT_EQ(heard(), "<3><3><1>");
  EXPECT_THAT(bench.line_news, ElementsAre("memory erased by #"));
}

TEST_F(Remote, EXT_065_ThePercentSignLeadsToTheMenuOfExternalData) {
  say("P0003N001G04H0001\0"sv);
  EXPECT_EQ(bench.control.mode(), Mode::menu) << "EXT-064";
  say("P0003N001G04H0001%");
  EXPECT_EQ(bench.control.mode(), Mode::external_data);
  EXPECT_THAT(bench.line_news, ElementsAre("received P0003", "received P0003"));
}

TEST_F(Remote, AKeyDrivenTransferHasTheLineForItself) {
  heard();
  bench.keys("EXTERNE_DATEN 9 CLEAR ENTER");
  bench.run_for(20);
  EXPECT_EQ(heard(), "<3><3><1>");
  say("#");
  EXPECT_THAT(bench.monitor(15), HasSubstr("Uebertragung falsch")) << "commands are REMOTE's";
  bench.run_for(20);
  EXPECT_EQ(heard(), "<3><3><1>");
}

TEST_F(Remote, TheSwitchTurnsPollingOffAndOn) {
  heard();
  bench.control.set_remote(false);
  bench.run_for(20);
  EXPECT_EQ(heard(), "<3><3>");
  say("#!");
  EXPECT_EQ(heard(), "");
  bench.control.set_remote(true);
  bench.run_for(20);
  EXPECT_EQ(heard(), "<1>");
}

TEST_F(Remote, AtATrainingMachineThereIsNothingToRelease) {
  bench.keys("EXTERNE_DATEN START");
  EXPECT_FALSE(bench.control.armed());
  EXPECT_THAT(bench.row(18), HasSubstr("dieser Platz hat sie nicht"));
}

TEST_F(SerialPortTest, KEY_090_WithoutRemoteStartIsIgnored) {
  bench.keys("EXTERNE_DATEN START");
  EXPECT_THAT(bench.row(18), HasSubstr("START hat hier keine Wirkung"));
}

}  // namespace
}  // namespace cnclab::panel
