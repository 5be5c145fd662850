// Keys of GRAFIK, and the portions in which the test run is played.
#include "panel/modes/graphics_mode.hpp"

#include <algorithm>
#include <array>

#include "drawing/path_picture.hpp"
#include "panel/run/start_check.hpp"

namespace cnclab::panel {

namespace {

using language::Error;
using language::ErrorCode;

/// Where the switches are, counted from the middle of the travel (DEC-23); without a machine it stands there.
std::array<testrun::TravelRange, 3> travel_of(const machine::Snapshot& machine, const machine::MachineData& data,
                                              geometry::Point start) {
  constexpr int kFirstSteps = 14;
  constexpr std::array kAxes{&geometry::Point::x, &geometry::Point::y, &geometry::Point::z};
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
    start.*kAxes[axis] -=
        static_cast<double>(machine.steps[axis]) / static_cast<double>(data.get(kFirstSteps + static_cast<int>(axis)));
  return testrun::travel_about(start, data);
}

/// A copy of everything that decides the course of a run begun now (DEC-28).
testrun::TestOrder order_of(const ControlState& state, const language::Program& program) {
  const machine::Snapshot machine = state.machine();
  const machine::MachineData data = state.effective_data();
  testrun::TestOrder order{.programs = state.memory.snapshot(),
                           .settings = interpreter_settings(data, state.settings.vocabulary),
                           .start = {.program = program.number,
                                     .block = program.blocks.front().number,
                                     .position = istwert_of(machine),
                                     .modal = state.modal,
                                     .parameters = state.parameters,
                                     .compensation_mm = state.compensation_mm},
                           .data = data,
                           .workpiece = drawing::workpiece_under(istwert_of(machine), state.settings.workpiece.size_mm),
                           .cell_mm = state.settings.workpiece.cell_mm};
  order.start.modal.spindle = machine.spindle;
  order.travel = travel_of(machine, data, order.start.position);
  return order;
}

bool is_behind(const GraphicsMode& mode) { return mode.is_stale || mode.is_step_due; }

/// Takes over a view that is there. One that was begun before the newest key does not answer it.
void take_view(GraphicsMode& mode) {
  auto view = mode.test->take_view();
  if (!view) return;
  mode.view = std::move(*view);
  ++mode.pictures;
  if (mode.view.has_ended) mode.is_playing = false;
  if (!is_behind(mode)) mode.is_awaited = false;
}

/// Asks for the next portion where nobody is at it.
void go_on(GraphicsMode& mode, std::uint64_t blocks) {
  take_view(mode);
  if (mode.test->is_busy() || (blocks == 0 && !is_behind(mode))) return;
  const std::uint64_t portion = mode.is_step_due ? 1 : blocks;
  mode.is_stale = mode.is_step_due = false;
  mode.test->advance(portion, mode.window);
  take_view(mode);
}

/// Blocks of one portion: with the potentiometer at 100 % as many as give a new picture several times a second, below
/// it so few that they can be followed.
std::uint64_t blocks_at(int override_percent) {
  constexpr int kAll = 100;
  constexpr std::uint64_t kAtFullSpeed = 200;
  if (override_percent >= kAll) return kAtFullSpeed;
  const int slowed = override_percent * override_percent / kAll;
  return override_percent == 0 ? 0 : static_cast<std::uint64_t>(std::max(slowed, 1));
}

void begin_test(GraphicsMode& mode, ControlState& state) {
  const auto number = static_cast<std::uint16_t>(mode.program.value.value_or(0));
  const language::Program* program = number == language::kToolTable ? nullptr : state.memory.find(number);
  mode.program.typed = 0;
  if (program == nullptr) return state.complain_cannot_run(number);
  auto test = GraphicTest::begin(order_of(state, *program), state.settings.picture_work);
  if (!test) return state.complain(test.error());
  mode.test.emplace(std::move(*test));
  mode.view = {};
  mode.finding = 0;
  mode.is_playing = mode.is_step_due = false;
  mode.is_stale = true;
  state.automat_program = number;
}

void confirm_program(GraphicsMode& mode, ControlState& state) {
  if (mode.program.value) return begin_test(mode, state);
  state.complain(ErrorCode::program_missing, std::string(text(Text::said_number_missing, state.tongue())));
}

/// START plays on; after the end it begins anew, with the programs as they are now.
void start(GraphicsMode& mode, ControlState& state) {
  if (mode.view.has_ended) begin_test(mode, state);
  if (!mode.test || mode.view.has_ended || mode.is_playing) return;
  if (mode.single_block)
    mode.is_step_due = true;
  else
    mode.is_playing = true;
}

void change_window(GraphicsMode& mode, int figure) {
  constexpr std::array kViews{drawing::View::xy, drawing::View::xz, drawing::View::yz, drawing::View::iso};
  constexpr int kCloser = 5, kFarther = 6;
  if (figure >= 1 && figure <= static_cast<int>(kViews.size()))
    mode.window.look(kViews[static_cast<std::size_t>(figure) - 1]);
  else if (figure == kCloser)
    mode.window.zoom_in();
  else if (figure == kFarther)
    mode.window.zoom_out();
  mode.is_stale = true;
}

/// ±X to the right and left; ±Y, and ±Z as well, up and down.
void pan(GraphicsMode& mode, int figure) {
  constexpr int kFirstUp = 2;
  const int sense = figure % 2 == 0 ? 1 : -1;
  figure < kFirstUp ? mode.window.pan(sense, 0) : mode.window.pan(0, sense);
  mode.is_stale = true;
}

void press_prompt(GraphicsMode& mode, ControlState& state, Effect effect, int figure) {
  if (effect == Effect::digit) mode.program.digit(figure);
  if (effect == Effect::clear) mode.program.clear();
  if (effect == Effect::enter) confirm_program(mode, state);
}

void press_picture(GraphicsMode& mode, ControlState& state, Effect effect, int figure) {
  if (effect == Effect::digit) change_window(mode, figure);
  if (effect == Effect::direction) pan(mode, figure);
  if (effect == Effect::single_block) mode.single_block = !mode.single_block;
  if (effect == Effect::single_block || effect == Effect::stop) mode.is_playing = false;
  if (effect == Effect::start) start(mode, state);
  if (effect == Effect::down && !mode.view.findings.empty())
    mode.finding = (mode.finding + 1) % mode.view.findings.size();
}

}  // namespace

GraphicsMode open_graphics(const ControlState& state) {
  GraphicsMode mode;
  mode.program.offer(state.automat_program);
  return mode;
}

Place place_of(const GraphicsMode& mode) { return mode.test ? Place::graphics : Place::graphics_program; }

void press(GraphicsMode& mode, ControlState& state, Effect effect, int figure) {
  mode.test ? press_picture(mode, state, effect, figure) : press_prompt(mode, state, effect, figure);
  if (!mode.test || !is_behind(mode)) return;
  mode.is_awaited = !mode.is_playing;  // while it plays one picture follows the other anyway
  go_on(mode, 0);
}

void order_picture(GraphicsMode& mode) { mode.is_picture_wanted = mode.test.has_value(); }

void follow(GraphicsMode& mode, ControlState& state) {
  if (!mode.test) return;
  if (auto files = mode.test->take_files()) state.picture = std::move(*files);
  if (mode.is_picture_wanted && !mode.test->is_busy()) {
    mode.is_picture_wanted = false;
    take_view(mode);
    return mode.test->draw_files(mode.window.view, state.tongue());
  }
  go_on(mode, mode.is_playing ? blocks_at(state.override_percent) : 0);
}

}  // namespace cnclab::panel
