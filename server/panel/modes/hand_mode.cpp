// Keys and screen of HANDBETRIEB.
#include "panel/modes/hand_mode.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "language/screen_form.hpp"
#include "panel/screen/motion_screen.hpp"
#include "panel/screen/names.hpp"

namespace cnclab::panel {

namespace {

constexpr double kUmPerMm = 1000;

/// What is typed stands in the counter at once (KEY-060).
void set_istwert(const HandMode& mode, ControlState& state) {
  if (!state.connection.channel) return;
  const auto word = mode.value.word();
  machine::SetIstwert command{state.connection.epoch, {}, {}};
  command.axes[*mode.axis] = true;
  command.value_mm[*mode.axis] = word ? word->number / kUmPerMm : 0;
  state.is_switching = true;
  (void)state.connection.channel->command(command);
}

void press_value(HandMode& mode, ControlState& state, Effect effect, int figure) {
  switch (effect) {
    case Effect::digit:
      mode.value.digit(figure);
      break;
    case Effect::point:
      mode.value.point();
      break;
    case Effect::sign:
      mode.value.sign();
      break;
    case Effect::clear:
      mode.value.clear();
      break;
    default:
      return;
  }
  set_istwert(mode, state);
}

void toggle_sub_mode(HandMode& mode) {
  mode.sets_istwert = !mode.sets_istwert;
  mode.axis.reset();
  mode.driving.directions = {};
}

/// The fields that light up (D-19).
void draw_fields(const HandMode& mode, const ControlState& state, Monitor& monitor) {
  constexpr int kRow = 6;
  const machine::Snapshot machine = state.machine();
  struct Field {
    Key key;
    int column;
    bool is_lit;
  };
  const bool is_reference = mode.driving.is_moving() && mode.driving.motion.kind() == ManualMotion::Kind::reference;
  const std::array fields{Field{Key::ISTWERT, 0, mode.sets_istwert}, Field{Key::REFERENZ, 10, is_reference},
                          Field{Key::FRAESER, 21, machine.spindle != geometry::SpindleTurn::off},
                          Field{Key::KUEHLMITTEL, 30, machine.coolant}};
  for (const Field& field : fields)
    monitor.write(kRow, field.column, label_of(field.key), field.is_lit ? Attribute::inverse : Attribute::normal);
}

/// The counter that is being set, with the marker on its letter. Until the machine has taken the value, the typed one.
void draw_value(const HandMode& mode, const ControlState& state, Monitor& monitor) {
  const int row = kIstwertRow + static_cast<int>(*mode.axis);
  monitor.mark(row, kIstwertColumn);
  const bool is_under_way = state.connection.channel && !state.connection.channel->is_settled();
  if (!is_under_way) return;
  const auto word = mode.value.word();
  constexpr int kValueOffset = 3;
  monitor.write(row, kIstwertColumn + kValueOffset, language::istwert_text({word ? word->number : 0}));
}

}  // namespace

HandMode open_hand(const ControlState&) { return {}; }

void close(HandMode& mode, ControlState&) { close(mode.driving); }

void choose_axis(HandMode& mode, const ControlState& state, std::size_t axis) {
  constexpr std::array kAxes{language::Address::X, language::Address::Y, language::Address::Z};
  mode.axis = axis;
  const std::int64_t um = std::clamp<std::int64_t>(std::llround(state.machine().istwert_mm[axis] * kUmPerMm),
                                                   -language::kLargestWord_um, language::kLargestWord_um);
  const language::Word word{kAxes.at(axis), false, static_cast<std::int32_t>(um)};
  mode.value = WordEntry::of(word.address, &word);
}

Place place_of(const HandMode& mode) {
  if (mode.driving.is_moving())
    return mode.driving.motion.kind() == ManualMotion::Kind::jog ? Place::hand_moving : Place::hand_reference;
  if (!mode.sets_istwert) return Place::hand_ready;
  return mode.axis ? Place::hand_value : Place::hand_istwert;
}

void press(HandMode& mode, ControlState& state, Effect effect, int figure) {
  mode.is_referenced_now = false;
  if (effect == Effect::istwert) return toggle_sub_mode(mode);
  if (!mode.sets_istwert) return press(mode.driving, state, effect, figure);
  if (effect == Effect::direction) return choose_axis(mode, state, direction_of(figure).axis);
  if (effect == Effect::spindle || effect == Effect::coolant) return press(mode.driving, state, effect, figure);
  if (mode.axis) press_value(mode, state, effect, figure);
}

void follow(HandMode& mode, ControlState& state) {
  const auto end = follow(mode.driving, state);
  if (!end || end->kind != ManualMotion::Kind::reference || end->is_refused) return;
  if (end->cause == machine::StopCause::operator_stop) state.next_mode = Mode::menu;  // MOD-013
  if (end->cause == machine::StopCause::program_end) mode.is_referenced_now = true;
  if (end->cause == machine::StopCause::error) state.message.sentence = text(Text::said_switch_stuck, state.tongue());
}

void draw(const HandMode& mode, const ControlState& state, Monitor& monitor) {
  draw(mode.driving, state, monitor);
  draw_fields(mode, state, monitor);
  if (mode.axis) draw_value(mode, state, monitor);
}

std::string sentence_of(const HandMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  if (mode.sets_istwert && !mode.axis) return std::string(text(Text::wait_istwert_axis, tongue));
  if (mode.sets_istwert) return text(Text::wait_istwert_value, tongue, {std::string_view("XYZ").substr(*mode.axis, 1)});
  if (mode.is_referenced_now) return std::string(text(Text::wait_referenced, tongue));
  return sentence_of(mode.driving, state, Text::wait_hand, Text::wait_chosen);
}

}  // namespace cnclab::panel
