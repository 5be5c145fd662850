// Reads the embedded text line by line: "P9981" opens a program, "N005…" is a block of it, other lines say nothing.
#include "program/rom_programs.hpp"

#include <algorithm>
#include <ranges>
#include <stdexcept>
#include <string>
#include <vector>

#include "language/tape.hpp"

namespace cnclab::program {

namespace {

constexpr std::uint16_t kBeforeFirst = 9980;  // G81 → P9981
constexpr int kFirstCycle = 81, kLastCycle = 86;

/// The text belongs to the program, so a fault in it is one of the build: tests read it, no user ever can.
[[noreturn]] void fail(std::string_view line) { throw std::logic_error("ROM program: " + std::string(line)); }

std::vector<language::Program> read_rom(std::string_view text) {
  std::vector<language::Program> programs;
  for (const auto part : std::views::split(text, '\n')) {
    const std::string_view line(part.begin(), part.end());
    if (line.starts_with('P')) {
      programs.push_back({.number = static_cast<std::uint16_t>(std::stoi(std::string(line.substr(1))))});
    } else if (line.starts_with('N')) {
      if (programs.empty()) fail(line);
      auto block = language::read_block(line, programs.back().number);
      if (!block) fail(line);
      programs.back().blocks.push_back(std::move(*block));
    }
  }
  return programs;
}

}  // namespace

const language::Program* rom_program(std::uint16_t number) {
  static const std::vector<language::Program> kPrograms = read_rom(rom_text());
  const auto found = std::ranges::find(kPrograms, number, &language::Program::number);
  return found == kPrograms.end() ? nullptr : &*found;
}

const language::Program* rom_program_of(language::Function function) {
  const bool is_cycle =
      function.kind == language::Function::Kind::g && function.code >= kFirstCycle && function.code <= kLastCycle;
  if (!is_cycle) return nullptr;
  return rom_program(static_cast<std::uint16_t>(kBeforeFirst + function.code - (kFirstCycle - 1)));
}

}  // namespace cnclab::program
