// The computer's clocks and how times are written.
#include "lab/clock.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <ctime>

namespace cnclab::lab {

namespace {

std::tm local_time(std::int64_t unix_ms) {
  const std::time_t seconds = unix_ms / 1000;
  std::tm result{};
  localtime_r(&seconds, &result);
  return result;
}

}  // namespace

Clock system_clock() {
  using namespace std::chrono;
  return {
      [] { return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count(); },
      [] { return duration_cast<milliseconds>(std::chrono::system_clock::now().time_since_epoch()).count(); },
  };
}

panel::Now control_time(const Clock& clock, std::string_view kind, std::int64_t switched_on_ns) {
  const std::int64_t now_ns = clock.monotonic_ns();
  if (kind == "host") return {now_ns, wall_clock(clock.unix_ms())};
  // 00:00:00 with date 00/00/00, which never changes until it is set (D-33).
  const auto seconds = static_cast<int>((now_ns - switched_on_ns) / 1'000'000'000 % 86'400);
  return {now_ns, {seconds / 3600, seconds / 60 % 60, seconds % 60, 0, 0, 0}};
}

panel::WallClock wall_clock(std::int64_t unix_ms) {
  const std::tm time = local_time(unix_ms);
  return {time.tm_hour, time.tm_min, time.tm_sec, time.tm_mday, time.tm_mon + 1, time.tm_year % 100};
}

std::string iso_time(std::int64_t unix_ms) {
  const std::tm time = local_time(unix_ms);
  const std::string zone = fmt::format("{:%z}", time);  // "+0100"
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}{}:{}", time, unix_ms % 1000, zone.substr(0, 3), zone.substr(3));
}

}  // namespace cnclab::lab
