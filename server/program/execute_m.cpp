// M functions: what each does, and whether at the start or at the end of its block (section M, FST-009, FST-010).
#include <array>

#include "program/words.hpp"

namespace cnclab::program {

namespace {

using geometry::SpindleTurn;

void turn_spindle(BlockRun& run, SpindleTurn turn) {
  ModalState& modal = run.state.modal;
  modal.spindle = turn;
  const double rpm = turn == SpindleTurn::off ? 0 : static_cast<double>(modal.spindle_rpm);
  run.emit(geometry::Spindle{.turn = turn, .rpm = rpm});
}

void switch_coolant(BlockRun& run, bool on) {
  run.state.modal.coolant = on;
  run.emit(geometry::Coolant{.on = on});
}

void halt(BlockRun& run, int) { run.emit(geometry::Halt{.signal = false}); }
void halt_with_signal(BlockRun& run, int) { run.emit(geometry::Halt{.signal = true}); }
void end_program(BlockRun& run, int) { run.flow.kind = Flow::Kind::end; }
void spindle_clockwise(BlockRun& run, int) { turn_spindle(run, SpindleTurn::clockwise); }
void spindle_counterclockwise(BlockRun& run, int) { turn_spindle(run, SpindleTurn::counterclockwise); }
void spindle_off(BlockRun& run, int) { turn_spindle(run, SpindleTurn::off); }
void coolant_on(BlockRun& run, int) { switch_coolant(run, true); }
void coolant_off(BlockRun& run, int) { switch_coolant(run, false); }

void spindle_and_coolant_off(BlockRun& run, int) {
  turn_spindle(run, SpindleTurn::off);
  switch_coolant(run, false);
}

void clockwise_with_coolant(BlockRun& run, int) {
  turn_spindle(run, SpindleTurn::clockwise);
  switch_coolant(run, true);
}

void counterclockwise_with_coolant(BlockRun& run, int) {
  turn_spindle(run, SpindleTurn::counterclockwise);
  switch_coolant(run, true);
}

void sound_signal(BlockRun& run, int) { run.emit(geometry::Signal{}); }
void wait_for_input_1(BlockRun& run, int) { run.emit(geometry::Wait{.card = 0, .line = 0}); }

void special_functions_off(BlockRun& run, int) {
  ModalState& modal = run.state.modal;
  modal.blocks_hidden = modal.subprogram_blocks_hidden = modal.potentiometer_off = modal.test_run = false;
}

void hide_blocks(BlockRun& run, int) { run.state.modal.blocks_hidden = true; }
void hide_subprogram_blocks(BlockRun& run, int) { run.state.modal.subprogram_blocks_hidden = true; }
void potentiometer_off(BlockRun& run, int) { run.state.modal.potentiometer_off = true; }
void begin_test_run(BlockRun& run, int) { run.state.modal.test_run = true; }

// M40…M68 belong to card 1, M70…M98 to card 2; the units digit is the line, 0 means all eight (M-902).
int card_of(int code) { return code < 70 ? 1 : 2; }
void set_output(BlockRun& run, int code) {
  run.emit(geometry::Output{.card = card_of(code), .line = code % 10, .on = true});
}
void reset_output(BlockRun& run, int code) {
  run.emit(geometry::Output{.card = card_of(code), .line = code % 10, .on = false});
}
void wait_for_card(BlockRun& run, int code) { run.emit(geometry::Wait{.card = card_of(code), .line = code % 10}); }

/// One M function, or several whose codes follow each other.
struct MFunction {
  int first, last;
  void (*act)(BlockRun&, int code) = nullptr;
  Moment moment = Moment::block_end;
  bool acts_in_test_run = false;  ///< D-42, DEC-38
};

constexpr std::array kMFunctions{
    MFunction{0, 0, halt},
    MFunction{1, 1, halt_with_signal},
    MFunction{2, 2, end_program},
    MFunction{3, 3, spindle_clockwise, Moment::block_start},
    MFunction{4, 4, spindle_counterclockwise, Moment::block_start},
    MFunction{5, 5, spindle_off, Moment::block_end, true},
    MFunction{8, 8, coolant_on, Moment::block_start},
    MFunction{9, 9, coolant_off, Moment::block_end, true},
    MFunction{12, 12, spindle_and_coolant_off, Moment::block_end, true},
    MFunction{13, 13, clockwise_with_coolant, Moment::block_start},
    MFunction{14, 14, counterclockwise_with_coolant, Moment::block_start},
    MFunction{15, 15, sound_signal},
    MFunction{16, 16, wait_for_input_1},
    MFunction{20, 20, special_functions_off, Moment::block_end, true},
    MFunction{21, 21, hide_blocks, Moment::block_end, true},
    MFunction{22, 22, hide_subprogram_blocks, Moment::block_end, true},
    MFunction{23, 23, potentiometer_off, Moment::block_end, true},
    MFunction{24, 24, begin_test_run},
    MFunction{40, 48, set_output},
    MFunction{50, 58, reset_output},
    MFunction{60, 68, wait_for_card},
    MFunction{70, 78, set_output},
    MFunction{80, 88, reset_output},
    MFunction{90, 98, wait_for_card},
};

constexpr std::size_t kMCodes = 100;

constexpr std::array<const MFunction*, kMCodes> functions_by_code() {
  std::array<const MFunction*, kMCodes> table{};
  for (const MFunction& function : kMFunctions)
    for (int code = function.first; code <= function.last; ++code) table[static_cast<std::size_t>(code)] = &function;
  return table;
}

constexpr std::array<const MFunction*, kMCodes> kFunctionOf = functions_by_code();

/// The I/O card that a function needs, 0 for none (M-902).
int needed_card(int code) { return code < 40 ? 0 : card_of(code); }

/// Without its card a function has no effect and waits for nothing (D-124).
bool has_card(const Settings& settings, int card) {
  return card == 0 || settings.io_cards[static_cast<std::size_t>(card - 1)];
}

}  // namespace

void execute_m(BlockRun& run, Moment moment) {
  const language::Word* word = run.block.find(language::Address::M);
  if (word == nullptr || word->number < 0 || word->number >= static_cast<std::int64_t>(kMCodes)) return;
  const MFunction* function = kFunctionOf[static_cast<std::size_t>(word->number)];
  if (function == nullptr || function->moment != moment) return;
  if (run.state.modal.test_run && !function->acts_in_test_run) return;
  const int code = static_cast<int>(word->number);
  run.state.modal.m = code;
  if (has_card(run.settings, needed_card(code))) function->act(run, code);
}

}  // namespace cnclab::program
