// A person's place: made at login, gone at log-out.
#include "lab/desk.hpp"

#include <stdexcept>
#include <utility>

namespace cnclab::lab {

namespace {
/// A training machine has one user: its grant is made once and never ends while the desk lives.
constexpr machine::Epoch kTrainingEpoch{1};
}  // namespace

Desk::Desk(db::Person who, const panel::Settings& settings, panel::Memory memory, const machine::MachineData& data,
           machine::TickThread& ticks, machine::WorkpieceThread& workpieces, db::Store& store)
    : person(std::move(who)),
      control(settings, std::move(memory), data),
      ticks_(ticks),
      workpieces_(workpieces),
      site_(workpieces.add(control.workpiece())),
      machine_data_(data),
      machine_(data),
      training_(std::make_shared<machine::Channel>(machine_, data)) {
  recorder = std::make_unique<RunRecorder>(store, training_, RunRecorder::Keeps::digest);
  training_->grant(kTrainingEpoch, machine::kNeverExpires);
  training_->feed_cuts(&site_->feed());
  if (!ticks_.add(training_)) throw std::runtime_error("every place at the tick is taken");
  connect_training();
}

Desk::~Desk() { leave_machines(); }

void Desk::leave_machines() {
  if (std::exchange(has_left_machines_, true)) return;
  ticks_.remove(training_);
  workpieces_.remove(site_);
}

void Desk::connect_training() {
  on_lab_machine = false;
  control.connect({training_, kTrainingEpoch, false, {}});
  is_dirty = true;
}

void Desk::stop_training() { training_->stop(machine::StopCause::operator_stop); }

void Desk::settle_machine_data() {
  if (control.data() == machine_data_) return;
  const machine::Snapshot now = training_->snapshot();
  const bool at_rest = now.state == machine::MotionState::standstill || now.state == machine::MotionState::off;
  if (now.started || !at_rest) return;
  machine_data_ = control.data();
  machine_.set_data(machine_data_);
}

void Desk::set_workpiece(const machine::WorkpieceSpec& spec) {
  site_->set_spec(spec);
  control.set_workpiece(spec);
}

bool Desk::awaits_effect() const {
  return control.awaits_effect() || (stopping && stopping->channel->snapshot().tick < stopping->heeded_at_tick);
}

std::uint64_t Desk::handled() const {
  if (storing && *storing > 0) return *storing - 1;
  if (switching && *switching > 0) return *switching - 1;
  for (const Input& input : waiting)
    if (input.number > 0) return input.number - 1;
  return received;
}

}  // namespace cnclab::lab
