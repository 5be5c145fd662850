// What modes and keys are called on the screen.
#pragma once

#include <string>
#include <string_view>

#include "language/units.hpp"
#include "panel/mode.hpp"
#include "shared/key.hpp"

namespace cnclab::panel {

/// The title on the monitor: "AUTOMAT", "EINGABEMODUS", …; empty for the menu.
[[nodiscard]] std::string_view title_of(Mode mode, language::Tongue tongue);

/// The label of the key on the original keyboard (D-08): "SPEICHER LÖSCHEN", "→", "C", "+/-".
[[nodiscard]] std::string_view label_of(Key key);

/// "07": 0 to 99, two figures.
[[nodiscard]] std::string two_digits(int value);

}  // namespace cnclab::panel
