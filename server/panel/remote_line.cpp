// Polling, commands and the run that a computer began.
#include "panel/remote_line.hpp"

#include <utility>

#include "panel/key_table.hpp"

namespace cnclab::panel {

namespace {

using transfer::SerialLine;

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

transfer::Time time_of(const ControlState& state) {
  return std::chrono::duration_cast<transfer::Time>(std::chrono::nanoseconds(state.now.monotonic_ns));
}

std::string words(std::uint16_t program, std::uint16_t block) {
  return program_word(program) + " " + block_word(block);
}

/// D-110: in the menu and in EXTERNE DATEN, there not beside another transfer.
bool polls(const ActiveMode& mode) {
  const auto* external = std::get_if<ExternalDataMode>(&mode);
  if (external != nullptr) return external->phase != ExternalDataMode::Phase::transfer;
  return std::holds_alternative<MenuMode>(mode);
}

bool has_block_to_run(const ActiveMode& mode) {
  const auto* automat = std::get_if<AutomatMode>(&mode);
  return automat != nullptr && automat->phase == AutomatMode::Phase::ready;
}

/// Where "!" says that the control is: what runs or ran last, else the program last worked on (D-98).
geometry::SourceBlock current_of(const ActiveMode& mode, const ControlState& state) {
  if (has_block_to_run(mode)) return current_block(std::get<AutomatMode>(mode), state);
  if (state.port.current.program != 0) return state.port.current;
  const language::Program* program = state.memory.find(state.editor_program);
  const bool has_blocks = program != nullptr && !program->blocks.empty();
  return {state.editor_program, has_blocks ? program->blocks.front().number : std::uint16_t{1}};
}

transfer::ControlStatus status_of(const ActiveMode& mode, const ControlState& state) {
  using Letter = transfer::ControlStatus::Letter;
  const geometry::SourceBlock current = current_of(mode, state);
  const bool is_running = is_start_state(place_of(mode, state));
  const bool has_failed = !state.message.monitor.empty();
  return {.program = current.program,
          .block = current.block,
          .letter = is_running ? Letter::running : (has_failed ? Letter::failed : Letter::stopped)};
}

void begin(ControlState& state, SerialLine::Mode wanted, bool is_held = false) {
  SerialPort& port = state.port;
  port.line.stop(time_of(state));
  if (wanted == SerialLine::Mode::remote) port.line.begin_remote(state.editor_program, time_of(state), is_held);
  if (wanted == SerialLine::Mode::reading) port.line.begin_reading(time_of(state));
  if (wanted == SerialLine::Mode::sending)
    port.line.begin_sending(std::exchange(port.text_to_send, {}), time_of(state));
  port.order = SerialPort::Order::none;
}

/// Brings the line into the state that mode, order and REMOTE switch ask for.
void steer(const ActiveMode& mode, ControlState& state) {
  constexpr int kBaudDatum = 20;
  SerialPort& port = state.port;
  port.line.set_speed({.baud = static_cast<int>(state.data.get(kBaudDatum)), .is_paced = port.fitting.is_paced});
  if (port.order == SerialPort::Order::send) return begin(state, SerialLine::Mode::sending);
  if (port.order == SerialPort::Order::read) return begin(state, SerialLine::Mode::reading);
  switch (port.line.mode()) {
    case SerialLine::Mode::reading:
    case SerialLine::Mode::sending:
      return;
    case SerialLine::Mode::off:
      if (state.settings.remote) begin(state, SerialLine::Mode::remote, !polls(mode));
      return;
    case SerialLine::Mode::remote:
      if (!state.settings.remote) return port.line.stop(time_of(state));
      return polls(mode) ? port.line.go_on(time_of(state)) : port.line.hold(time_of(state));
  }
}

void take_text(ControlState& state, const transfer::TextReceived& text) {
  switch (take_line_text(state, text, std::nullopt, false)) {
    case LineIntake::storing:
      return;
    case LineIntake::nothing:
      return state.port.line.accept();
    case LineIntake::refused:
      return state.port.line.refuse();
  }
}

/// "#": as C and → in SPEICHER LÖSCHEN; not while the lab's machine would get other data by it (DEC-39).
void take_erase(ControlState& state) {
  if (state.connection.is_lab_machine) {
    state.message.sentence = text(Text::said_not_on_lab_machine, state.tongue());
    state.port.news.emplace_back("# refused: on the lab machine");
    return state.port.line.refuse();
  }
  state.storing = state.whole_memory();
  state.port.is_storing = true;
}

void take_event(ActiveMode& mode, ControlState& state, const transfer::LineEvent& event) {
  auto* external = std::get_if<ExternalDataMode>(&mode);
  if (external != nullptr && external->phase == ExternalDataMode::Phase::transfer)
    return take_line_event(*external, state, event);
  std::visit(Overloaded{[&](const transfer::TextReceived& text) { take_text(state, text); },
                        [&](const transfer::StartReceived& start) {
                          const auto came = std::chrono::duration_cast<std::chrono::nanoseconds>(start.came);
                          state.port.asked = RemoteStart{start.program, start.block, came.count()};
                          state.port.has_handed_out_start = false;
                        },
                        [&](const transfer::EraseReceived&) { take_erase(state); },
                        [&](const transfer::LineFault& fault) { complain_of_line(state, fault); },
                        [](const transfer::StatusQuery&) {}, [](const transfer::SendingDone&) {}},
             event);
}

/// The run that "*" began is over: back to the mode before it.
void notice_end_of_run(const ActiveMode& mode, ControlState& state) {
  SerialPort& port = state.port;
  if (!port.runs || state.run.is_present()) return;
  port.runs = false;
  port.line.run_ended(time_of(state));
  if (!std::holds_alternative<AutomatMode>(mode)) return;
  state.next_mode = port.return_to;
  if (state.message.monitor.empty() && state.message.sentence.empty())
    state.message.sentence = text(Text::said_remote_run_over, state.tongue(), {program_word(port.current.program)});
}

}  // namespace

void connect_line(ActiveMode& mode, ControlState& state, bool is_connected) {
  SerialPort& port = state.port;
  if (port.is_connected == is_connected) return;
  port.is_connected = is_connected;
  if (is_connected && port.fitting.is_fitted) return steer(mode, state);  // what comes with the first line counts
  if (is_connected) return;
  const bool was_busy = port.line.mode() == SerialLine::Mode::reading || port.line.mode() == SerialLine::Mode::sending;
  port.line.cut(time_of(state));
  port.asked.reset();
  if (auto* external = std::get_if<ExternalDataMode>(&mode); external != nullptr && was_busy)
    line_broke(*external, state);
}

void follow_line(ActiveMode& mode, ControlState& state) {
  SerialPort& port = state.port;
  if (!port.fitting.is_fitted) return;
  if (has_block_to_run(mode)) port.current = current_of(mode, state);
  notice_end_of_run(mode, state);
  if (!port.is_connected) return;
  // The line's time stands still while something of it waits for an answer: nothing that comes meanwhile is lost.
  if (port.is_storing || port.asked) return;
  steer(mode, state);
  while (!state.storing && !port.asked && !state.next_mode) {
    const auto event = port.line.advance(time_of(state), status_of(mode, state));
    if (!event) return;
    take_event(mode, state, *event);
  }
}

void line_stored(ActiveMode& mode, ControlState& state, const StoreRequest& request, bool is_stored) {
  SerialPort& port = state.port;
  port.is_storing = false;
  auto* external = std::get_if<ExternalDataMode>(&mode);
  if (external != nullptr && external->phase == ExternalDataMode::Phase::transfer)
    return line_stored(*external, state, is_stored);
  if (!is_stored) return port.line.refuse();
  state.message = {};
  if (std::holds_alternative<EraseMemory>(request)) {
    state.initialise();
    port.current = {};
    port.news.emplace_back("memory erased by #");
  }
  if (const auto* put = std::get_if<PutPrograms>(&request); put != nullptr && !put->programs.empty()) {
    const language::Program& program = put->programs.back();
    if (program.number != language::kToolTable) {
      state.editor_program = program.number;
      port.current = {program.number, program.blocks.front().number};
    }
    port.news.push_back("received " + program_word(program.number));
  }
  if (port.line.ends_transmission() && std::holds_alternative<MenuMode>(mode))
    state.next_mode = Mode::external_data;  // EXT-065
  port.line.accept();
}

bool answer_remote_start(ActiveMode& mode, ControlState& state, const std::string& refusal) {
  SerialPort& port = state.port;
  if (!port.asked) return false;
  const RemoteStart start = *std::exchange(port.asked, std::nullopt);
  state.message = {};
  if (!refusal.empty()) {
    state.message.sentence = refusal;
    port.line.refuse();
    return false;
  }
  const Mode before = mode_of(mode);
  close_mode(mode, state);
  AutomatMode automat = open_automat(state);
  if (!start_at(automat, state, {start.program, start.block})) {
    mode = open_mode(before, state);
    port.news.push_back("not started " + words(start.program, start.block));
    port.line.refuse();
    return false;
  }
  mode = std::move(automat);
  port.runs = true;
  port.return_to = before;
  port.current = {start.program, start.block};
  port.line.accept();
  return true;
}

}  // namespace cnclab::panel
