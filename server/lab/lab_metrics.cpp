// The lab's counters in Prometheus' text form.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "lab/lab.hpp"

namespace cnclab::lab {

namespace {

class Exposition {
 public:
  template <class Value>
  void add(const char* name, const char* type, const char* help, Value value) {
    fmt::format_to(std::back_inserter(text_), "# HELP cnclab_{0} {2}\n# TYPE cnclab_{0} {1}\ncnclab_{0} {3}\n", name,
                   type, help, value);
  }
  [[nodiscard]] std::string text() const { return fmt::to_string(text_); }

 private:
  fmt::memory_buffer text_;
};

}  // namespace

std::string Lab::metrics() const {
  const auto count = [this](auto stage) {
    return std::ranges::count_if(visits_, [&](const auto& visit) { return visit->stage == stage; });
  };
  const auto running = std::ranges::count_if(seats_.all(), [](const auto& desk) { return desk->control.is_running(); });
  const auto ticks = ticks_.statistics();
  const auto store = store_.counters();
  const auto snapshot = machine_.snapshot();
  Exposition all;
  all.add("connections", "gauge", "Open connections.", visits_.size());
  all.add("stations", "gauge", "Stations where somebody is logged in.", count(Stage::at_desk));
  all.add("consoles", "gauge", "Instructors' consoles.", count(Stage::at_console));
  all.add("observers", "gauge", "Connections that look on.", count(Stage::looking_on));
  all.add("controls_running", "gauge", "Controls in START state.", running);
  all.add("selected_station", "gauge", "Station that controls the machine, 0 nobody.", authority_.selected());
  all.add("lease", "counter", "Number of the newest lease.", static_cast<std::uint64_t>(authority_.newest()));
  all.add("machine_halted", "gauge", "1 while MASCHINE HALT is latched.", authority_.is_halted() ? 1 : 0);
  all.add("machine_powered", "gauge", "1 while the drives may have current.", authority_.is_powered() ? 1 : 0);
  all.add("machine_started", "gauge", "1 while the lab's machine is in START state.", snapshot.started ? 1 : 0);
  all.add("commands_refused_total", "counter", "Commands refused for their lease.", snapshot.refused);
  all.add("ticks_total", "counter", "Ticks since the start.", ticks.ticks);
  all.add("ticks_late_total", "counter", "Ticks that began more than 1 ms late.", ticks.late);
  all.add("ticks_very_late_total", "counter", "Ticks that began more than 5 ms late.", ticks.very_late);
  all.add("tick_longest_delay_seconds", "gauge", "The latest that a tick began.",
          static_cast<double>(ticks.longest_delay_ns) / 1e9);
  all.add("tick_stalls_total", "counter", "Times that the beat stood still and the machine's current was cut.",
          machine_.stalls());
  all.add("store_jobs_total", "counter", "Jobs of the store.", store.jobs);
  all.add("store_commits_total", "counter", "Commits of the store.", store.commits);
  all.add("store_failures_total", "counter", "Jobs that could not be stored.", store.failures);
  all.add("store_waiting", "gauge", "Jobs that wait for the store.", store.waiting);
  return all.text();
}

}  // namespace cnclab::lab
