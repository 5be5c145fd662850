// A machine in virtual time, a recorder that looks at it, and the database that the recorder writes to (STO-007).
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "db/store.hpp"
#include "lab/runs/run_recorder.hpp"
#include "lab/runs/run_replay.hpp"
#include "machine/simulated_machine.hpp"
#include "panel/run/run.hpp"

namespace cnclab::lab {

/// The student's side of a run: keys go in, ticks pass, and what the recorder has kept comes out.
class ReplayRig {
 public:
  static constexpr machine::Epoch kEpoch{1};
  static constexpr const char* kProgram =
      "P0001N001G01X+20000Y+5000F2000S1000M03N002G02X+5000Y+5000I+5000J+0N003G04H0002N004G01X-3000N005G22P0002N001W01"
      "N006G01Z+4000F500M00N007G01X+1000F800M02"
      "P0002N001G01Y+2000F900N002G01Y-1000";

  /// tape   stored for a student, and what a run finds in the memory
  explicit ReplayRig(const std::string& tape = kProgram);

  /// As the lab's beat: every 17 ticks it looks, less regularly than a replay does.
  void ticks(int count);
  /// START with nothing present; fails the test where it is refused.
  void start(bool is_lab_machine = false);
  /// A motion by hand began some ticks ago.
  void begin_by_hand();
  /// Ends the record and reads it back as the instructor's command does.
  [[nodiscard]] RecordedRun recorded();

  panel::RunOrder order;
  machine::SimulatedMachine machine{machine::MachineData{}};
  std::shared_ptr<machine::Channel> channel;
  std::unique_ptr<db::Store> store;
  std::unique_ptr<RunRecorder> recorder;
  panel::Run run;

 private:
  [[nodiscard]] RecordedRun newest_run(db::Database& database) const;

  db::PersonId anna_{};
  std::int64_t tick_ = 0;
};

}  // namespace cnclab::lab
