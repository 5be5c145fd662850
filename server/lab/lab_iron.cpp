// What belongs to the lab's machine besides its channel: watchdog, machine data, tool list, workpiece.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "lab/lab.hpp"
#include "language/tape.hpp"

namespace cnclab::lab {

namespace {

std::string_view name_of(machine::MillingEvent::Kind kind) {
  switch (kind) {
    case machine::MillingEvent::Kind::rapid_in_material:
      return "rapid in material";
    case machine::MillingEvent::Kind::spindle_off_in_material:
      return "spindle off in material";
  }
  return "";
}

}  // namespace

void Lab::heed_watchdog() {
  const std::uint64_t stalls = watchdog_.stalls();
  if (stalls == stalls_heeded_) return;
  stalls_heeded_ = stalls;
  spdlog::error("the beat stood still: the machine's current is cut until power-on (stall {})", stalls);
  write_journal("watchdog", fmt::format("the beat stood still, current cut (stall {})", stalls), authority_.selected(),
                "", authority_.newest());
  static_cast<void>(decide(PowerSwitched{false}, configuration_.tongue));
}

void Lab::use_machine_data(const machine::MachineData& data) {
  machine_data_due_ = data;
  settle_machine_data();
}

void Lab::settle_machine_data() {
  if (!machine_data_due_ || authority_.phase() != Phase::nobody) return;
  if (!channel_->set_data(*machine_data_due_)) return;  // it still moves
  machine_data_ = *machine_data_due_;
  machine_data_due_.reset();
  machine_.set_data(machine_data_);
  const auto per_mm = machine::motion_limits(machine_data_).steps_per_mm;
  zeros_.set_steps_per_mm({per_mm[0], per_mm[1], per_mm[2]});
  write_journal("machine_data", "new data hold");
}

machine::WorkpieceSpec Lab::workpiece() const { return {workpiece_mm_, configuration_.cell_mm}; }

void Lab::use_workpiece(const std::array<double, 3>& size_mm) {
  workpiece_mm_ = size_mm;
  site_->set_spec(workpiece());
  for (const auto& [id, desk] : desks_) desk->set_workpiece(workpiece());
}

void Lab::use_tools(const std::string& tape) {
  tools_ = tape;
  tool_list_ = {};
  program::ProgramSet programs;
  for (language::ReadProgram& read : language::read_tape(tape, language::Reading::file).programs)
    programs.put(std::move(read.program));
  constexpr int kLastTool = 99;
  for (int number = 1; number <= kLastTool; ++number)
    if (const auto tool = programs.tool(number))
      tool_list_.put(number, {language::to_mm(tool->radius), language::to_mm(tool->length)});
}

void Lab::tell_milling(const DeskPtr& desk) {
  tell_milling(desk, desk->take_milling_news(), Epoch{});
  if (desk->on_lab_machine) tell_milling(desk, site_->take_news(), authority_.newest());
}

void Lab::tell_milling(const DeskPtr& desk, const std::vector<machine::MillingEvent>& news, Epoch lease) {
  for (const machine::MillingEvent& event : news) {
    const bool is_watched = (lease != Epoch{}) == desk->on_lab_machine;
    if (is_watched) desk->control.tell_milling(event);
    desk->errors_ns.push_back(clock_.monotonic_ns());  // INS-001
    desk->is_dirty = true;
    write_journal(
        "milling",
        fmt::format("{} P{:04} N{:03} at X{:+.3f} Y{:+.3f} Z{:+.3f}, {}", name_of(event.kind), event.source.program,
                    event.source.block, event.mm[0], event.mm[1], event.mm[2], lease == Epoch{} ? "training" : "lab"),
        desk->station, desk->person.name, lease);
  }
}

}  // namespace cnclab::lab
