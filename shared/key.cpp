// Names of the keys and chords, both ways.
#include "shared/key.hpp"

#include <algorithm>
#include <array>

namespace cnclab {
namespace {

// In the order of the numbers; index 0 is "no key".
constexpr std::array<std::string_view, kKeys + 1> kNames = {"",
                                                            "HAND",
                                                            "START",
                                                            "STOP",
                                                            "PLUS_X",
                                                            "MINUS_X",
                                                            "PLUS_Y",
                                                            "MINUS_Y",
                                                            "PLUS_Z",
                                                            "MINUS_Z",
                                                            "ISTWERT",
                                                            "FRAESER",
                                                            "KUEHLMITTEL",
                                                            "AUTOMAT",
                                                            "GRAFIK",
                                                            "MENU",
                                                            "EINZELSATZ",
                                                            "REFERENZ",
                                                            "EXTERNE_DATEN",
                                                            "TEACH_IN",
                                                            "SATZ_SUCHEN",
                                                            "SPEICHER_LOESCHEN",
                                                            "EINGABE",
                                                            "HANDEINGABE",
                                                            "SATZ_LOESCHEN",
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
                                                            "POINT",
                                                            "SIGN",
                                                            "DOWN",
                                                            "CLEAR",
                                                            "ENTER",
                                                            "RESET",
                                                            "MELDUNG",
                                                            "MASCHINE_HALT",
                                                            "LABOR"};

}  // namespace

std::string_view name_of(Key key) {
  const auto number = static_cast<std::size_t>(key);
  return number < kNames.size() ? kNames[number] : std::string_view{};
}

std::optional<Key> key_of(std::string_view name) {
  if (name.empty()) return std::nullopt;
  const auto* const found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Key>(found - kNames.begin());
}

std::vector<Key> keys_of(std::string_view chord) {
  std::vector<Key> keys;
  for (std::size_t start = 0; start <= chord.size();) {
    const std::size_t end = std::min(chord.find('+', start), chord.size());
    const auto key = key_of(chord.substr(start, end - start));
    if (!key || std::ranges::find(keys, *key) != keys.end()) return {};
    keys.push_back(*key);
    start = end + 1;
  }
  return keys;
}

std::optional<int> digit_of(Key key) {
  if (key < Key::D0 || key > Key::D9) return std::nullopt;
  return static_cast<int>(key) - static_cast<int>(Key::D0);
}

}  // namespace cnclab
