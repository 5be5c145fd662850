// EINGABE and SATZ LÖSCHEN: nothing is asked to be stored that is not complete, allowed and within the memory.
#include <algorithm>

#include "panel/modes/editor_mode.hpp"

namespace cnclab::panel {

namespace {

using language::Address;
using language::Error;
using language::ErrorCode;

/// G20 to G23 must not lead into the programs of the cycles (DEC-64).
bool leads_to_cycles(const language::Block& block) {
  constexpr std::uint8_t kFirstJump = 20, kLastCall = 23;
  const bool is_jump = block.function.kind == language::Function::Kind::g && block.function.code >= kFirstJump &&
                       block.function.code <= kLastCall;
  const language::Word* target = block.find(Address::P);
  return is_jump && target != nullptr && !target->is_parameter &&
         language::is_reserved_for_cycles(static_cast<int>(target->number));
}

/// The first fault of the block, with program and block filled in.
std::optional<Error> fault_of(const EditorMode& mode, const ControlState& state, const language::Block& block) {
  const language::EntryLimits limits = state.entry_limits();
  const auto checked = language::check_block(block, mode.plane, state.settings.vocabulary, &limits);
  Error error = checked ? Error{.code = ErrorCode::reserved_for_cycles, .word = 'P'} : checked.error();
  if (checked && !leads_to_cycles(block)) return std::nullopt;
  error.program = mode.number();
  error.block = block.number;
  error.in_tool_table = mode.line.is_tool_row();
  return error;
}

/// Does a block of this number stand in the memory, and was it not loaded to be changed?
bool stands_there(const EditorMode& mode, const language::Program* program, std::uint16_t number) {
  return program != nullptr && !mode.line.is_loaded() && program->find(number).has_value();
}

/// The tool table is never renumbered: a row whose number was typed takes the place of the one that stands there, and
/// that is told. A number that was only offered (behind T099 there is none) replaces nothing: false after the
/// complaint.
bool may_replace_row(const EditorMode& mode, ControlState& state, std::uint16_t number) {
  const std::string tool = block_text(number);
  state.message.sentence = text(Text::said_row_replaced, state.tongue(), {tool});
  if (mode.line.is_number_typed()) return true;
  state.complain(ErrorCode::block_number_wrong, text(Text::said_row_exists, state.tongue(), {tool}));
  return false;
}

int bytes_needed(const language::Program* program, const language::Block& block, bool inserts) {
  const auto old = program == nullptr || inserts ? std::nullopt : program->find(block.number);
  return language::cost_bytes(block) - (old ? language::cost_bytes(program->blocks[*old]) : 0);
}

/// The programs of the cycles are for reading only (DEC-06): true after the complaint.
bool complains_of_rom(const EditorMode& mode, ControlState& state) {
  if (!language::is_reserved_for_cycles(mode.number())) return false;
  state.complain(ErrorCode::reserved_for_cycles, std::string(text(Text::said_rom, state.tongue())));
  return true;
}

/// A word was begun as a parameter and has no number: true after the complaint.
bool complains_of_half_word(EditorMode& mode, ControlState& state) {
  const WordEntry* half = mode.line.half_word();
  if (half == nullptr) return false;
  const char letter = language::letter(half->address);
  state.complain(ErrorCode::word_missing,
                 text(Text::said_parameter_unfinished, state.tongue(), {std::string_view(&letter, 1)}));
  mode.line.mark(letter);
  return true;
}

/// The line is one that may be checked as a block; complains and returns false where a field is still to be filled.
bool is_ready_to_check(EditorMode& mode, ControlState& state) {
  if (!check_number(mode, state)) return false;
  const bool is_fresh_number = mode.line.marker() == EntryLine::Marker::number && !mode.line.has_words_shown();
  if (is_fresh_number && !mode.line.is_tool_row()) {
    mode.line.go_to_function();
    state.complain(ErrorCode::word_missing, std::string(text(Text::said_code_missing, state.tongue())));
    return false;
  }
  if (!mode.line.words_fit_function() && !show_words(mode, state)) return false;
  return !complains_of_half_word(mode, state);
}

}  // namespace

bool check_number(EditorMode& mode, ControlState& state) {
  constexpr int kLastTool = 99;
  const bool is_tool = mode.line.is_tool_row();
  const int number = mode.line.number();
  if (number >= 1 && number <= (is_tool ? kLastTool : language::kLastBlock)) return true;
  mode.line.go_to_number();
  state.complain(ErrorCode::block_number_wrong,
                 std::string(text(is_tool ? Text::said_tool_number : Text::said_block_number, state.tongue())));
  return false;
}

bool show_words(EditorMode& mode, ControlState& state) {
  const std::optional<language::Function> function = mode.line.function();
  if (!function) {
    state.complain(ErrorCode::word_missing, std::string(text(Text::said_code_missing, state.tongue())));
    mode.line.go_to_function();
    return false;
  }
  const language::Program* program = program_in(state, mode.number());
  // A loaded block keeps the plane of its own words as long as its function is not changed.
  if (!mode.line.words_fit_function()) mode.plane = plane_before(program, mode.line.number(), state.plane());
  const language::BlockForm* form = language::find_form(*function, mode.plane, state.settings.vocabulary);
  if (form == nullptr) {
    state.complain(Error{.code = ErrorCode::function_unknown,
                         .program = mode.number(),
                         .block = static_cast<std::uint16_t>(mode.line.number()),
                         .detail = function_text(*function)});
    mode.line.go_to_function();
    return false;
  }
  mode.line.show_words(*form);
  return true;
}

void store_line(EditorMode& mode, ControlState& state) {
  if (complains_of_rom(mode, state)) return;
  if (!is_ready_to_check(mode, state)) return;
  const language::Block block = mode.line.block();
  if (const auto fault = fault_of(mode, state, block)) {
    mode.line.mark(fault->word);
    return state.complain(*fault);
  }
  const language::Program* program = program_in(state, mode.number());
  const bool is_there = stands_there(mode, program, block.number);
  const bool inserts = is_there && !mode.line.is_tool_row();  // D-47
  if (inserts && program->blocks.back().number == language::kLastBlock) {
    mode.line.go_to_number();
    return state.complain(ErrorCode::block_number_wrong, std::string(text(Text::said_overflow_n999, state.tongue())));
  }
  if (bytes_needed(program, block, inserts) > state.memory.free_bytes())
    return state.complain(Error{.code = ErrorCode::memory_full,
                                .program = mode.number(),
                                .block = block.number,
                                .in_tool_table = mode.line.is_tool_row()});
  if (inserts)
    state.storing = InsertBlock{mode.number(), block};
  else if (is_there && !may_replace_row(mode, state, block.number))
    return mode.line.go_to_number();
  else
    state.storing = PutBlock{mode.number(), block};
}

void erase_loaded_block(EditorMode& mode, ControlState& state) {
  if (complains_of_rom(mode, state)) return;
  const auto number = static_cast<std::uint16_t>(mode.line.number());
  const language::Program* program = program_in(state, mode.number());
  if (!mode.line.is_loaded() || program == nullptr || !program->find(number)) {
    state.hint = text(Text::said_not_loaded, state.tongue());
    return;
  }
  state.storing = DeleteBlock{mode.number(), number};
}

}  // namespace cnclab::panel
