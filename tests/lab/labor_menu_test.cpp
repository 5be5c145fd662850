// The lab's own menu: what each key does on each page, and how the pages stand in rows 18 to 23 (interfaces.md 3).
#include "lab/labor/labor_menu.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lab/labor/labor_screen.hpp"

namespace cnclab::lab {
namespace {

using language::Tongue;
using testing::HasSubstr;

constexpr LaborFacilities kEverything{.can_print_screen = true, .has_cassettes = true};

/// Presses keys named as in interfaces.md; gives the order of the last one.
LaborOrder press(LaborMenu& menu, std::initializer_list<const char*> keys) {
  LaborOrder order;
  for (const char* key : keys) order = menu.press(key_of(key).value());
  return order;
}

std::vector<LaborVersion> ten_versions() {
  std::vector<LaborVersion> versions;
  for (int number = 10; number > 0; --number)
    versions.push_back({number, 1'000'000LL * number, "eva", 7, "put", number});
  return versions;
}

std::vector<std::string> rows_of(const LaborMenu& menu, Tongue tongue, bool keeps_sentence = false) {
  Screen screen;
  for (int row = 0; row < Screen::kRows; ++row) screen.write(row, 0, "control");
  draw_labor_menu(screen, menu, tongue, keeps_sentence);
  std::vector<std::string> rows;
  for (int row = 0; row < Screen::kRows; ++row) rows.push_back(screen.text(row));
  return rows;
}

std::string bottom_of(const LaborMenu& menu, Tongue tongue) {
  std::string text;
  const auto rows = rows_of(menu, tongue);
  for (std::size_t row = 18; row < rows.size(); ++row) text += rows[row] + "\n";
  return text;
}

TEST(LaborMenu, EachDigitOfTheStartPageGivesItsOrder) {
  const auto index_after = [](LaborFacilities facilities, const char* digit) {
    LaborMenu menu(facilities);
    return press(menu, {digit}).index();
  };
  EXPECT_EQ(index_after(kEverything, "2"), LaborOrder(AskForPassword{}).index());
  EXPECT_EQ(index_after(kEverything, "4"), LaborOrder(PrintScreen{}).index());
  EXPECT_EQ(index_after(kEverything, "5"), LaborOrder(ReadList{}).index());
  EXPECT_EQ(index_after(kEverything, "6"), LaborOrder(ReadList{}).index());
  EXPECT_EQ(index_after(kEverything, "7"), LaborOrder(LogOut{}).index());
  for (const char* digit : {"4", "5", "8", "9", "0"}) EXPECT_EQ(index_after({}, digit), 0U) << digit;
}

TEST(LaborMenu, WhatTheLabDoesNotOfferIsNotShown) {
  EXPECT_THAT(bottom_of(LaborMenu(kEverything), Tongue::german), HasSubstr("4 Bildschirm drucken    5 Kassetten"));
  const std::string without = bottom_of(LaborMenu({}), Tongue::german);
  EXPECT_THAT(without, Not(HasSubstr("4 ")));
  EXPECT_THAT(without, Not(HasSubstr("5 ")));
  EXPECT_THAT(without, HasSubstr("zeichnet Tasten, Programmänderungen, Läufe und Freigaben auf"));  // STO-006
}

TEST(LaborMenu, LABOR_and_MENU_leave_from_every_page_and_C_goes_one_page_back) {
  for (const char* leaving : {"LABOR", "MENU"}) {
    LaborMenu menu(kEverything);
    static_cast<void>(press(menu, {"1", "1", "7"}));
    EXPECT_TRUE(std::holds_alternative<CloseMenu>(press(menu, {leaving}))) << leaving;
  }
  LaborMenu menu(kEverything);
  static_cast<void>(press(menu, {"1", "1", "7", "ENTER"}));
  menu.show_versions(std::uint16_t{7}, ten_versions());
  static_cast<void>(press(menu, {"2", "CLEAR"}));
  EXPECT_TRUE(std::holds_alternative<VersionsPage>(menu.page()));
  static_cast<void>(press(menu, {"CLEAR"}));
  EXPECT_TRUE(std::holds_alternative<SubjectPage>(menu.page()));
  static_cast<void>(press(menu, {"1", "4", "CLEAR"}));
  EXPECT_TRUE(std::holds_alternative<ProgramPage>(menu.page())) << "C deletes the digit first";
  static_cast<void>(press(menu, {"CLEAR", "CLEAR"}));
  EXPECT_TRUE(std::holds_alternative<StartPage>(menu.page()));
  EXPECT_TRUE(std::holds_alternative<CloseMenu>(press(menu, {"CLEAR"})));
}

TEST(LaborMenu, STO_005_VersionsOfProgramToolsAndMachineDataAreAskedFor) {
  struct Row {
    std::initializer_list<const char*> keys;
    Subject of;
  };
  const Row rows[] = {{{"1", "1", "0", "0", "4", "2", "9", "ENTER"}, std::uint16_t{42}},
                      {{"1", "1", "9", "9", "9", "9", "ENTER"}, std::uint16_t{9999}},
                      {{"1", "2"}, std::uint16_t{0}},
                      {{"1", "3"}, MachineDataSet{}}};
  for (const Row& row : rows) {
    LaborMenu menu({});
    const LaborOrder order = press(menu, row.keys);
    ASSERT_TRUE(std::holds_alternative<ReadVersions>(order));
    EXPECT_EQ(std::get<ReadVersions>(order).of, row.of);
  }
  LaborMenu menu({});
  EXPECT_TRUE(std::holds_alternative<std::monostate>(press(menu, {"1", "1", "ENTER"}))) << "no number, no list";
}

TEST(LaborMenu, STO_005_AVersionIsChosenConfirmedAndRestored) {
  LaborMenu menu({});
  static_cast<void>(press(menu, {"1", "1", "7", "ENTER"}));
  menu.show_versions(std::uint16_t{8}, ten_versions());
  EXPECT_TRUE(std::holds_alternative<ReadingPage>(menu.page())) << "the list of another program comes too late";
  menu.show_versions(std::uint16_t{7}, ten_versions());
  EXPECT_TRUE(std::holds_alternative<std::monostate>(press(menu, {"DOWN", "3"})));
  ASSERT_TRUE(std::holds_alternative<RestorePage>(menu.page()));
  const LaborOrder order = press(menu, {"ENTER"});
  ASSERT_TRUE(std::holds_alternative<RestoreVersion>(order));
  EXPECT_EQ(std::get<RestoreVersion>(order).version, 4);
  EXPECT_EQ(std::get<RestoreVersion>(order).of, Subject(std::uint16_t{7}));
}

TEST(LaborMenu, PagesTurnOnBackAndAroundAndOnlyShownLinesAreChosen) {
  struct Row {
    std::initializer_list<const char*> keys;
    std::size_t first;
  };
  const Row rows[] = {{{}, 0},       {{"DOWN"}, 4},         {{"DOWN", "DOWN"}, 8}, {{"DOWN", "DOWN", "DOWN"}, 0},
                      {{"SIGN"}, 8}, {{"DOWN", "SIGN"}, 0}, {{"ENTER"}, 0}};
  for (const Row& row : rows) {
    LaborMenu menu({});
    static_cast<void>(press(menu, {"1", "2"}));
    menu.show_versions(std::uint16_t{0}, ten_versions());
    static_cast<void>(press(menu, row.keys));
    EXPECT_EQ(std::get<VersionsPage>(menu.page()).first, row.first);
  }
  LaborMenu menu({});
  static_cast<void>(press(menu, {"1", "2"}));
  menu.show_versions(std::uint16_t{0}, ten_versions());
  static_cast<void>(press(menu, {"DOWN", "DOWN", "3"}));
  EXPECT_TRUE(std::holds_alternative<VersionsPage>(menu.page())) << "the last page has two lines";
  menu = LaborMenu({});
  static_cast<void>(press(menu, {"1", "2"}));
  menu.show_versions(std::uint16_t{0}, std::vector<LaborVersion>(90));
  static_cast<void>(press(menu, {"ENTER"}));
  EXPECT_EQ(std::get<VersionsPage>(menu.page()).first, 40U) << "→ turns ten pages";
}

TEST(LaborMenu, CassettesAreChosenByTheirLineAndMessagesAreNot) {
  LaborMenu menu(kEverything);
  menu.show_list(LaborList::cassettes, {"eins", "zwei", "drei", "vier", "fünf"});
  const LaborOrder order = press(menu, {"DOWN", "1"});
  ASSERT_TRUE(std::holds_alternative<ChooseCassette>(order));
  EXPECT_EQ(std::get<ChooseCassette>(order).index, 4U);
  menu.show_list(LaborList::messages, {"zu spät"});
  EXPECT_THAT(bottom_of(menu, Tongue::german), Not(HasSubstr("zu spät"))) << "another list is on the page";
  LaborMenu second(kEverything);
  second.show_list(LaborList::messages, {"14:03  lehrer: bitte abmelden"});
  EXPECT_THAT(bottom_of(second, Tongue::german), HasSubstr("14:03  lehrer: bitte abmelden"));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(press(second, {"1"})));
}

TEST(LaborMenu, LanguageIsChosenByADigit) {
  LaborMenu menu({});
  const LaborOrder order = press(menu, {"3", "2"});
  ASSERT_TRUE(std::holds_alternative<ChooseLanguage>(order));
  EXPECT_EQ(std::get<ChooseLanguage>(order).tongue, Tongue::english);
}

TEST(LaborScreen, RowsEighteenToTwentyThreeOnlyAndRowEighteenMayStay) {
  const auto rows = rows_of(LaborMenu({}), Tongue::german);
  for (std::size_t row = 0; row < 18; ++row) EXPECT_TRUE(rows[row].starts_with("control")) << row;
  EXPECT_THAT(rows[18], HasSubstr("LABOR  Was möchten Sie tun?"));
  const auto kept = rows_of(LaborMenu({}), Tongue::german, true);
  EXPECT_TRUE(kept[18].starts_with("control")) << "an offer of the machine must be seen";
  EXPECT_EQ(kept[19], rows[19]);
}

TEST(LaborScreen, AVersionSaysNumberTimeChangeAndWho) {
  LaborMenu menu({});
  static_cast<void>(press(menu, {"1", "1", "7", "ENTER"}));
  const std::int64_t time_ms = 1'700'000'000'000;
  menu.show_versions(std::uint16_t{7}, {{3, time_ms, "lehrer", 0, "replace", 0}, {2, time_ms, "eva", 12, "delete", 5}});
  const std::string german = bottom_of(menu, Tongue::german);
  EXPECT_THAT(german, HasSubstr("LABOR  Versionen: P0007, Seite 1 von 1"));
  EXPECT_THAT(german, testing::ContainsRegex("1  V3 .*\\.11\\.23 ..:..:..  im Ganzen gespeichert +lehrer"));
  EXPECT_THAT(german, testing::ContainsRegex("2  V2 .*  Satz N005 gelöscht +eva, Platz 12"));
  EXPECT_THAT(bottom_of(menu, Tongue::english), HasSubstr("block N005 deleted"));
}

TEST(LaborScreen, STO_005_the_seat_stands_behind_a_long_name_and_the_whole_name_where_it_is_chosen) {
  LaborMenu menu({});
  static_cast<void>(press(menu, {"1", "1", "7", "ENTER"}));
  const std::string name = "müller-überlang-von-der-" + std::string(8, 'x');
  menu.show_versions(std::uint16_t{7}, {{1234, 1'700'000'000'000, name, 12, "delete", 5}});
  EXPECT_THAT(bottom_of(menu, Tongue::german), HasSubstr("müller-ü…xxxxxxxx, Platz 12"));
  EXPECT_THAT(bottom_of(menu, Tongue::english), HasSubstr("…xxxxxxx, station 12"));
  static_cast<void>(press(menu, {"1"}));
  EXPECT_THAT(bottom_of(menu, Tongue::german), HasSubstr("von " + name + ", Platz 12"));
}

TEST(LaborScreen, NoPageIsCutInEitherLanguage) {
  const auto check = [](const LaborMenu& menu) {
    for (const Tongue tongue : {Tongue::german, Tongue::english})
      for (const std::string& row : rows_of(menu, tongue)) EXPECT_EQ(from_utf8(row).back(), U' ') << row;
  };
  LaborMenu menu(kEverything);
  check(menu);
  for (const auto& keys : {std::initializer_list<const char*>{"1"}, {"1", "1"}, {"3"}}) {
    LaborMenu page(kEverything);
    static_cast<void>(press(page, keys));
    check(page);
  }
  static_cast<void>(press(menu, {"1", "3"}));
  check(menu);
  menu.show_versions(MachineDataSet{},
                     {{1, 1'700'000'000'000, "schueler0123", 15, "03 04 05 06 07 09 10 11 12 14", 0}, {}});
  check(menu);
  EXPECT_THAT(bottom_of(menu, Tongue::german), HasSubstr("wie geliefert"));
  static_cast<void>(press(menu, {"1"}));
  check(menu);
}

TEST(LaborScreen, DEC_01_OnlyKeysThatDoSomethingAreListed) {
  const auto keys_of = [](const LaborMenu& menu) { return rows_of(menu, Tongue::german)[23]; };
  LaborMenu cassettes(kEverything);
  cassettes.show_list(LaborList::cassettes, {});
  EXPECT_THAT(keys_of(cassettes), testing::StartsWith(" EINGABE neue   C zurück "));
  cassettes.show_list(LaborList::cassettes, {"eins", "zwei"});
  EXPECT_THAT(keys_of(cassettes), testing::StartsWith(" 1-2 wählt   EINGABE neue   C zurück "));
  cassettes.show_list(LaborList::cassettes, {"eins", "zwei", "drei", "vier", "fünf"});
  EXPECT_THAT(keys_of(cassettes), testing::StartsWith(" 1-4 wählt   EINGABE neue   ↓ weiter   +/- zurückblättern"));
  static_cast<void>(press(cassettes, {"DOWN"}));
  EXPECT_THAT(keys_of(cassettes), testing::StartsWith(" 1 wählt   EINGABE neue   ↓ weiter"));
  cassettes.show_cassette(4, "fünf", false);
  EXPECT_THAT(keys_of(cassettes), testing::StartsWith(" 1,6,7 wählt "));
  cassettes.show_cassette(4, "fünf", true);
  EXPECT_THAT(keys_of(cassettes), testing::StartsWith(" 1-7 wählt "));
  LaborMenu messages(kEverything);
  messages.show_list(LaborList::messages, {});
  EXPECT_THAT(keys_of(messages), testing::StartsWith(" C zurück "));
  LaborMenu versions(kEverything);
  static_cast<void>(press(versions, {"1", "2"}));
  versions.show_versions(std::uint16_t{0}, std::vector<LaborVersion>(3));
  EXPECT_THAT(keys_of(versions), testing::StartsWith(" 1-3 zurückholen   C zurück "));
  EXPECT_THAT(keys_of(LaborMenu({.can_print_screen = false, .has_cassettes = true})),
              testing::StartsWith(" 1-3,5-7 wählt "));
}

}  // namespace
}  // namespace cnclab::lab
