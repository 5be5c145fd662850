// Machine data, clock, memory test, RESET and cold start (chapter 5, 6.2, 6.4; D-17, D-33, D-112, D-113, DEC-39).
#include <gtest/gtest.h>

#include "bench.hpp"
#include "panel/panel_clock.hpp"
#include "panel/screen/texts.hpp"

namespace cnclab::panel {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// Leads from the datum shown to that number.
void go_to(Bench& bench, std::string_view number) {
  for (int i = 0; i < 20 && !bench.monitor(4).starts_with("NR " + std::string(number)); ++i) bench.keys("ENTER");
  ASSERT_TRUE(bench.monitor(4).starts_with("NR " + std::string(number))) << bench.monitor(4);
}

TEST(MachineDataMode, MD_004_D_113_TheOrderOfTheDataAndRoundAgain) {
  Bench bench;
  bench.keys("ENTER+RESET");
  EXPECT_EQ(bench.control.mode(), Mode::machine_data);
  std::string order;
  for (int i = 0; i < 19; ++i) {
    order += bench.monitor(4).substr(3, 3);
    bench.keys(i % 2 == 0 ? "ENTER" : "EINGABE");
  }
  EXPECT_EQ(order, "01 02 03 04 05 06 07 09 10 11 12 14 15 16 17 19 20 22 01 ");
  EXPECT_EQ(bench.stores(), 0) << "looking changes nothing";
}

struct DatumCase {
  std::string_view number, typed;
  bool is_taken;
};

// D-112: limits of every datum.
constexpr DatumCase kData[] = {
    {"03", "1", true},      {"03", "9999999", true}, {"03", "0", false},      {"04", "250000", true},
    {"05", "0", false},     {"06", "300", true},     {"06", "299", false},    {"06", "9999", true},
    {"07", "0", false},     {"07", "1", true},       {"09", "99", true},      {"09", "0", false},
    {"10", "3000", true},   {"10", "3001", false},   {"11", "0", true},       {"11", "9999", true},
    {"12", "0", false},     {"12", "9999", true},    {"14", "1", true},       {"15", "0", false},
    {"16", "9999", true},   {"17", "400", true},     {"19", "51503", true},   {"19", "202", false},
    {"20", "4800", true},   {"20", "9600", false},   {"20", "1201", false},   {"22", "0", true},
    {"22", "2", false},     {"01", "235959", true},  {"01", "240000", false}, {"01", "6000", false},
    {"02", "840229", true}, {"02", "830229", false}, {"02", "831301", false}, {"02", "0", false},
};

TEST(MachineDataMode, D_112_WhatIsTakenOver) {
  for (const DatumCase& row : kData) {
    SCOPED_TRACE(std::string(row.number) + " = " + std::string(row.typed));
    Bench bench;
    bench.keys("ENTER+RESET");
    go_to(bench, row.number);
    bench.type(row.typed);
    bench.keys("ENTER");
    EXPECT_EQ(bench.monitor(15), row.is_taken ? "" : "Wert unzulaessig");
    const bool is_clock = row.number == "01" || row.number == "02";
    EXPECT_EQ(bench.stores(), row.is_taken && !is_clock ? 1 : 0);
    EXPECT_EQ(bench.monitor(4).starts_with("NR " + std::string(row.number)), !row.is_taken);
  }
}

TEST(MachineDataMode, MD_103_106_AChangedDatumActsAtOnce) {
  Bench bench;
  bench.keys("ENTER+RESET");
  go_to(bench, "03");
  bench.type("20000");
  bench.keys("ENTER");
  go_to(bench, "06");
  bench.type("1200");
  bench.keys("ENTER MENU HANDEINGABE");
  bench.type("00");
  bench.keys("ENTER");
  bench.type("21");
  bench.keys("START");
  EXPECT_EQ(bench.monitor(15), "Satz überprüfen") << "MD 03";
  bench.keys("MENU HAND");
  bench.run_for(20);
  bench.keys("PLUS_X START");
  bench.run_for(1000);
  EXPECT_NEAR(bench.snapshot().speed_mm_per_min, 1200, 1) << "MD 06";
}

TEST(MachineDataMode, STO_005_AnOlderVersionThatHoldsAgainIsShown) {
  Bench bench;
  bench.keys("ENTER+RESET ENTER ENTER ENTER ENTER ENTER");
  ASSERT_TRUE(bench.monitor(4).contains("3000")) << bench.monitor(4);
  machine::MachineData older;
  ASSERT_TRUE(older.set(6, 2500));
  bench.control.replace_data(older);
  EXPECT_TRUE(bench.monitor(4).contains("2500")) << bench.monitor(4);
  bench.type("12");
  bench.control.replace_data({});
  EXPECT_TRUE(bench.monitor(4).contains("0012")) << "what is being typed stays: " << bench.monitor(4);
}

TEST(MachineDataMode, EDIT_027_WithoutTheBeeperStoringIsSilent) {
  Bench bench;
  bench.keys("ENTER+RESET");
  go_to(bench, "22");
  bench.type("0");
  bench.keys("ENTER MENU EINGABE ENTER ENTER");
  bench.type("90");
  bench.keys("ENTER EINGABE");
  EXPECT_EQ(bench.stores(), 2);
  EXPECT_EQ(bench.control.take_beeps(), 0);
}

TEST(MachineDataMode, ERR_014_TheMessageOfRestoredData) {
  Bench bench;
  bench.control.tell_data_restored();
  EXPECT_EQ(bench.monitor(15), "CHECKSUM FEHLER");
  EXPECT_TRUE(bench.row(18).contains("ROM")) << bench.row(18);
}

TEST(MachineDataMode, TheGermanNamesAreThoseOfTheDataThemselves) {
  Bench bench;
  bench.keys("ENTER+RESET");
  for (const machine::DatumForm& form : machine::datum_forms()) {
    go_to(bench, form.number < 10 ? "0" + std::to_string(form.number) : std::to_string(form.number));
    EXPECT_TRUE(bench.monitor(4).contains(form.text)) << bench.monitor(4);
  }
}

TEST(Clock, MD_101_102_DEC_10_AnOffsetToTheLabsTime) {
  Bench bench;  // 11:39:58 02/03/82
  bench.keys("ENTER+RESET");
  bench.type("235959");
  bench.keys("ENTER");
  bench.type("831231");
  bench.keys("ENTER");
  EXPECT_TRUE(bench.monitor(0).ends_with("23:59:59 31/12/83")) << bench.monitor(0);
  bench.now.wall.second = 59;
  EXPECT_TRUE(bench.monitor(0).ends_with("00:00:00 01/01/84")) << "Gregorian day change (D-33)";
  Bench after;
  after.control.restore_state(bench.control.save_state());
  EXPECT_TRUE(after.monitor(0).ends_with("23:59:59 31/12/83")) << "kept with the student";
}

TEST(Clock, D_33_WithoutADateNoDayChangesUntilOneIsSet) {
  PanelClock clock;
  Now now{0, {0, 3, 20, 0, 0, 0}};
  EXPECT_EQ(clock.at(now).minute, 3);
  EXPECT_EQ(clock.at(now).month, 0);
  ASSERT_TRUE(clock.set_time(now, 23, 59, 58));
  now.monotonic_ns = 3 * kSecond_ns;
  EXPECT_EQ(clock.at(now).hour, 0);
  EXPECT_EQ(clock.at(now).second, 1);
  EXPECT_EQ(clock.at(now).day, 0);
  ASSERT_TRUE(clock.set_date(now, 84, 2, 28));
  ASSERT_TRUE(clock.set_time(now, 23, 59, 59));
  now.monotonic_ns += 2 * kSecond_ns;
  EXPECT_EQ(clock.at(now).day, 29);
  EXPECT_EQ(clock.at(now).month, 2);
  EXPECT_EQ(clock.at(now).year, 84);
  EXPECT_FALSE(clock.set_date(now, 83, 2, 29));
}

TEST(MemoryTest, ERR_030_031_032_033_ListsErasesAndRunsUntilReset) {
  Bench bench({.tape = std::string(kBild7)});
  bench.keys("3+6+9");
  ASSERT_EQ(bench.control.mode(), Mode::memory_test);
  EXPECT_EQ(bench.monitor(3), "PAGE 1   04096");
  EXPECT_EQ(bench.monitor(6), "PAGE 4   04096");
  EXPECT_TRUE(bench.row(18).contains("zerstört den Speicherinhalt")) << bench.row(18);
  EXPECT_FALSE(bench.control.memory().programs().empty());
  bench.keys("SPEICHER_LOESCHEN");
  EXPECT_TRUE(bench.control.memory().programs().empty()) << "ERR-032";
  EXPECT_EQ(bench.monitor(3), "");
  std::string seen;
  for (int i = 0; i < 5; ++i) {
    bench.run_for(2000);
    seen += bench.monitor(3).substr(0, 3);
  }
  EXPECT_EQ(seen, "00 FF 55 AA 00 ");
  EXPECT_EQ(bench.row(19), " RESET Test beenden");
  EXPECT_EQ(bench.monitor(15), "");
  bench.keys("MENU ENTER SPEICHER_LOESCHEN");
  EXPECT_EQ(bench.control.mode(), Mode::memory_test);
  bench.keys("RESET");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
}

TEST(MemoryTest, ERR_006_034_AnInjectedFaultIsFound) {
  Bench bench;
  bench.control.set_ram_fault(true);
  bench.keys("3+6+9 SPEICHER_LOESCHEN");
  bench.run_for(2500);
  EXPECT_EQ(bench.monitor(15), "PAGE 1 RAM DEFEKT");
}

TEST(MemoryTest, SCR_061_ThePagesOfTheLargestMemoryAreListedWhole) {
  Bench bench({.settings = {.memory_bytes = 100'093}});
  bench.keys("3+6+9");
  std::string list;
  for (int row = 3; row < 15; ++row) list += bench.monitor(row) + " \n";
  for (int page = 1; page <= 24; ++page) {
    const std::string line = "PAGE " + std::to_string(page) + "   04096 ";
    EXPECT_TRUE(list.contains(line)) << page << "\n" << list;
  }
  EXPECT_TRUE(list.contains("PAGE 25   01789 ")) << list;
}

TEST(MemoryTest, MenuBeforeTheTestKeepsEverything) {
  Bench bench({.tape = std::string(kBild7)});
  bench.keys("3+6+9 MENU");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  EXPECT_EQ(bench.control.memory().free_bytes(), 16221);
}

TEST(MemoryTest, D_17_InTheMenuOnlyAndOtherKeysOnTheRackVersion) {
  Bench bench;
  bench.keys("EINGABE 3+6+9");
  EXPECT_EQ(bench.control.mode(), Mode::editor);
  bench.keys("MENU 1+4+7");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  Bench::Setup setup;
  setup.settings.keys_19inch = true;
  Bench rack(setup);
  rack.keys("3+6+9");
  EXPECT_EQ(rack.control.mode(), Mode::menu);
  rack.keys("1+4+7");
  EXPECT_EQ(rack.control.mode(), Mode::memory_test);
}

TEST(MemoryTest, DEC_39_ServiceModesEndWhenTheLabsMachineIsConnected) {
  for (const std::string_view keys : {"ENTER+RESET", "3+6+9"}) {
    Bench bench;
    bench.keys(keys);
    bench.control.connect({bench.channel, machine::Epoch{1}, false, {}});
    EXPECT_NE(bench.control.mode(), Mode::menu) << keys;
    bench.control.connect({bench.channel, machine::Epoch{1}, true, {}});
    EXPECT_EQ(bench.control.mode(), Mode::menu) << keys;
  }
}

TEST(Reset, ERR_040_D_121_ColdStartClearsTheWorkingStateAndKeepsTheMemory) {
  Bench bench({.tape = "P0001N001G90%P0002N001G91%"});
  bench.keys("EINGABE 2 ENTER MENU RESET EINGABE");
  EXPECT_EQ(bench.monitor(2), "PROGRAMM NR □0002") << "RESET alone keeps what was worked on";
  bench.keys("DOWN+RESET");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
  EXPECT_EQ(bench.control.memory().programs().size(), 2U);
  bench.keys("EINGABE");
  EXPECT_EQ(bench.monitor(2), "PROGRAMM NR □0001");
}

TEST(Reset, DEC_39_ResetActsInEveryStateAndEndsALease) {
  for (const std::string_view keys :
       {"", "HAND PLUS_X START", "HAND PLUS_X REFERENZ", "HANDEINGABE 0 0 ENTER 9 START", "TEACH_IN ENTER PLUS_Y START",
        "AUTOMAT ENTER ENTER START", "EINGABE ENTER ENTER", "SPEICHER_LOESCHEN CLEAR", "ENTER+RESET"}) {
    SCOPED_TRACE(std::string(keys));
    Bench bench({.tape = std::string(kBild7)});
    bench.keys(keys);
    bench.run_for(100);
    const Outcome outcome = bench.control.press(Key::RESET, bench.now);
    EXPECT_TRUE(outcome.was_reset);
    EXPECT_EQ(bench.control.mode(), Mode::menu);
    bench.run_for(1500);
    EXPECT_FALSE(bench.snapshot().started);
    EXPECT_EQ(bench.snapshot().speed_mm_per_min, 0);
    const auto there = bench.snapshot().steps;
    bench.run_for(500);
    EXPECT_EQ(bench.snapshot().steps, there);
  }
}

/// What begins the control anew: its status line says M12, and that is what the machine does.
constexpr std::string_view kBeginnings[] = {"SPEICHER_LOESCHEN CLEAR ENTER", "3+6+9 SPEICHER_LOESCHEN RESET", "RESET",
                                            "DOWN+RESET"};

TEST(Service, MOD_078_D_121_D_12_BeginningAnewSwitchesSpindleAndCoolantOff) {
  for (const std::string_view keys : kBeginnings) {
    SCOPED_TRACE(std::string(keys));
    Bench bench({.tape = std::string(kBild7)});
    bench.keys("HANDEINGABE 1 1 ENTER ENTER ENTER ENTER 1 4 START");
    ASSERT_TRUE(bench.run_to_rest());
    ASSERT_EQ(bench.snapshot().spindle, geometry::SpindleTurn::counterclockwise);
    ASSERT_TRUE(bench.snapshot().coolant);
    bench.keys("MENU");
    bench.keys(keys);
    bench.run_for(50);
    EXPECT_EQ(bench.snapshot().spindle, geometry::SpindleTurn::off);
    EXPECT_FALSE(bench.snapshot().coolant);
    bench.keys("MENU HAND FRAESER");
    bench.run_for(50);
    EXPECT_EQ(bench.snapshot().spindle, geometry::SpindleTurn::clockwise) << "the direction of switching on";
  }
}

}  // namespace
}  // namespace cnclab::panel
