// Feeding the machine a few seconds ahead, and telling from its sequence number what the operator sees.
#include "panel/run/run.hpp"

#include <algorithm>
#include <utility>

#include "geometry/path_math.hpp"
#include "geometry/step_grid.hpp"

namespace cnclab::panel {

namespace {

using machine::StopCause;

/// Items per poll: 400 of them take 0.4 ms (measured), well below the 2 ms that a poll may take (DEC-63).
constexpr int kItemsPerPoll = 400;
/// Blocks that may wait: more would only cost memory, and a jump loop without motion would fill it.
constexpr std::uint64_t kMostBlocksAhead = 8192;
constexpr double kLeastLookAhead_s = 2;

program::Settings settings_of(const RunOrder& order, bool is_lab_machine) {
  program::Settings settings = interpreter_settings(order.data, order.vocabulary);
  settings.io_cards = order.io_cards;
  settings.rests_accumulate = order.rests_accumulate;
  settings.outputs_at_end_off = is_lab_machine && !order.is_single_function;
  return settings;
}

bool is_alarm(const geometry::PathItem& item) {
  const auto* halt = std::get_if<geometry::Halt>(&item.what);
  return halt != nullptr && halt->signal;
}

/// Only the lab's machine has machine coordinates, and only while it is referenced (DEC-27, D-116).
std::optional<std::array<double, 3>> known_place(const Connection& connection,
                                                 const std::array<double, 4>& steps_per_mm) {
  const machine::Snapshot now = connection.channel->snapshot();
  if (!connection.is_lab_machine || !now.is_referenced) return std::nullopt;
  std::array<double, 3> mm{};
  for (std::size_t axis = 0; axis < mm.size(); ++axis)
    mm[axis] = static_cast<double>(now.steps[axis]) / steps_per_mm[axis];
  return mm;
}

/// What START finds called, as its table has it now.
geometry::ToolChange tool_in_force(const RunOrder& order) {
  const int number = order.start.modal.tool;
  const program::ToolData tool = order.programs.tool(number).value_or(program::ToolData{});
  return {.number = number, .radius_mm = language::to_mm(tool.radius), .length_mm = language::to_mm(tool.length)};
}

bool acts_at_block_start(int m) { return m == 3 || m == 4 || m == 8 || m == 13 || m == 14; }  // M-900

}  // namespace

program::Settings interpreter_settings(const machine::MachineData& data, const language::Vocabulary& vocabulary) {
  program::Settings settings;
  settings.f_max_mm_per_min = static_cast<double>(data.get(6));
  settings.s_max_rpm = static_cast<double>(data.get(7));
  for (int axis = 0; axis < 3; ++axis)
    settings.travel_mm[static_cast<std::size_t>(axis)] = static_cast<double>(data.get(3 + axis)) / 1000.0;
  for (int axis = 0; axis < 4; ++axis)
    settings.steps_per_mm[static_cast<std::size_t>(axis)] = static_cast<double>(data.get(14 + axis));
  settings.vocabulary = vocabulary;
  return settings;
}

std::expected<void, language::Error> Run::begin(const Connection& connection, RunOrder order) {
  const program::Settings settings = settings_of(order, connection.is_lab_machine);
  auto source = program::PathSource::begin(order.programs, settings, order.start);
  if (!source) return std::unexpected(source.error());
  *this = Run{};
  connection_ = connection;
  if (!order.machine_mm) order.machine_mm = known_place(connection, settings.steps_per_mm);
  order_ = std::make_shared<const RunOrder>(std::move(order));
  source_ = std::move(*source);
  steps_per_mm_ = settings.steps_per_mm;
  offsets_.emplace(order_->start.compensation_mm);
  first_parameters_ = parameters_ = std::make_shared<const program::Parameters>(order_->start.parameters);
  look();
  if (!Preflight::is_needed(order_->programs, order_->start)) return launch();
  preflight_.emplace(order_->long_work, order_->programs, settings, order_->start);
  const std::optional<Preflight::Result> result = preflight_->result();
  return result ? conclude_check(*result) : std::expected<void, language::Error>{};
}

std::expected<void, language::Error> Run::conclude_check(const Preflight::Result& result) {
  preflight_.reset();
  sound_contours_ = result.sound_contours;
  if (!result.error) return launch();
  *this = Run{};
  return std::unexpected(*result.error);
}

std::expected<void, language::Error> Run::launch() {
  if (order_->machine_mm) guard_.emplace(*order_->machine_mm, order_->data, order_->start.position);
  tools_.emplace(order_->tools, tool_in_force(*order_));
  static_cast<void>(prepare_block());
  if (failure_) {
    auto error = std::unexpected(std::move(*failure_));
    *this = Run{};
    return error;
  }
  const motion::Limits limits = machine::motion_limits(order_->data);
  look_ahead_s_ = kLeastLookAhead_s + limits.f_max_mm_per_s / limits.stop_deceleration_mm_per_s2;
  motion::Planner* planner =
      connection_.channel->begin_run(connection_.epoch, order_->start.position, !order_->is_single_function);
  if (planner != nullptr) {
    run_ = planner->run();
    feed();
  }
  go();
  return {};
}

void Run::go() {
  const machine::Snapshot now = connection_.channel->snapshot();
  refused_before_ = now.refused + now.dropped;
  answer_tick_ = now.tick + kAnswerTicks;
  (void)connection_.channel->command(machine::Go{connection_.epoch});
  look();
}

bool Run::prepare_block() {
  if (!may_go_on()) return false;
  items_.clear();
  next_item_ = 0;
  auto executed = source_->step(items_);
  offsets_->take(items_);
  geometry::run_in_step_grid(items_, steps_per_mm_);
  guard_travel();
  guard_tools();
  if (executed) guard_contours(*executed);
  scout_contours();
  if (!executed && !failure_) failure_ = executed.error();
  if (!executed) return true;
  const program::Interpreter& interpreter = source_->interpreter();
  if (interpreter.parameters() != *parameters_)
    parameters_ = std::make_shared<const program::Parameters>(interpreter.parameters());
  records_.push_back({*executed, parameters_, std::ranges::any_of(source_->programmed(), is_alarm), path_s_});
  account_for_items();
  return true;
}

/// Items may come after their block, when the stages know what follows.
void Run::account_for_items() {
  for (const geometry::PathItem& item : items_) {
    path_s_ += geometry::seconds_at_feed(item);
    if (item.sequence < records_.front().block.sequence || item.sequence > records_.back().block.sequence) continue;
    records_[static_cast<std::size_t>(item.sequence - records_.front().block.sequence)].path_s = path_s_;
  }
}

/// The block being done does not count, however long it is: at its end what follows has to be there, or it stops there.
bool Run::is_far_enough_ahead() const {
  if (records_.empty()) return false;
  const Record* current = record(std::max(seen_.sequence, seen_.finished_sequence));
  const double behind_s = path_s_ - (current == nullptr ? 0 : current->path_s);
  return behind_s >= look_ahead_s_ || records_.back().block.sequence - seen_.finished_sequence >= kMostBlocksAhead;
}

bool Run::feed(Questions questions) {
  questions_ = questions;
  has_gone_on_ = false;
  motion::Planner& planner = connection_.channel->planner();
  int budget = kItemsPerPoll;
  for (; budget > 0; --budget) {
    if (next_item_ == items_.size()) {
      if (failure_ || source_->ended() || is_far_enough_ahead() || !prepare_block()) break;
      continue;
    }
    if (!planner.append(items_[next_item_])) break;
    ++next_item_;
  }
  planner.plan();
  if (has_gone_on_) connection_.channel->note_resumption(last_answer_);
  return budget == 0;
}

void Run::forget_done_blocks() {
  const std::uint64_t still_needed = std::min(seen_.finished_sequence, seen_.sequence);
  while (records_.size() > 1 && records_.front().block.sequence < still_needed) records_.pop_front();
  tools_->forget_before(still_needed);
  offsets_->forget_before(still_needed);
}

const Run::Record* Run::record(std::uint64_t sequence) const {
  if (records_.empty() || sequence < records_.front().block.sequence || sequence > records_.back().block.sequence)
    return nullptr;
  return &records_[static_cast<std::size_t>(sequence - records_.front().block.sequence)];
}

Run::State Run::state() const {
  if (!is_present()) return State::none;
  if (is_checking()) return State::running;
  if (seen_.run != run_ || seen_.tick < answer_tick_) return State::running;
  if (is_backing_off()) return State::braking;
  if (!seen_.started) return seen_.cause == StopCause::single_block ? State::between : State::stopped;
  switch (seen_.state) {
    case machine::MotionState::halted:
      return State::waiting;
    case machine::MotionState::stopping:
      return State::braking;
    case machine::MotionState::standstill:
    case machine::MotionState::moving:
    case machine::MotionState::off:
      return State::running;
  }
  return State::running;
}

bool Run::is_backing_off() const {
  return is_present() && !is_checking() && seen_.run == run_ && !seen_.started &&
         seen_.state == machine::MotionState::stopping;
}

void Run::go_on() {
  if (is_present() && !is_checking()) go();
}

void Run::stop() {
  is_stopped_in_check_ = is_checking();
  if (is_present()) connection_.channel->stop(StopCause::operator_stop);
}

RunEnd Run::finish(RunEnd::Kind kind) {
  RunEnd end{kind, seen_.cause, std::nullopt, legacy()};
  if (kind == RunEnd::Kind::failed) end.error = failure_;
  *this = Run{};
  return end;
}

std::optional<RunEnd> Run::abandon() {
  if (!is_present()) return std::nullopt;
  look();
  (void)connection_.channel->command(machine::Abandon{});
  return finish(RunEnd::Kind::broken);
}

/// Everything that was appended has been passed; what the source holds back or has failed at is not part of it.
bool Run::is_path_done() const {
  return next_item_ == items_.size() && connection_.channel->queue().waiting() == 0 && seen_.speed_mm_per_min == 0;
}

/// STOP during the check ends it: nothing has been started that could go on.
std::optional<RunEnd> Run::poll_check() {
  if (is_stopped_in_check_) return finish(RunEnd::Kind::broken);
  const std::optional<Preflight::Result> result = preflight_->result();
  if (!result) return std::nullopt;
  const Legacy untouched = legacy();
  const auto begun = conclude_check(*result);
  if (begun) return std::nullopt;
  return RunEnd{RunEnd::Kind::failed, StopCause::none, begun.error(), untouched};
}

void Run::feed_replay(Questions questions, std::optional<bool> input_1) {
  if (!is_present() || is_checking()) return;
  look();
  recorded_input_1_ = input_1;
  // What the lab has looked at several times for may be wanted at the next START: here all of it comes at once.
  while (feed(questions) && !has_gone_on_) {
  }
  forget_done_blocks();
}

std::optional<RunEnd> Run::poll() {
  if (!is_present()) return std::nullopt;
  look();
  if (is_checking()) return poll_check();
  feed();
  forget_done_blocks();
  if (seen_.tick < answer_tick_) return std::nullopt;
  const bool is_refused = seen_.refused + seen_.dropped > refused_before_;
  if (seen_.run != run_) return is_refused ? std::optional(finish(RunEnd::Kind::refused)) : std::nullopt;
  if (is_backing_off()) return std::nullopt;
  if (!seen_.run_active)
    return finish(seen_.cause == StopCause::program_end ? RunEnd::Kind::program_end : RunEnd::Kind::broken);
  if (!seen_.started || !failure_ || !is_path_done()) return std::nullopt;
  connection_.channel->stop(StopCause::error);
  return finish(RunEnd::Kind::failed);
}

void Run::look() {
  seen_ = connection_.channel->snapshot();
  if (seen_.run == run_) return;
  // What the snapshot still says belongs to the run before.
  seen_.sequence = seen_.finished_sequence = 0;
}

const Run::Record* Run::next_record() const {
  return state() == State::between ? record(seen_.finished_sequence + 1) : nullptr;
}

geometry::SourceBlock Run::shown_block() const {
  if (const Record* next = next_record()) return next->block.source;
  if (state() == State::between && failure_) return {failure_->program, failure_->block};
  const Record* current = record(seen_.sequence);
  // Behind a block that is done the next one has begun, also where the potentiometer lets nothing of it move (DEC-40).
  const bool has_done_all = state() == State::running && seen_.sequence <= seen_.finished_sequence;
  if (const Record* next = has_done_all ? record(seen_.finished_sequence + 1) : nullptr) current = next;
  if (current == nullptr && !records_.empty()) current = &records_.front();
  return current == nullptr ? geometry::SourceBlock{} : current->block.source;
}

bool Run::shows_blocks() const {
  const Record* next = next_record();
  const Record* current = next != nullptr ? next : record(seen_.sequence);
  return current == nullptr || current->block.is_shown;
}

bool Run::ignores_single_block() const {
  const Record* current = record(seen_.sequence);
  return current != nullptr && current->block.depth > 0 && current->block.modal.subprogram_blocks_hidden;
}

program::ModalState Run::modal() const {
  const Record* done = record(seen_.finished_sequence);
  program::ModalState modal = done == nullptr ? order_->start.modal : done->block.modal;
  const Record* begun = record(seen_.sequence);
  if (begun == nullptr || seen_.sequence <= seen_.finished_sequence) return modal;
  // F, S, T and the M functions of the block start are in force as soon as the block has begun (FST-009, FST-011).
  modal.feed_mm_per_min = begun->block.modal.feed_mm_per_min;
  modal.spindle_rpm = begun->block.modal.spindle_rpm;
  modal.tool = begun->block.modal.tool;
  if (!acts_at_block_start(begun->block.modal.m)) return modal;
  modal.m = begun->block.modal.m;
  modal.spindle = begun->block.modal.spindle;
  modal.coolant = begun->block.modal.coolant;
  return modal;
}

const program::Parameters& Run::parameters() const {
  const Record* done = record(seen_.finished_sequence);
  return done == nullptr ? *first_parameters_ : *done->parameters;
}

std::array<double, 3> Run::compensation_mm() const {
  const bool is_done = seen_.finished_sequence >= seen_.sequence;
  return is_done ? offsets_->behind(seen_.finished_sequence) : offsets_->within(seen_.sequence, seen_.path_mm);
}

Legacy Run::legacy() const { return {modal(), parameters(), compensation_mm()}; }

bool Run::sounds_alarm() const {
  if (state() != State::waiting || seen_.cause != StopCause::programmed_halt || tool_due() != 0) return false;
  const Record* current = record(seen_.sequence);
  return current != nullptr && current->has_alarm;
}

/// A halt of the block's own comes behind the tool's: then it is in the spindle already.
int Run::tool_due() const {
  if (state() != State::waiting || seen_.cause != StopCause::programmed_halt) return 0;
  const int due = tools_->due(seen_.sequence);
  return due == seen_.tool ? 0 : due;
}

}  // namespace cnclab::panel
