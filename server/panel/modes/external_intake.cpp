// Received text into the memory: complete and correct, or not at all (DEC-57).
#include <algorithm>

#include "panel/modes/external_data_mode.hpp"
#include "transfer/intake.hpp"

namespace cnclab::panel {

namespace {

using language::Error;
using language::ErrorCode;

/// The student's data with those received; nothing after a complaint. F START/STOP must not pass F MAX at any moment,
/// so what is refused at first is tried again when the others are set.
std::optional<machine::MachineData> with_data(ControlState& state,
                                              const std::vector<language::MachineDatum>& received) {
  machine::MachineData data = state.data;
  const language::MachineDatum* refused = nullptr;
  for (int pass = 0; pass < 2; ++pass) {
    refused = nullptr;
    for (const language::MachineDatum& datum : received)
      if (!data.set(datum.number, datum.value)) refused = &datum;
  }
  if (refused == nullptr) return data;
  state.complain(Error{.code = ErrorCode::machine_datum_wrong, .detail = "N" + block_text(refused->number).substr(1)});
  return std::nullopt;
}

bool fits(const ControlState& state, const PutPrograms& put) {
  Memory memory = state.memory;
  for (const std::uint16_t number : put.removed) memory.remove_program(number);
  for (const language::Program& program : put.programs) memory.put_program(program);
  return !memory.is_overfull();
}

/// Nothing of what was received is to be stored: it was left out (DEC-06), or it was not there.
void complain_of_nothing(ControlState& state, const ReceivedText& received, const std::vector<std::string>& notices) {
  const bool may_be_left_out = !received.sought || language::is_reserved_for_cycles(*received.sought);
  if (!notices.empty() && may_be_left_out) return state.complain(ErrorCode::reserved_for_cycles, notices.front());
  if (!received.sought)
    return state.complain(ErrorCode::program_missing, std::string(text(Text::said_nothing_read, state.tongue())));
  state.complain(ErrorCode::program_missing,
                 text(Text::said_not_in_file, state.tongue(), {program_word(*received.sought)}));
}

}  // namespace

bool take_in(ControlState& state, const ReceivedText& received) {
  auto intake = transfer::take_in(received.text, received.reading, state.tongue());
  if (!intake) {
    state.complain(intake.error());
    return false;
  }
  PutPrograms put{.programs = std::move(intake->programs), .removed = {}, .data = {}};
  if (received.sought)
    std::erase_if(put.programs, [&](const language::Program& program) { return program.number != *received.sought; });
  if (received.is_continuation)
    for (language::Program& part : put.programs) {
      const language::Program* stored = state.memory.find(part.number);
      part = transfer::joined(stored == nullptr ? language::Program{part.number, {}} : *stored, part);
    }
  const bool has_data =
      received.adopts_machine_data && !intake->machine_data.empty() && !state.connection.is_lab_machine;
  if (put.programs.empty() && !has_data) {
    complain_of_nothing(state, received, intake->notices);
    return false;
  }
  if (received.is_whole_memory)
    for (const language::Program& program : state.memory.programs()) put.removed.push_back(program.number);
  if (has_data) {
    put.data = with_data(state, intake->machine_data);
    if (!put.data) return false;
  }
  if (!fits(state, put)) {
    state.complain(Error{.code = ErrorCode::memory_full});
    return false;
  }
  if (!received.sought)
    for (const std::string& notice : intake->notices) put.notice += " " + notice;
  put.notice += received.notice;
  state.storing = std::move(put);
  return true;
}

std::string without_small_letters(std::string_view text) {
  std::string seen;
  bool is_comment = false;
  for (const char c : text) {
    is_comment = c == '(' || (is_comment && c != ')');
    if (is_comment || c < 'a' || c > 'z') seen += c;
  }
  return seen;
}

std::string machine_data_text(const machine::MachineData& data) {
  std::vector<language::MachineDatum> section;
  for (const machine::DatumForm& form : machine::datum_forms())
    section.push_back({.number = static_cast<std::uint16_t>(form.number), .value = data.get(form.number)});
  return language::write_machine_data(section);
}

}  // namespace cnclab::panel
