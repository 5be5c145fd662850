// EXTERNE DATEN: what leaves comes back, whole or not at all (EXT, D-105 to D-111, DEC-34, DEC-57).
#include <gmock/gmock.h>

#include "bench.hpp"
#include "language/tape.hpp"

namespace cnclab::panel {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kMemory = "P0000T001R+5000L+0P0007N001G05P0001N001G11F1000N002G00X+1000N003G20P0007N001%";

class ExternalData : public testing::Test {
 public:
  ExternalData() : bench({.settings = {.student = "Jörg"}, .tape = std::string(kMemory)}) {
    bench.control.connect_media(true);
    bench.control.insert_cassette({}, bench.now);
    bench.keys("EXTERNE_DATEN");
  }

  void until(const std::string& text, int most_ms = 200'000) {
    ASSERT_TRUE(bench.run_until([&] { return bench.picture().find(text) != std::string::npos; }, most_ms))
        << bench.picture();
  }
  void write_cassette(const std::string& keys, int leader_ms = 6000) {
    bench.keys("2 " + keys);
    bench.hold(Key::ENTER, leader_ms);
    until("Ausgabe beendet");
  }
  void rewind() {
    bench.control.press_recorder(Control::RecorderKey::rewind, bench.now);
    ASSERT_TRUE(bench.run_until([&] { return !bench.control.recorder_runs(); }));
  }
  void erase_everything() { bench.keys("MENU SPEICHER_LOESCHEN CLEAR ENTER MENU EXTERNE_DATEN"); }
  [[nodiscard]] std::string memory() const {
    std::string text;
    for (const language::Program& program : bench.control.memory().programs()) text += language::write_program(program);
    return text;
  }
  void set_x_travel(std::int64_t um) {
    bench.keys("MENU ENTER+RESET ENTER ENTER CLEAR");
    bench.type(std::to_string(um));
    bench.keys("ENTER MENU EXTERNE_DATEN");
  }

