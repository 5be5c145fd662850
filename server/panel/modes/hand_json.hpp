// HANDBETRIEB, HANDEINGABE and TEACH IN as JSON. Private to this folder. Chosen directions are not kept: after a login
// nothing stands ready to move. Steps mean nothing to the next machine: a place is kept as the Istwert that it has now,
// and comes back as far behind the axes as it was.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "panel/modes/hand_input_mode.hpp"
#include "panel/modes/hand_mode.hpp"
#include "panel/modes/teach_in_mode.hpp"

namespace cnclab::panel {

[[nodiscard]] nlohmann::json hand_json(const HandMode& mode);
[[nodiscard]] HandMode hand_of(const nlohmann::json& json);

[[nodiscard]] nlohmann::json hand_input_json(const HandInputMode& mode);
[[nodiscard]] HandInputMode hand_input_of(const nlohmann::json& json, const ControlState& state);

/// Istwert of X, Y, Z in µm that is kept in the same text.
using KeptIstwert = std::array<std::int64_t, 3>;

[[nodiscard]] nlohmann::json teach_in_json(const TeachInMode& mode, const ControlState& state);
[[nodiscard]] TeachInMode teach_in_of(const nlohmann::json& json, const KeptIstwert& istwert_um,
                                      const ControlState& state);

[[nodiscard]] nlohmann::json taught_json(const TaughtPosition& taught, const ControlState& state);
[[nodiscard]] TaughtPosition taught_of(const nlohmann::json& json, const KeptIstwert& istwert_um,
                                       const ControlState& state);

}  // namespace cnclab::panel
