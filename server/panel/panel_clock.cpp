// Times as seconds since 2000-01-01, so that setting a clock is one subtraction.
#include "panel/panel_clock.hpp"

#include <chrono>

namespace cnclab::panel {

namespace {

constexpr std::int64_t kSecondsPerMinute = 60, kSecondsPerHour = 3'600, kSecondsPerDay = 86'400;
constexpr int kCentury = 2000;
constexpr std::chrono::sys_days kEpoch{std::chrono::year{kCentury} / 1 / 1};

bool has_date(const WallClock& wall) { return wall.month > 0; }

std::chrono::year_month_day date_of(int year, int month, int day) {
  return std::chrono::year{kCentury + year} / std::chrono::month{static_cast<unsigned>(month)} /
         std::chrono::day{static_cast<unsigned>(day)};
}

std::int64_t day_number(int year, int month, int day) {
  return (std::chrono::sys_days{date_of(year, month, day)} - kEpoch).count();
}

std::int64_t seconds_of(const WallClock& wall) {
  const std::int64_t days = has_date(wall) ? day_number(wall.year, wall.month, wall.day) : 0;
  return days * kSecondsPerDay + wall.hour * kSecondsPerHour + wall.minute * kSecondsPerMinute + wall.second;
}

std::int64_t floor_day(std::int64_t seconds) {
  const std::int64_t days = seconds / kSecondsPerDay;
  return seconds % kSecondsPerDay < 0 ? days - 1 : days;
}

WallClock wall_of(std::int64_t seconds, bool with_date) {
  const std::int64_t days = floor_day(seconds);
  const auto in_day = static_cast<int>(seconds - days * kSecondsPerDay);
  WallClock wall{in_day / 3600, in_day / 60 % 60, in_day % 60, 0, 0, 0};
  if (!with_date) return wall;
  const std::chrono::year_month_day date{kEpoch + std::chrono::days{days}};
  constexpr int kYearsShown = 100;
  wall.day = static_cast<int>(static_cast<unsigned>(date.day()));
  wall.month = static_cast<int>(static_cast<unsigned>(date.month()));
  wall.year = (static_cast<int>(date.year()) % kYearsShown + kYearsShown) % kYearsShown;
  return wall;
}

}  // namespace

std::int64_t PanelClock::seconds_at(const Now& now) const {
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  if (has_date(now.wall)) return seconds_of(now.wall) + offset_s_;
  if (!own_) return seconds_of(now.wall);
  return own_->set_to_s + (own_->set_ns ? (now.monotonic_ns - *own_->set_ns) / kNsPerSecond : 0);
}

std::optional<PanelClock::Standing> PanelClock::standing(const Now& now) const {
  if (!own_ || has_date(now.wall)) return std::nullopt;
  return Standing{seconds_at(now), own_->has_date};
}

WallClock PanelClock::at(const Now& now) const {
  return wall_of(seconds_at(now), has_date(now.wall) || (own_ && own_->has_date));
}

void PanelClock::move_to(const Now& now, std::int64_t seconds, bool with_date) {
  if (has_date(now.wall))
    offset_s_ = seconds - seconds_of(now.wall);
  else
    own_ = Own{now.monotonic_ns, seconds, with_date};
}

bool PanelClock::set_time(const Now& now, int hour, int minute, int second) {
  if (hour > 23 || minute > 59 || second > 59) return false;
  const std::int64_t days = floor_day(seconds_at(now));
  move_to(now, days * kSecondsPerDay + hour * kSecondsPerHour + minute * kSecondsPerMinute + second,
          own_ && own_->has_date);
  return true;
}

bool PanelClock::set_date(const Now& now, int year, int month, int day) {
  if (!date_of(year, month, day).ok()) return false;
  const std::int64_t seconds = seconds_at(now);
  const std::int64_t in_day = seconds - floor_day(seconds) * kSecondsPerDay;
  move_to(now, day_number(year, month, day) * kSecondsPerDay + in_day, true);
  return true;
}

}  // namespace cnclab::panel