  Bench bench;
};

TEST_F(ExternalData, ACassetteGivesBackAProgram_EXT_010_to_023) {
  const std::string before = memory();
  write_cassette("CLEAR 1");
  bench.keys("MENU EINGABE 1 ENTER 2 ENTER SATZ_LOESCHEN MENU EXTERNE_DATEN");
  rewind();
  bench.keys("6 1 ENTER");
  until("Gelesen und gespeichert, Programme: 1.");
  EXPECT_EQ(memory(), before);
}

TEST_F(ExternalData, AWholeMemoryReplacesEverything_EXT_024_DEC_57) {
  const std::string before = memory();
  write_cassette("CLEAR");
  bench.keys("MENU EINGABE 5 ENTER 1 ENTER 0 5 EINGABE MENU EXTERNE_DATEN");
  rewind();
  bench.keys("6 CLEAR ENTER");
  until("Gelesen und gespeichert, Programme: 3.");
  EXPECT_EQ(memory(), "P0000\nT001R+5000L+0\n" + before.substr(before.find("P0007")));
}

TEST_F(ExternalData, MachineDataComeBackOnlyWithTheSign_EXT_026_KEY_066) {
  write_cassette("CLEAR");
  set_x_travel(400'000);
  rewind();
  bench.keys("6 CLEAR ENTER");
  until("Gelesen");
  bench.keys("MENU ENTER+RESET ENTER ENTER");
  EXPECT_THAT(bench.picture(), HasSubstr("400000"));
  bench.keys("MENU EXTERNE_DATEN");
  rewind();
  bench.keys("6 CLEAR ENTER");
  bench.run_for(500);
  bench.keys("SIGN");
  until("Gelesen");
  bench.keys("MENU ENTER+RESET ENTER ENTER");
  EXPECT_THAT(bench.picture(), HasSubstr("500000"));
}

/// What the cassette, the diskette, the punched tape and the line would get has no mark for damage.
TEST_F(ExternalData, ERR_004_ERR_010_DamagedBlocksDoNotLeave) {
  Memory memory = bench.control.memory();
  language::Program program = *memory.find(1);
  program.blocks.at(1).is_damaged = true;
  memory.put_program(program);
  bench.control.replace_memory(memory);
  for (const std::string keys : {"4 1 ENTER", "4 CLEAR ENTER", "3 1 ENTER", "2 1 ENTER", "2 CLEAR ENTER"}) {
    SCOPED_TRACE(keys);
    bench.keys("MENU EXTERNE_DATEN " + keys);
    bench.run_for(200);
    EXPECT_EQ(bench.monitor(15), "CHECKSUM FEHLER");
    EXPECT_EQ(bench.row(18), "P0001 N002: Der Satz ist im Speicher beschädigt. Löschen und neu eingeben.");
    EXPECT_TRUE(bench.media.empty());
    EXPECT_FALSE(bench.control.recorder_runs());
  }
  bench.keys("MENU EXTERNE_DATEN 4 7 ENTER");
  EXPECT_EQ(bench.media.size(), 1U) << "a sound program leaves";
  bench.media.clear();
  bench.keys("MENU EXTERNE_DATEN 1 1 ENTER");
  EXPECT_EQ(bench.monitor(15), "CHECKSUM FEHLER");
  bench.run_for(200);
  ASSERT_TRUE(bench.media.contains("DRUCK-P0001.txt")) << "paper has a mark";
  EXPECT_THAT(bench.media.at("DRUCK-P0001.txt"), HasSubstr("N002!G00"));
}

TEST_F(ExternalData, ERR_010_ADamagedToolRowDoesNotLeaveWithTheWholeMemory) {
  Memory memory = bench.control.memory();
  language::Program tools = *memory.find(0);
  tools.blocks.front().is_damaged = true;
  memory.put_program(tools);
  bench.control.replace_memory(memory);
  bench.keys("4 CLEAR ENTER");
  EXPECT_EQ(bench.monitor(15), "CHECKSUM FEHLER");
  EXPECT_THAT(bench.row(18), HasSubstr("P0000 T001: "));
  EXPECT_TRUE(bench.media.empty());
}

// A file is read faster than a key is pressed: its machine data are chosen at the prompt.
TEST_F(ExternalData, MachineDataOfAFileAreChosenAtThePrompt_EXT_026_KEY_066_MD_006) {
  constexpr std::string_view kChosen = "MIT MASCHINENDATEN (MD)";
  bench.media["SPEICHER.nc"] = "P0001\nN001G05\nMD\nN06=1234\n%\n";
  const auto f_max = [&] { return bench.control.data().get(6); };
  const std::int64_t before = f_max();
  bench.keys("8 CLEAR ENTER");
  EXPECT_EQ(bench.row(18), "Gelesen und gespeichert, Programme: 1. Gerät wählen.");
  bench.keys("8 SIGN");
  EXPECT_EQ(bench.monitor(10), kChosen);
  bench.keys("SIGN");  // and not after all
  EXPECT_EQ(bench.monitor(10), "");
  bench.keys("CLEAR ENTER");
  EXPECT_EQ(f_max(), before);
  bench.keys("8 SIGN CLEAR");
  EXPECT_EQ(bench.monitor(10), kChosen);
  EXPECT_THAT(bench.row(19), HasSubstr("+/- Maschinendaten übernehmen"));
  bench.keys("ENTER");
  EXPECT_EQ(f_max(), 1234);
  EXPECT_THAT(bench.row(18), HasSubstr("dazu die Maschinendaten (MD)."));
  bench.keys("8");
  EXPECT_EQ(bench.monitor(10), "") << "each reading is chosen anew";
}

TEST_F(ExternalData, TheSignAtThePromptHoldsForACassetteToo_EXT_026) {
  write_cassette("CLEAR");
  set_x_travel(400'000);
  rewind();
  bench.keys("6 CLEAR SIGN ENTER");
  until("Gelesen");
  EXPECT_EQ(bench.control.data().get(3), 500'000);
}

TEST_F(ExternalData, OnlyAnInputHasTheSignAndOnlyTheLeaderTheArrow_KEY_090) {
  bench.keys("2");
  EXPECT_THAT(bench.row(19), Not(HasSubstr("+/-")));
  bench.keys("CLEAR 1");
  (void)bench.control.press(Key::ENTER, bench.now);
  bench.run_for(6000);
  EXPECT_EQ(bench.row(19), " STOP abbrechen   → Vorspann zu Ende");
  bench.control.release(Key::ENTER, bench.now);
  bench.run_for(1100);
  EXPECT_EQ(bench.row(19), " STOP abbrechen");
  bench.keys("SIGN");
  EXPECT_THAT(bench.row(18), HasSubstr("+/- wirkt erst danach")) << "until the transfer is over:";
  until("Ausgabe beendet");
  rewind();
  bench.keys("6 1 ENTER");
  bench.run_for(500);
  EXPECT_THAT(bench.picture(), HasSubstr(" STOP abbrechen   +/- Maschinendaten übernehmen"));
}

TEST(ExternalDataOnLabMachine, TheSignSaysWhyNoMachineDataComeAlong_DEC_39) {
  Bench bench({.is_lab_machine = true});
  bench.control.connect_media(true);
  bench.media["SPEICHER.nc"] = "P0001\nN001G05\nMD\nN06=1234\n%\n";
  bench.keys("EXTERNE_DATEN 8 CLEAR SIGN");
  EXPECT_EQ(bench.row(18), "Das geht nicht, solange dieser Platz die Maschine im Raum hat.");
  EXPECT_EQ(bench.monitor(10), "");
}

TEST_F(ExternalData, ADashTurnsWhileAProgramIsRead_SCR_048_D_106) {
  write_cassette("CLEAR 1");
  rewind();
  bench.keys("6 1 ENTER");
  bench.run_for(6900);
  EXPECT_EQ(bench.monitor(0).size(), 63U);
  bench.run_for(150);
  EXPECT_THAT(std::string("|/-\\"), HasSubstr(bench.monitor(0).substr(63)));
  EXPECT_EQ(bench.monitor(0).size(), 64U);
}

TEST_F(ExternalData, ADamagedRecordingChangesNothing_D_107) {
  write_cassette("CLEAR");
  transfer::Cassette cassette = bench.control.cassette().value();
  ASSERT_TRUE(cassette.damage(0, 40));
  cassette.wind_to(0);
  bench.control.insert_cassette(cassette, bench.now);
  const std::string before = memory();
  bench.keys("6 CLEAR ENTER");
  until("CHECKSUM FEHLER");
  EXPECT_EQ(memory(), before);
  EXPECT_EQ(bench.stores(), 0);
}

TEST_F(ExternalData, StopAbortsAndTakesNothingOver_D_107) {
  write_cassette("CLEAR 1");
  rewind();
  bench.keys("6 1 ENTER");
  bench.run_for(6000);
  bench.keys("STOP");
  EXPECT_FALSE(bench.control.recorder_runs());
  bench.run_for(10'000);
  EXPECT_EQ(bench.stores(), 0);
  EXPECT_THAT(bench.row(18), HasSubstr("abgebrochen"));
}

TEST_F(ExternalData, AShortLeaderIsExplained_D_105) {
  bench.keys("2 CLEAR 1 ENTER");  // a terminal's press and release at once
  until("Vorspann zu kurz");
}

TEST_F(ExternalData, TheSecondPressEndsTheLeaderOfATerminal) {
  bench.keys("2 CLEAR 1");
  (void)bench.control.press(Key::ENTER, bench.now);
  bench.run_for(6000);
  (void)bench.control.press(Key::ENTER, bench.now);
  until("Ausgabe beendet");
}

TEST_F(ExternalData, DisketteAndTapeAreFilesAtTheStation_EXT_030_EXT_032) {
  const std::string before = memory();
  bench.keys("4 CLEAR ENTER 3 CLEAR 1 ENTER");
  EXPECT_THAT(bench.media.at("SPEICHER.nc"), HasSubstr("MD\nN03=500000\n"));
  EXPECT_THAT(bench.media.at("P0001.tap"), Not(HasSubstr("MD")));
  EXPECT_THAT(bench.media.at("P0001.txt"), HasSubstr("P0001\nN001G11F1000\n"));
  erase_everything();
  EXPECT_EQ(memory(), "");
  bench.keys("7 1 ENTER");
  EXPECT_EQ(memory(), before.substr(before.find("P0001")));
  bench.keys("8 CLEAR ENTER");
  EXPECT_EQ(memory().size(), before.size());
  erase_everything();
  bench.keys("8 7 ENTER");  // one program out of the whole memory
  EXPECT_EQ(memory(), "P0007\nN001G05\n");
}

TEST_F(ExternalData, WhatIsWrongOrTooMuchLeavesTheMemoryAsItWas_DEC_57) {
  const std::string before = memory();
  bench.media["P0001.nc"] = "P0001\nN001 G01 X+\n%\n";
  bench.media["P0002.nc"] = "P0001\nN001G05\n%\n";
  bench.keys("8 CLEAR 1 ENTER");
  EXPECT_THAT(bench.row(18), HasSubstr("P0001 N001"));
  bench.keys("8 2 ENTER");
  EXPECT_THAT(bench.monitor(15), HasSubstr("Programm fehlt"));
  bench.keys("8 9 ENTER");
  EXPECT_THAT(bench.row(18), HasSubstr("Datei P0009.nc fehlt."));
  std::string large = "P0003";
  for (int block = 100; block < 999; ++block) large += "N" + std::to_string(block) + "G01X+1Y+1Z+1F1000S1000T01M03";
  bench.media["P0003.nc"] = large + "%";
  bench.keys("8 3 ENTER");
  EXPECT_THAT(bench.monitor(15), HasSubstr("Speicher voll"));
  EXPECT_EQ(memory(), before);
  EXPECT_EQ(bench.stores(), 0);
}

// DEC-30, EXT-049: the control skips small letters; row 18 tells that it did.
TEST_F(ExternalData, SmallLettersOfADisketteAreSkippedAndTold_DEC_30) {
  bench.media["P0004.nc"] = "P0004 (Nut links)\nN001 G01 X+1000 hallo\n%\n";
  bench.keys("8 CLEAR 4 ENTER");
  EXPECT_THAT(memory(), HasSubstr("P0004\nN001G01X+1000\n"));
  EXPECT_EQ(bench.row(18), "Gelesen und gespeichert, Programme: 1. Gerät wählen. Kleinbuchstaben hat die");
  EXPECT_EQ(bench.row(19), "Steuerung überlesen.");
  bench.media["P0005.nc"] = "P0005 (Nut rechts)\nN001 G01 X+1000\n%\n";
  bench.keys("8 CLEAR 5 ENTER");
  EXPECT_EQ(bench.row(18), "Gelesen und gespeichert, Programme: 1. Gerät wählen.") << "comments are no loss";
  bench.media["P0006.nc"] = "hallo";
  bench.keys("8 CLEAR 6 ENTER");
  EXPECT_THAT(bench.row(18) + " " + bench.row(19), HasSubstr("Kleinbuchstaben hat die Steuerung überlesen."));
}

TEST_F(ExternalData, AReservedNumberIsLeftOutAndTold_DEC_06) {
  bench.media["P9985.nc"] = "P9985\nN001G05\n%\n";
  bench.keys("8 CLEAR 9 9 8 5 ENTER");
  EXPECT_EQ(bench.monitor(15), "Reserviert fuer Zyklen");
  EXPECT_THAT(bench.row(18), HasSubstr("P9981 bis P9989"));
  bench.media["SPEICHER.nc"] = "P0001\nN001G05\nP9985\nN001G05\n%\n";
  bench.keys("8 CLEAR ENTER");
  EXPECT_EQ(memory(), "P0001\nN001G05\n");
  EXPECT_THAT(bench.row(18) + " " + bench.row(19), HasSubstr("P9981 bis P9989"));
  bench.keys("8 1 ENTER");
  EXPECT_THAT(bench.row(18) + " " + bench.row(19), Not(HasSubstr("P9981"))) << "nobody asked for it";
}

TEST_F(ExternalData, AnEmptyMemoryAndTheCyclesAreToldAsWhatTheyAre) {
  for (const char* const keys : {"1 CLEAR 9 9 8 1 ENTER", "4 CLEAR 9 9 8 9 ENTER"}) {
    bench.keys(keys);
    EXPECT_EQ(bench.monitor(15), "Reserviert fuer Zyklen") << keys;
    EXPECT_THAT(bench.row(18), HasSubstr("P9981 bis P9989")) << keys;
  }
  erase_everything();
  for (const char* const keys : {"1 CLEAR ENTER", "3 CLEAR ENTER", "4 CLEAR ENTER"}) {
    bench.keys(keys);
    EXPECT_EQ(bench.monitor(15), "Programm fehlt") << keys;
    EXPECT_THAT(bench.row(18), HasSubstr("Der Speicher ist leer")) << keys;
  }
}

TEST_F(ExternalData, AStoreThatFailsEndsTheTransfer) {
  bench.media["P0005.nc"] = "P0005N001G05%";
  bench.fail_next_store("Platte voll");
  bench.keys("8 5 ENTER");
  EXPECT_THAT(bench.row(18), HasSubstr("Platte voll"));
  bench.run_for(20);
  bench.keys("MENU");
  EXPECT_EQ(bench.control.mode(), Mode::menu);
}

TEST_F(ExternalData, ThePrinterGivesTextAndPdf_EXT_003_to_005) {
  bench.keys("1 CLEAR ENTER");
  bench.run_for(20);
  EXPECT_THAT(bench.media.at("DRUCK-SPEICHER.txt"), HasSubstr("Jörg"));
  EXPECT_THAT(bench.media.at("DRUCK-SPEICHER.txt"), HasSubstr("(11:39:58 02/03/82)"));
  EXPECT_THAT(bench.media.at("DRUCK-SPEICHER.txt"), HasSubstr("N003 G20 (SPRUNG PROGRAMM) P0007 N001"));
  EXPECT_EQ(bench.media.at("DRUCK-SPEICHER.pdf").substr(0, 5), "%PDF-");
  EXPECT_THAT(bench.row(18), HasSubstr("Ausgabe beendet"));
  bench.keys("1 CLEAR 9 ENTER");
  EXPECT_THAT(bench.monitor(15), HasSubstr("Programm fehlt"));
}

TEST_F(ExternalData, Row18NamesTheFilesThatWereWritten_SYS_019) {
  struct Row {
    const char *keys, *sentence;
  };
  for (const Row& row :
       {Row{"4 CLEAR 1 ENTER", "Ausgabe beendet: P0001.nc. Gerät wählen."},
        Row{"3 CLEAR 1 ENTER", "Ausgabe beendet: P0001.tap, P0001.txt. Gerät wählen."},
        Row{"4 CLEAR ENTER", "Ausgabe beendet: SPEICHER.nc. Gerät wählen."},
        Row{"1 CLEAR ENTER", "Ausgabe beendet: DRUCK-SPEICHER.txt, DRUCK-SPEICHER.pdf. Gerät wählen."}}) {
    bench.keys(row.keys);
    bench.run_for(20);
    EXPECT_EQ(bench.row(18), row.sentence) << row.keys;
  }
  bench.control.connect_printer(true);
  bench.control.connect_media(false);  // the pages are printed in the lab and stand in no folder
  bench.keys("1 CLEAR 1 ENTER");
  bench.run_for(20);
  EXPECT_EQ(bench.row(18), "Ausgabe beendet. Gerät wählen.");
}

TEST(ExternalData3250, HasNeitherPrinterNorPunchedTape_MODEL_004_005) {
  Bench bench({.settings = {.vocabulary = {.model = language::Model::cnc3250}}});
  bench.control.connect_media(true);
  bench.keys("EXTERNE_DATEN");
  EXPECT_THAT(bench.picture(), Not(HasSubstr("DRUCKER")));
  EXPECT_THAT(bench.picture(), Not(HasSubstr("LOCHSTREIFEN")));
  EXPECT_EQ(bench.row(19), " 4 Gerät   8 Gerät   MENU Menü");
  for (const char* key : {"1", "3", "7"}) {
    bench.keys(key);
    EXPECT_THAT(bench.row(18), HasSubstr("keine Wirkung")) << key;
  }
  for (const char* key : {"5", "9"}) {
    bench.keys(key);
    EXPECT_THAT(bench.row(18), HasSubstr("nicht angeschlossen")) << key;
  }
  bench.keys("8");
  EXPECT_THAT(bench.monitor(8), HasSubstr("PROGRAMM NR"));
}

struct Connected {
  std::string_view name, keys;
  bool has_media, has_cassette;
};

TEST(ExternalDataKeys, DEC_01_D_109_OnlyConnectedDevicesAreListed) {
  for (const auto& [name, keys, has_media, has_cassette] : {Connected{"nothing", " MENU Menü", false, false},
                                                            {"a folder", " 1,3-4,7-8 Gerät   MENU Menü", true, false},
                                                            {"a recorder", " 2,6 Gerät   MENU Menü", false, true},
                                                            {"both", " 1-4,6-8 Gerät   MENU Menü", true, true}}) {
    SCOPED_TRACE(std::string(name));
    Bench bench;
    bench.control.connect_media(has_media);
    if (has_cassette) bench.control.insert_cassette({}, bench.now);
    bench.keys("EXTERNE_DATEN");
    EXPECT_EQ(bench.row(19), keys);
  }
}

TEST_F(ExternalData, D_109_ADeviceThatIsTakenAwayAtThePromptIsMissedWhenItIsToWork) {
  bench.keys("2");
  bench.control.eject_cassette();
  bench.keys("1 ENTER");
  EXPECT_THAT(bench.row(18), HasSubstr("Keine Kassette eingelegt."));
  EXPECT_FALSE(bench.control.is_busy());
}

}  // namespace
}  // namespace cnclab::panel
