// Helpers that every mode needs: complaints, the connected machine's data and state.
#include "panel/control_state.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace cnclab::panel {

namespace {

std::string zero_padded(int number, std::size_t places) {
  const std::string digits = std::to_string(number);
  return digits.size() < places ? std::string(places - digits.size(), '0') + digits : digits;
}

}  // namespace

void ControlState::complain(const language::Error& error) { complain(error.code, language::explain(error, tongue())); }

void ControlState::complain(language::ErrorCode code, std::string sentence) {
  message = Message{std::string(language::monitor_text(code, tongue())), 0, std::move(sentence)};
}

void ControlState::complain_cannot_run(std::uint16_t number) {
  if (number == language::kToolTable)
    return complain(language::ErrorCode::program_missing, std::string(text(Text::said_tool_table, tongue())));
  complain(language::Error{.code = language::ErrorCode::program_missing, .detail = program_word(number)});
}

machine::MachineData ControlState::effective_data() const {
  return connection.is_lab_machine ? machine::on_lab_machine(data, connection.lab_data) : data;
}

bool ControlState::apply_data() {
  if (!connection.channel) return false;
  machine::MachineData wanted = effective_data();
  if (applied_data == wanted) return true;
  if (!connection.channel->set_data(wanted)) return false;
  applied_data = std::move(wanted);
  return true;
}

language::EntryLimits ControlState::entry_limits() const {
  return {.x = {data.get(3)}, .y = {data.get(4)}, .z = {data.get(5)}, .f_max = data.get(6), .s_max = data.get(7)};
}

EraseMemory ControlState::whole_memory() const {
  EraseMemory request;
  for (const language::Program& program : memory.programs()) request.programs.push_back(program.number);
  return request;
}

void ControlState::reset_modal_state() {
  modal = {};
  compensation_mm = {};
  last_turn = geometry::SpindleTurn::clockwise;  // D-12
  if (!connection.channel) return;
  is_switching = true;
  (void)connection.channel->command(machine::SwitchSpindle{connection.epoch, {}});
  (void)connection.channel->command(machine::SwitchCoolant{connection.epoch, false});
}

void ControlState::initialise() {
  (void)apply_data();  // where the machine does not stand still, the next START tries again
  reset_modal_state();
  parameters = {};
  taught = {};
  editor_program = automat_program = 1;
}

void ControlState::take_over(const RunEnd& end) {
  const bool is_broken_off = end.kind == RunEnd::Kind::broken && machine::abandons_run(end.cause);
  const bool tools_are_off = is_broken_off || end.kind == RunEnd::Kind::failed;
  modal = tools_are_off ? with_tools_off(end.legacy.modal) : end.legacy.modal;
  parameters = end.legacy.parameters;
  compensation_mm = end.legacy.compensation_mm;
}

bool ControlState::awaits_potentiometer() const {
  return override_percent == 0 && run.is_present() && !run.modal().potentiometer_off && machine().speed_mm_per_min == 0;
}

language::Plane ControlState::plane() const { return static_cast<language::Plane>(modal.plane); }

machine::Snapshot ControlState::machine() const {
  return connection.channel ? connection.channel->snapshot() : machine::Snapshot{};
}

program::ModalState with_tools_off(program::ModalState modal) {
  constexpr std::array kSwitchOn{3, 4, 8, 13, 14};
  constexpr int kBothOff = 12;
  if (std::ranges::find(kSwitchOn, modal.m) != kSwitchOn.end()) modal.m = kBothOff;
  modal.spindle = geometry::SpindleTurn::off;
  modal.coolant = false;
  return modal;
}

std::string program_text(int number) { return zero_padded(number, 4); }
std::string block_text(int number) { return zero_padded(number, 3); }
std::string program_word(int number) { return std::string(1, 'P').append(program_text(number)); }
std::string block_word(int number) { return std::string(1, 'N').append(block_text(number)); }

std::string function_text(language::Function function) {
  std::string text(function.kind == language::Function::Kind::g ? "G" : "↓");
  if (function.code < 10) text += '0';
  return text.append(std::to_string(function.code));
}

}  // namespace cnclab::panel
