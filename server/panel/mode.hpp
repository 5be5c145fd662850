// The operating modes of one control.
#pragma once

#include <cstdint>
#include <string_view>

namespace cnclab::panel {

/// The operating modes (0 Conventions of the requirement list).
enum class Mode : std::uint8_t {
  menu,
  hand,
  hand_input,
  teach_in,
  automat,
  external_data,
  graphics,
  erase_memory,
  editor,
  machine_data,
  memory_test,
};

inline constexpr int kModes = static_cast<int>(Mode::memory_test) + 1;

/// The mode's name as screens and `status` give it: "MENU", "HANDBETRIEB", "AUTOMAT", "EINGABEMODUS", …
[[nodiscard]] std::string_view name_of(Mode mode);

}  // namespace cnclab::panel
