// The half-filled entry line as JSON, and the readers that every part of the state uses. Private to this folder.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "panel/modes/editor_mode.hpp"

namespace cnclab::panel {

/// The member, or nullptr where `json` is no object or has none of that name.
[[nodiscard]] const nlohmann::json* member_of(const nlohmann::json& json, const char* name);
/// An integer within its limits; nothing for everything else.
[[nodiscard]] std::optional<std::int64_t> integer_of(const nlohmann::json& json, std::int64_t least, std::int64_t most);
[[nodiscard]] std::int64_t integer_in(const nlohmann::json& json, const char* name, std::int64_t least,
                                      std::int64_t most, std::int64_t otherwise);
[[nodiscard]] bool flag_in(const nlohmann::json& json, const char* name);

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
