// HANDBETRIEB, HANDEINGABE and TEACH IN as JSON. Private to this folder. Chosen directions are not kept: after a login
// nothing stands ready to move.
#pragma once

#include <nlohmann/json.hpp>

#include "panel/modes/hand_input_mode.hpp"
#include "panel/modes/hand_mode.hpp"
#include "panel/modes/teach_in_mode.hpp"

namespace cnclab::panel {

[[nodiscard]] nlohmann::json hand_json(const HandMode& mode);
[[nodiscard]] HandMode hand_of(const nlohmann::json& json);

[[nodiscard]] nlohmann::json hand_input_json(const HandInputMode& mode);
[[nodiscard]] HandInputMode hand_input_of(const nlohmann::json& json, const ControlState& state);

[[nodiscard]] nlohmann::json teach_in_json(const TeachInMode& mode);
[[nodiscard]] TeachInMode teach_in_of(const nlohmann::json& json, const ControlState& state);

[[nodiscard]] nlohmann::json taught_json(const TaughtPosition& taught);
[[nodiscard]] TaughtPosition taught_of(const nlohmann::json& json);

}  // namespace cnclab::panel
