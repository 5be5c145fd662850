// Keys and rows of one cassette.
#include "lab/labor/cassette_page.hpp"

#include <fmt/format.h>

namespace cnclab::lab {

namespace {

constexpr std::size_t kDigits = 2;

std::optional<CassetteAct> act_of(const CassettePage& page, int digit) {
  if (digit == 1) return page.is_inserted ? CassetteAct::eject : CassetteAct::insert;
  if (!page.is_inserted) return std::nullopt;
  if (digit == 2) return CassetteAct::rewind;
  if (digit == 3) return CassetteAct::wind_on;
  if (digit == 4) return CassetteAct::stop;
  if (digit == 5) return CassetteAct::zero_counter;
  return std::nullopt;
}

}  // namespace

std::optional<CassetteAct> press(CassettePage& page, Key key) {
  constexpr int kRename = 6, kRemove = 7;
  const auto digit = digit_of(key);
  switch (page.step) {
    case CassettePage::Step::acts:
      if (digit == kRename) page.step = CassettePage::Step::renaming;
      if (digit == kRemove) page.step = CassettePage::Step::removing;
      return act_of(page, digit.value_or(0));
    case CassettePage::Step::renaming:
      if (digit && page.digits.size() < kDigits) page.digits += static_cast<char>('0' + *digit);
      if (key != Key::ENTER || page.digits.empty()) return std::nullopt;
      return CassetteAct::rename;
    case CassettePage::Step::removing:
      if (key != Key::ENTER) return std::nullopt;
      return CassetteAct::remove;
  }
  return std::nullopt;
}

bool step_back(CassettePage& page) {
  if (page.step == CassettePage::Step::acts) return false;
  if (page.digits.empty())
    page.step = CassettePage::Step::acts;
  else
    page.digits.pop_back();
  return true;
}

CassetteRows rows_of(const CassettePage& page, language::Tongue tongue) {
  const auto say = [is_german = tongue == language::Tongue::german](const char* german, const char* english) {
    return std::string(is_german ? german : english);
  };
  switch (page.step) {
    case CassettePage::Step::renaming:
      return {.heading = say("Neuer Name: K", "New name: K") + page.digits + "_",
              .lines = {page.line},
              .keys = say("Zwei Ziffern   → umbenennen   C löscht eine Ziffer, dann zurück",
                          "Two digits   → rename   C deletes a digit, then back")};
    case CassettePage::Step::removing:
      return {.heading = say("Diese Kassette für immer löschen?", "Remove this cassette for good?"),
              .lines = {page.line},
              .keys = say("→ ja   C nein", "→ yes   C no")};
    case CassettePage::Step::acts:
      break;
  }
  CassetteRows rows{.heading = say("Kassette", "Cassette"),
                    .lines = {page.line},
                    .keys = (page.is_inserted ? "1-7" : "1,6,7") +
                            say(" wählt   C zurück   LABOR zur Steuerung", " choose   C back   LABOR to the control")};
  rows.lines.push_back(page.is_inserted ? say("1 auswerfen  2 zurückspulen  3 vorspulen  4 Stop  5 Zähler auf 000",
                                              "1 eject  2 rewind  3 wind on  4 stop  5 counter to 000")
                                        : say("1 in den Rekorder einlegen", "1 put into the recorder"));
  rows.lines.push_back(say("6 umbenennen  7 löschen", "6 rename  7 remove"));
  return rows;
}

}  // namespace cnclab::lab
