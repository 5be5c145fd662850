// The names of modes and keys.
#include "panel/screen/names.hpp"

#include <algorithm>
#include <array>

namespace cnclab::panel {

namespace {

struct ModeNames {
  std::string_view german, english;
};

constexpr std::array<ModeNames, kModes> kTitles{{
    {"", ""},
    {"HANDBETRIEB", "MANUAL OPERATION"},
    {"HANDEINGABE", "MANUAL INPUT"},
    {"TEACH IN", "TEACH IN"},
    {"AUTOMAT", "AUTOMATIC"},
    {"EXTERNE DATEN", "EXTERNAL DATA"},
    {"GRAFIK", "GRAPHICS"},
    {"SPEICHER LOESCHEN", "ERASE MEMORY"},
    {"EINGABEMODUS", "PROGRAM ENTRY"},
    {"MASCHINENDATEN", "MACHINE DATA"},
    {"SPEICHERTEST", "MEMORY TEST"},
}};

constexpr std::array<std::string_view, kKeys + 1> kLabels{"",
                                                          "HAND",
                                                          "START",
                                                          "STOP",
                                                          "+X",
                                                          "-X",
                                                          "+Y",
                                                          "-Y",
                                                          "+Z",
                                                          "-Z",
                                                          "ISTWERT",
                                                          "FRÄSER",
                                                          "KÜHLMITTEL",
                                                          "AUTOMAT",
                                                          "GRAFIK",
                                                          "MENU",
                                                          "EINZELSATZ",
                                                          "REFERENZ",
                                                          "EXTERNE DATEN",
                                                          "TEACH IN",
                                                          "SATZ SUCHEN",
                                                          "SPEICHER LÖSCHEN",
                                                          "EINGABE",
                                                          "HANDEINGABE",
                                                          "SATZ LÖSCHEN",
                                                          "0",
                                                          "1",
                                                          "2",
                                                          "3",
                                                          "4",
                                                          "5",
                                                          "6",
                                                          "7",
                                                          "8",
                                                          "9",
                                                          ".",
                                                          "+/-",
                                                          "↓",
                                                          "C",
                                                          "→",
                                                          "RESET",
                                                          "MELDUNG",
                                                          "MASCHINE HALT",
                                                          "LABOR"};

}  // namespace

std::string_view title_of(Mode mode, language::Tongue tongue) {
  const ModeNames& names = kTitles[static_cast<std::size_t>(mode)];
  return tongue == language::Tongue::german ? names.german : names.english;
}

std::string_view name_of(Mode mode) {
  return mode == Mode::menu ? std::string_view("MENU") : kTitles[static_cast<std::size_t>(mode)].german;
}

std::string_view label_of(Key key) {
  const auto index = static_cast<std::size_t>(key);
  return index < kLabels.size() ? kLabels[index] : std::string_view();
}

std::string two_digits(int value) {
  const int shown = std::clamp(value, 0, 99);
  return {static_cast<char>('0' + shown / 10), static_cast<char>('0' + shown % 10)};
}

}  // namespace cnclab::panel
