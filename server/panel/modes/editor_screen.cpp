// Bild 7: what EINGABEMODUS shows.
#include <algorithm>
#include <string>

#include "language/screen_form.hpp"
#include "panel/modes/editor_mode.hpp"

namespace cnclab::panel {

namespace {

constexpr int kPromptRow = 2, kListRow = 3;

void draw_overview(const EditorMode& mode, const ControlState& state, Monitor& monitor) {
  const auto& programs = state.memory.programs();
  if (programs.empty()) return monitor.write(kListRow, 0, text(Text::no_programs, state.tongue()));
  const std::size_t end = std::min(programs.size(), *mode.overview + kProgramsPerLine * kOverviewLines);
  for (std::size_t i = *mode.overview; i < end; ++i) {
    const auto place = static_cast<int>(i - *mode.overview);
    const int row = kListRow + place / static_cast<int>(kProgramsPerLine);
    const int column =
        place % static_cast<int>(kProgramsPerLine) * (Monitor::kColumns / static_cast<int>(kProgramsPerLine));
    monitor.write(row, column, program_word(programs[i].number));
  }
}

/// The listed blocks; returns the row below them.
int draw_list(const EditorMode& mode, const ControlState& state, Monitor& monitor) {
  const language::Program* program = program_in(state, mode.number());
  if (program == nullptr || !mode.list_from) return kListRow;
  auto block = std::ranges::lower_bound(program->blocks, *mode.list_from, {}, &language::Block::number);
  int row = kListRow;
  if (block == program->blocks.end()) return row;
  language::Plane plane = plane_before(program, block->number, state.plane());
  for (; block != program->blocks.end() && row < kListRow + kListedBlocks; ++block, ++row) {
    monitor.write(row, 0, language::block_line(*block, language::plane_of_words(*block, plane), state.tongue()));
    plane = plane_before(program, block->number + 1, state.plane());
  }
  return row;
}

}  // namespace

language::Plane plane_before(const language::Program* program, int block, language::Plane fallback) {
  constexpr std::uint8_t kFirstPlane = 17, kLastPlane = 19;
  if (program == nullptr) return fallback;
  language::Plane plane = fallback;
  for (const language::Block& earlier : program->blocks) {
    if (earlier.number >= block) break;
    const language::Function function = earlier.function;
    if (function.kind != language::Function::Kind::g || function.code < kFirstPlane || function.code > kLastPlane)
      continue;
    plane = static_cast<language::Plane>(function.code - kFirstPlane);
  }
  return plane;
}

std::optional<geometry::SourceBlock> damaged_block(const EditorMode& mode, const ControlState& state) {
  const language::Program* program = mode.is_open ? program_in(state, mode.number()) : nullptr;
  if (program == nullptr || !mode.list_from) return std::nullopt;
  auto block = std::ranges::lower_bound(program->blocks, *mode.list_from, {}, &language::Block::number);
  for (int line = 0; block != program->blocks.end() && line < kListedBlocks; ++block, ++line)
    if (block->is_damaged) return geometry::SourceBlock{program->number, block->number};
  return std::nullopt;
}

void draw(const EditorMode& mode, const ControlState& state, Monitor& monitor) {
  const std::string_view label = text(Text::program_number, state.tongue());
  const int column = columns_of(label);
  monitor.write(kPromptRow, 0, label);
  if (mode.program.value) monitor.write(kPromptRow, column, program_word(*mode.program.value));
  if (!mode.is_open) {
    monitor.mark(kPromptRow, column);
    if (mode.overview) draw_overview(mode, state, monitor);
    return;
  }
  const int row = draw_list(mode, state, monitor);
  mode.line.draw(monitor, row, mode.plane, state.tongue());
}

std::string sentence_of(const EditorMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  if (state.storing) return std::string(text(Text::wait_store, tongue));
  switch (place_of(mode)) {
    case Place::editor_program:
      if (mode.overview) return std::string(text(Text::wait_overview, tongue));
      if (!mode.program.value) return std::string(text(Text::wait_editor_empty, tongue));
      return text(Text::wait_editor_program, tongue, {program_text(*mode.program.value)});
    case Place::editor_number:
      return std::string(
          text(language::is_reserved_for_cycles(mode.number()) ? Text::wait_rom_number : Text::wait_number, tongue));
    case Place::editor_function:
      return std::string(text(Text::wait_function, tongue));
    default: {
      const auto& content = mode.line.content();
      const char letter = language::letter(content.words[content.word].address);
      return text(Text::wait_word, tongue, {std::string_view(&letter, 1)});
    }
  }
}

}  // namespace cnclab::panel
