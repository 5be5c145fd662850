// The keys that mean the same on every entry line: figures, point and sign.
#pragma once

#include "panel/key_table.hpp"
#include "panel/modes/entry_line.hpp"

namespace cnclab::panel {

/// Enters what the key stands for; false where the mode itself has to say what it does.
[[nodiscard]] bool key_into(EntryLine& line, Effect effect, int figure);

}  // namespace cnclab::panel
