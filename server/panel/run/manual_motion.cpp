// Tells from snapshots whether the axes still move, and why they do not.
#include "panel/run/manual_motion.hpp"

namespace cnclab::panel {

void ManualMotion::begin(const Connection& connection, Kind kind, const Directions& directions) {
  *this = ManualMotion{};
  connection_ = connection;
  kind_ = kind;
  is_present_ = true;
  seen_ = connection_.channel->snapshot();
  refused_before_ = seen_.refused + seen_.dropped;
  answer_tick_ = seen_.tick + kAnswerTicks;
  if (kind == Kind::jog)
    (void)connection_.channel->command(machine::Jog{connection_.epoch, directions});
  else
    (void)connection_.channel->command(machine::RunReference{connection_.epoch, directions});
}

void ManualMotion::stop() {
  if (!is_present_) return;
  is_stopped_ = true;
  connection_.channel->stop(machine::StopCause::operator_stop);
}

ManualMotion::State ManualMotion::state() const {
  if (!is_present_) return State::none;
  const bool brakes = is_stopped_ || seen_.state == machine::MotionState::stopping;
  return brakes ? State::braking : State::moving;
}

std::optional<ManualMotion::End> ManualMotion::poll() {
  if (!is_present_) return std::nullopt;
  seen_ = connection_.channel->snapshot();
  if (seen_.tick < answer_tick_ || seen_.started) return std::nullopt;
  const bool is_refused = !is_stopped_ && seen_.refused + seen_.dropped > refused_before_;
  const End end{kind_, is_refused, seen_.cause};
  *this = ManualMotion{};
  return end;
}

}  // namespace cnclab::panel
