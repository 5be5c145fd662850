// The half-filled entry line and its digits as JSON. Private to this folder.
#pragma once

#include <nlohmann/json.hpp>

#include "panel/modes/editor_mode.hpp"

namespace cnclab::panel {

[[nodiscard]] nlohmann::json field_json(const DigitField& field);
void read_field(const nlohmann::json& json, const char* name, DigitField& field);

[[nodiscard]] nlohmann::json line_json(const EntryLine& line);
/// The line as it was left; words that its function does not have any more come back empty.
[[nodiscard]] EntryLine line_of(const nlohmann::json& json, bool is_tool_row, language::Plane plane,
                                const language::Vocabulary& vocabulary);

[[nodiscard]] nlohmann::json editor_json(const EditorMode& mode);
/// The mode as it was left; a line that does not fit this control any more comes back empty.
[[nodiscard]] EditorMode editor_of(const nlohmann::json& json, const ControlState& state);

}  // namespace cnclab::panel
