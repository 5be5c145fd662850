// What the lab machine really did: each run and its trace, tick by tick, into the database (STO-007).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "machine/channel.hpp"

namespace cnclab::lab {

/// Who runs what; filled by the lab when a run begins.
struct RunStart {
  db::PersonId person{};
  int station = 0;
  std::uint64_t lease = 0;
  int program = 0, block = 0;
  std::int64_t unix_ms = 0;
  std::string setup;  ///< JSON: machine data, position, potentiometer, software
};

/// A run lasts from START to its end, over STOP, halts and single blocks. At most 10 minutes of it are traced.
class RunRecorder {
 public:
  static constexpr std::uint64_t kMostTicks = 600'000;
  static constexpr int kTracesKept = 60;

  RunRecorder(db::Store& store, std::shared_ptr<machine::Channel> channel);

  [[nodiscard]] bool is_recording() const { return run_ != nullptr; }
  void begin(const RunStart& start);
  /// Takes what was traced since the last call; every 10 to 20 ms.
  void poll();
  /// ended   "program_end", "lease_ended", …
  void end(const std::string& ended);

 private:
  struct Run;
  void flush();
  db::Store& store_;
  std::shared_ptr<machine::Channel> channel_;
  std::shared_ptr<Run> run_;
  std::vector<machine::TracePoint> points_;
};

/// One record of run_trace, little endian (db/README.md).
[[nodiscard]] std::string pack_trace(const std::vector<machine::TracePoint>& points);
/// The trace CSV of interfaces.md section 5.
[[nodiscard]] std::string trace_csv(const std::string& packed, const std::array<double, 4>& steps_per_mm);

}  // namespace cnclab::lab
