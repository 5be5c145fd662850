// Keys, patterns and screen of the memory test.
#include "panel/modes/memory_test_mode.hpp"

#include <algorithm>
#include <array>

namespace cnclab::panel {

namespace {

constexpr int kFirstRow = 3;
constexpr int kPageBytes = 4096;
constexpr std::int64_t kPeriod_ns = 2'000'000'000;  // ERR-031
constexpr std::array<std::string_view, 4> kPatterns{"00", "FF", "55", "AA"};

std::string five_digits(int value) {
  const std::string digits = std::to_string(value);
  return std::string(5 - std::min<std::size_t>(5, digits.size()), '0') + digits;
}

/// Numbers and sizes of the pages that the memory has.
void draw_list(const ControlState& state, Monitor& monitor) {
  constexpr int kRows = 9, kColumnWidth = 20;  // three columns: the largest memory has 25 pages
  int page = 0;
  for (int left = state.settings.memory_bytes; left > 0; left -= kPageBytes, ++page)
    monitor.write(kFirstRow + page % kRows, page / kRows * kColumnWidth,
                  "PAGE " + std::to_string(page + 1) + "   " + five_digits(std::min(left, kPageBytes)));
}

void draw_pattern(std::string_view pattern, Monitor& monitor) {
  constexpr int kRows = 8, kWidth = 3;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column + kWidth <= Monitor::kColumns; column += kWidth)
      monitor.write(kFirstRow + row, column, pattern);
}

}  // namespace

Place place_of(const MemoryTestMode& mode) {
  switch (mode.phase) {
    case MemoryTestMode::Phase::list:
      return Place::memory_list;
    case MemoryTestMode::Phase::running:
      return Place::memory_running;
  }
  return Place::memory_list;
}

void press(MemoryTestMode& mode, ControlState& state, Effect effect, int /*figure*/) {
  if (effect == Effect::test_memory && mode.phase == MemoryTestMode::Phase::list)
    state.storing = state.whole_memory();  // ERR-032; the versions stay (STO-005)
}

void stored(MemoryTestMode& mode, ControlState& state, const StoreRequest& request) {
  if (!std::holds_alternative<EraseMemory>(request)) return;
  state.initialise();
  mode.phase = MemoryTestMode::Phase::running;
  mode.begun_ns = state.now.monotonic_ns;
}

void follow(MemoryTestMode& mode, ControlState& state) {
  if (!mode.begun_ns) return;
  const std::int64_t periods = (state.now.monotonic_ns - *mode.begun_ns) / kPeriod_ns;
  mode.pattern = periods == 0 ? -1 : static_cast<int>((periods - 1) % static_cast<std::int64_t>(kPatterns.size()));
  if (mode.pattern < 0 || !state.is_ram_faulty) return;
  state.message = Message{std::string(text(Text::ram_defective, state.tongue())), 0,
                          std::string(text(Text::said_ram_defective, state.tongue()))};
}

void draw(const MemoryTestMode& mode, const ControlState& state, Monitor& monitor) {
  if (mode.phase != MemoryTestMode::Phase::running) return draw_list(state, monitor);
  if (mode.pattern >= 0) draw_pattern(kPatterns.at(static_cast<std::size_t>(mode.pattern)), monitor);
}

std::string sentence_of(const MemoryTestMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  if (state.storing) return std::string(text(Text::wait_erasing, tongue));
  switch (mode.phase) {
    case MemoryTestMode::Phase::list:
      return std::string(text(Text::wait_memory_list, tongue));
    case MemoryTestMode::Phase::running:
      return std::string(text(Text::wait_memory_running, tongue));
  }
  return {};
}

}  // namespace cnclab::panel
