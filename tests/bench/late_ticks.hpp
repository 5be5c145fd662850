// Ticks that began more than 5 ms late (LOAD-003), and whether this machine let a beat that does nothing be in time
// then.
#pragma once

#include <ctime>
#include <iomanip>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "figure.hpp"
#include "harness/child_process.hpp"

namespace cnclab::bench {

using WallTimes = std::vector<std::int64_t>;  ///< ms since 1970

/// A bare beat on every processor from now on (load_floor beat).
class BareBeats {
 public:
  explicit BareBeats(const std::filesystem::path& load_floor) {
    for (unsigned processor = 0; processor < std::thread::hardware_concurrency(); ++processor)
      beats_.emplace_back(harness::Launch{load_floor, {"beat", std::to_string(processor)}, {}, {}});
  }

  /// Ends them and prints what they were; when one of them was late.
  WallTimes end() {
    double ticks = 0, late = 0, longest_ms = 0;
    WallTimes late_at_ms;
    for (harness::ChildProcess& beat : beats_) {
      beat.close_input();
      std::istringstream figures(line_of(beat)), times(line_of(beat));
      double its_ticks = 0, its_late = 0, its_longest_ms = 0;
      figures >> its_ticks >> its_late >> its_longest_ms;
      ticks += its_ticks;
      late += its_late;
      longest_ms = std::max(longest_ms, its_longest_ms);
      for (std::int64_t at = 0; times >> at;) late_at_ms.push_back(at);
    }
    print_figure("bare_beat_ticks", ticks, "1");
    print_figure("bare_beat_late_ticks", late, "1");
    print_figure("bare_beat_longest_delay_ms", longest_ms, "ms");
    return late_at_ms;
  }

 private:
  static std::string line_of(harness::ChildProcess& beat) {
    const auto line = beat.read_line(harness::Deadline(std::chrono::seconds(5)));
    if (!line) throw std::runtime_error("a bare beat ended");
    return *line;
  }

  std::vector<harness::ChildProcess> beats_;
};

/// When the server's log tells of ticks more than 5 ms late, once for each of them.
inline WallTimes very_late_ticks(const std::string& log) {
  WallTimes all;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("more than 5 ms late") == std::string::npos) continue;
    std::istringstream words(line);
    std::tm time{};
    char point = 0;
    std::int64_t milliseconds = 0, number = 0;
    std::string level;
    words >> std::get_time(&time, "%Y-%m-%dT%H:%M:%S") >> point >> milliseconds >> level >> number;
    time.tm_isdst = -1;
    all.insert(all.end(), static_cast<std::size_t>(number), std::int64_t{std::mktime(&time)} * 1000 + milliseconds);
  }
  return all;
}

/// Those of `ticks` beside which no bare beat was late: what this machine's other work does not explain.
inline std::size_t count_unexplained(const WallTimes& ticks, const WallTimes& bare) {
  constexpr std::int64_t kBeside_ms = 50;  // the log tells of a tick some milliseconds later
  return static_cast<std::size_t>(std::ranges::count_if(ticks, [&](std::int64_t tick) {
    return std::ranges::none_of(bare, [&](std::int64_t at) { return std::abs(at - tick) <= kBeside_ms; });
  }));
}

}  // namespace cnclab::bench
