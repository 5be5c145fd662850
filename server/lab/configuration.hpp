// Everything that lab.toml can say, with its defaults (interfaces.md section 2).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "language/units.hpp"

namespace cnclab::lab {

struct Configuration {
  // [server]
  std::string listen = "127.0.0.1:3300";
  std::filesystem::path data = "var";
  std::string metrics;
  // [lab]
  language::Tongue tongue = language::Tongue::german;
  bool accept = true;
  int keep_minutes = 10;
  int memory_bytes = 16384;
  bool hints = true;
  int silence_manual_ms = 300;
  int silence_lease_ms = 1000;
  int journal_days = 90;
  int undo_days = 30;
  // [control]
  language::Model model = language::Model::cnc3300;
  bool planned_functions = true;
  std::string rests = "exact";
  std::string clock = "host";
  std::string start_in_middle = "rebuilt";
  bool remote = false;
  bool keys_19inch = false;
  std::vector<int> io_cards{1, 2, 3};
  // [machine]
  std::string kind = "simulated";
  bool require_reference = false;
  bool tool_list = false;
  std::vector<int> outputs_off_at_power_off;
  // [workpiece]
  std::vector<double> size_mm{120, 80, 30};
  double cell_mm = 0.25;
  // [dnc]
  std::string dnc_listen, dnc_device;
  int dnc_station = 0;
  bool dnc_pacing = true, dnc_training_start = false;
  // [printer]
  std::string printer_queue;
};

}  // namespace cnclab::lab
