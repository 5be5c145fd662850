// Writes and reads the modes that move by hand.
#include "panel/modes/hand_json.hpp"

#include "panel/json_readers.hpp"
#include "panel/modes/editor_json.hpp"

namespace cnclab::panel {

namespace {

using Json = nlohmann::json;

constexpr std::int64_t kFarthest_um = 100'000'000;

Json position_json(const std::array<std::int64_t, 3>& um) { return {um[0], um[1], um[2]}; }

void read_position(const Json& json, const char* name, std::array<std::int64_t, 3>& um) {
  const Json* position = member_of(json, name);
  if (position == nullptr || !position->is_array() || position->size() != um.size()) return;
  for (std::size_t axis = 0; axis < um.size(); ++axis)
    um[axis] = integer_of((*position)[axis], -kFarthest_um, kFarthest_um).value_or(um[axis]);
}

}  // namespace

Json hand_json(const HandMode& mode) { return {{"istwert", mode.sets_istwert}}; }

HandMode hand_of(const Json& json) {
  HandMode mode;
  mode.sets_istwert = flag_in(json, "istwert");
  return mode;
}

Json hand_input_json(const HandInputMode& mode) {
  return {{"plane", static_cast<int>(mode.plane)}, {"line", line_json(mode.line)}};
}

HandInputMode hand_input_of(const Json& json, const ControlState& state) {
  HandInputMode mode = open_hand_input(state);
  const Json* line = member_of(json, "line");
  if (line == nullptr) return mode;
  mode.plane = static_cast<language::Plane>(integer_in(json, "plane", 0, 2, static_cast<int>(mode.plane)));
  mode.line = line_of(*line, false, mode.plane, state.settings.vocabulary);
  if (mode.line.marker() == EntryLine::Marker::number) mode.line.go_to_function();
  return mode;
}

Json teach_in_json(const TeachInMode& mode) {
  return {{"program", field_json(mode.program)},
          {"open", mode.is_open},
          {"line", line_json(mode.line)},
          {"reference", position_json(mode.reference_um)}};
}

TeachInMode teach_in_of(const Json& json, const ControlState& state) {
  TeachInMode mode = open_teach_in(state);
  read_field(json, "program", mode.program);
  read_position(json, "reference", mode.reference_um);
  const Json* line = member_of(json, "line");
  const bool may_be_taught =
      mode.number() != language::kToolTable && !language::is_reserved_for_cycles(mode.number()) && line != nullptr;
  if (!may_be_taught || !flag_in(json, "open")) return mode;
  mode.line = line_of(*line, false, language::Plane::xy, state.settings.vocabulary);
  mode.is_open = mode.line.has_words_shown() && mode.line.number() > 0;
  if (mode.line.marker() == EntryLine::Marker::function) mode.line.go_to_number();
  return mode;
}

Json taught_json(const TaughtPosition& taught) {
  return {{"program", taught.program}, {"position", position_json(taught.position_um)}};
}

TaughtPosition taught_of(const Json& json) {
  TaughtPosition taught;
  taught.program = static_cast<std::uint16_t>(integer_in(json, "program", 0, language::kLastProgram, 0));
  read_position(json, "position", taught.position_um);
  return taught;
}

}  // namespace cnclab::panel
