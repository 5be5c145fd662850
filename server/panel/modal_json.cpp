// Field by field; structured bindings see to it that a field that is added to the state is not forgotten here.
#include "panel/modal_json.hpp"

#include <string>

#include "panel/json_readers.hpp"

namespace cnclab::panel {

namespace {

using Json = nlohmann::json;

constexpr std::int64_t kLargestRate = 99'999;  ///< of F and S
constexpr std::int64_t kLargestCode = 99;      ///< of T and M
constexpr std::int64_t kLargestFactor = 9'999'999;

template <class Enum>
Enum choice_in(const Json& json, const char* name, Enum last, Enum otherwise) {
  return static_cast<Enum>(
      integer_in(json, name, 0, static_cast<std::int64_t>(last), static_cast<std::int64_t>(otherwise)));
}

void read_scale(const Json& json, std::array<std::int64_t, 3>& scale) {
  const Json* factors = member_of(json, "scale");
  if (factors == nullptr || !factors->is_array() || factors->size() != scale.size()) return;
  for (std::size_t axis = 0; axis < scale.size(); ++axis)
    scale[axis] = integer_of((*factors)[axis], -kLargestFactor, kLargestFactor).value_or(scale[axis]);
}

}  // namespace

Json modal_json(const program::ModalState& modal) {
  const auto& [plane, radius, length, tool_radius, tool_length, scale_on, scale, dimension, feed, rpm, tool, m, spindle,
               coolant, hidden, sub_hidden, potentiometer_off, test_run] = modal;
  return {{"plane", static_cast<int>(plane)},
          {"radius", static_cast<int>(radius)},
          {"length", length},
          {"tool_radius", tool_radius.value},
          {"tool_length", tool_length.value},
          {"scale_on", scale_on},
          {"scale", scale},
          {"dimension", static_cast<int>(dimension)},
          {"f", feed},
          {"s", rpm},
          {"t", tool},
          {"m", m},
          {"spindle", static_cast<int>(spindle)},
          {"coolant", coolant},
          {"m21", hidden},
          {"m22", sub_hidden},
          {"m23", potentiometer_off},
          {"m24", test_run}};
}

program::ModalState modal_of(const Json& json) {
  program::ModalState modal;
  auto& [plane, radius, length, tool_radius, tool_length, scale_on, scale, dimension, feed, rpm, tool, m, spindle,
         coolant, hidden, sub_hidden, potentiometer_off, test_run] = modal;
  plane = choice_in(json, "plane", geometry::Plane::yz, plane);
  radius = choice_in(json, "radius", program::RadiusCompensation::minus, radius);
  length = flag_in(json, "length");
  tool_radius.value = integer_in(json, "tool_radius", 0, language::kLargestWord_um, 0);
  tool_length.value = integer_in(json, "tool_length", -language::kLargestWord_um, language::kLargestWord_um, 0);
  scale_on = flag_in(json, "scale_on");
  read_scale(json, scale);
  dimension = choice_in(json, "dimension", program::Dimension::absolute, dimension);
  if (flag_in(json, "absolute")) dimension = program::Dimension::absolute;  // so version 0.1.0 wrote it
  feed = static_cast<int>(integer_in(json, "f", 0, kLargestRate, feed));
  rpm = static_cast<int>(integer_in(json, "s", 0, kLargestRate, rpm));
  tool = static_cast<int>(integer_in(json, "t", 0, kLargestCode, tool));
  m = static_cast<int>(integer_in(json, "m", 0, kLargestCode, m));
  spindle = choice_in(json, "spindle", geometry::SpindleTurn::counterclockwise, spindle);
  coolant = flag_in(json, "coolant");
  hidden = flag_in(json, "m21");
  sub_hidden = flag_in(json, "m22");
  potentiometer_off = flag_in(json, "m23");
  test_run = flag_in(json, "m24");
  return modal;
}

Json parameters_json(const program::Parameters& parameters) {
  Json json = Json::object();
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i] != 0) json[std::to_string(i)] = parameters[i];
  return json;
}

program::Parameters parameters_of(const Json& json) {
  program::Parameters parameters{};
  for (std::size_t i = 0; i < parameters.size(); ++i)
    parameters[i] = integer_in(json, std::to_string(i).c_str(), -program::kLargestValue, program::kLargestValue, 0);
  return parameters;
}

}  // namespace cnclab::panel
