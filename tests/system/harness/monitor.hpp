// The parts of a station's screen: the control's monitor of 16 rows, and what changes by itself taken out (DEC-01).
#pragma once

#include <string>
#include <vector>

#include "harness/station_process.hpp"

namespace cnclab::harness {

/// Row 1..16 of the control's 64-column monitor, blanks at its end removed.
[[nodiscard]] std::string monitor_row(const ScreenRows& rows, int row);
/// The 14 columns right of the monitor, row 0..17, blanks at both ends removed.
[[nodiscard]] std::string side_row(const ScreenRows& rows, int row);
/// Every digit of the clock and date (screen row 1) as `0`, so that screens of different moments can be compared.
[[nodiscard]] ScreenRows without_clock(ScreenRows rows);

}  // namespace cnclab::harness
