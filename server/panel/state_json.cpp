// JSON out and in. Nothing that is read is trusted.
#include "panel/state_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "panel/json_readers.hpp"
#include "panel/key_table.hpp"
#include "panel/modal_json.hpp"
#include "panel/modes/editor_json.hpp"
#include "panel/modes/hand_json.hpp"
#include "program/rebuild_modal.hpp"

namespace cnclab::panel {

namespace {

using Json = nlohmann::json;

constexpr std::int64_t kLargestOffset_s = 200LL * 366 * 86'400;  // two centuries
constexpr double kLargestIstwert_mm = 99'999.999;                ///< a counter goes on behind what can be typed

/// Three lengths in mm; nothing where the text has no such row of three.
std::optional<std::array<double, 3>> lengths_in(const Json& json, const char* name) {
  const Json* row = member_of(json, name);
  std::array<double, 3> mm{};
  if (row == nullptr || !row->is_array() || row->size() != mm.size()) return std::nullopt;
  for (std::size_t axis = 0; axis < mm.size(); ++axis)
    if (const Json& value = (*row)[axis]; value.is_number())
      mm[axis] = std::clamp(value.get<double>(), -kLargestIstwert_mm, kLargestIstwert_mm);
  return mm;
}

KeptIstwert in_um(const std::array<double, 3>& mm) {
  constexpr double kUmPerMm = 1000;
  return {std::llround(mm[0] * kUmPerMm), std::llround(mm[1] * kUmPerMm), std::llround(mm[2] * kUmPerMm)};
}

Json automat_json(const AutomatMode& mode) {
  return {{"phase", static_cast<int>(mode.phase)},
          {"program", field_json(mode.program)},
          {"block", field_json(mode.block)}};
}

AutomatMode automat_of(const Json& json, const ControlState& state) {
  AutomatMode mode;
  read_field(json, "program", mode.program);
  read_field(json, "block", mode.block);
  const auto phase = static_cast<AutomatMode::Phase>(integer_in(json, "phase", 0, 2, 0));
  const language::Program* program = state.memory.find(mode.program_number());
  if (program == nullptr || mode.program_number() == language::kToolTable) return mode;
  const bool has_block = program->find(mode.block_number()).has_value();
  mode.phase = phase == AutomatMode::Phase::ready && !has_block ? AutomatMode::Phase::block : phase;
  prepare_start(mode, state);
  return mode;
}

/// The prompt alone: what was being transferred, or released for a remote start, is over, and C for everything has to
/// be pressed again.
Json external_data_json(const ExternalDataMode& mode) {
  if (mode.phase != ExternalDataMode::Phase::program) return Json::object();
  return {{"device", static_cast<int>(*mode.device)},
          {"program", field_json(mode.program)},
          {"data", mode.adopts_machine_data}};
}

/// Whether the device is still connected shows when it is to do something.
ExternalDataMode external_data_of(const Json& json, const ControlState& state) {
  ExternalDataMode mode = open_external_data(state);
  const auto device = integer_in(json, "device", 0, static_cast<int>(Device::computer_in), 0);
  if (device == 0) return mode;
  mode.device = static_cast<Device>(device);
  mode.phase = ExternalDataMode::Phase::program;
  read_field(json, "program", mode.program);
  mode.adopts_machine_data = flag_in(json, "data") && mode.device >= Device::cassette_in;
  return mode;
}

/// Lines of what was erased are those of one session; C has to be pressed again.
EraseMemoryMode erase_memory_of(const Json& json) {
  EraseMemoryMode mode;
  read_field(json, "program", mode.program);
  return mode;
}

GraphicsMode graphics_of(const Json& json, const ControlState& state) {
  GraphicsMode mode = open_graphics(state);
  read_field(json, "program", mode.program);
  return mode;
}

/// The datum that stood there, with what was typed of it.
MachineDataMode machine_data_of(const Json& json, const ControlState& state) {
  constexpr int kTime = 1, kDate = 2;
  MachineDataMode mode = open_machine_data(state);
  const auto number = static_cast<int>(integer_in(json, "number", 1, 99, kTime));
  if (has_datum(number)) show_datum(mode, state, number);
  DigitField typed = mode.value;
  read_field(json, "value", typed);
  if (typed.typed > 0)
    mode.value = typed;
  else
    mode.awaits_clock = mode.number == kTime || mode.number == kDate;
  return mode;
}

/// Has the control a key that opens the mode? The model may have been changed since (MODEL-003).
bool is_there(Mode mode, const ControlState& state) {
  const bool opens = effect_of(Place::menu, Key::GRAFIK, state.settings.vocabulary) == Effect::open_graphics;
  return mode != Mode::graphics || opens;
}

/// The state may be one of the other model: what the control has no function for is over, and where it has no
/// compensation nothing is left to be led back (MODEL-007, MODEL-009, MODEL-010).
void fit_to_model(ControlState& state) {
  state.modal = program::within(state.modal, state.settings.vocabulary);
  if (state.settings.vocabulary.model == language::Model::cnc3250) state.compensation_mm = {};
}

void read_clock(const Json& json, PanelClock& clock) {
  clock.set_offset_s(integer_in(json, "clock_offset", -kLargestOffset_s, kLargestOffset_s, 0));
  const Json* standing = member_of(json, "clock");
  if (standing == nullptr || !standing->is_object()) return;
  clock.stand_at({integer_in(*standing, "seconds", 0, kLargestOffset_s, 0), flag_in(*standing, "date")});
}

std::optional<Mode> mode_named(const Json& json) {
  const Json* name = member_of(json, "mode");
  if (name == nullptr || !name->is_string()) return std::nullopt;
  for (int i = 0; i < kModes; ++i)
    if (name->get_ref<const std::string&>() == name_of(static_cast<Mode>(i))) return static_cast<Mode>(i);
  return std::nullopt;
}

ActiveMode active_mode_of(Mode mode, const Json& json, const KeptIstwert& istwert_um, ControlState& state) {
  static const Json kNothing = Json::object();
  const auto part = [&](const char* name) -> const Json& {
    const Json* found = member_of(json, name);
    return found == nullptr ? kNothing : *found;
  };
  if (mode == Mode::editor) return editor_of(part("editor"), state);
  if (mode == Mode::automat) return automat_of(part("automat"), state);
  if (mode == Mode::erase_memory) return erase_memory_of(part("erase_memory"));
  if (mode == Mode::external_data) return external_data_of(part("external_data"), state);
  if (mode == Mode::hand) return hand_of(part("hand"));
  if (mode == Mode::hand_input) return hand_input_of(part("hand_input"), state);
  if (mode == Mode::teach_in) return teach_in_of(part("teach_in"), istwert_um, state);
  if (mode == Mode::graphics) return graphics_of(part("graphics"), state);
  if (mode == Mode::machine_data) return machine_data_of(part("machine_data"), state);
  return open_mode(mode, state);
}

}  // namespace

std::string write_state(const ActiveMode& mode, const ControlState& state) {
  const Legacy legacy =
      state.run.is_present() ? state.run.legacy() : Legacy{state.modal, state.parameters, state.compensation_mm};
  const std::array<double, 3>& offset_mm = legacy.compensation_mm;
  const machine::Snapshot machine = state.machine();
  Json json{{"v", 1},
            {"mode", name_of(mode_of(mode))},
            {"override", state.override_percent},
            {"modal", modal_json(legacy.modal)},
            {"parameters", parameters_json(legacy.parameters)},
            {"istwert", {machine.istwert_mm[0], machine.istwert_mm[1], machine.istwert_mm[2]}},
            {"editor_program", state.editor_program},
            {"automat_program", state.automat_program},
            {"compensation", {offset_mm[0], offset_mm[1], offset_mm[2]}},
            {"clock_offset", state.clock.offset_s()},
            {"taught", taught_json(state.taught, state)}};
  if (const auto clock = state.clock.standing(state.now))
    json["clock"] = {{"seconds", clock->seconds}, {"date", clock->has_date}};
  if (const auto* erase = std::get_if<EraseMemoryMode>(&mode))
    json["erase_memory"]["program"] = field_json(erase->program);
  if (const auto* external = std::get_if<ExternalDataMode>(&mode))
    json["external_data"] = external_data_json(*external);
  if (const auto* hand = std::get_if<HandMode>(&mode)) json["hand"] = hand_json(*hand);
  if (const auto* input = std::get_if<HandInputMode>(&mode)) json["hand_input"] = hand_input_json(*input);
  if (const auto* teach_in = std::get_if<TeachInMode>(&mode)) json["teach_in"] = teach_in_json(*teach_in, state);
  if (const auto* editor = std::get_if<EditorMode>(&mode)) json["editor"] = editor_json(*editor);
  if (const auto* automat = std::get_if<AutomatMode>(&mode)) json["automat"] = automat_json(*automat);
  if (const auto* graphics = std::get_if<GraphicsMode>(&mode))
    json["graphics"]["program"] = field_json(graphics->program);
  if (const auto* data = std::get_if<MachineDataMode>(&mode))
    json["machine_data"] = {{"number", data->number}, {"value", field_json(data->value)}};
  return json.dump();
}

ReadState read_state(const std::string& text, ControlState& state) {
  ReadState read;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return read;
  state.override_percent = static_cast<int>(integer_in(json, "override", 0, 100, state.override_percent));
  // Always in STOP, spindle and coolant off, as the machine is (SEAT-004).
  if (const Json* modal = member_of(json, "modal")) state.modal = with_tools_off(modal_of(*modal));
  if (const Json* parameters = member_of(json, "parameters")) state.parameters = parameters_of(*parameters);
  state.editor_program = static_cast<std::uint16_t>(integer_in(json, "editor_program", 0, language::kLastProgram, 1));
  state.automat_program = static_cast<std::uint16_t>(integer_in(json, "automat_program", 0, language::kLastProgram, 1));
  read_clock(json, state.clock);
  read.istwert_mm = lengths_in(json, "istwert");
  const KeptIstwert istwert_um = in_um(read.istwert_mm.value_or(std::array<double, 3>{}));
  if (const Json* taught = member_of(json, "taught")) state.taught = taught_of(*taught, istwert_um, state);
  state.compensation_mm = lengths_in(json, "compensation").value_or(state.compensation_mm);
  fit_to_model(state);
  if (const auto mode = mode_named(json); mode && is_there(*mode, state))
    read.mode = active_mode_of(*mode, json, istwert_um, state);
  return read;
}

}  // namespace cnclab::panel
