// The control's keyboard drawn below the monitor: where each key cap is and what a click hits.
//
//   A HANDBETRIEB             B BETRIEBSARTEN             C DATENEINGABE
//   HAND     START    STOP    AUTOMAT   GRAFIK    MENU    7     8     9     C
//    h        s       Leert.   a         g         m      7     8     9     c
//   …                                                                          two lines for each row of keys
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "station/keymap.hpp"

namespace cnclab::station {

struct KeyCap {
  const Binding* binding;
  int row, column;  ///< within the keyboard's 12 rows and 80 columns
  int width;        ///< columns; every cap is two rows high
  std::string label, hint;
};

class KeyboardView {
 public:
  static constexpr int kRows = 12;  ///< below the monitor's 24: a terminal of 36 rows shows it

  explicit KeyboardView(Language language, bool is_ascii = false);

  [[nodiscard]] const std::vector<KeyCap>& caps() const { return caps_; }
  /// The cap at this place, nothing between the caps.
  [[nodiscard]] const KeyCap* hit(int row, int column) const;
  struct Title {
    int column;
    std::string text;
  };
  [[nodiscard]] const std::vector<Title>& titles() const { return titles_; }

 private:
  std::vector<KeyCap> caps_;
  std::vector<Title> titles_;
};

}  // namespace cnclab::station
