// Writes and reads the modes that move by hand.
#include "panel/modes/hand_json.hpp"

#include "panel/json_readers.hpp"
#include "panel/modes/editor_json.hpp"
#include "panel/run/machine_place.hpp"

namespace cnclab::panel {

namespace {

using Json = nlohmann::json;

constexpr std::int64_t kFarthest_um = 100'000'000;

Json place_json(const MachinePlace& place, const ControlState& state) {
  const auto istwert_um = istwerte_um(state), way_um = way_um_since(place, state);
  return {istwert_um[0] - way_um[0], istwert_um[1] - way_um[1], istwert_um[2] - way_um[2]};
}

/// What cannot be read is no way: the place is where the axes stand.
MachinePlace place_in(const Json& json, const char* name, const KeptIstwert& istwert_um, const ControlState& state) {
  const Json* position = member_of(json, name);
  std::array<std::int64_t, 3> way_um{};
  if (position == nullptr || !position->is_array() || position->size() != way_um.size()) return place_now(state);
  for (std::size_t axis = 0; axis < way_um.size(); ++axis)
    if (const auto um = integer_of((*position)[axis], -kFarthest_um, kFarthest_um))
      way_um[axis] = istwert_um[axis] - *um;
  return place_behind(way_um, state);
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

Json teach_in_json(const TeachInMode& mode, const ControlState& state) {
  return {{"program", field_json(mode.program)},
          {"open", mode.is_open},
          {"line", line_json(mode.line)},
          {"reference", place_json(mode.reference, state)}};
}

TeachInMode teach_in_of(const Json& json, const KeptIstwert& istwert_um, const ControlState& state) {
  TeachInMode mode = open_teach_in(state);
  read_field(json, "program", mode.program);
  mode.reference = place_in(json, "reference", istwert_um, state);
  const Json* line = member_of(json, "line");
  const bool may_be_taught =
      mode.number() != language::kToolTable && !language::is_reserved_for_cycles(mode.number()) && line != nullptr;
  if (!may_be_taught || !flag_in(json, "open")) return mode;
  mode.line = line_of(*line, false, language::Plane::xy, state.settings.vocabulary);
  mode.is_open = mode.line.has_words_shown() && mode.line.number() > 0;
  if (mode.line.marker() == EntryLine::Marker::function) mode.line.go_to_number();
  return mode;
}

Json taught_json(const TaughtPosition& taught, const ControlState& state) {
  return {{"program", taught.program}, {"position", place_json(taught.place, state)}};
}

TaughtPosition taught_of(const Json& json, const KeptIstwert& istwert_um, const ControlState& state) {
  TaughtPosition taught;
  taught.program = static_cast<std::uint16_t>(integer_in(json, "program", 0, language::kLastProgram, 0));
  taught.place = place_in(json, "position", istwert_um, state);
  return taught;
}

}  // namespace cnclab::panel
