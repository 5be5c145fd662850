// How the lab's own menu stands in rows 18 to 23.
#pragma once

#include <string>

#include "lab/labor/labor_menu.hpp"
#include "language/units.hpp"
#include "shared/screen.hpp"

namespace cnclab::lab {

/// Rows 18 to 23 become the menu's. `keeps_sentence`: row 18 stays as it is, because it says what must be read now.
void draw_labor_menu(Screen& screen, const LaborMenu& menu, language::Tongue tongue, bool keeps_sentence);

/// "P0001", "Werkzeugtabelle P0000", "Maschinendaten", for sentences.
[[nodiscard]] std::string name_of(const Subject& subject, language::Tongue tongue);

}  // namespace cnclab::lab
