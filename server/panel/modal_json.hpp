// Modal state and parameters as JSON: in a control between two logins (state_json.hpp), and in what a run was begun
// with (STO-007).
//
//   { "plane": 0, "radius": 1, "tool_radius": 5000, "scale": [1000, 1000, 1000], "f": 1000, "t": 3, … }
//   { "4": 25000000 }      parameters other than 0, by their number
//
// Numbers are in the units of the structs. Reading takes any JSON: what is missing, of another type or out of range
// keeps its default. Who wants nothing put right writes what was read and compares.
#pragma once

#include <nlohmann/json.hpp>

#include "program/modal_state.hpp"

namespace cnclab::panel {

[[nodiscard]] nlohmann::json modal_json(const program::ModalState& modal);
[[nodiscard]] program::ModalState modal_of(const nlohmann::json& json);

[[nodiscard]] nlohmann::json parameters_json(const program::Parameters& parameters);
[[nodiscard]] program::Parameters parameters_of(const nlohmann::json& json);

}  // namespace cnclab::panel
