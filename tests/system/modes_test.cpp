// The modes that move by hand and the service modes at a real station, through TLS, lab, database and tick
// (2.1 to 2.3, 2.7, chapter 5).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class Modes : public testing::Test {
 protected:
  Modes() { room_.add_student("anna"); }
  Classroom room_;
};

TEST_F(Modes, MOD_005_MOD_038_HandTeachInAndBackToAutomat) {
  StationProcess anna = room_.seat(1, "anna");
  anna.key("HANDEINGABE");
  anna.wait_for("G01 X.....,...");
  anna.type("11");
  anna.key("ENTER");
  anna.type("1000");
  anna.key("START");
  anna.wait_for("F1000");
  anna.key("HAND");
  anna.wait_for("HANDBETRIEB");
  anna.key("TEACH_IN");
  anna.wait_for("PROGRAMM NR");
  anna.key("ENTER");
  anna.expect_ok("pot 10");  // 5 mm/s: every picture of the moving counter shows another tenth
  anna.key("PLUS_X");
  anna.key("START");
  anna.wait_for("X  +0001.");
  anna.key("STOP");
  anna.wait_for("EINGABE speichert den Satz");
  const std::string taught = monitor_row(anna.screen(), 7);
  EXPECT_THAT(taught, StartsWith("N001 G01 X+"));
  anna.key("EINGABE");
  anna.wait_for("N002 G01");
  anna.key("MENU");
  anna.key("EINGABE");
  anna.key("ENTER");
  EXPECT_EQ(monitor_row(anna.screen(), 4), taught) << "stored as it was taught";
}

TEST_F(Modes, MOD_075_SpeicherLoeschenErasesInTheDatabase) {
  StationProcess anna = room_.seat(1, "anna");
  anna.key("EINGABE");
  anna.key("ENTER");
  anna.key("ENTER");
  anna.type("90");
  anna.key("ENTER");
  anna.key("EINGABE");
  anna.wait_for("002");
  anna.key("MENU");
  anna.key("SPEICHER_LOESCHEN");
  anna.type("1");
  anna.key("ENTER");
  anna.wait_for("PROGRAMM NR P0001   PROGRAMM GELOESCHT");
  EXPECT_THAT(monitor_row(anna.screen(), 2), EndsWith("16290"));
}

TEST_F(Modes, MD_002_KEY_082_ChordsReachTheServiceModes) {
  StationProcess anna = room_.seat(1, "anna");
  anna.expect_ok("hold 50 ENTER+RESET");
  anna.wait_for("MASCHINENDATEN");
  for (int i = 0; i < 5; ++i) anna.key("ENTER");
  EXPECT_THAT(monitor_row(anna.screen(), 5), StartsWith("NR 06  F MAX"));
  anna.type("1500");
  anna.key("ENTER");
  anna.wait_for("NR 07");
  anna.key("RESET");
  anna.expect_ok("hold 50 3+6+9");
  anna.wait_for("SPEICHERTEST");
  EXPECT_THAT(monitor_row(anna.screen(), 4), HasSubstr("PAGE 1"));
  anna.key("MENU");
  anna.expect_ok("hold 50 ENTER+RESET");
  for (int i = 0; i < 5; ++i) anna.key("ENTER");
  EXPECT_THAT(monitor_row(anna.screen(), 5), HasSubstr("1500")) << "kept in the database's copy";
}

TEST_F(Modes, ERR_006_ERR_034_TheMemoryTestFindsTheFaultThatTheTeacherSets) {
  EXPECT_THAT(room_.instructor().run({"ram-fault", "1", "on"}).errors, HasSubstr("niemand angemeldet"));
  StationProcess anna = room_.seat(1, "anna");
  room_.instructor().must({"ram-fault", "1", "on"});
  EXPECT_EQ(room_.instructor().station(1)["ram_fault"], true);
  anna.expect_ok("hold 50 3+6+9");
  anna.key("SPEICHER_LOESCHEN");
  anna.key("SPEICHER_LOESCHEN");
  anna.wait_for("PAGE 1 RAM DEFEKT");
  room_.instructor().must({"ram-fault", "1", "off"});
  EXPECT_EQ(room_.instructor().station(1)["ram_fault"], false);
}

}  // namespace
}  // namespace cnclab::harness
