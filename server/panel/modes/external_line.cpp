// EXTERNE DATEN over the serial line, and what becomes of the text that it brings (EXT-046 to EXT-066).
#include <utility>

#include "panel/modes/external_data_mode.hpp"
#include "panel/remote_line.hpp"
#include "transfer/punched_tape.hpp"

namespace cnclab::panel {

namespace {

using language::Error;
using language::ErrorCode;

constexpr std::string_view kMachineData = "MD";

bool is_output(const ExternalDataMode& mode) { return *mode.device < Device::cassette_in; }

std::optional<std::uint16_t> sought(const ExternalDataMode& mode) {
  if (mode.takes_all) return std::nullopt;
  return static_cast<std::uint16_t>(mode.program.value.value_or(0));
}

/// Reading has come to its "%".
void end_reading(ExternalDataMode& mode, ControlState& state) {
  const int count = state.port.programs_read;
  const auto number = sought(mode);
  if (count > 0 || !number) return end_transfer(mode, text(Text::said_read, state.tongue(), {std::to_string(count)}));
  end_transfer(mode, {});
  state.complain(Error{.code = ErrorCode::program_missing, .detail = program_word(*number)});
}

void take_text(ExternalDataMode& mode, ControlState& state, const transfer::TextReceived& text) {
  switch (take_line_text(state, text, sought(mode), mode.adopts_machine_data)) {
    case LineIntake::storing:
      return;
    case LineIntake::nothing:
      state.port.line.accept();
      if (state.port.line.mode() == transfer::SerialLine::Mode::off) end_reading(mode, state);
      return;
    case LineIntake::refused:
      state.port.line.refuse();
      return end_transfer(mode, {});
  }
}

}  // namespace

LineIntake take_line_text(ControlState& state, const transfer::TextReceived& text, std::optional<std::uint16_t> sought,
                          bool adopts_machine_data) {
  const bool is_machine_data = text.text.starts_with(kMachineData);
  const bool adopts = adopts_machine_data && !state.connection.is_lab_machine;
  if (text.text.empty() || (is_machine_data && !adopts)) return LineIntake::nothing;
  if (!is_machine_data && sought && text.program != *sought) return LineIntake::nothing;
  if (!is_machine_data && language::is_reserved_for_cycles(text.program)) {  // read without it, with a notice (DEC-06)
    state.message.sentence =
        language::explain({.code = ErrorCode::reserved_for_cycles, .program = text.program}, state.tongue());
    return LineIntake::nothing;
  }
  const ReceivedText received{.text = text.text,
                              .adopts_machine_data = adopts_machine_data,
                              .is_continuation = text.is_continuation,
                              .sought = {}};
  if (!take_in(state, received)) {
    state.port.news.push_back("refused " + program_word(text.program) + ": " + state.message.monitor);
    return LineIntake::refused;
  }
  state.port.is_storing = true;
  return LineIntake::storing;
}

void complain_of_line(ControlState& state, transfer::LineFault fault) {
  const bool is_overflow = fault == transfer::LineFault::overflow;
  state.complain(ErrorCode::transfer_wrong,
                 std::string(text(is_overflow ? Text::said_line_overflow : Text::said_line_beginning, state.tongue())));
  state.port.news.emplace_back(is_overflow ? "refused: more than 4096 characters"
                                           : "refused: no PxxxxNxxx at the beginning");
}

void begin_line_transfer(ExternalDataMode& mode, ControlState& state, const std::vector<language::Program>& leaving) {
  mode.phase = ExternalDataMode::Phase::transfer;
  mode.is_on_line = true;
  state.port.programs_read = 0;
  state.port.order = is_output(mode) ? SerialPort::Order::send : SerialPort::Order::read;
  if (is_output(mode)) state.port.text_to_send = transfer::line_text(leaving);
}

void take_line_event(ExternalDataMode& mode, ControlState& state, const transfer::LineEvent& event) {
  if (std::holds_alternative<transfer::SendingDone>(event)) {
    state.port.news.push_back("sent " + (mode.takes_all ? std::string("all programs") : program_word(*sought(mode))));
    return end_transfer(mode, std::string(text(Text::said_written, state.tongue())));
  }
  if (const auto* fault = std::get_if<transfer::LineFault>(&event)) {
    end_transfer(mode, {});
    return complain_of_line(state, *fault);
  }
  if (const auto* received = std::get_if<transfer::TextReceived>(&event)) take_text(mode, state, *received);
}

void line_stored(ExternalDataMode& mode, ControlState& state, bool is_stored) {
  if (!is_stored) {
    state.port.line.refuse();
    return end_transfer(mode, {});
  }
  ++state.port.programs_read;
  state.port.line.accept();
  if (state.port.line.mode() == transfer::SerialLine::Mode::off) end_reading(mode, state);
}

void line_broke(ExternalDataMode& mode, ControlState& state) {
  if (mode.phase != ExternalDataMode::Phase::transfer) return;
  end_transfer(mode, {});
  state.complain(ErrorCode::transfer_wrong, std::string(text(Text::said_line_lost, state.tongue())));
}

void abort_line_transfer(ExternalDataMode&, ControlState& state) {
  state.port.order = SerialPort::Order::none;
  state.port.text_to_send.clear();
  const auto now = std::chrono::duration_cast<transfer::Time>(std::chrono::nanoseconds(state.now.monotonic_ns));
  state.port.line.stop(now);
}

}  // namespace cnclab::panel
