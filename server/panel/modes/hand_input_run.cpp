// START in HANDEINGABE: the line becomes a program of one block and runs like any other.
#include <algorithm>

#include "language/check_block.hpp"
#include "panel/modes/hand_input_mode.hpp"
#include "panel/run/start_check.hpp"

namespace cnclab::panel {

namespace {

using language::Error;
using language::ErrorCode;

/// A number that no stored program can have.
constexpr std::uint16_t kLineProgram = language::kLastProgram + 1;
constexpr std::uint16_t kLineBlock = 1;

/// D-37: G04, also with an exact stop (G64, BLK-161), and G20 to G23 are not executed here.
bool is_barred(language::Function function) {
  constexpr std::uint8_t kDwell = 4, kExactDwell = 64, kFirstJump = 20, kLastCall = 23;
  return function.code == kDwell || function.code == kExactDwell ||
         (function.code >= kFirstJump && function.code <= kLastCall);
}

/// D-37: M00, M01 and M02 are skipped, the rest of their block is executed.
void drop_program_ends(language::Block& block) {
  constexpr std::int32_t kLastOfThem = 2;
  const auto skipped = std::ranges::find_if(block.words, [](const language::Word& word) {
    return word.address == language::Address::M && word.number <= kLastOfThem;
  });
  if (skipped != block.words.end()) block.words.erase(skipped);
}

/// The line alone, with the tool table that its T, G41 and G46 read.
program::ProgramSet programs_for(const language::Block& block, const Memory& memory) {
  program::ProgramSet programs;
  if (const language::Program* tools = memory.find(language::kToolTable)) programs.put(*tools);
  programs.put({kLineProgram, {block}});
  return programs;
}

bool has_fault(HandInputMode& mode, ControlState& state, const language::Block& block) {
  const language::EntryLimits limits = state.entry_limits();
  const auto checked = language::check_block(block, mode.plane, state.settings.vocabulary, &limits);
  if (checked) return false;
  complain_of_line(mode, state, checked.error());
  return true;
}

}  // namespace

void complain_of_line(HandInputMode& mode, ControlState& state, Error error) {
  mode.line.mark(error.word);
  if (mode.line.marker() == EntryLine::Marker::function) mode.line.go_to_function();
  if (error.in_tool_table) return state.complain(error);
  error.block = kLineBlock;  // it is the block that is wrong, not a program
  state.complain(error.code, language::message_of(error, state.tongue()));
}

bool show_words(HandInputMode& mode, ControlState& state) {
  const std::optional<language::Function> function = mode.line.function();
  if (!function) {
    state.complain(ErrorCode::word_missing, std::string(text(Text::said_code_missing, state.tongue())));
    return false;
  }
  mode.plane = state.plane();  // the function refers to the active state (MOD-022)
  const language::BlockForm* form = language::find_form(*function, mode.plane, state.settings.vocabulary);
  if (form == nullptr) {
    state.complain(Error{.code = ErrorCode::function_unknown, .detail = function_text(*function)});
    mode.line.go_to_function();
    return false;
  }
  mode.line.show_words(*form);
  if (mode.line.marker() == EntryLine::Marker::function) mode.line.go_to_function();
  return true;
}

void execute_line(HandInputMode& mode, ControlState& state) {
  const bool plane_changed = mode.plane != state.plane();
  if ((!mode.line.words_fit_function() || plane_changed) && !show_words(mode, state)) return;
  if (mode.line.marker() == EntryLine::Marker::function) mode.line.go_to_function();
  language::Block block = mode.line.block();
  block.number = kLineBlock;
  const std::size_t words_before = block.words.size();
  drop_program_ends(block);
  const bool has_lost_all = block.words.empty() && words_before > 0;
  if (is_barred(block.function) || has_lost_all) {
    state.hint = text(Text::said_barred, state.tongue());
    return;
  }
  if (has_fault(mode, state, block) || !may_run(state)) return;
  RunOrder order{.programs = programs_for(block, state.memory),
                 .start = {.program = kLineProgram,
                           .block = block.number,
                           .position = istwert_of(state.machine()),
                           .modal = state.modal,
                           .parameters = state.parameters,
                           .compensation_mm = state.compensation_mm},
                 .data = state.effective_data(),
                 .vocabulary = state.settings.vocabulary,
                 // S goes out by card 3 in AUTOMAT alone (D-123)
                 .io_cards = {state.settings.io_cards[0], state.settings.io_cards[1], false},
                 .rests_accumulate = state.settings.rests_accumulate,
                 .long_work = state.settings.long_work,
                 .is_single_function = true,
                 .tools = tools_at(state)};
  const auto begun = state.run.begin(state.connection, std::move(order));
  if (!begun) complain_of_line(mode, state, begun.error());
}

}  // namespace cnclab::panel
