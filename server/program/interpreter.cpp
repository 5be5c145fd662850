// The order of execution: one block per step, levels of calls, the end of the program.
#include "program/interpreter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "program/compensation.hpp"
#include "program/functions.hpp"
#include "program/reachable.hpp"
#include "program/words.hpp"

namespace cnclab::program {

namespace {

std::int64_t to_nm(double mm) { return std::llround(mm * kNanometresPerMm); }
std::int64_t to_um(std::int64_t nm) { return (nm >= 0 ? nm + 500 : nm - 500) / 1000; }

/// The first block in reach that this control cannot execute (D-02: nothing moves before it is known).
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
  constexpr std::uint64_t kFirst = 1;
  if (run.sequence == kFirst)
    if (Outcome announced = announce_compensation(run); !announced) return announced;
  if (Outcome called = execute_feed_speed_tool(run); !called) return called;
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
  return Interpreter(std::move(programs), settings, start);
}

Interpreter::Interpreter(ProgramSet programs, Settings settings, const Start& start)
    : programs_(std::move(programs)), settings_(settings), parameters_(start.parameters) {
  state_.modal = start.modal;
  state_.path = start.position;
  state_.fourth_axis_nm = to_nm(start.position.u);
  for (std::size_t axis = 0; axis < start.compensation_mm.size(); ++axis) {
    // The stages begin with the same compensation and add it again (D-75).
    double& path_mm = state_.path.*kPathAxes[axis];
    path_mm -= start.compensation_mm[axis];
    state_.programmed_nm[axis] = to_nm(path_mm);
  }
  begin_compensated(state_, start.compensation_mm);
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

std::array<std::int64_t, 3> Interpreter::programmed_um() const {
  const auto& [x, y, z] = state_.programmed_nm;
  return {to_um(x), to_um(y), to_um(z)};
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

BlockRun Interpreter::bench_for(const language::Block& block, std::vector<geometry::PathItem>& out) {
  return {.block = block,
          .source = {.program = levels_.back().program->number, .block = block.number},
          .sequence = sequence_ + 1,
          .override_off = state_.modal.potentiometer_off,
          .settings = settings_,
          .programs = programs_,
          .levels = levels_,
          .input_is_active = input_answer_.value_or(false),
          .state = state_,
          .parameters = parameters_,
          .result = result_,
          .out = out};
}

std::expected<ExecutedBlock, language::Error> Interpreter::execute_block(std::vector<geometry::PathItem>& out) {
  const Frame& level = levels_.back();
  const auto with_values = prepare(level);
  if (!with_values) return std::unexpected(with_values.error());
  BlockRun run = bench_for(*with_values ? **with_values : level.program->blocks[level.next], out);
  const std::uint16_t main_program = levels_.front().program->number;
  const int depth = static_cast<int>(levels_.size()) - 1;
  const bool is_shown = !state_.modal.blocks_hidden && !is_in_hidden_subprogram();

  const std::size_t items_before = out.size();
  if (Outcome outcome = execute_words(run); !outcome)
    return std::unexpected(naming_parameter(std::move(outcome.error()), level.program->blocks[level.next]));
  ended_ = go_on(run.flow);
  if (ended_) append_end(run);
  if (out.size() == items_before) run.emit(geometry::Mark{});
  out.back().ends_block = true;
  // EINZELSATZ rests where the next block is one that it may show: never before a block of a hidden subprogram, and
  // behind the last of them (KEY-046).
  if (is_in_hidden_subprogram())
    std::for_each(out.begin() + static_cast<std::ptrdiff_t>(items_before), out.end(),
                  [](geometry::PathItem& item) { item.passes_single_block = true; });
  sequence_ = run.sequence;
  // Built in its place: copying it would take as long as the block's way takes to work out.
  return std::expected<ExecutedBlock, language::Error>(std::in_place, sequence_, run.source, depth, main_program,
                                                       is_shown, state_.modal, programmed_um(), ended_);
}

std::expected<std::optional<language::Block>, language::Error> Interpreter::prepare(const Frame& level) {
  const geometry::Plane plane = state_.modal.plane;
  const language::Block& stored = level.program->blocks[level.next];
  const geometry::SourceBlock source{.program = level.program->number, .block = stored.number};
  if (!checked_.has_passed(*level.program, level.next, plane)) {
    if (stored.is_damaged) return error_at(language::ErrorCode::checksum_wrong, source, 0);
    if (Outcome known = executable(stored, source, settings_.vocabulary); !known) return std::unexpected(known.error());
    if (Outcome form = check_words(stored, source, plane, settings_); !form) return std::unexpected(form.error());
    checked_.pass(*level.program, level.next, plane);
  }
  if (reads_tool(stored))
    if (Outcome row = check_tool_row(programs_, state_.modal.tool, source); !row) return std::unexpected(row.error());
  if (!has_parameters(stored)) return std::nullopt;
  language::Block with_values = read_parameters(stored, parameters_, state_, programs_);
  if (is_dwell_of_nothing(with_values)) return with_values;  // DEC-53
  if (Outcome values = check_words(with_values, source, plane, settings_); !values)
    return std::unexpected(naming_parameter(std::move(values.error()), stored));
  return with_values;
}

bool Interpreter::pass_over_fault() {
  const Frame& level = levels_.back();
  const language::Block& stored = level.program->blocks[level.next];
  if (!last_ || last_->has_value() || jumps_always(stored)) return false;
  const bool has_no_feed = last_->error().code == language::ErrorCode::feed_missing;
  last_.reset();
  const language::Block block = read_parameters(stored, parameters_, state_, programs_);
  std::vector<geometry::PathItem> unused;
  BlockRun run = bench_for(block, unused);
  static_cast<void>(execute_feed_speed_tool(run));  // a tool whose row is damaged was told already
  execute_m(run, Moment::block_start);
  if (const auto target = target_of(run); target && is_way(block.function)) arrive(run, *target);
  execute_m(run, Moment::block_end);
  if (has_no_feed) state_.modal.feed_mm_per_min = 1;
  // An F above F MAX was told of here, not at each way behind it.
  state_.modal.feed_mm_per_min = std::min(state_.modal.feed_mm_per_min, static_cast<int>(settings_.f_max_mm_per_min));
  ++sequence_;
  ended_ = go_on(run.flow);
  return !ended_;
}

bool Interpreter::is_in_hidden_subprogram() const {
  return levels_.size() > 1 && state_.modal.subprogram_blocks_hidden;
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
