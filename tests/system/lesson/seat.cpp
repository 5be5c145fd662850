// Keys and glances at the screen.
#include "seat.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <regex>

#include "harness/failure.hpp"

namespace cnclab::lesson {

using namespace std::chrono_literals;

namespace {

constexpr auto kLoginLimit = 30s;  ///< fifteen passwords are hashed one after the other (SEC-002)
constexpr auto kRunLimit = 30s;    ///< no part takes longer than 5 s
constexpr auto kStartLimit = 3s;
constexpr auto kAskLimit = 700ms;  ///< by then a START that starts has lit its lamp

/// The lamp as it stands in the side column (DEC-01) while it is lit.
bool has_lit_start_lamp(const harness::ScreenRows& rows) {
  static const std::regex kLamp("START *●");
  for (const std::string& row : rows) {
    if (std::regex_search(row, kLamp)) return true;
  }
  return false;
}

}  // namespace

Seat::Seat(const Part& part, const harness::StationOptions& options)
    : part_(part), station_(options.station), process_(options) {}

std::string Seat::name() const { return fmt::format("station {:02} {}", station_, part_.student); }

void Seat::log_in() {
  process_.wait_for("CNC 3300", kLoginLimit);
  process_.wait_for("TRAINING");
  process_.expect_ok("pot 100");
}

void Seat::open_program(int number) {
  process_.key("MENU");
  process_.key("EINGABE");
  process_.wait_for("EINGABEMODUS");
  process_.key("CLEAR");
  process_.type(fmt::format("{:04}", number));
  process_.key("ENTER");
  process_.wait_for("□001");
}

void Seat::key_in(const WrittenBlock& block, int number, int plane) {
  for (const std::string& command : key_commands(block, plane)) process_.expect_ok(command);
  process_.wait_for(fmt::format("□{:03}", number + 1));
}

int Seat::key_in_programs() {
  int acknowledged = 0;
  for (const WrittenProgram& program : part_.programs) {
    open_program(program.number);
    int plane = 17;
    int number = 0;
    for (const std::string& line : program.blocks) {
      const WrittenBlock block = parse_block(line);
      plane = plane_after(block, plane);
      key_in(block, ++number, plane);
      ++acknowledged;
    }
  }
  process_.key("MENU");
  return acknowledged;
}

void Seat::choose_program() {
  process_.key("MENU");
  process_.key("AUTOMAT");
  process_.wait_for("AUTOMAT");
  process_.type("0001");
  process_.key("ENTER");
  process_.key("ENTER");
  process_.wait_for("N001 G");
}

void Seat::start() {
  process_.key("START");
  if (harness::eventually(kAskLimit, [&] { return is_started(); })) return;
  if (part_.is_absolute) process_.key("START");
  if (!harness::eventually(kStartLimit, [&] { return is_started(); })) {
    throw harness::Failure(name() + ": START did not start the program\n" + process_.text());
  }
}

void Seat::stop() {
  process_.key("STOP");
  finish();
}

void Seat::finish() {
  if (!harness::eventually(kRunLimit, [&] { return !is_started(); })) {
    throw harness::Failure(name() + ": the program does not end\n" + process_.text());
  }
}

bool Seat::is_started() { return has_lit_start_lamp(process_.screen()); }

Point Seat::shown_position() {
  static const std::array<std::regex, 3> kCounters = {std::regex("X +([+-][0-9]{4}\\.[0-9]{3})"),
                                                      std::regex("Y +([+-][0-9]{4}\\.[0-9]{3})"),
                                                      std::regex("Z +([+-][0-9]{4}\\.[0-9]{3})")};
  const std::string text = process_.text();
  Point position{};
  for (std::size_t axis = 0; axis < kCounters.size(); ++axis) {
    std::smatch found;
    if (!std::regex_search(text, found, kCounters[axis])) {
      throw harness::Failure(name() + ": no Istwert on the screen\n" + text);
    }
    position[axis] = std::strtod(found[1].str().c_str(), nullptr);
  }
  return position;
}

}  // namespace cnclab::lesson
