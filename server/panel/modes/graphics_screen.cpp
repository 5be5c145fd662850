// What GRAFIK shows and says.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "panel/modes/graphics_mode.hpp"

namespace cnclab::panel {

namespace {

/// "0:12:34".
std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::llround(seconds));
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string percent_text(double share) { return std::to_string(static_cast<int>(std::floor(share * 100))); }

/// Row 16: "P0001 N012  45 %  X-Y    Weg 1234.567 mm  0:12:34  Meldungen 2"
std::string status_line(const GraphicsMode& mode, language::Tongue tongue) {
  constexpr std::array<std::string_view, 4> kViews{"X-Y", "X-Z", "Y-Z", "X-Y-Z"};
  const GraphicTestView& view = mode.view;
  const auto with = [&](const std::string& way) {
    return fmt::format("P{:04} N{:03} {:>3} %  {:5}  {} {} mm  {}  {} {}", view.block.program, view.block.block,
                       percent_text(view.progress), kViews[static_cast<std::size_t>(view.view)],
                       text(Text::graphics_way, tongue), way, duration_text(view.machine_time_s),
                       text(Text::graphics_findings, tongue), view.findings.size() + view.findings_left_off);
  };
  const std::string exact = with(fmt::format("{:.3f}", view.path_mm));
  // On long runs the thousandths of the way give their room to the number of findings.
  return columns_of(exact) <= Monitor::kColumns ? exact : with(fmt::format("{:.0f}", view.path_mm));
}

void draw_prompt(const GraphicsMode& mode, const ControlState& state, Monitor& monitor) {
  constexpr int kRow = 2;
  const std::string_view label = text(Text::program_number, state.tongue());
  monitor.write(kRow, 0, label);
  if (mode.program.value) monitor.write(kRow, columns_of(label), program_word(*mode.program.value));
  monitor.mark(kRow, columns_of(label));
}

std::string finding_sentence(const GraphicsMode& mode, language::Tongue tongue) {
  const GraphicTestView& view = mode.view;
  if (view.findings.empty())
    return text(Text::wait_graphics_sound, tongue,
                {fmt::format("{:.3f}", view.path_mm), duration_text(view.machine_time_s)});
  const std::size_t shown = std::min(mode.finding, view.findings.size() - 1);
  return fmt::format("{}/{} {}", shown + 1, view.findings.size() + view.findings_left_off,
                     testrun::explain(view.findings[shown], tongue));
}

}  // namespace

void draw(const GraphicsMode& mode, const ControlState& state, Monitor& monitor) {
  if (!mode.test) return draw_prompt(mode, state, monitor);
  constexpr int kFirstRow = 2;
  for (int row = 0; row < drawing::BrailleCanvas::kCellRows; ++row)
    monitor.write(kFirstRow + row, 0, mode.view.canvas.row_text(row));
  if (mode.view.block.block != 0) monitor.write(Monitor::kMessageRow, 0, status_line(mode, state.tongue()));
}

std::string sentence_of(const GraphicsMode& mode, const ControlState& state) {
  const language::Tongue tongue = state.tongue();
  if (!mode.test) return std::string(text(Text::wait_graphics_program, tongue));
  if (mode.view.has_ended) return finding_sentence(mode, tongue);
  const std::string program = program_text(mode.program.value.value_or(0));
  if (mode.is_playing) return text(Text::wait_graphics_playing, tongue, {program, percent_text(mode.view.progress)});
  return text(mode.single_block ? Text::wait_graphics_single : Text::wait_graphics_ready, tongue, {program});
}

}  // namespace cnclab::panel
