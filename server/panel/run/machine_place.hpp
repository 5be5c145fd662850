// A place on the machine, whatever the operator calls it: what TEACH IN measures ways from.
//
// The Istwert is a name that ISTWERT, REFERENZ, G68, G69 and a limit switch give anew while nothing has moved (D-116);
// the difference of two names is no way. Steps are the truth, and only of one machine: a change of machine ends it.
#pragma once

#include <array>
#include <cstdint>

#include "panel/control_state.hpp"

namespace cnclab::panel {

/// Where X, Y and Z of the connected machine stand.
[[nodiscard]] MachinePlace place_now(const ControlState& state);

/// The way from `place` to where the axes stand, in µm. The ways between several places add up to that between the
/// first and the last: nothing is lost by rounding.
[[nodiscard]] std::array<std::int64_t, 3> way_um_since(const MachinePlace& place, const ControlState& state);

/// The place that lies so far behind the axes, to the nearest step: for a place that was kept as a way.
[[nodiscard]] MachinePlace place_behind(const std::array<std::int64_t, 3>& way_um, const ControlState& state);

/// What the operator reads of X, Y and Z, in µm.
[[nodiscard]] std::array<std::int64_t, 3> istwerte_um(const ControlState& state);

/// The words X, Y and Z of a block under G90 that ends here, in µm: what the operator reads, without the offset
/// of G41 to G46 in which the tool stands, since the block will have it again (MOD-041, MOD-043).
[[nodiscard]] std::array<std::int64_t, 3> programmed_um(const ControlState& state);

}  // namespace cnclab::panel
