// The release of a remote start on the screen EXTERNE DATEN: what AUTH-013 asks of the student. How the screen asks for
// it is our own definition; the original started whatever the computer named.
//
//   START ──▶ the program shown, from its first block, for 60 s        digits, C: another number, → program or block
//             STOP, MENU, another number: withdrawn                     START again: released anew
#include "panel/modes/automat_mode.hpp"
#include "panel/modes/external_data_mode.hpp"
#include "panel/screen/texts.hpp"

namespace cnclab::panel {

namespace {

using language::Error;
using language::ErrorCode;

DigitField& field_of(ExternalDataMode& mode) { return mode.is_at_block ? mode.block : mode.program; }

/// Program and block where they can be started; nothing after a complaint.
std::optional<geometry::SourceBlock> startable(const ExternalDataMode& mode, ControlState& state) {
  const auto number = static_cast<std::uint16_t>(mode.program.value.value_or(0));
  const bool is_program = number != language::kToolTable && !language::is_reserved_for_cycles(number);
  const language::Program* program = is_program ? state.memory.find(number) : nullptr;
  if (program == nullptr) {
    state.complain_cannot_run(number);
    return std::nullopt;
  }
  const auto block = static_cast<std::uint16_t>(mode.block.value.value_or(program->blocks.front().number));
  if (program->find(block)) return geometry::SourceBlock{number, block};
  state.complain(Error{.code = ErrorCode::block_missing, .program = number, .detail = block_word(block)});
  return std::nullopt;
}

/// DEC-27: the first start of such a program under a lease asks for the zero; here the release does.
bool must_confirm_zero(ExternalDataMode& mode, ControlState& state, geometry::SourceBlock place) {
  if (!would_ask_zero(state, place)) return false;
  state.is_zero_confirmed = mode.asks_zero;
  mode.asks_zero = true;
  if (!state.is_zero_confirmed) state.hint = text(Text::said_confirm_zero, state.tongue());
  return !state.is_zero_confirmed;
}

std::int64_t left_ns(const Armed& armed, const ControlState& state) {
  return armed.at_ns + Armed::kValid_ns - state.now.monotonic_ns;
}

}  // namespace

void release_start(ExternalDataMode& mode, ControlState& state) {
  if (mode.phase != ExternalDataMode::Phase::release) {
    mode.program.offer(state.editor_program);
    mode.block.clear();
    mode.is_at_block = mode.asks_zero = false;
    mode.done.clear();
    mode.phase = ExternalDataMode::Phase::release;
  }
  mode.armed.reset();
  mode.program.typed = mode.block.typed = 0;
  const auto place = startable(mode, state);
  if (!place) return;
  mode.block.offer(place->block);
  if (!state.connection.is_lab_machine) {
    state.hint = text(Text::said_release_machine, state.tongue());
    return;
  }
  if (must_confirm_zero(mode, state, *place)) return;
  mode.armed = Armed{place->program, place->block, state.connection.epoch, state.now.monotonic_ns};
  state.port.news.push_back("released " + program_word(place->program) + " " + block_word(place->block));
}

void press_release(ExternalDataMode& mode, ControlState& state, Effect effect, int figure) {
  if (effect == Effect::start) return release_start(mode, state);
  mode.armed.reset();
  mode.asks_zero = false;
  if (effect == Effect::stop) {
    state.port.news.emplace_back("release withdrawn");
    mode.phase = ExternalDataMode::Phase::device;
  }
  if (effect == Effect::enter) mode.is_at_block = !mode.is_at_block;
  if (effect != Effect::digit && effect != Effect::clear) return;
  effect == Effect::digit ? field_of(mode).digit(figure) : field_of(mode).clear();
  if (!mode.is_at_block) mode.block.clear();  // another program begins at its own first block
}

void follow_release(ExternalDataMode& mode, ControlState& state) {
  if (!state.settings.remote || !state.port.fitting.is_fitted) mode.phase = ExternalDataMode::Phase::device;
  if (mode.armed && (mode.phase == ExternalDataMode::Phase::device || left_ns(*mode.armed, state) <= 0))
    mode.armed.reset();
}

std::string release_sentence(const ExternalDataMode& mode, const ControlState& state) {
  if (!mode.armed) return std::string(text(Text::wait_release, state.tongue()));
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  const std::int64_t seconds = (left_ns(*mode.armed, state) + kSecond_ns - 1) / kSecond_ns;
  return text(Text::wait_released, state.tongue(),
              {program_word(mode.armed->program), block_word(mode.armed->block), std::to_string(seconds)});
}

}  // namespace cnclab::panel
