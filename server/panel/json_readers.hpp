// Values out of JSON that nobody vouches for: what is missing, of another type or out of range is told, never thrown.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

namespace cnclab::panel {

/// The member, or nullptr where `json` is no object or has none of that name.
[[nodiscard]] const nlohmann::json* member_of(const nlohmann::json& json, const char* name);
/// An integer within its limits; nothing for everything else.
[[nodiscard]] std::optional<std::int64_t> integer_of(const nlohmann::json& json, std::int64_t least, std::int64_t most);
[[nodiscard]] std::int64_t integer_in(const nlohmann::json& json, const char* name, std::int64_t least,
                                      std::int64_t most, std::int64_t otherwise);
[[nodiscard]] bool flag_in(const nlohmann::json& json, const char* name);

}  // namespace cnclab::panel
