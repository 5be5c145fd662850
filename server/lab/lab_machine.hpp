// The lab's one real machine and what belongs to it: the channel that drives it, its data, tool list, zeros and
// workpiece, the watchdog and the record of its runs. Who may move it is the authority's to say (authority.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "lab/authority.hpp"
#include "lab/configuration.hpp"
#include "lab/runs/run_recorder.hpp"
#include "machine/simulated_machine.hpp"
#include "machine/tick_thread.hpp"
#include "machine/tool_list.hpp"
#include "machine/watchdog.hpp"
#include "machine/workpiece_thread.hpp"
#include "machine/zero_book.hpp"

namespace cnclab::lab {

/// What the machine keeps over restarts.
struct MachineInheritance {
  machine::MachineData data;
  std::vector<int> damaged_data;                      ///< numbers of data that were found damaged (STO-003)
  std::string tools;                                  ///< its tool list as a tape with P0000, empty: none (DEC-29)
  std::optional<std::array<double, 3>> workpiece_mm;  ///< as the instructor set it last; else the configuration's
};

/// Lab thread.
class LabMachine {
 public:
  /// Takes part in the tick from now on; throws std::runtime_error when the tick has no place.
  /// store, ticks, workpieces   outlive the machine
  LabMachine(const Configuration& configuration, db::Store& store, machine::TickThread& ticks,
             machine::WorkpieceThread& workpieces, const MachineInheritance& inheritance);
  ~LabMachine();
  LabMachine(const LabMachine&) = delete;
  LabMachine& operator=(const LabMachine&) = delete;

  [[nodiscard]] const std::shared_ptr<machine::Channel>& channel() const { return channel_; }
  [[nodiscard]] machine::Snapshot snapshot() const { return channel_->snapshot(); }
  [[nodiscard]] RunRecorder& recorder() { return recorder_; }
  /// card   0 and line 0: Input 1; else 1 or 2 and its line 1 to 8
  void set_input(int card, int line, bool is_on) { machine_.set_input(card, line, is_on); }

  /// The data that hold.
  [[nodiscard]] const machine::MachineData& data() const { return data_; }
  /// The data that hold as soon as they can.
  [[nodiscard]] const machine::MachineData& wished_data() const { return wished_data_ ? *wished_data_ : data_; }
  void wish_data(const machine::MachineData& data) { wished_data_ = data; }
  /// Takes up what was wished, while the machine stands still; true when new data hold. Only while nobody has it.
  [[nodiscard]] bool settle_data();

  /// Numbers of the data that were found damaged and have not been set since: until they are, nobody is given the
  /// machine, for its limits are not known (AUTH-011, STO-003). Ascending.
  [[nodiscard]] const std::vector<int>& damaged_data() const { return damaged_data_; }
  /// Every one of them has been set and stored again.
  void data_are_whole() { damaged_data_.clear(); }

  /// tape   text with P0000 (DEC-29)
  void use_tools(const std::string& tape);
  [[nodiscard]] const std::string& tools_tape() const { return tools_tape_; }
  [[nodiscard]] const machine::ToolList& tools() const { return tools_; }

  /// Beginning with the next program start (DEC-24).
  void use_workpiece(const std::array<double, 3>& size_mm);
  [[nodiscard]] machine::WorkpieceSpec workpiece() const { return {workpiece_mm_, cell_mm_}; }
  /// What the tool did wrong since the last call.
  [[nodiscard]] std::vector<machine::MillingEvent> take_milling_news() { return site_->take_news(); }

  /// The person's own zero is the Istwert again where the position was kept (DEC-27).
  void take_up_zero(db::PersonId person, Epoch lease);
  void keep_zero(db::PersonId person);

  /// The beat stood still since the last call: the watchdog has cut the current.
  [[nodiscard]] bool take_stall();
  /// How often it did since the start.
  [[nodiscard]] std::uint64_t stalls() const { return watchdog_.stalls(); }

 private:
  machine::TickThread& ticks_;
  machine::MachineData data_;
  std::optional<machine::MachineData> wished_data_;
  std::vector<int> damaged_data_;
  std::string tools_tape_;
  machine::ToolList tools_;
  std::array<double, 3> workpiece_mm_;
  double cell_mm_;
  std::shared_ptr<machine::MillingSite> site_;
  machine::SimulatedMachine machine_;
  std::shared_ptr<machine::Channel> channel_;
  machine::Watchdog watchdog_;
  std::uint64_t stalls_seen_ = 0;
  machine::ZeroBook zeros_;
  RunRecorder recorder_;
};

/// "CHECKSUM FEHLER", which of the machine's data, and what to do.
[[nodiscard]] std::string damage_sentence(const std::vector<int>& numbers, language::Tongue tongue);

}  // namespace cnclab::lab
