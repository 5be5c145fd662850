// The keys of EINGABEMODUS.
#include "panel/modes/editor_mode.hpp"

#include <algorithm>

#include "panel/modes/line_keys.hpp"
#include "panel/screen/names.hpp"
#include "program/rom_programs.hpp"

namespace cnclab::panel {

namespace {

using language::ErrorCode;

int last_number_of(const EditorMode& mode) {
  constexpr int kLastTool = 99;
  return mode.number() == language::kToolTable ? kLastTool : language::kLastBlock;
}

/// A new line that offers `number`, the marker on it.
void offer(EditorMode& mode, int number) {
  mode.line = EntryLine(mode.number(), std::min(number, last_number_of(mode)), mode.proposed_g);
}

void list_last_up_to(EditorMode& mode, const language::Program& program, int number) {
  const auto end = std::ranges::upper_bound(program.blocks, number, {},
                                            [](const language::Block& block) { return int{block.number}; });
  const auto listed = std::min<std::ptrdiff_t>(kListedBlocks, end - program.blocks.begin());
  mode.list_from = listed == 0 ? std::nullopt : std::optional((end - listed)->number);
}

void open_program(EditorMode& mode, ControlState& state, bool from_first) {
  const std::uint16_t number = mode.number();
  mode.program.typed = 0;  // whatever comes of it, the next digit begins another number
  const language::Program* program = program_in(state, number);
  if (language::is_reserved_for_cycles(number) && program == nullptr)  // P9987 to P9989 are empty (DEC-64)
    return state.complain(language::Error{.code = ErrorCode::program_missing, .detail = program_word(number)});
  state.editor_program = number;
  mode.is_open = true;
  mode.list_from.reset();
  if (program == nullptr) return offer(mode, 1);
  const language::Block& last = program->blocks.back();
  if (last.function.kind == language::Function::Kind::g) mode.proposed_g = last.function.code;
  offer(mode, last.number + 1);
  list_last_up_to(mode, *program, last.number);
  if (from_first) mode.list_from = program->blocks.front().number;
}

void page_overview(EditorMode& mode, const ControlState& state) {
  const std::size_t next = mode.overview ? *mode.overview + kProgramsPerLine * kOverviewLines : 0;
  mode.overview = next < state.memory.programs().size() ? next : 0;
}

void press_program(EditorMode& mode, ControlState& state, Effect effect, int figure) {
  switch (effect) {
    case Effect::digit:
      mode.overview.reset();
      return mode.program.digit(figure);
    case Effect::clear:
      mode.overview.reset();
      return mode.program.clear();
    case Effect::enter:
    case Effect::down:
      if (!mode.program.value) return page_overview(mode, state);
      return open_program(mode, state, effect == Effect::down);
    default:
      return;
  }
}

/// ↓ at N: the blocks from the typed number on, then the next ten each time (KEY-068).
void page_blocks(EditorMode& mode, ControlState& state) {
  const language::Program* program = program_in(state, mode.number());
  if (program == nullptr) return void(state.hint = text(Text::said_no_more_blocks, state.tongue()));
  const auto at_or_after = [&](int number) {
    return std::ranges::lower_bound(program->blocks, number, {},
                                    [](const language::Block& block) { return int{block.number}; });
  };
  auto from = at_or_after(mode.line.number());
  if (!mode.line.is_number_typed() && mode.list_from) {
    from = at_or_after(*mode.list_from);
    from += std::min<std::ptrdiff_t>(kListedBlocks, program->blocks.end() - from);
  }
  if (from == program->blocks.end()) return void(state.hint = text(Text::said_no_more_blocks, state.tongue()));
  mode.list_from = from->number;
  mode.line.offer_number(mode.line.number());
}

/// SATZ SUCHEN: block N into the entry line (EDIT-017).
void load_block(EditorMode& mode, ControlState& state) {
  const auto number = static_cast<std::uint16_t>(mode.line.number());
  const language::Program* program = program_in(state, mode.number());
  const auto index = program == nullptr ? std::nullopt : program->find(number);
  if (!index) {
    const bool is_tool = mode.line.is_tool_row();
    state.complain(language::Error{.code = ErrorCode::block_missing,
                                   .program = mode.number(),
                                   .detail = is_tool ? "T" + block_text(number) : block_word(number),
                                   .in_tool_table = is_tool});
    return;
  }
  const language::Block& block = program->blocks[*index];
  mode.plane = language::plane_of_words(block, plane_before(program, number, state.plane()));
  const language::BlockForm* form = language::find_form(block.function, mode.plane, state.settings.vocabulary);
  // A stored function that this control does not have can still be looked at and deleted.
  if (form == nullptr) {
    const auto known = std::ranges::find(language::all_forms(), block.function, &language::BlockForm::function);
    if (known == language::all_forms().end())
      return state.complain(
          language::Error{.code = ErrorCode::function_unknown, .program = mode.number(), .block = number});
    form = &*known;
  }
  mode.line = EntryLine::loaded(mode.number(), block, *form);
}

void press_enter(EditorMode& mode, ControlState& state) {
  switch (mode.line.marker()) {
    case EntryLine::Marker::number:
      if (!check_number(mode, state)) return;
      if (mode.line.is_tool_row()) return void(show_words(mode, state));
      return mode.line.go_to_function();
    case EntryLine::Marker::function:
      return void(show_words(mode, state));
    case EntryLine::Marker::word:
      return mode.line.next_word();
  }
}

void press_down(EditorMode& mode, ControlState& state) {
  if (mode.line.marker() == EntryLine::Marker::number) return page_blocks(mode, state);
  const bool has_parameters = state.settings.vocabulary.model == language::Model::cnc3300;  // MODEL-006
  if (!has_parameters || !mode.line.down())
    state.hint = text(Text::hint_no_effect, state.tongue(), {label_of(Key::DOWN)});
}

void press_line(EditorMode& mode, ControlState& state, Effect effect, int figure) {
  if (key_into(mode.line, effect, figure)) return;
  switch (effect) {
    case Effect::clear:
      return mode.line.clear();
    case Effect::enter:
      return press_enter(mode, state);
    case Effect::down:
      return press_down(mode, state);
    case Effect::search:
      return load_block(mode, state);
    case Effect::store:
      return store_line(mode, state);
    case Effect::erase_block:
      return erase_loaded_block(mode, state);
    default:
      return;
  }
}

}  // namespace

const language::Program* program_in(const ControlState& state, std::uint16_t number) {
  if (!language::is_reserved_for_cycles(number)) return state.memory.find(number);
  const language::Vocabulary& known = state.settings.vocabulary;
  const bool has_cycles = known.model == language::Model::cnc3300 && known.planned_functions;
  return has_cycles ? program::rom_program(number) : nullptr;
}

EditorMode open_editor(const ControlState& state) {
  EditorMode mode;
  mode.program.offer(state.editor_program);
  return mode;
}

Place place_of(const EditorMode& mode) {
  if (!mode.is_open) return Place::editor_program;
  switch (mode.line.marker()) {
    case EntryLine::Marker::number:
      return Place::editor_number;
    case EntryLine::Marker::function:
      return Place::editor_function;
    case EntryLine::Marker::word:
      return Place::editor_word;
  }
  return Place::editor_program;
}

void press(EditorMode& mode, ControlState& state, Effect effect, int figure) {
  if (mode.is_open) return press_line(mode, state, effect, figure);
  press_program(mode, state, effect, figure);
}

void stored(EditorMode& mode, ControlState& state, const StoreRequest& request) {
  const auto next_after = [&](std::uint16_t program_number, const language::Block& block) {
    if (!mode.is_open || program_number != mode.number()) return;
    if (block.function.kind == language::Function::Kind::g) mode.proposed_g = block.function.code;
    offer(mode, block.number + 1);
    if (const language::Program* program = state.memory.find(program_number))
      list_last_up_to(mode, *program, block.number);
  };
  if (const auto* put = std::get_if<PutBlock>(&request)) next_after(put->program, put->block);
  if (const auto* insert = std::get_if<InsertBlock>(&request)) next_after(insert->program, insert->block);
  const auto* erased = std::get_if<DeleteBlock>(&request);
  if (erased == nullptr || !mode.is_open || erased->program != mode.number()) return;
  offer(mode, erased->block);
  const language::Program* program = state.memory.find(erased->program);
  mode.list_from.reset();
  if (program != nullptr) list_last_up_to(mode, *program, language::kLastBlock);
}

}  // namespace cnclab::panel
