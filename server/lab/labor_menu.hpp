// The lab's own menu behind key LABOR: what its keys do and how it stands in rows 18 to 23.
#pragma once

#include <cstdint>

#include "language/units.hpp"
#include "shared/key.hpp"
#include "shared/screen.hpp"

namespace cnclab::lab {

enum class LaborChoice : std::uint8_t { none, open_or_close, close, log_out };

[[nodiscard]] LaborChoice labor_choice(Key key);
void draw_labor_menu(Screen& screen, language::Tongue tongue);

}  // namespace cnclab::lab
