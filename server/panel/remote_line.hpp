// The serial line beside the operating modes: begun, held and ended as mode and REMOTE switch say (D-110).
//
//   REMOTE on, somebody there ──▶ polled in the menu and in EXTERNE DATEN, held in every other mode
//        text ──▶ stored ──▶ next        "#" ──▶ memory erased        "!" ──▶ answered in every mode
//        "*" ──▶ the lab is asked ──▶ AUTOMAT runs ──▶ back to the mode before, polled again (EXT-060)
//   key 3, 5, 7 or 9 ──▶ the transfer that EXTERNE DATEN wants; the line is polled again behind it
#pragma once

#include <string>

#include "panel/modes/modes.hpp"

namespace cnclab::panel {

/// Somebody is at the other end, or nobody any more: what is under way breaks off.
void connect_line(ActiveMode& mode, ControlState& state, bool is_connected);
/// Lets the line's time pass; to be called at each poll, behind `follow`.
void follow_line(ActiveMode& mode, ControlState& state);
/// The answer to a store that the line has caused; `error` as for Control::store_done.
void line_stored(ActiveMode& mode, ControlState& state, const StoreRequest& request, bool is_stored);
/// The lab's word on the remote start that waits: a refusal as a sentence, or empty. True where a run began; `mode` is
/// AUTOMAT then.
bool answer_remote_start(ActiveMode& mode, ControlState& state, const std::string& refusal);

/// What became of received text (external_line.cpp).
enum class LineIntake : std::uint8_t {
  storing,  ///< a request to store it is pending
  nothing,  ///< there is nothing to store in it
  refused,  ///< the screen says why
};
/// sought               only this program counts; nothing: all
/// adopts_machine_data  "+/-" was pressed (EXT-026)
[[nodiscard]] LineIntake take_line_text(ControlState& state, const transfer::TextReceived& text,
                                        std::optional<std::uint16_t> sought, bool adopts_machine_data);
void complain_of_line(ControlState& state, transfer::LineFault fault);

}  // namespace cnclab::panel
