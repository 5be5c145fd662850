// Every key of the CNC 3300 and the three that the lab adds; one enum for wire, panel, terminals and tests.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace cnclab {

/// Names are those of interfaces.md section 3; numbers are those of the wire (proto/cnclab/v1/keys.proto).
enum class Key : std::uint8_t {
  none = 0,
  // Block A
  HAND = 1,
  START,
  STOP,
  PLUS_X,
  MINUS_X,
  PLUS_Y,
  MINUS_Y,
  PLUS_Z,
  MINUS_Z,
  ISTWERT,
  FRAESER,
  KUEHLMITTEL,
  // Block B
  AUTOMAT,
  GRAFIK,
  MENU,
  EINZELSATZ,
  REFERENZ,
  EXTERNE_DATEN,
  TEACH_IN,
  SATZ_SUCHEN,
  SPEICHER_LOESCHEN,
  EINGABE,
  HANDEINGABE,
  SATZ_LOESCHEN,
  // Block C
  D0,
  D1,
  D2,
  D3,
  D4,
  D5,
  D6,
  D7,
  D8,
  D9,
  POINT,
  SIGN,
  DOWN,
  CLEAR,
  ENTER,
  RESET,
  // The lab's own
  MELDUNG,
  MASCHINE_HALT,
  LABOR,
};

inline constexpr int kKeys = static_cast<int>(Key::LABOR);

/// "EINGABE", "0", "PLUS_X" …: the name of interfaces.md.
[[nodiscard]] std::string_view name_of(Key key);
[[nodiscard]] std::optional<Key> key_of(std::string_view name);
/// Keys joined by "+", e.g. "ENTER+RESET"; empty where one is unknown.
[[nodiscard]] std::vector<Key> keys_of(std::string_view chord);
/// 0..9 for a digit key.
[[nodiscard]] std::optional<int> digit_of(Key key);

}  // namespace cnclab
