// Steps to µm and back, with the machine data that the machine has been given.
#include "panel/run/machine_place.hpp"

#include <cmath>

namespace cnclab::panel {

namespace {

constexpr double kMicrometresPerMm = 1000;
constexpr int kFirstStepsDatum = 14;  ///< MD 14 to 16: steps per mm of X, Y, Z

double steps_per_um(const ControlState& state, std::size_t axis) {
  const machine::MachineData data = state.applied_data ? *state.applied_data : state.effective_data();
  return static_cast<double>(data.get(kFirstStepsDatum + static_cast<int>(axis))) / kMicrometresPerMm;
}

}  // namespace

MachinePlace place_now(const ControlState& state) {
  const machine::Snapshot machine = state.machine();
  return {{machine.steps[0], machine.steps[1], machine.steps[2]}};
}

std::array<std::int64_t, 3> way_um_since(const MachinePlace& place, const ControlState& state) {
  const MachinePlace now = place_now(state);
  std::array<std::int64_t, 3> way_um{};
  for (std::size_t axis = 0; axis < way_um.size(); ++axis) {
    const double per_um = steps_per_um(state, axis);
    way_um[axis] = std::llround(static_cast<double>(now.steps[axis]) / per_um) -
                   std::llround(static_cast<double>(place.steps[axis]) / per_um);
  }
  return way_um;
}

MachinePlace place_behind(const std::array<std::int64_t, 3>& way_um, const ControlState& state) {
  MachinePlace place = place_now(state);
  for (std::size_t axis = 0; axis < way_um.size(); ++axis)
    place.steps[axis] -= std::llround(static_cast<double>(way_um[axis]) * steps_per_um(state, axis));
  return place;
}

std::array<std::int64_t, 3> istwerte_um(const ControlState& state) {
  const machine::Snapshot machine = state.machine();
  std::array<std::int64_t, 3> um{};
  for (std::size_t axis = 0; axis < um.size(); ++axis)
    um[axis] = std::llround(machine.istwert_mm[axis] * kMicrometresPerMm);
  return um;
}

std::array<std::int64_t, 3> programmed_um(const ControlState& state) {
  std::array<std::int64_t, 3> um = istwerte_um(state);
  for (std::size_t axis = 0; axis < um.size(); ++axis)
    um[axis] -= std::llround(state.compensation_mm[axis] * kMicrometresPerMm);
  return um;
}

}  // namespace cnclab::panel
