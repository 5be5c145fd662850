// The order of execution: one block per step, levels of calls, the end of the program.
#include "program/interpreter.hpp"

#include <fmt/core.h>

#include <cmath>

#include "program/functions.hpp"
#include "program/reachable.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

constexpr double kNanometresPerMm = 1e6;

std::int64_t to_um(std::int64_t nm) { return (nm >= 0 ? nm + 500 : nm - 500) / 1000; }

/// The first block in reach that this version cannot execute (D-02: nothing moves before it is known).
Outcome check_executable(const ProgramSet& programs, const Settings& settings, const Start& start) {
  Outcome outcome;
  walk_reachable(programs, start.program, start.block, [&](geometry::SourceBlock source, const language::Block& block) {
    outcome = executable(block, source, settings.vocabulary);
    return outcome.has_value();
  });
  return outcome;
}

/// F, S, T and the M functions of the block's start; the function itself; the M functions of its end (M-900, FST-009).
Outcome execute_words(BlockRun& run) {
  execute_feed_speed_tool(run);
  execute_m(run, Moment::block_start);
  if (Outcome outcome = handler_of(run.block.function)(run); !outcome) return outcome;
  execute_m(run, Moment::block_end);
  return {};
}

}  // namespace

std::unexpected<language::Error> error_at(language::ErrorCode code, geometry::SourceBlock source, char word,
                                          std::string detail, std::string expected) {
  return std::unexpected(language::Error{.code = code,
                                         .program = source.program,
                                         .block = source.block,
                                         .word = word,
                                         .detail = std::move(detail),
                                         .expected = std::move(expected)});
}

std::unexpected<language::Error> feed_above_limit(geometry::SourceBlock source, std::int64_t feed,
                                                  const Settings& settings) {
  return error_at(language::ErrorCode::feed_above_limit, source, 'F', std::to_string(feed),
                  fmt::format("0001..{:04}", std::llround(settings.f_max_mm_per_min)));
}

std::expected<Interpreter, language::Error> Interpreter::begin(ProgramSet programs, Settings settings,
                                                               const Start& start) {
  const geometry::SourceBlock place{.program = start.program, .block = start.block};
  const language::Program* program = start.program == language::kToolTable ? nullptr : programs.find(start.program);
  if (language::is_reserved_for_cycles(start.program))
    return error_at(language::ErrorCode::reserved_for_cycles, place, 'P', fmt::format("P{:04}", start.program));
  if (program == nullptr)
    return error_at(language::ErrorCode::program_missing, {.program = start.program, .block = 0}, 'P',
                    fmt::format("P{:04}", start.program));
  if (!program->find(start.block))
    return error_at(language::ErrorCode::block_missing, place, 'N', fmt::format("N{:03}", start.block));
  if (Outcome outcome = check_executable(programs, settings, start); !outcome) return std::unexpected(outcome.error());
  return Interpreter(std::move(programs), std::move(settings), start);
}

Interpreter::Interpreter(ProgramSet programs, Settings settings, const Start& start)
    : programs_(std::move(programs)), settings_(std::move(settings)), parameters_(start.parameters) {
  const geometry::Point& position = start.position;
  state_.modal = start.modal;
  state_.programmed_nm = {std::llround(position.x * kNanometresPerMm), std::llround(position.y * kNanometresPerMm),
                          std::llround(position.z * kNanometresPerMm)};
  state_.fourth_axis_nm = std::llround(position.u * kNanometresPerMm);
  state_.path = position;
  for (std::size_t axis = 0; axis < programmed_um_.size(); ++axis)
    programmed_um_[axis] = to_um(state_.programmed_nm[axis]);
  const language::Program* program = programs_.find(start.program);
  const std::size_t index = program->find(start.block).value_or(0);
  levels_.push_back({.program = program, .next = index, .called = program, .entry = index, .repeats_left = 0});
}

std::optional<std::uint64_t> Interpreter::awaited_input() const {
  if (last_ || input_answer_) return std::nullopt;
  const Frame& level = levels_.back();
  const language::Function function = level.program->blocks[level.next].function;
  const bool asks = function.kind == language::Function::Kind::g && (function.code == 21 || function.code == 23);
  constexpr std::uint64_t kBlocksBefore = 2;
  if (!asks) return std::nullopt;
  return sequence_ + 1 > kBlocksBefore ? sequence_ + 1 - kBlocksBefore : 0;
}

void Interpreter::answer_input(bool is_active) { input_answer_ = is_active; }

std::expected<ExecutedBlock, language::Error> Interpreter::step(std::vector<geometry::PathItem>& out) {
  if (last_) return *last_;
  const ExecutionState before = state_;
  const std::size_t items_before = out.size();
  auto result = execute_block(out);
  if (!result) {
    state_ = before;
    out.resize(items_before);
  }
  input_answer_.reset();
  if (!result || result->ended) last_ = result;
  return result;
}

