// What the station draws itself over the server's screen: the help page, the question before logging out, the lost
// line, that a station is only looked at.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "shared/screen.hpp"
#include "station/keymap.hpp"

namespace cnclab::station {

/// The last screen, dimmed and named as such, under "VERBINDUNG VERLOREN" and the seconds since then (SEAT-005).
[[nodiscard]] Screen with_lost_line(const Screen& last, std::chrono::seconds since, const std::string& trouble,
                                    Language language);

/// The screen of a station that is only looked at: the frame names it, and row 23 says in place of that station's keys
/// that none works here (SEAT-003, SEAT-006).
[[nodiscard]] Screen with_looking_on(const Screen& seen, std::uint32_t station, Language language);

/// Row 23 asks whether to log out, or to end looking on.
[[nodiscard]] Screen with_log_out_question(const Screen& screen, bool looks_on, Language language);

/// The help page with the lost line's seconds in its heading.
[[nodiscard]] Screen with_lost_heading(const Screen& help, std::chrono::seconds since, Language language);

/// What stands in a window without room for a screen.
[[nodiscard]] std::string too_small_text(int rows, int columns, Language language);

/// The help page from its line `first` on.
[[nodiscard]] Screen help_screen(std::size_t first, Language language);
/// The largest useful `first`.
[[nodiscard]] std::size_t last_help_start(Language language);

/// The potentiometer's position as row 8 of the side column shows it (DEC-01), 0..100.
[[nodiscard]] std::optional<int> shown_potentiometer(const Screen& screen);

/// EXTERNE DATEN is on the screen (its title in the monitor's second row).
[[nodiscard]] bool shows_external_data(const Screen& screen);

}  // namespace cnclab::station
