// What a machine really did: each run with what decided its course, its events and the digest of its steps; the lab
// machine's also tick by tick (STO-007).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "machine/channel.hpp"
#include "panel/run/run.hpp"

namespace cnclab::lab {

/// What a motion by hand begins with, besides the machine's data; its directions are its first event.
struct HandStart {
  std::array<double, 4> istwert_mm{};
  machine::MachineData data;  ///< that the channel goes by
};

/// Who runs what; filled by the lab when a run begins.
struct RunStart {
  db::PersonId person{};
  int station = 0;
  std::uint64_t lease = 0;
  int program = 0, block = 0;
  std::int64_t unix_ms = 0;
  std::shared_ptr<const panel::RunOrder> order;  ///< nullptr: motion by hand
  machine::MachineData machine_data;             ///< of the machine itself: its travel
  std::optional<HandStart> hand{};               ///< where there is no order
  /// Called once, by the store's `Post`, where the store could not take the whole record (STO-009).
  std::function<void(const db::StoreError&)> on_loss{};
};

/// The steps of a run, boiled down: equal digests mean the same trajectory. FNV-1a over the four positions of each
/// tick.
class TrajectoryDigest {
 public:
  void add(const std::array<std::int32_t, 4>& steps);
  [[nodiscard]] std::string text() const;  ///< 16 hexadecimal digits

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

/// A run lasts from START to its end, over STOP, halts and single blocks; a motion by hand until the axes rest.
/// Bounded: at most 10 minutes are traced, and kMostEvents events are kept; a run with more is recorded without a
/// digest and cannot be replayed.
class RunRecorder {
 public:
  static constexpr std::uint64_t kMostTicks = 600'000;
  static constexpr std::size_t kMostEvents = 20'000;
  static constexpr int kTracesKept = 60;

  enum class Keeps : std::uint8_t { digest, trace };

  RunRecorder(db::Store& store, std::shared_ptr<machine::Channel> channel, Keeps keeps);

  [[nodiscard]] bool is_recording() const { return run_ != nullptr; }
  [[nodiscard]] bool is_by_hand() const { return is_recording() && is_by_hand_; }
  /// Of the run being recorded.
  [[nodiscard]] const panel::RunOrder* order() const { return order_.get(); }
  /// Begins with the first tick of that kind that has come since the last `poll`, by hand or of a program.
  void begin(const RunStart& start);
  /// Takes what was traced since the last call; every 10 to 20 ms.
  void poll();
  /// What the last `poll` has found has a motion by hand in it that belongs to no record, however short it was.
  [[nodiscard]] bool has_hand_start() const;
  /// Nobody wants what came since the last `poll`.
  void pass_over();
  /// ended   "program_end", "lease_ended", …; of a run in which no tick passed `kNotStarted` is kept instead
  void end(const std::string& ended);
  /// Something was in the way of its START.
  static constexpr const char* kNotStarted = "not_started";

 private:
  struct Run;
  using Answer = std::expected<void, db::StoreError>;
  /// What the store could not take of a record is gone, and the record cannot be played again.
  [[nodiscard]] static std::function<void(const Answer&)> watching(const std::shared_ptr<Run>& run);
  void take(const machine::TracePoint& point);
  [[nodiscard]] bool is_of_next_run(const machine::TracePoint& point) const;
  void note(const char* kind, double value);
  void flush();
  void flush_events();

  db::Store& store_;
  std::shared_ptr<machine::Channel> channel_;
  Keeps keeps_;
  std::shared_ptr<const panel::RunOrder> order_;
  bool is_by_hand_ = false;
  std::shared_ptr<Run> run_;
  std::vector<machine::TracePoint> arrived_;  ///< of no record so far
  std::vector<machine::TracePoint> points_;   ///< of this one, to be stored
};

/// One record of run_trace, little endian (db/README.md).
[[nodiscard]] std::string pack_trace(const std::vector<machine::TracePoint>& points);
/// The trace CSV of interfaces.md section 5.
[[nodiscard]] std::string trace_csv(const std::string& packed, const std::array<double, 4>& steps_per_mm);
/// Directions −1, 0, 1 of a motion by hand as the value of an event `jog` or `reference`, and back.
[[nodiscard]] double hand_value(const std::array<std::int8_t, 3>& directions);
[[nodiscard]] std::array<std::int8_t, 3> hand_directions(double value);

/// The positions of a packed trace, tick after tick.
[[nodiscard]] std::vector<std::array<std::int32_t, 4>> trace_steps(const std::string& packed);

}  // namespace cnclab::lab
