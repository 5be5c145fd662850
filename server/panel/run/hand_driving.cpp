// Direction keys, motion, spindle and coolant without a program.
#include "panel/run/hand_driving.hpp"

#include <algorithm>

#include "panel/run/run_end.hpp"
#include "panel/run/start_check.hpp"
#include "panel/screen/motion_screen.hpp"

namespace cnclab::panel {

namespace {

using geometry::SpindleTurn;

/// D-10: the same key deselects, the opposite one replaces.
void press_direction(HandDriving& driving, int figure) {
  const DirectionKey key = direction_of(figure);
  std::int8_t& chosen = driving.directions[key.axis];
  chosen = chosen == key.sign ? std::int8_t{0} : key.sign;
}

void begin(HandDriving& driving, ControlState& state, ManualMotion::Kind kind) {
  if (!driving.has_direction()) {
    state.hint = text(Text::said_no_direction, state.tongue());
    return;
  }
  if (!may_move(state)) return;
  driving.motion.begin(state.connection, kind, driving.directions);
}

/// Without current nothing can be switched on; row 18 says so.
bool may_switch(ControlState& state) {
  if (are_drives_off(state)) state.hint = drives_off_sentence(state);
  return state.connection.channel && !are_drives_off(state);
}

/// D-12: clockwise, or as last programmed; the M of the status line stays.
void toggle_spindle(ControlState& state) {
  if (!may_switch(state)) return;
  const bool is_on = state.machine().spindle != SpindleTurn::off;
  state.modal.spindle = is_on ? SpindleTurn::off : state.last_turn;
  state.is_switching = true;
  const geometry::Spindle spindle{state.modal.spindle, static_cast<double>(is_on ? 0 : state.modal.spindle_rpm)};
  (void)state.connection.channel->command(machine::SwitchSpindle{state.connection.epoch, spindle});
}

void toggle_coolant(ControlState& state) {
  if (!may_switch(state)) return;
  state.modal.coolant = !state.machine().coolant;
  state.is_switching = true;
  (void)state.connection.channel->command(machine::SwitchCoolant{state.connection.epoch, state.modal.coolant});
}

/// Is one of the chosen directions one whose switch is active? Then the machine refuses to move (D-117).
bool is_at_switch(const HandDriving& driving, const machine::Snapshot& machine) {
  for (std::size_t axis = 0; axis < driving.directions.size(); ++axis)
    if (driving.directions[axis] != 0 && machine.limit[axis]) return true;
  return false;
}

}  // namespace

DirectionKey direction_of(int figure) {
  return {static_cast<std::size_t>(figure / 2), figure % 2 == 0 ? std::int8_t{1} : std::int8_t{-1}};
}

void press(HandDriving& driving, ControlState& state, Effect effect, int figure) {
  switch (effect) {
    case Effect::direction:
      return press_direction(driving, figure);
    case Effect::start:
      return begin(driving, state, ManualMotion::Kind::jog);
    case Effect::reference:
      return begin(driving, state, ManualMotion::Kind::reference);
    case Effect::stop:
      driving.motion.stop();
      if (!driving.is_moving()) driving.directions = {};
      return;
    case Effect::spindle:
      return toggle_spindle(state);
    case Effect::coolant:
      return toggle_coolant(state);
    default:
      return;
  }
}

std::optional<ManualMotion::End> follow(HandDriving& driving, ControlState& state) {
  const auto end = driving.motion.poll();
  if (!end) return std::nullopt;
  state.hint.clear();
  if (end->is_refused) {
    const bool at_switch = is_at_switch(driving, state.machine());
    state.message.sentence = text(at_switch ? Text::said_towards_switch : Text::said_start_refused, state.tongue());
  } else if (end->cause != machine::StopCause::limit_switch) {
    tell_break(state, end->cause);  // `Endschalter` stands as long as the switch is active, not until the next key
  }
  driving.directions = {};
  return end;
}

void close(HandDriving& driving) {
  driving.motion.stop();
  driving = HandDriving{};
}

void draw(const HandDriving& driving, const ControlState& state, Monitor& monitor) {
  constexpr int kFirstColumn = 10, kColumns = 4;
  const machine::Snapshot machine = state.machine();
  draw_start_and_stop(driving.is_moving(), kLowStartRow, monitor);
  constexpr std::array<std::string_view, 6> kKeys{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  for (int figure = 0; figure < 6; ++figure) {
    const DirectionKey key = direction_of(figure);
    const bool is_chosen = driving.directions[key.axis] == key.sign;
    monitor.write(kIstwertRow + static_cast<int>(key.axis), kFirstColumn + figure % 2 * kColumns,
                  kKeys[static_cast<std::size_t>(figure)], is_chosen ? Attribute::inverse : Attribute::normal);
  }
  draw_istwerte(machine, monitor);
  const bool is_reference = driving.is_moving() && driving.motion.kind() == ManualMotion::Kind::reference;
  if (is_reference || machine.state == machine::MotionState::off) return;  // D-117, ERR-021
  for (std::size_t axis = 0; axis < machine.limit.size(); ++axis)
    if (machine.limit[axis])
      monitor.write(Monitor::kMessageRow, limit_column(axis), text(Text::limit_switch, state.tongue()));
}

std::string sentence_of(const HandDriving& driving, const ControlState& state, Text ready, Text chosen_text) {
  const language::Tongue tongue = state.tongue();
  if (driving.motion.state() == ManualMotion::State::braking) return std::string(text(Text::wait_axes_brake, tongue));
  if (driving.is_moving()) {
    const bool is_jog = driving.motion.kind() == ManualMotion::Kind::jog;
    return std::string(text(is_jog ? Text::wait_hand_moving : Text::wait_reference, tongue));
  }
  const machine::Snapshot machine = state.machine();
  if (std::ranges::find(machine.limit, true) != machine.limit.end())
    return std::string(text(Text::wait_off_switch, tongue));
  if (!driving.has_direction()) return std::string(text(ready, tongue));
  std::string chosen;
  for (std::size_t axis = 0; axis < driving.directions.size(); ++axis) {
    if (driving.directions[axis] == 0) continue;
    chosen += chosen.empty() ? "" : " ";
    chosen += driving.directions[axis] > 0 ? '+' : '-';
    chosen += "XYZ"[axis];
  }
  return text(chosen_text, tongue, {chosen});
}

}  // namespace cnclab::panel
