// The table from function code to handler; a further function is a further row.
#include "program/functions.hpp"

#include <fmt/core.h>

#include <array>

namespace cnclab::program {

namespace {

constexpr std::size_t kCodes = 100;

struct Row {
  std::size_t code;
  Handler handler;
};

constexpr std::array kRows{
    Row{0, execute_rapid},
    Row{1, execute_line},
    Row{2, execute_clockwise_arc},
    Row{3, execute_counterclockwise_arc},
    Row{4, dwell},
    Row{5, execute_clockwise_by_radius},
    Row{6, execute_counterclockwise_by_radius},
    Row{7, execute_clockwise_helix},
    Row{8, execute_counterclockwise_helix},
    Row{10, round_corner},
    Row{11, only_words},
    Row{12, execute_fourth_axis},
    Row{17, select_plane_xy},
    Row{18, select_plane_xz},
    Row{19, select_plane_yz},
    Row{20, jump},
    Row{21, jump_on_input},
    Row{22, call},
    Row{23, call_on_input},
    Row{40, cancel_radius_compensation},
    Row{41, compensate_left},
    Row{42, compensate_right},
    Row{43, lengthen_ways},
    Row{44, shorten_ways},
    Row{45, cancel_length_compensation},
    Row{46, compensate_length},
    Row{61, with_exact_stop<execute_line>},
    Row{62, with_exact_stop<execute_clockwise_arc>},
    Row{63, with_exact_stop<execute_counterclockwise_arc>},
    Row{64, dwell},  // stands still anyway
    Row{65, with_exact_stop<execute_clockwise_by_radius>},
    Row{66, with_exact_stop<execute_counterclockwise_by_radius>},
    Row{68, set_actual},
    Row{69, search_switches},
    Row{74, cancel_scale},
    Row{75, set_scale},
    Row{81, execute_cycle},
    Row{82, execute_cycle},
    Row{83, execute_cycle},
    Row{84, execute_cycle},
    Row{85, execute_cycle},
    Row{86, execute_cycle},
    Row{90, select_absolute},
    Row{91, select_incremental},
};

constexpr std::array kParametricRows{
    Row{0, assign_value},    Row{1, calculate},       Row{2, calculate},       Row{3, calculate},
    Row{4, calculate},       Row{10, calculate},      Row{11, calculate},      Row{12, calculate},
    Row{13, calculate},      Row{14, calculate},      Row{15, calculate},      Row{16, calculate},
    Row{17, calculate},      Row{50, jump_on_result}, Row{51, jump_on_result}, Row{52, jump_on_result},
    Row{53, jump_on_result}, Row{54, jump_on_result},
};

constexpr std::array<Handler, kCodes> by_code(std::span<const Row> rows) {
  std::array<Handler, kCodes> table{};
  for (const Row& row : rows) table[row.code] = row.handler;
  return table;
}

constexpr std::array<Handler, kCodes> kGFunctions = by_code(kRows);
constexpr std::array<Handler, kCodes> kParametricFunctions = by_code(kParametricRows);

/// "G41", "↓01".
std::string name_of(language::Function function) {
  const bool is_parametric = function.kind == language::Function::Kind::parametric;
  return fmt::format("{}{:02}", is_parametric ? "↓" : "G", function.code);
}

}  // namespace

Handler handler_of(language::Function function) {
  switch (function.kind) {
    case language::Function::Kind::g:
      return function.code < kCodes ? kGFunctions[function.code] : nullptr;
    case language::Function::Kind::parametric:
      return function.code < kCodes ? kParametricFunctions[function.code] : nullptr;
    case language::Function::Kind::tool:
      return nullptr;
  }
  return nullptr;
}

Outcome executable(const language::Block& block, geometry::SourceBlock source, const language::Vocabulary& vocabulary) {
  const bool is_known = language::find_form(block.function, language::Plane::xy, vocabulary) != nullptr;
  if (is_known && handler_of(block.function) != nullptr) return {};
  const char word = block.function.kind == language::Function::Kind::parametric ? '\0' : 'G';
  return error_at(language::ErrorCode::function_unknown, source, word, name_of(block.function));
}

}  // namespace cnclab::program
