// Keying in programs as a student does, word by word, at a real station (EX-010, EDIT, STO-002, STO-003).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/classroom.hpp"
#include "harness/monitor.hpp"

namespace cnclab::harness {
namespace {

/// A word typed and acknowledged with →; an empty one is passed over.
void word(StationProcess& station, const std::string& value) {
  if (!value.empty()) station.type(value);
  station.key("ENTER");
}

/// One block: the offered number, the G function, its words; EINGABE stores it.
void block(StationProcess& station, const std::string& g, const std::vector<std::string>& words) {
  station.key("ENTER");
  word(station, g);
  for (const auto& value : words) word(station, value);
  station.key("EINGABE");
}

/// P0001 of Bild 7 keyed in at an empty memory.
void key_in_bild_7(StationProcess& station) {
  station.key("EINGABE");
  station.wait_for("PROGRAMM NR");
  station.key("ENTER");
  block(station, "", {"50", "50", "50"});
  block(station, "04", {"10"});
  block(station, "01", {"25", "10", "4", "1000", "", "", "03"});
  block(station, "02", {"10", "0", "5", "0"});
  block(station, "20", {"1", "1"});
}

class Editor : public testing::Test {
 protected:
  Editor() { room_.add_student("anna"); }
  Classroom room_;
};

TEST_F(Editor, EX_010_Bild_7_keyed_in_word_by_word_is_the_manuals_screen) {
  StationProcess anna = room_.seat(1, "anna");
  key_in_bild_7(anna);
  const ScreenRows rows = anna.screen();
  EXPECT_THAT(monitor_row(rows, 2), testing::StartsWith("EINGABEMODUS"));
  EXPECT_THAT(monitor_row(rows, 2), testing::EndsWith("16221"));
  EXPECT_EQ(monitor_row(rows, 3), "PROGRAMM NR P0001");
  EXPECT_EQ(monitor_row(rows, 4), "N001 G00 X+..50.000 Y+..50.000 Z+..50.000 (EILGANG)");
  EXPECT_EQ(monitor_row(rows, 5), "N002 G04 (VERWEILZEIT ZEHNTELSEK.) H0010");
  EXPECT_EQ(monitor_row(rows, 6), "N003 G01 X+..25.000 Y+..10.000 Z+...4.000 F1000 S.... T.. M03");
  EXPECT_EQ(monitor_row(rows, 7), "N004 G02 X+..10.000 Y+...0.000 I+...5.000 J+...0.000");
  EXPECT_EQ(monitor_row(rows, 8), "N005 G20 (SPRUNG PROGRAMM) P0001 N001");
  EXPECT_THAT(monitor_row(rows, 9), testing::StartsWith("□006"));
}

TEST_F(Editor, STO_002_what_EINGABE_acknowledged_is_in_the_database_as_tape_text) {
  StationProcess anna = room_.seat(1, "anna");
  key_in_bild_7(anna);
  EXPECT_EQ(room_.instructor().must({"program", "show", "anna", "P0001"}).output,
            "P0001\nN001G00X+50000Y+50000Z+50000\nN002G04H0010\nN003G01X+25000Y+10000Z+4000F1000M03\n"
            "N004G02X+10000Y+0I+5000J+0\nN005G20P0001N001\n%\n");
  const auto programs = room_.instructor().must({"programs", "anna"}).objects;
  ASSERT_EQ(programs.size(), 1U);
  EXPECT_EQ(programs[0]["program"], "P0001");
  EXPECT_EQ(programs[0]["blocks"], 5);
  EXPECT_EQ(programs[0]["bytes"], 69) << "D-22: 16290 - 16221";
}

TEST_F(Editor, EDIT_014_an_incomplete_block_is_not_stored_and_says_so) {
  StationProcess anna = room_.seat(1, "anna");
  anna.key("EINGABE ENTER ENTER");
  word(anna, "02");
  anna.type("10");
  anna.key("EINGABE");
  anna.wait_for("Satz überprüfen");
  EXPECT_TRUE(room_.instructor().must({"programs", "anna"}).objects.empty());
}

TEST_F(Editor, EDIT_011_an_unknown_function_is_refused) {
  StationProcess anna = room_.seat(1, "anna");
  anna.key("EINGABE ENTER ENTER");
  word(anna, "99");
  anna.wait_for("Funktion nicht vorgesehen");
}

TEST_F(Editor, EDIT_016_F_above_F_MAX_is_not_accepted) {
  StationProcess anna = room_.seat(1, "anna");
  anna.key("EINGABE ENTER ENTER");
  word(anna, "11");
  anna.type("3001");
  anna.key("EINGABE");
  anna.wait_for("Satz überprüfen");
  EXPECT_TRUE(room_.instructor().must({"programs", "anna"}).objects.empty());
}

TEST_F(Editor, EDIT_017_a_block_is_loaded_corrected_and_stored_again) {
  room_.instructor().must(
      {"program", "send", room_.folder().write("t", "P0001\nN001G00X+1000\nN002G00Y+2000\n").string(), "anna"});
  StationProcess anna = room_.seat(1, "anna");
  anna.key("EINGABE ENTER");
  anna.type("2");
  anna.key("SATZ_SUCHEN ENTER ENTER ENTER");
  anna.type("7");
  anna.key("EINGABE");
  EXPECT_EQ(room_.instructor().must({"program", "show", "anna", "P0001"}).output,
            "P0001\nN001G00X+1000\nN002G00Y+7000\n%\n");
}

TEST_F(Editor, EDIT_018_a_block_is_loaded_and_deleted) {
  room_.instructor().must(
      {"program", "send", room_.folder().write("t", "P0001\nN001G00X+1000\nN002G00Y+2000\n").string(), "anna"});
  StationProcess anna = room_.seat(1, "anna");
  anna.key("EINGABE ENTER");
  anna.type("1");
  anna.key("SATZ_SUCHEN SATZ_LOESCHEN");
  EXPECT_EQ(room_.instructor().must({"program", "show", "anna", "P0001"}).output, "P0001\nN002G00Y+2000\n%\n");
}

TEST_F(Editor, EDIT_019_a_block_is_inserted_and_the_following_move_up) {
  room_.instructor().must(
      {"program", "send", room_.folder().write("t", "P0001\nN001G00X+1000\nN002G00Y+2000\n").string(), "anna"});
  StationProcess anna = room_.seat(1, "anna");
  anna.key("EINGABE ENTER");
  anna.type("1");
  block(anna, "00", {"", "", "3"});
  EXPECT_EQ(room_.instructor().must({"program", "show", "anna", "P0001"}).output,
            "P0001\nN001G00Z+3000\nN002G00X+1000\nN003G00Y+2000\n%\n");
}

TEST_F(Editor, STO_004_a_full_memory_is_a_clear_message_and_loses_nothing) {
  std::string tape = "P0001\n";
  constexpr int kBlocks = 900;  // 18 bytes each (D-22): 16200 of the 16290
  for (int number = 1; number <= kBlocks; ++number) {
    tape += "N" + std::string(3 - std::to_string(number).size(), '0') + std::to_string(number) +
            "G01X+1000Y+1000Z+1000F1000\n";
  }
  room_.instructor().must({"program", "send", room_.folder().write("t", tape).string(), "anna"});
  StationProcess anna = room_.seat(1, "anna");
  anna.key("EINGABE");
  anna.wait_for("00090");
  anna.key("ENTER");
  for (int i = 0; i < 5; ++i) block(anna, "00", {"1", "1", "1"});  // 16 bytes each
  anna.wait_for("00010");
  block(anna, "00", {"1", "1", "1"});
  anna.wait_for("Speicher voll");
  EXPECT_EQ(room_.instructor().must({"programs", "anna"}).objects[0]["blocks"], kBlocks + 5);
}

}  // namespace
}  // namespace cnclab::harness
