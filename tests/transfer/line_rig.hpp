// A serial line with somebody at its other end, for tests: what is said is answered at once unless told otherwise.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

#include "transfer/iso_code.hpp"
#include "transfer/serial_line.hpp"

namespace cnclab::transfer {

using namespace std::string_view_literals;

/// The bytes as readable text, with parity checked: "<DC1>", "<DC3>", "<NUL>" and characters; "<odd>" for a wrong one.
inline std::string readable(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) {
    const char c = without_parity(byte);
    if (std::popcount(static_cast<unsigned char>(byte)) % 2 != 0)
      text += "<odd>";
    else if (c == kReaderOn)
      text += "<DC1>";
    else if (c == kReaderOff)
      text += "<DC3>";
    else if (c == kNul)
      text += "<NUL>";
    else
      text += c;
  }
  return text;
}

inline std::string readable(const LineEvent& event) {
  if (const auto* text = std::get_if<TextReceived>(&event))
    return (text->is_continuation ? "more[" : "text[") + text->text + (text->is_last ? "]." : "]");
  if (const auto* start = std::get_if<StartReceived>(&event))
    return "start P" + std::to_string(start->program) + " N" + std::to_string(start->block);
  if (std::holds_alternative<EraseReceived>(event)) return "erase";
  if (std::holds_alternative<StatusQuery>(event)) return "query";
  if (std::holds_alternative<SendingDone>(event)) return "sent";
  return std::get<LineFault>(event) == LineFault::overflow ? "overflow" : "wrong";
}

struct LineRig {
  explicit LineRig(LineSpeed speed = {.is_paced = false}) : line(speed) {}

  /// Brings bytes and follows the line; every question gets `answer`.
  LineRig& say(std::string_view bytes) {
    EXPECT_EQ(line.receive(bytes, now), bytes.size());
    return pass(Time(0));
  }
  LineRig& pass(Time time) {
    now += time;
    while (const auto event = line.advance(now, status)) {
      events.push_back(readable(*event));
      if (line.is_waiting_for_answer() && answers) accepts ? line.accept() : line.refuse();
    }
    return *this;
  }
  /// What the control has sent since the last call.
  std::string sent() { return readable(line.take_output(now)); }

  SerialLine line;
  Time now{1'000'000};
  ControlStatus status{.program = 7, .block = 12};
  bool answers = true, accepts = true;
  std::vector<std::string> events;
};

}  // namespace cnclab::transfer
