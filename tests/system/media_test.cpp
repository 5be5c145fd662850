// Diskettes, punched tapes and printed pages as files at a real station (EXT-003 to EXT-005, EXT-030 to EXT-033,
// DEC-57, DEC-62, SYS-019).
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <bit>

#include "harness/monitor.hpp"
#include "media_seat.hpp"

namespace cnclab::harness {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Media : public testing::Test, public MediaSeat {
 protected:
  /// A device key, a program number or "C", and →.
  static void transfer(StationProcess& station, const std::string& device, const std::string& number) {
    station.type(device);
    station.wait_for(device >= "6" ? "→ sucht" : "→ gibt");
    number == "C" ? station.key("CLEAR") : station.type(number);
    station.key("ENTER");
  }
};

TEST_F(Media, EXT_030_DEC_62_ADisketteTakesAProgramAndGivesItBack) {
  StationProcess anna = sit_down();
  transfer(anna, "4", "7");
  anna.wait_for("Ausgabe beendet: P0007.nc.");
  EXPECT_EQ(content("P0007.nc"), "P0007\nN001G11F1000\nN002G01X+12000Y-1500\nN003G00Z+5000\n%\n");
  lay("P0007.nc", "P0007\nN001G11F0500\nN002G01X+1\n%\n");
  transfer(anna, "8", "7");
  anna.wait_for("Gelesen und gespeichert, Programme: 1.");
  EXPECT_THAT(stored("P0007"), HasSubstr("N002G01X+1"));
  EXPECT_THAT(stored("P0007"), Not(HasSubstr("N003")));
}

TEST_F(Media, EXT_032_EXT_033_ATapeHasRowsOfEvenParityAndATwinToRead) {
  StationProcess anna = sit_down();
  transfer(anna, "3", "7");
  anna.wait_for("Ausgabe beendet: P0007.tap, P0007.txt.");
  const std::string rows = content("P0007.tap");
  ASSERT_GT(rows.size(), 200U);
  EXPECT_EQ(rows.substr(0, 100), std::string(100, '\0')) << "leader";
  EXPECT_EQ(rows.substr(rows.size() - 100), std::string(100, '\0')) << "trailer";
  for (const char row : rows) EXPECT_EQ(std::popcount(static_cast<unsigned char>(row)) % 2, 0) << int{row};
  EXPECT_EQ(content("P0007.txt"), "P0007\nN001G11F1000\nN002G01X+12000Y-1500\nN003G00Z+5000\n%\n");
  anna.key("MENU");
  anna.key("SPEICHER_LOESCHEN");
  anna.type("7");
  anna.key("ENTER");
  anna.wait_for("GELOESCHT");
  anna.key("MENU");
  anna.key("EXTERNE_DATEN");
  transfer(anna, "7", "7");
  anna.wait_for("Gelesen und gespeichert");
  EXPECT_THAT(stored("P0007"), HasSubstr("N003G00Z+5000"));
}

TEST_F(Media, EX_050_DEC_13_ATapeMadeElsewhereIsStoredAndItsLimitsAreForTheRun) {
  lay("P0001.tap", "\r\nP0001N001G00X+12Y-1500000Z+4150%");
  StationProcess anna = sit_down();
  transfer(anna, "7", "1");
  anna.wait_for("Gelesen und gespeichert");
  EXPECT_THAT(stored("P0001"), HasSubstr("N001G00X+12Y-1500000Z+4150"));
  EXPECT_NE(stored("P0007"), "") << "a tape deletes nothing else (DEC-57)";
}

TEST_F(Media, DEC_57_STO_005_AWholeMemoryReplacesEverythingAndVersionsStay) {
  StationProcess anna = sit_down();
  transfer(anna, "4", "C");
  anna.wait_for("Ausgabe beendet");
  EXPECT_THAT(content("SPEICHER.nc"), StartsWith("P0007\n"));
  EXPECT_THAT(content("SPEICHER.nc"), HasSubstr("\nMD\n")) << "with the machine data (DEC-34)";
  EXPECT_THAT(content("SPEICHER.nc"), EndsWith("%\n"));
  lay("SPEICHER.nc", "P0001N001G00X+1\nP0002N001G00X+2\n%\n");
  transfer(anna, "8", "C");
  anna.wait_for("Gelesen und gespeichert, Programme: 2.");
  EXPECT_THAT(stored("P0002"), HasSubstr("N001G00X+2"));
  EXPECT_EQ(stored("P0007"), "P0007\n%\n") << "removed: no blocks in its newest version";
  const auto versions = room().instructor().must({"program", "versions", "anna", "P0007"}).objects;
  ASSERT_GE(versions.size(), 2U);
  EXPECT_EQ(versions.back().at("change"), "remove") << versions.back().dump();
  const std::string before = std::to_string(versions[versions.size() - 2].at("version").get<int>());
  room().instructor().must({"program", "restore", "anna", "P0007", before});
  EXPECT_THAT(stored("P0007"), HasSubstr("N003G00Z+5000"));
}

TEST_F(Media, DEC_57_WhatIsNotWholeAndRightChangesNothing) {
  StationProcess anna = sit_down();
  const std::string before = stored("P0007");
  const struct {
    const char* name;
    std::string text;
    const char* complaint;
  } rows[] = {
      {"a block that is none", "P0001N001G00X+1\nN002G77\n%\n", "P0001 N002"},
      {"too much for the memory", "", "Speicher voll"},
      {"small letters alone (DEC-30)", "hallo\n", "Kleinbuchstaben"},
      {"nothing in it", "%\n", "P0001N001"},
  };
  for (const auto& row : rows) {
    std::string text = row.text;
    for (int block = 1; text.size() < 60'000 && row.text.empty(); ++block)
      text += (block - 1) % 900 == 0 ? "P" + std::to_string(1000 + block) + "N001G00X+1\n"
                                     : "N" + std::to_string(1000 + (block - 1) % 900 + 1).substr(1) + "G00X+1\n";
    lay("SPEICHER.nc", text);
    transfer(anna, "8", "C");
    anna.wait_for(row.complaint);
    EXPECT_EQ(stored("P0007"), before) << row.name;
    EXPECT_EQ(room().instructor().must({"programs", "anna"}).objects.size(), 1U) << row.name;
  }
}

TEST_F(Media, SEC_006_DEC_62_WhatCannotBeReadOrWrittenIsToldInARow) {
  StationProcess anna = sit_down();
  transfer(anna, "8", "9");
  anna.wait_for("P0009.nc liegt nicht im Dateiordner des Platzes.");
  const TemporaryFolder outside;
  const fs::path secret = outside.write("secret", "P0009N001G00X+1\n%\n");
  fs::create_symlink(secret, file("P0009.nc"));
  transfer(anna, "8", "9");
  anna.wait_for("P0009.nc ist am Platz nicht lesbar.");
  fs::create_symlink(secret, file("P0007.nc"));
  transfer(anna, "4", "7");
  anna.wait_for("P0007.nc ist am Platz nicht beschreibbar.");
  EXPECT_EQ(read_file(secret), "P0009N001G00X+1\n%\n");
  fs::remove_all(folder());
  transfer(anna, "4", "7");
  anna.wait_for("Der Dateiordner des Platzes fehlt.");
}

TEST_F(Media, EXT_003_EXT_004_EXT_005_ThePrinterGivesTextAndPdf) {
  StationProcess anna = sit_down();
  transfer(anna, "1", "7");
  anna.wait_for("Ausgabe beendet");
  const std::string list = content("DRUCK-P0007.txt");
  EXPECT_THAT(list, HasSubstr("anna"));
  EXPECT_THAT(list, HasSubstr("\nP0007\n"));
  EXPECT_THAT(list, HasSubstr("N002 G01 X+..12.000 Y-...1.500"));
  EXPECT_THAT(content("DRUCK-P0007.pdf"), StartsWith("%PDF-"));
  transfer(anna, "1", "C");
  anna.wait_for("Ausgabe beendet");
  EXPECT_THAT(content("DRUCK-SPEICHER.txt"), HasSubstr("N002 G01 X+..12.000"));
  EXPECT_THAT(content("DRUCK-SPEICHER.txt"), HasSubstr("MASCHINENDATEN"));
  EXPECT_THAT(content("DRUCK-SPEICHER.txt"), HasSubstr("500000 1/1000 mm"));
  EXPECT_THAT(content("DRUCK-SPEICHER.pdf"), StartsWith("%PDF-"));
}

TEST_F(Media, SYS_013_TheScreenIsPrintedAndInGraphicsThePictureToo) {
  StationProcess anna = sit_down();
  anna.key("MENU");
  anna.key("GRAFIK");
  anna.type("7");
  anna.key("ENTER");
  anna.key("START");
  anna.wait_for("100 %");
  anna.key("LABOR");
  anna.wait_for("4 Bildschirm drucken");
  anna.key("4");
  ASSERT_TRUE(eventually(10s, [&] { return fs::exists(file("GRAFIK-P0007-XY.pdf")); }));
  EXPECT_THAT(content("GRAFIK-P0007-XY.svg"), HasSubstr("</svg>"));
  EXPECT_THAT(content("GRAFIK-P0007-XY.pdf"), StartsWith("%PDF-"));
  ASSERT_TRUE(eventually(10s, [&] {
    int pages = 0;
    for (const auto& entry : fs::directory_iterator(folder()))
      if (entry.path().filename().string().starts_with("BILD-")) ++pages;
    return pages == 2;
  }));
}

TEST(MediaPrinter, EXT_003_ThePrintersQueueTakesThePages) {
  const TemporaryFolder bin;
  const fs::path lp =
      bin.write("lp", "#!/bin/sh\ncd '" + bin.path().string() + "'\necho \"$@\" > words\ncat > pages\n");
  ::chmod(lp.c_str(), 0755);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (bin.path().string() + ":" + path).c_str(), 1);
  {
    MediaSeat seat("[printer]\nqueue = \"saal3\"\n");
    StationProcess anna = seat.sit_down();
    anna.type("1");
    anna.type("7");
    anna.key("ENTER");
    anna.wait_for("Ausgabe beendet");
    EXPECT_EQ(read_file(bin.path() / "words"), "-d saal3 -t DRUCK-P0007.pdf\n");
    EXPECT_EQ(read_file(bin.path() / "pages"), seat.content("DRUCK-P0007.pdf"));
  }
  ::setenv("PATH", path.c_str(), 1);
}

TEST(MediaModel, MODEL_003_MODEL_004_MODEL_005_The3250HasNoPrinterNoTapeAndNoGraphics) {
  MediaSeat seat("[control]\nmodel = \"3250\"\n");
  StationProcess anna = seat.sit_down();
  for (const std::string device : {"1", "3", "7"}) {
    anna.type(device);
    anna.wait_for(device + " hat hier keine Wirkung");
    anna.key("STOP");
  }
  anna.type("4");
  anna.wait_for("→ gibt");
  anna.key("MENU");
  anna.key("GRAFIK");
  EXPECT_THAT(monitor_row(anna.screen(), 1), Not(HasSubstr("GRAFIK")));
}

}  // namespace
}  // namespace cnclab::harness
