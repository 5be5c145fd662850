// The conversation on the serial line.
#include "transfer/serial_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "transfer/iso_code.hpp"

namespace cnclab::transfer {

namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

constexpr Time kSilence = std::chrono::seconds(1);
/// Answers to "!" that nobody reads are not heaped up.
constexpr std::size_t kMostAnswers = 1024;

}  // namespace

std::string SerialLine::with_parity(std::string_view text) { return with_even_parity(text); }

void SerialLine::set_speed(LineSpeed speed) {
  input_.set_speed(speed);
  output_.set_speed(speed);
}

void SerialLine::begin(Mode mode, Time now) {
  mode_ = mode;
  time_ = std::max(time_, now);
  asked_ = {};
  is_running_ = has_failed_ = is_held_ = false;
  silent_since_.reset();
  input_.clear();
}

void SerialLine::begin_reading(Time now) {
  begin(Mode::reading, now);
  input_rules_ = LineInput(false, -1);
  switch_reader_on();
}

void SerialLine::begin_remote(std::uint16_t program, Time now, bool is_held) {
  begin(Mode::remote, now);
  input_rules_ = LineInput(true, program);
  is_held_ = is_held;
  ask_again();
}

void SerialLine::hold(Time now) {
  if (mode_ != Mode::remote || is_held_) return;
  time_ = std::max(time_, now);
  is_held_ = true;
  silent_since_.reset();
  if (is_reader_on_) switch_reader_off();
}

void SerialLine::go_on(Time now) {
  if (mode_ != Mode::remote || !is_held_) return;
  time_ = std::max(time_, now);
  is_held_ = false;
  if (!is_waiting_for_answer() && !is_running_) ask_again();
}

void SerialLine::begin_sending(std::string_view text, Time now) {
  begin(Mode::sending, now);
  send(text);
}

void SerialLine::stop(Time now) {
  time_ = std::max(time_, now);
  if (mode_ == Mode::sending) output_.clear();
  if (is_reader_on_) switch_reader_off();
  begin(Mode::off, now);
}

void SerialLine::cut(Time now) {
  is_reader_on_ = false;
  input_rules_.forget();
  output_.clear();
  begin(Mode::off, now);
}

bool SerialLine::ends_transmission() const {
  const auto* text = std::get_if<TextReceived>(&asked_);
  return text != nullptr && text->is_last;
}

void SerialLine::switch_reader_on() {
  is_reader_on_ = true;
  silent_since_.reset();
  send({&kReaderOn, 1});
}

void SerialLine::ask_again() {
  if (!is_held_) switch_reader_on();
}

void SerialLine::switch_reader_off() {
  is_reader_on_ = false;
  input_rules_.forget();
  send({&kReaderOff, 1});
  send({&kReaderOff, 1});
}

std::size_t SerialLine::receive(std::string_view bytes, Time now) {
  if (mode_ == Mode::off || mode_ == Mode::sending) return bytes.size();
  const std::string_view taken = bytes.substr(0, kBacklog - std::min(kBacklog, input_.waiting()));
  input_.put(taken, std::max(time_, now));
  return taken.size();
}

std::string SerialLine::take_output(Time now, std::size_t most) {
  std::string bytes;
  for (auto due = output_.due(); due && *due <= now && bytes.size() < most; due = output_.due())
    bytes += output_.take();
  return bytes;
}

std::optional<LineEvent> SerialLine::advance(Time now, const ControlStatus& status) {
  for (auto due = input_.due(); due && *due <= now && mode_ != Mode::off; due = input_.due()) {
    time_ = std::max(time_, *due);
    auto event = take(input_.take(), status);
    if (!event) continue;
    if (auto* start = std::get_if<StartReceived>(&*event)) start->came = *due;
    return event;
  }
  time_ = std::max(time_, now);
  if (silent_since_ && time_ - *silent_since_ >= kSilence) switch_reader_on();
  if (mode_ != Mode::sending || output_.waiting() > 0) return std::nullopt;
  mode_ = Mode::off;
  return SendingDone{};
}

std::optional<LineEvent> SerialLine::take(char byte, const ControlStatus& status) {
  if (silent_since_) silent_since_ = time_;
  if (!is_reader_on_) {
    if (mode_ != Mode::remote || silent_since_ || without_parity(byte) != '!') return std::nullopt;
    answer_query(status);
    return StatusQuery{};
  }
  Received received = input_rules_.take(byte);
  return std::visit(Overloaded{[](std::monostate) -> std::optional<LineEvent> { return std::nullopt; },
                               [&](StatusQuery query) -> std::optional<LineEvent> {
                                 answer_query(status);
                                 return query;
                               },
                               [&](LineFault fault) { return take_fault(fault); },
                               [&](auto& asked) -> std::optional<LineEvent> {
                                 switch_reader_off();
                                 asked_ = asked;
                                 return std::move(asked);
                               }},
                    received);
}

std::optional<LineEvent> SerialLine::take_fault(LineFault fault) {
  switch_reader_off();
  has_failed_ = true;
  if (mode_ == Mode::remote)
    silent_since_ = time_;
  else
    mode_ = Mode::off;
  return fault;
}

void SerialLine::answer_query(const ControlStatus& status) {
  if (output_.waiting() > kMostAnswers) return;
  const bool is_failed = has_failed_ && status.letter != ControlStatus::Letter::running;
  send(fmt::format("P{:04}N{:03}{}%", status.program, status.block,
                   static_cast<char>(is_failed ? ControlStatus::Letter::failed : status.letter)));
}

void SerialLine::accept() {
  const Received asked = std::exchange(asked_, {});
  if (std::holds_alternative<std::monostate>(asked)) return;
  has_failed_ = false;
  const auto* text = std::get_if<TextReceived>(&asked);
  if (std::holds_alternative<StartReceived>(asked))
    is_running_ = true;
  else if (mode_ == Mode::reading && text != nullptr && text->is_last)
    mode_ = Mode::off;
  else
    ask_again();
}

void SerialLine::refuse() {
  if (!is_waiting_for_answer()) return;
  asked_ = {};
  has_failed_ = true;
  if (mode_ == Mode::remote)
    ask_again();
  else
    mode_ = Mode::off;
}

void SerialLine::run_ended(Time now) {
  if (!is_running_) return;
  is_running_ = false;
  time_ = std::max(time_, now);
  ask_again();
}

}  // namespace cnclab::transfer
