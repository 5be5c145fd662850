// Values out of JSON, looked at before they are taken.
#include "panel/json_readers.hpp"

namespace cnclab::panel {

using Json = nlohmann::json;

const Json* member_of(const Json& json, const char* name) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find(name);
  return found == json.end() ? nullptr : &*found;
}

std::optional<std::int64_t> integer_of(const Json& json, std::int64_t least, std::int64_t most) {
  if (!json.is_number_integer()) return std::nullopt;
  if (json.is_number_unsigned() && json.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX))
    return std::nullopt;
  const auto value = json.get<std::int64_t>();
  return value >= least && value <= most ? std::optional(value) : std::nullopt;
}

std::int64_t integer_in(const Json& json, const char* name, std::int64_t least, std::int64_t most,
                        std::int64_t otherwise) {
  const Json* member = member_of(json, name);
  return member == nullptr ? otherwise : integer_of(*member, least, most).value_or(otherwise);
}

bool flag_in(const Json& json, const char* name) {
  const Json* member = member_of(json, name);
  return member != nullptr && member->is_boolean() && member->get<bool>();
}

}  // namespace cnclab::panel
