// The two lines beside START and STOP: active functions, inputs and outputs (SCR-016, SCR-032).
#pragma once

#include <string>

#include "language/units.hpp"
#include "machine/channel.hpp"
#include "program/modal_state.hpp"

namespace cnclab::panel {

/// "G17 G40 G45 G74 G91 F1000 S0000 T00 M03" (BLK-202); the 3250 shows G74 and G91 only (D-126).
[[nodiscard]] std::string status_line(const program::ModalState& modal, language::Model model);

/// Inputs card 1, outputs card 1, inputs card 2, outputs card 2; left digit = line 1 (D-23).
[[nodiscard]] std::string inputs_and_outputs(const machine::Snapshot& snapshot);

}  // namespace cnclab::panel
