// The screen of EXTERNE DATEN (Bild 6).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "panel/modes/external_data_mode.hpp"

namespace cnclab::panel {

namespace {

constexpr int kInputColumn = 27, kFirstRow = 3, kProgramRow = 8, kFunctionRow = 10, kRecorderRow = 11, kLineRow = 12,
              kReleaseRow = 13;

struct DeviceRow {
  Device device;
  Text name;
  int row, column;
};
constexpr std::array kDevices{DeviceRow{Device::printer, Text::device_printer, 0, 0},
                              DeviceRow{Device::cassette_out, Text::device_cassette, 1, 0},
                              DeviceRow{Device::tape_out, Text::device_tape, 2, 0},
                              DeviceRow{Device::disk_out, Text::device_disk, 3, 0},
                              DeviceRow{Device::computer_out, Text::device_computer, 4, 0},
                              DeviceRow{Device::cassette_in, Text::device_cassette, 0, kInputColumn},
                              DeviceRow{Device::tape_in, Text::device_tape, 1, kInputColumn},
                              DeviceRow{Device::disk_in, Text::device_disk, 2, kInputColumn},
                              DeviceRow{Device::computer_in, Text::device_computer, 3, kInputColumn}};

constexpr std::array kNotOn3250{Device::printer, Device::tape_out, Device::tape_in};  // their lines stay blank (D-126)

/// Every device with its marker field; the chosen one's is lit (SCR-045, SCR-047).
void draw_devices(const ExternalDataMode& mode, const ControlState& state, Monitor& monitor) {
  constexpr int kNameColumn = 2;
  const language::Tongue tongue = state.tongue();
  const bool is_3250 = state.settings.vocabulary.model == language::Model::cnc3250;
  monitor.write(kFirstRow - 1, 0, text(Text::external_output, tongue));
  monitor.write(kFirstRow - 1, kInputColumn, text(Text::external_input, tongue));
  for (const DeviceRow& row : kDevices) {
    if (is_3250 && std::ranges::count(kNotOn3250, row.device) > 0) continue;
    const bool is_chosen = mode.device == row.device;
    monitor.put(kFirstRow + row.row, row.column, U'□', is_chosen ? Attribute::inverse : Attribute::normal);
    monitor.write(kFirstRow + row.row, row.column + kNameColumn,
                  fmt::format("{} {}", static_cast<int>(row.device), text(row.name, tongue)));
  }
}

void draw_recorder(const ControlState& state, Monitor& monitor) {
  if (!state.recorder) return;
  const transfer::CassetteDeck& recorder = *state.recorder;
  const auto lamp = [](bool is_on) { return is_on ? "●" : "○"; };
  monitor.write(
      kRecorderRow, 0,
      text(Text::recorder, state.tongue(),
           {fmt::format("{:03}", recorder.counter()), lamp(recorder.motor_runs()), lamp(recorder.led_is_on())}));
}

/// The number that is asked for; before a device is chosen the one that will be offered (SCR-046).
void draw_prompt(const ExternalDataMode& mode, const ControlState& state, Monitor& monitor) {
  const std::string_view label = text(Text::program_number, state.tongue());
  const std::optional<int> number = mode.device ? mode.program.value : std::optional<int>(state.editor_program);
  monitor.write(kProgramRow, 0, label);
  if (number) monitor.write(kProgramRow, columns_of(label), program_word(*number));
  if (mode.phase == ExternalDataMode::Phase::program) monitor.mark(kProgramRow, columns_of(label));
  monitor.write(kProgramRow + 1, 0, text(Text::all_programs_hint, state.tongue()));
}

/// What binds a connection to this seat (interfaces.md section 8), and under REMOTE the release of a remote start.
void draw_line(const ExternalDataMode& mode, const ControlState& state, Monitor& monitor) {
  constexpr int kNumberColumn = 18, kBlockColumn = 24;
  const SerialPort& port = state.port;
  if (!port.fitting.is_fitted) return;
  monitor.write(kLineRow, 0, text(Text::line, state.tongue(), {port.is_connected ? "●" : "○", port.fitting.binding}));
  if (!state.settings.remote) return;
  monitor.write(kReleaseRow, 0, text(Text::remote_release, state.tongue()));
  if (mode.phase != ExternalDataMode::Phase::release) return;
  const Attribute attribute = mode.armed ? Attribute::inverse : Attribute::normal;
  monitor.write(kReleaseRow, kNumberColumn, "P" + mode.program.text(), attribute);
  monitor.write(kReleaseRow, kBlockColumn, "N" + mode.block.text(), attribute);
  if (!mode.armed) monitor.mark(kReleaseRow, mode.is_at_block ? kBlockColumn : kNumberColumn);
}

bool is_reading(const ExternalDataMode& mode, const ControlState& state) {
  if (state.port.line.is_reading()) return true;
  return mode.device == Device::cassette_in && state.recorder && state.recorder->is_reading();
}

}  // namespace

void draw(const ExternalDataMode& mode, const ControlState& state, Monitor& monitor) {
  const language::Tongue tongue = state.tongue();
  draw_devices(mode, state, monitor);
  draw_prompt(mode, state, monitor);
  if (mode.device == Device::cassette_out) monitor.write(kFunctionRow, 0, text(Text::write_cassette, tongue));
  if (mode.adopts_machine_data && mode.device) monitor.write(kFunctionRow, 0, text(Text::with_machine_data, tongue));
  draw_recorder(state, monitor);
  draw_line(mode, state, monitor);
  if (!is_reading(mode, state)) return;
  const auto now = std::chrono::duration_cast<transfer::Time>(std::chrono::nanoseconds(state.now.monotonic_ns));
  const char32_t dash = static_cast<char32_t>(transfer::reading_dash(now));
  monitor.put(0, Monitor::kColumns - 1, dash);  // SCR-048
}

std::string sentence_of(const ExternalDataMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  if (state.storing) return std::string(text(Text::wait_external_storing, tongue));
  switch (mode.phase) {
    case ExternalDataMode::Phase::device:
      return mode.done.empty() ? std::string(text(Text::wait_external_device, tongue)) : mode.done;
    case ExternalDataMode::Phase::program: {
      const bool is_input = *mode.device >= Device::cassette_in;
      if (mode.takes_all)
        return std::string(text(is_input ? Text::wait_external_next : Text::wait_external_all, tongue));
      return std::string(text(is_input ? Text::wait_external_read : Text::wait_external_write, tongue));
    }
    case ExternalDataMode::Phase::release:
      return release_sentence(mode, state);
    case ExternalDataMode::Phase::transfer:
      break;
  }
  if (mode.device == Device::cassette_out && state.recorder &&
      state.recorder->state() == transfer::CassetteDeck::State::leader)
    return std::string(text(Text::wait_external_leader, tongue));
  if (mode.is_on_line && !state.port.is_connected) return std::string(text(Text::wait_line, tongue));
  if (mode.device == Device::cassette_in) return std::string(text(Text::wait_external_reading, tongue));
  return std::string(text(Text::wait_external_transfer, tongue));
}

}  // namespace cnclab::panel
