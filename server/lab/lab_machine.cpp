// The machine's data, tools, workpiece and zeros, as they are set, kept and taken up.
#include "lab/lab_machine.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "lab/sentences.hpp"
#include "language/tape.hpp"
#include "program/program_source.hpp"

namespace cnclab::lab {

namespace {

/// Steps per mm of X, Y, Z.
std::array<double, 3> zero_scale(const machine::MachineData& data) {
  const auto per_mm = machine::motion_limits(data).steps_per_mm;
  return {per_mm[0], per_mm[1], per_mm[2]};
}

std::array<double, 3> workpiece_of(const Configuration& configuration) {
  return {configuration.size_mm.at(0), configuration.size_mm.at(1), configuration.size_mm.at(2)};
}

/// Bits of cards 1 and 2 from numbers such as 11 (card 1, line 1) and 28.
std::array<std::uint8_t, 2> output_lines(const std::vector<int>& numbers) {
  std::array<std::uint8_t, 2> cards{};
  for (const int number : numbers)
    cards.at(static_cast<std::size_t>(number / 10 - 1)) |= static_cast<std::uint8_t>(1U << (number % 10 - 1));
  return cards;
}

}  // namespace

LabMachine::LabMachine(const Configuration& configuration, db::Store& store, machine::TickThread& ticks,
                       machine::WorkpieceThread& workpieces, const MachineInheritance& inheritance)
    : ticks_(ticks),
      data_(inheritance.data),
      damaged_data_(inheritance.damaged_data),
      workpiece_mm_(inheritance.workpiece_mm.value_or(workpiece_of(configuration))),
      cell_mm_(configuration.cell_mm),
      site_(workpieces.add(workpiece())),
      machine_(data_),
      channel_(std::make_shared<machine::Channel>(machine_, data_)),
      watchdog_(ticks, ticks.is_real_time() ? machine::Watchdog::kLimit : machine::Watchdog::kPatientLimit),
      zeros_(zero_scale(data_)),
      recorder_(store, channel_, RunRecorder::Keeps::trace) {
  use_tools(inheritance.tools);
  channel_->feed_cuts(&site_->feed());
  channel_->set_outputs_off_at_power_off(output_lines(configuration.outputs_off_at_power_off));
  if (!ticks_.add(channel_)) throw std::runtime_error("the tick has no place for the lab's machine");
  watchdog_.guard(channel_);
}

LabMachine::~LabMachine() { ticks_.remove(channel_); }

bool LabMachine::settle_data() {
  if (!wished_data_ || !channel_->set_data(*wished_data_)) return false;  // it still moves
  data_ = *wished_data_;
  wished_data_.reset();
  machine_.set_data(data_);
  zeros_.set_steps_per_mm(zero_scale(data_));
  return true;
}

void LabMachine::use_tools(const std::string& tape) {
  tools_tape_ = tape;
  tools_ = {};
  program::ProgramSet programs;
  for (language::ReadProgram& read : language::read_tape(tape, language::Reading::file).programs)
    programs.put(std::move(read.program));
  constexpr int kLastTool = 99;
  for (int number = 1; number <= kLastTool; ++number)
    if (const auto tool = programs.tool(number))
      tools_.put(number, {language::to_mm(tool->radius), language::to_mm(tool->length)});
}

void LabMachine::use_workpiece(const std::array<double, 3>& size_mm) {
  workpiece_mm_ = size_mm;
  site_->set_spec(workpiece());
}

void LabMachine::take_up_zero(db::PersonId person, Epoch lease) {
  if (const auto mm = zeros_.istwert(static_cast<std::int64_t>(person), channel_->snapshot()))
    static_cast<void>(channel_->command(machine::SetIstwert{lease, {true, true, true}, *mm}));
}

void LabMachine::keep_zero(db::PersonId person) {
  zeros_.keep(static_cast<std::int64_t>(person), channel_->snapshot());
}

std::string damage_sentence(const std::vector<int>& numbers, language::Tongue tongue) {
  std::string list, command = "machine-data";
  for (const int number : numbers) {
    list += fmt::format("{}{:02}", list.empty() ? "" : ", ", number);
    command += fmt::format(" {:02}=…", number);
  }
  return fmt::format(
      fmt::runtime(say(tongue, "CHECKSUM FEHLER: Maschinendaten der Maschine beschädigt, Nummer {}. Neu setzen: {}",
                       "CHECKSUM FEHLER: the machine's data are damaged, number {}. Set them again: {}")),
      list, command);
}

bool LabMachine::take_stall() {
  const std::uint64_t stalls = watchdog_.stalls();
  return std::exchange(stalls_seen_, stalls) != stalls;
}

}  // namespace cnclab::lab
