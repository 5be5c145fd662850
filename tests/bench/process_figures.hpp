// What a process costs, as /proc tells it.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>

namespace cnclab::bench {

/// Seconds of processor time that a process has used.
inline double cpu_seconds(pid_t pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string text((std::istreambuf_iterator<char>(file)), {});
  std::istringstream fields(text.substr(text.rfind(')') + 2));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// A line of /proc/PID/status that counts KiB, in MiB.
inline double status_mib(pid_t pid, std::string_view name) {
  std::ifstream file(fmt::format("/proc/{}/status", pid));
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(name)) return std::stod(line.substr(name.size())) / 1024;
  return 0;
}

inline double rss_mib(pid_t pid) { return status_mib(pid, "VmRSS:"); }
/// The most that it ever was.
inline double peak_rss_mib(pid_t pid) { return status_mib(pid, "VmHWM:"); }

}  // namespace cnclab::bench
