// Keys of TEACH IN.
#include "panel/modes/teach_in_mode.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "language/check_block.hpp"
#include "panel/modes/line_keys.hpp"
#include "panel/run/machine_place.hpp"
#include "panel/run/start_check.hpp"

namespace cnclab::panel {

namespace {

using language::Address;
using language::Error;
using language::ErrorCode;

constexpr std::array kTaughtAxes{Address::X, Address::Y, Address::Z};
constexpr language::Function kLine{language::Function::Kind::g, 1};
constexpr std::uint8_t kProposedG = 1;

std::uint16_t lowest_free(const Memory& memory) {
  std::uint16_t number = 1;
  while (memory.find(number) != nullptr && number < language::kLastProgram) ++number;
  return number;
}

/// An empty G01 line of that number, no word chosen.
void offer(TeachInMode& mode, const ControlState& state, int number) {
  mode.line = EntryLine(mode.number(), number, kProposedG);
  if (const auto* form = language::find_form(kLine, language::Plane::xy, state.settings.vocabulary))
    mode.line.show_words(*form);
  mode.line.go_to_number();
}

void open_program(TeachInMode& mode, ControlState& state) {
  const std::uint16_t number = mode.number();
  mode.program.typed = 0;
  if (language::is_reserved_for_cycles(number))
    return state.complain(Error{.code = ErrorCode::reserved_for_cycles, .program = number});
  if (number == language::kToolTable)
    return state.complain(ErrorCode::program_number_wrong,
                          std::string(text(Text::said_number_for_teaching, state.tongue())));
  const language::Program* program = state.memory.find(number);
  const int next = program == nullptr ? 1 : program->blocks.back().number + 1;  // DEC-61: an existing one is continued
  if (next > language::kLastBlock)
    return state.complain(ErrorCode::block_number_wrong, std::string(text(Text::said_program_full, state.tongue())));
  if (program != nullptr && state.taught.program == number) mode.reference = state.taught.place;
  mode.is_open = true;
  offer(mode, state, next);
}

void press_prompt(TeachInMode& mode, ControlState& state, Effect effect, int figure) {
  if (effect == Effect::digit) mode.program.digit(figure);
  if (effect == Effect::clear) mode.program.clear();
  if (effect == Effect::enter) open_program(mode, state);
}

/// After STOP: what was driven stands in X, Y and Z (MOD-038, MOD-041). A place that no word can hold leaves them
/// empty, so that it is not stored.
void fill_position(TeachInMode& mode, ControlState& state) {
  const bool is_absolute = state.modal.dimension == program::Dimension::absolute;
  const auto words_um = is_absolute ? programmed_um(state) : way_um_since(mode.reference, state);
  const auto beyond =
      std::ranges::find_if(words_um, [](std::int64_t um) { return std::abs(um) > language::kLargestWord_um; });
  if (beyond != words_um.end()) {
    for (const Address axis : kTaughtAxes) mode.line.fill(axis, std::nullopt);
    const char letter = language::letter(kTaughtAxes.at(static_cast<std::size_t>(beyond - words_um.begin())));
    state.message.sentence = text(Text::said_istwert_too_large, state.tongue(), {std::string_view(&letter, 1)});
    return;
  }
  for (std::size_t axis = 0; axis < kTaughtAxes.size(); ++axis) {
    const bool stays_empty = !is_absolute && words_um[axis] == 0;
    mode.line.fill(kTaughtAxes[axis],
                   stays_empty ? std::nullopt : std::optional(static_cast<std::int32_t>(words_um[axis])));
  }
}

void store_line(TeachInMode& mode, ControlState& state) {
  const language::Block block = mode.line.block();
  const language::EntryLimits limits = state.entry_limits();
  const auto checked = language::check_block(block, language::Plane::xy, state.settings.vocabulary, &limits);
  if (!checked) {
    Error error = checked.error();
    error.program = mode.number();
    error.block = block.number;
    if (error.word != 0) mode.line.mark(error.word);
    return state.complain(error);
  }
  if (language::cost_bytes(block) > state.memory.free_bytes())
    return state.complain(Error{.code = ErrorCode::memory_full, .program = mode.number(), .block = block.number});
  state.storing = PutBlock{mode.number(), block};
}

void press_line(TeachInMode& mode, ControlState& state, Effect effect, int figure) {
  if (key_into(mode.line, effect, figure)) return;
  switch (effect) {
    case Effect::clear:
      return mode.line.clear();
    case Effect::enter:
      return mode.line.next_word();
    case Effect::store:
      return store_line(mode, state);
    case Effect::start:
      if (!may_run(state)) return;  // unreferenced only HANDBETRIEB moves (DEC-27)
      return press(mode.driving, state, effect, figure);
    default:
      return press(mode.driving, state, effect, figure);
  }
}

}  // namespace

TeachInMode open_teach_in(const ControlState& state) {
  TeachInMode mode;
  mode.program.offer(lowest_free(state.memory));
  mode.reference = place_now(state);
  return mode;
}

void close(TeachInMode& mode, ControlState&) { close(mode.driving); }

Place place_of(const TeachInMode& mode) {
  if (!mode.is_open) return Place::teach_program;
  if (mode.driving.is_moving()) return Place::teach_moving;
  return mode.line.marker() == EntryLine::Marker::word ? Place::teach_word : Place::teach_ready;
}

void press(TeachInMode& mode, ControlState& state, Effect effect, int figure) {
  if (!mode.is_open) return press_prompt(mode, state, effect, figure);
  press_line(mode, state, effect, figure);
}

void follow(TeachInMode& mode, ControlState& state) {
  const auto end = follow(mode.driving, state);
  if (end && !end->is_refused) fill_position(mode, state);
}

void stored(TeachInMode& mode, ControlState& state, const StoreRequest& request) {
  const auto* put = std::get_if<PutBlock>(&request);
  if (put == nullptr || !mode.is_open || put->program != mode.number()) return;
  mode.reference = place_now(state);
  state.taught = {mode.number(), mode.reference};
  state.editor_program = mode.number();  // the program last worked on (D-35)
  const int next = put->block.number + 1;
  if (next <= language::kLastBlock) return offer(mode, state, next);
  mode.is_open = false;
  state.message.sentence = text(Text::said_program_full, state.tongue());
}

}  // namespace cnclab::panel
