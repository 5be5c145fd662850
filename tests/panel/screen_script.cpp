// Reads a script line by line and plays it on a bench.
#include "screen_script.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <sstream>

#include "bench.hpp"

namespace cnclab::panel {

namespace {

struct Script {
  bool redraw = false;
  std::vector<std::string> lines{};
  std::size_t next = 0;
  std::string rewritten{};
  Bench::Setup setup{};
  std::optional<Bench> bench{};

  /// The bench is made with the first line that needs one. As at every station there is a place for files.
  Bench& at_bench() {
    if (!bench) bench.emplace(setup).control.connect_media(true);
    return *bench;
  }
};

void set_clock(Script& script, const std::string& rest) {
  WallClock& clock = script.at_bench().now.wall;
  char separator = 0;
  std::istringstream stream(rest);
  stream >> clock.hour >> separator >> clock.minute >> separator >> clock.second >> clock.day >> separator >>
      clock.month >> separator >> clock.year;
}

void damage(Script& script, const std::string& rest) {
  const auto number = static_cast<std::uint16_t>(std::stoi(rest.substr(1, 4)));
  const auto block = static_cast<std::uint16_t>(std::stoi(rest.substr(7, 3)));
  Memory memory = script.at_bench().control.memory();
  language::Program program = *memory.find(number);
  program.blocks.at(program.find(block).value()).is_damaged = true;
  memory.put_program(program);
  script.at_bench().control.replace_memory(memory);
}

/// Lines that shape the bench before it is made; true where the line was one.
bool read_setup(Script& script, const std::string& command, const std::string& rest) {
  if (command == "english")
    script.setup.settings.tongue = language::Tongue::english;
  else if (command == "hints")
    script.setup.settings.hints = rest == "on";
  else if (command == "model")
    script.setup.settings.vocabulary.model = language::Model::cnc3250;
  else if (command == "memory")
    script.setup.settings.memory_bytes = std::stoi(rest);
  else if (command == "lab")
    script.setup.is_lab_machine = true;
  else if (command == "load")
    script.setup.tape += rest;
  else if (command == "data")
    EXPECT_TRUE(script.setup.data.set(std::stoi(rest), std::stoll(rest.substr(rest.find(' ')))));
  else
    return false;
  EXPECT_FALSE(script.bench.has_value()) << command << " belongs before the first key";
  return true;
}

bool play(Script& script, const std::string& command, const std::string& rest) {
  Bench& bench = script.at_bench();
  if (command == "clock")
    set_clock(script, rest);
  else if (command == "keys")
    bench.keys(rest);
  else if (command == "type")
    bench.type(rest);
  else if (command == "pot")
    bench.control.set_override(std::stoi(rest));
  else if (command == "damage")
    damage(script, rest);
  else if (command == "store")
    bench.fail_next_store(rest.substr(rest.find(' ') + 1));
  else if (command == "input")
    bench.machine.set_input(0, 0, rest == "on");
  else if (command == "media")
    bench.control.connect_media(rest == "on");
  else if (command == "cassette")
    bench.control.insert_cassette({}, bench.now);
  else if (command == "hold")
    bench.hold(key_of(rest.substr(rest.find(' ') + 1)).value(), std::stoi(rest));
  else if (command == "run")
    bench.run_for(std::stoi(rest));
  else if (command == "rest")
    EXPECT_TRUE(bench.run_to_rest()) << "still running\n" << bench.picture();
  else if (command == "until")
    EXPECT_TRUE(bench.run_until([&] { return bench.picture().find(rest) != std::string::npos; })) << rest << "\n"
                                                                                                  << bench.picture();
  else
    return false;
  return true;
}

bool compare(Script& script, const std::string& command, const std::string& rest) {
  Bench& bench = script.at_bench();
  const auto number_and_text = [&] {
    const std::size_t blank = rest.find(' ');
    return std::pair(std::stoi(rest), blank == std::string::npos ? std::string() : rest.substr(blank + 1));
  };
  if (command == "monitor") {
    const auto [index, text] = number_and_text();
    EXPECT_EQ(bench.monitor(index), text) << bench.picture();
  } else if (command == "row") {
    const auto [index, text] = number_and_text();
    EXPECT_EQ(bench.row(index), text) << bench.picture();
  } else if (command == "marks") {
    std::string joined;
    for (const std::string& mark : bench.marks()) joined += (joined.empty() ? "" : ", ") + mark;
    EXPECT_EQ(joined, rest);
  } else if (command == "beeps") {
    EXPECT_EQ(bench.control.take_beeps(), std::stoi(rest));
  } else {
    return false;
  }
  return true;
}

void compare_picture(Script& script) {
  const std::string drawn = script.at_bench().picture();
  std::string expected;
  for (int row = 0; row < Screen::kRows && script.next < script.lines.size(); ++row)
    expected += script.lines[script.next++] + "\n";
  if (!script.redraw) {
    EXPECT_EQ(drawn, expected);
  }
  script.rewritten += drawn;
}

}  // namespace

std::string run_screen_script(const std::filesystem::path& file, bool redraw) {
  Script script;
  script.redraw = redraw;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) script.lines.push_back(line);
  while (script.next < script.lines.size()) {
    const std::string line = script.lines[script.next++];
    script.rewritten += line + "\n";
    if (line.empty() || line.front() == '#') continue;
    SCOPED_TRACE(file.filename().string() + ":" + std::to_string(script.next) + ": " + line);
    const std::size_t blank = line.find(' ');
    const std::string command = line.substr(0, blank);
    const std::string rest = blank == std::string::npos ? "" : line.substr(blank + 1);
    if (command == "screen")
      compare_picture(script);
    else if (!read_setup(script, command, rest) && !play(script, command, rest) && !compare(script, command, rest))
      ADD_FAILURE() << "unknown line";
  }
  return script.rewritten;
}

}  // namespace cnclab::panel
