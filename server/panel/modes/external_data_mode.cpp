// Keys of EXTERNE DATEN, and what its transfers come to.
#include "panel/modes/external_data_mode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "panel/modes/machine_data_mode.hpp"
#include "shared/media_name.hpp"
#include "transfer/punched_tape.hpp"

namespace cnclab::panel {

namespace {

using language::Error;
using language::ErrorCode;

transfer::Time time_of(const ControlState& state) {
  return std::chrono::duration_cast<transfer::Time>(std::chrono::nanoseconds(state.now.monotonic_ns));
}

bool is_fitted(Device device, const ControlState& state) {
  const bool is_3300 = state.settings.vocabulary.model == language::Model::cnc3300;
  switch (device) {
    case Device::cassette_out:
    case Device::cassette_in:
      return state.recorder.has_value();
    case Device::disk_out:
    case Device::disk_in:
      return state.has_media;
    case Device::printer:
      return (state.has_media || state.has_printer) && is_3300;  // MODEL-004
    case Device::tape_out:
    case Device::tape_in:
      return (state.has_media || state.port.fitting.is_fitted) && is_3300;  // MODEL-005, DEC-62
    case Device::computer_out:
    case Device::computer_in:
      return state.port.fitting.is_fitted;  // D-109, DEC-36
  }
  return false;
}

/// DEC-62: where there is a line, it takes the place of the tape reader and punch.
bool is_on_line(Device device, const ControlState& state) {
  const bool is_tape = device == Device::tape_out || device == Device::tape_in;
  return device == Device::computer_out || device == Device::computer_in || (is_tape && state.port.fitting.is_fitted);
}

/// Row 18 says what is missing.
bool is_connected(Device device, ControlState& state) {
  if (is_fitted(device, state)) return true;
  const bool is_recorder = device == Device::cassette_out || device == Device::cassette_in;
  if (state.settings.hints)
    state.hint = text(is_recorder ? Text::said_no_cassette : Text::said_not_fitted, state.tongue());
  return false;
}

void choose_device(ExternalDataMode& mode, ControlState& state, Effect effect, int figure) {
  if (effect == Effect::start) return release_start(mode, state);
  if (effect != Effect::digit || figure < 1) return;
  const auto device = static_cast<Device>(figure);
  if (!is_connected(device, state)) return;
  mode.device = device;
  mode.phase = ExternalDataMode::Phase::program;
  mode.takes_all = mode.adopts_machine_data = false;
  mode.done.clear();
  mode.program.offer(state.editor_program);
}

std::optional<std::uint16_t> chosen(const ExternalDataMode& mode) {
  if (mode.takes_all) return std::nullopt;
  return static_cast<std::uint16_t>(mode.program.value.value_or(0));
}

/// The programs that are to leave; none after a complaint.
std::vector<language::Program> leaving(const ExternalDataMode& mode, ControlState& state) {
  if (mode.takes_all) {
    if (state.memory.programs().empty())
      state.complain(ErrorCode::program_missing, std::string(text(Text::said_nothing_stored, state.tongue())));
    return state.memory.programs();
  }
  const std::uint16_t number = *chosen(mode);
  if (language::is_reserved_for_cycles(number)) {
    state.complain(Error{.code = ErrorCode::reserved_for_cycles, .program = number});
    return {};
  }
  const language::Program* program = state.memory.find(number);
  if (program != nullptr) return {*program};
  state.complain(Error{.code = ErrorCode::program_missing, .detail = program_word(number)});
  return {};
}

/// The first block of them whose check code did not fit when it was read.
std::optional<Error> damage_in(const std::vector<language::Program>& programs) {
  for (const language::Program& program : programs) {
    const auto block = std::ranges::find(program.blocks, true, &language::Block::is_damaged);
    if (block == program.blocks.end()) continue;
    return Error{.code = ErrorCode::checksum_wrong,
                 .program = program.number,
                 .block = block->number,
                 .in_tool_table = program.number == language::kToolTable};
  }
  return std::nullopt;
}

/// Only paper has a mark for damage: written as data, a damaged block would come back as a sound one (ERR-004,
/// ERR-010). Tells of it; true where nothing may leave.
bool is_kept_by_damage(const ExternalDataMode& mode, ControlState& state,
                       const std::vector<language::Program>& programs) {
  const auto damage = damage_in(programs);
  if (!damage) return false;
  state.complain(*damage);
  return mode.device != Device::printer;
}

/// P0000 first, the others in storage order (DEC-34).
std::vector<language::Program> tools_first(std::vector<language::Program> programs) {
  std::ranges::stable_partition(programs, [](const language::Program& p) { return p.number == language::kToolTable; });
  return programs;
}

std::string stamp(const WallClock& clock) {
  return fmt::format("{:02}:{:02}:{:02} {:02}/{:02}/{:02}", clock.hour, clock.minute, clock.second, clock.day,
                     clock.month, clock.year);
}

void print(ExternalDataMode& mode, ControlState& state, std::vector<language::Program> programs) {
  const std::string time = stamp(state.clock.at(state.now));
  const std::string what = mode.takes_all ? "" : "  " + program_word(*chosen(mode));
  std::string file = media_name(MediaKind::tape_text, chosen(mode));
  file = "DRUCK-" + file.substr(0, file.find('.'));
  mode.print.emplace(
      state.settings.picture_work,
      PrintOrder{.programs = std::move(programs),
                 .machine_data = mode.takes_all ? machine_data_list(state.data, state.tongue()) : std::string(),
                 .time_stamp = time,
                 .header = {.what = "CNC 3300" + what,
                            .student = state.settings.student,
                            .date = time,
                            .tongue = state.tongue()},
                 .file = std::move(file)});
}

/// What is printed stays in the lab where the station takes no files: without a folder, or while it has the machine.
void order_files(ExternalDataMode& mode, ControlState& state, PutFiles put) {
  const bool stays_here = state.has_media && !state.connection.is_lab_machine;
  mode.files.clear();
  for (const MediaFile& file : put.files)
    if (stays_here) mode.files += (mode.files.empty() ? "" : ", ") + file.name;
  state.media = std::move(put);
}

void write(ExternalDataMode& mode, ControlState& state) {
  std::vector<language::Program> programs = tools_first(leaving(mode, state));
  if (programs.empty() || is_kept_by_damage(mode, state, programs)) return;
  mode.phase = ExternalDataMode::Phase::transfer;
  if (is_on_line(*mode.device, state)) return begin_line_transfer(mode, state, programs);
  const std::string machine_data = mode.takes_all ? machine_data_text(state.data) : std::string();  // D-111
  const auto number = chosen(mode);
  if (mode.device == Device::printer) return print(mode, state, std::move(programs));
  if (mode.device == Device::cassette_out)
    return state.recorder->begin_writing({.is_whole_memory = mode.takes_all,
                                          .program = number.value_or(0),
                                          .text = transfer::disk_text(programs, machine_data)},
                                         time_of(state));
  if (mode.device == Device::disk_out)
    return order_files(mode, state,
                       {{{media_name(MediaKind::diskette, number), transfer::disk_text(programs, machine_data)}}});
  const std::string rows = transfer::punch(transfer::line_text(programs));
  order_files(mode, state,
              {{{media_name(MediaKind::punched_tape, number), rows},
                {media_name(MediaKind::tape_text, number), transfer::twin_text(rows)}}});
}

void read(ExternalDataMode& mode, ControlState& state) {
  mode.phase = ExternalDataMode::Phase::transfer;
  if (is_on_line(*mode.device, state)) return begin_line_transfer(mode, state, {});
  if (mode.device == Device::cassette_in) {
    state.recorder->begin_reading(chosen(mode), time_of(state));
    if (mode.adopts_machine_data) state.recorder->adopt_machine_data();
    return;
  }
  const MediaKind kind = mode.device == Device::disk_in ? MediaKind::diskette : MediaKind::punched_tape;
  GetFile get{{media_name(kind, chosen(mode))}};
  if (!mode.takes_all) get.names.push_back(media_name(kind, std::nullopt));  // it may stand among all programs
  state.media = std::move(get);
}

bool is_output(Device device) { return device < Device::cassette_in; }

/// "+/-" (KEY-066): while data are read, and at the prompt before, since a file is read faster than a key is pressed.
void choose_machine_data(ExternalDataMode& mode, ControlState& state, bool adopts) {
  if (state.connection.is_lab_machine) {
    state.hint = text(Text::said_not_on_lab_machine, state.tongue());
    return;
  }
  mode.adopts_machine_data = adopts;
  if (adopts && mode.phase == ExternalDataMode::Phase::transfer && mode.device == Device::cassette_in)
    state.recorder->adopt_machine_data();
}

void press_prompt(ExternalDataMode& mode, ControlState& state, Effect effect, int figure) {
  if (effect == Effect::digit) {
    mode.takes_all = false;
    mode.program.digit(figure);
  }
  if (effect == Effect::clear) {
    mode.takes_all = true;
    mode.program.clear();
  }
  if (effect == Effect::sign) return choose_machine_data(mode, state, !mode.adopts_machine_data);
  if (effect != Effect::enter) return;
  if (!mode.takes_all && !mode.program.value)
    return state.complain(ErrorCode::program_missing, std::string(text(Text::said_number_missing, state.tongue())));
  mode.program.typed = 0;
  if (!is_connected(*mode.device, state)) {
    end_transfer(mode, {});
    return;
  }
  is_output(*mode.device) ? write(mode, state) : read(mode, state);
}

/// STOP: nothing half received is kept (D-107).
void abort(ExternalDataMode& mode, ControlState& state) {
  if (state.recorder) state.recorder->stop(time_of(state));
  if (mode.is_on_line) abort_line_transfer(mode, state);
  state.media.reset();
  state.is_media_stale = state.is_media_pending;
  end_transfer(mode, std::string(text(Text::said_transfer_stopped, state.tongue())));
}

void take_event(ExternalDataMode& mode, ControlState& state, const transfer::DeckEvent& event) {
  const language::Tongue tongue = state.tongue();
  if (const auto* written = std::get_if<transfer::Written>(&event))
    return end_transfer(mode,
                        std::string(text(written->is_lost ? Text::said_leader_short : Text::said_written, tongue)));
  if (const auto* failed = std::get_if<transfer::DeckFailed>(&event)) {
    end_transfer(mode, {});
    if (failed->fault == transfer::DeckFault::damaged)
      return state.complain(ErrorCode::checksum_wrong, std::string(text(Text::said_recording_damaged, tongue)));
    return state.complain(ErrorCode::transfer_wrong, std::string(text(Text::said_tape_end, tongue)));
  }
  const auto& read = std::get<transfer::WasRead>(event);
  if (!take_in(state, {.text = read.payload.text,
                       .is_whole_memory = read.payload.is_whole_memory,
                       .adopts_machine_data = read.adopts_machine_data,
                       .sought = {}}))
    end_transfer(mode, {});
}

}  // namespace

void end_transfer(ExternalDataMode& mode, std::string done) {
  mode.phase = ExternalDataMode::Phase::device;
  mode.device.reset();
  mode.print.reset();
  mode.is_on_line = false;
  mode.done = std::move(done);
}

ExternalDataMode open_external_data(const ControlState&) { return {}; }

void close(ExternalDataMode& mode, ControlState& state) {
  if (mode.phase == ExternalDataMode::Phase::transfer) abort(mode, state);
}

Place place_of(const ExternalDataMode& mode, const ControlState& state) {
  const bool is_polled = state.port.fitting.is_fitted && state.settings.remote;
  switch (mode.phase) {
    case ExternalDataMode::Phase::device:
      return is_polled ? Place::external_polled : Place::external_device;
    case ExternalDataMode::Phase::program:
      return is_output(*mode.device) ? Place::external_write : Place::external_read;
    case ExternalDataMode::Phase::transfer: {
      if (!is_output(*mode.device)) return Place::external_reading;
      const bool is_leader = mode.device == Device::cassette_out && state.recorder &&
                             state.recorder->state() == transfer::CassetteDeck::State::leader;
      return is_leader ? Place::external_leader : Place::external_transfer;
    }
    case ExternalDataMode::Phase::release:
      return Place::external_release;
  }
  return Place::external_device;
}

bool is_of_use(const ExternalDataMode& mode, const ControlState& state, int figure) {
  return mode.phase != ExternalDataMode::Phase::device || (figure > 0 && is_fitted(static_cast<Device>(figure), state));
}

void press(ExternalDataMode& mode, ControlState& state, Effect effect, int figure) {
  switch (mode.phase) {
    case ExternalDataMode::Phase::device:
      return choose_device(mode, state, effect, figure);
    case ExternalDataMode::Phase::program:
      return press_prompt(mode, state, effect, figure);
    case ExternalDataMode::Phase::release:
      return press_release(mode, state, effect, figure);
    case ExternalDataMode::Phase::transfer:
      if (effect == Effect::stop) return abort(mode, state);
      if (effect == Effect::enter) return release_enter(mode, state);  // terminals know no release
      if (effect == Effect::sign) choose_machine_data(mode, state, true);
      return;
  }
}

void release_enter(ExternalDataMode& mode, ControlState& state) {
  if (mode.device == Device::cassette_out && state.recorder) state.recorder->end_leader(time_of(state));
}

void follow(ExternalDataMode& mode, ControlState& state) {
  const auto event = state.recorder ? state.recorder->advance(time_of(state)) : std::nullopt;
  if (mode.phase == ExternalDataMode::Phase::release) return follow_release(mode, state);
  if (mode.phase != ExternalDataMode::Phase::transfer || state.storing || mode.is_on_line) return;
  if (event) return take_event(mode, state, *event);
  if (mode.print) {
    if (auto files = mode.print->result()) {
      mode.print.reset();
      order_files(mode, state, std::move(*files));
    }
    return;
  }
  const bool is_over = !state.media && !state.is_media_pending && !(state.recorder && state.recorder->motor_runs());
  if (is_over) end_transfer(mode, {});  // what was read could not be stored: the message says why
}

void media_answered(ExternalDataMode& mode, ControlState& state,
                    const std::expected<std::string, std::string>& answer) {
  if (mode.phase != ExternalDataMode::Phase::transfer) return;  // stopped meanwhile
  if (!answer) {
    end_transfer(mode, {});
    return state.complain(ErrorCode::transfer_wrong, answer.error());
  }
  if (is_output(*mode.device))
    return end_transfer(mode, mode.files.empty() ? std::string(text(Text::said_written, state.tongue()))
                                                 : text(Text::said_files_written, state.tongue(), {mode.files}));
  const bool is_disk = mode.device == Device::disk_in;
  const std::string received = is_disk ? without_small_letters(*answer) : transfer::read_punched(*answer);
  const bool has_lost_letters = is_disk && received.size() != answer->size();
  const std::string notice =
      has_lost_letters ? " " + std::string(text(Text::said_small_letters, state.tongue())) : std::string();
  const bool is_whole = is_disk && mode.takes_all;
  if (!take_in(state, {.text = received,
                       .reading = is_disk ? language::Reading::file : language::Reading::strict,
                       .is_whole_memory = is_whole,
                       .adopts_machine_data = mode.adopts_machine_data,
                       .sought = chosen(mode),
                       .notice = notice})) {
    state.message.sentence += notice;
    end_transfer(mode, {});
  }
}

void stored(ExternalDataMode& mode, ControlState& state, const StoreRequest& request) {
  if (const auto* put = std::get_if<PutPrograms>(&request))
    end_transfer(mode, text(put->data ? Text::said_read_with_data : Text::said_read, state.tongue(),
                            {std::to_string(put->programs.size())}) +
                           put->notice);
}

}  // namespace cnclab::panel
