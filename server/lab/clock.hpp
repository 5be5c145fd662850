// Time as the lab is given it; tests hand in their own.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "panel/control.hpp"

namespace cnclab::lab {

inline constexpr std::int64_t kSecond_ns = 1'000'000'000;

struct Clock {
  std::function<std::int64_t()> monotonic_ns;
  std::function<std::int64_t()> unix_ms;
};

/// The clocks of this computer.
[[nodiscard]] Clock system_clock();

/// The clocks as a control has them (DEC-10).
/// kind              "host": the server's local time; "original": as after switching on
/// switched_on_ns   when that control was
[[nodiscard]] panel::Now control_time(const Clock& clock, std::string_view kind, std::int64_t switched_on_ns);

/// The server's local time for the header line (DEC-10).
[[nodiscard]] panel::WallClock wall_clock(std::int64_t unix_ms);
/// "2026-11-22T10:15:00.123+01:00", local time, for the journal.
[[nodiscard]] std::string iso_time(std::int64_t unix_ms);

}  // namespace cnclab::lab