std::expected<ExecutedBlock, language::Error> Interpreter::execute_block(std::vector<geometry::PathItem>& out) {
  const Frame& level = levels_.back();
  const language::Block& stored = level.program->blocks[level.next];
  ExecutedBlock executed;
  executed.sequence = sequence_ + 1;
  executed.source = {.program = level.program->number, .block = stored.number};
  executed.depth = static_cast<int>(levels_.size()) - 1;
  executed.main_program = levels_.front().program->number;
  const bool is_hidden_subprogram = executed.depth > 0 && state_.modal.subprogram_blocks_hidden;
  executed.is_shown = !state_.modal.blocks_hidden && !is_hidden_subprogram;

  const auto block = prepare(stored, executed.source);
  if (!block) return std::unexpected(block.error());
  BlockRun run{.block = *block ? **block : stored,
               .source = executed.source,
               .settings = settings_,
               .programs = programs_,
               .levels = levels_,
               .pattern = {.source = executed.source,
                           .sequence = executed.sequence,
                           .passes_single_block = is_hidden_subprogram,
                           .override_off = state_.modal.potentiometer_off},
               .state = state_,
               .parameters = parameters_,
               .result = result_,
               .out = out,
               .flow = {}};
  const std::size_t items_before = out.size();
  if (Outcome outcome = execute_words(run); !outcome)
    return std::unexpected(naming_parameter(std::move(outcome.error()), stored));
  ended_ = go_on(run.flow);
  if (ended_) append_end(run);
  if (out.size() == items_before) run.emit(geometry::Mark{});
  out.back().ends_block = true;

  sequence_ = executed.sequence;
  for (std::size_t axis = 0; axis < programmed_um_.size(); ++axis)
    programmed_um_[axis] = to_um(state_.programmed_nm[axis]);
  executed.modal = state_.modal;
  executed.programmed_um = programmed_um_;
  executed.ended = ended_;
  return executed;
}

std::expected<std::optional<language::Block>, language::Error> Interpreter::prepare(
    const language::Block& stored, geometry::SourceBlock source) const {
  if (stored.is_damaged) return error_at(language::ErrorCode::checksum_wrong, source, 0);
  if (Outcome outcome = executable(stored, source, settings_.vocabulary); !outcome)
    return std::unexpected(outcome.error());
  std::optional<language::Block> with_values;
  if (has_parameters(stored)) with_values = read_parameters(stored, parameters_, state_, programs_);
  if (with_values && is_dwell_of_nothing(*with_values)) return with_values;  // DEC-53
  if (Outcome outcome = check_words(with_values ? *with_values : stored, source, state_.modal.plane, settings_);
      !outcome)
    return std::unexpected(naming_parameter(std::move(outcome.error()), stored));
  return with_values;
}

bool Interpreter::go_on(const Flow& flow) {
  Frame& level = levels_.back();
  switch (flow.kind) {
    case Flow::Kind::next:
      ++level.next;
      break;
    case Flow::Kind::jump:
      level.program = flow.program;
      level.next = flow.index;
      break;
    case Flow::Kind::call:
      ++level.next;
      levels_.push_back({.program = flow.program,
                         .next = flow.index,
                         .called = flow.program,
                         .entry = flow.index,
                         .repeats_left = flow.repeats});
      break;
    case Flow::Kind::end:
      return true;
  }
  return leave_finished_levels();
}

bool Interpreter::leave_finished_levels() {
  while (levels_.back().next >= levels_.back().program->blocks.size()) {
    if (levels_.size() == 1) return true;
    Frame& level = levels_.back();
    if (level.repeats_left == 0) {
      levels_.pop_back();
      continue;
    }
    --level.repeats_left;
    level.program = level.called;
    level.next = level.entry;
  }
  return false;
}

/// DEC-38: on the lab machine the end of a program leaves nothing running.
void Interpreter::append_end(BlockRun& run) {
  ModalState& modal = state_.modal;
  if (settings_.outputs_at_end_off && modal.spindle != geometry::SpindleTurn::off) {
    modal.spindle = geometry::SpindleTurn::off;
    run.emit(geometry::Spindle{});
    modal.m = 12;
  }
  if (settings_.outputs_at_end_off && modal.coolant) {
    modal.coolant = false;
    run.emit(geometry::Coolant{});
    modal.m = 12;
  }
  run.emit(geometry::End{});
}

std::vector<std::pair<geometry::SourceBlock, const language::Block*>> Interpreter::upcoming(std::size_t count) const {
  std::vector<std::pair<geometry::SourceBlock, const language::Block*>> blocks;
  if (ended_) return blocks;
  const language::Program* program = levels_.back().program;
  std::size_t next = levels_.back().next;
  while (blocks.size() < count && next < program->blocks.size()) {
    const language::Block& block = program->blocks[next];
    blocks.emplace_back(geometry::SourceBlock{.program = program->number, .block = block.number}, &block);
    const auto target = unconditional_target(programs_, *program, block);
    if (!target) {
      ++next;
      continue;
    }
    program = target->program;
    next = target->index;
  }
  return blocks;
}

}  // namespace cnclab::program
