// The memory test of the CMOS RAM (6.4, ERR-030 to ERR-034, D-120). It destroys what the memory holds; row 18 says so
// beside the list.
//
//   list of pages ──SPEICHER LÖSCHEN──▶ memory erased ──2 s──▶ patterns, each 2 s, until RESET
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "panel/control_state.hpp"
#include "panel/key_table.hpp"
#include "panel/screen/canvas.hpp"

namespace cnclab::panel {

struct MemoryTestMode {
  enum class Phase : std::uint8_t { list, running };
  Phase phase = Phase::list;
  std::optional<std::int64_t> begun_ns;  ///< monotonic; nothing while the contents are being erased
  int pattern = -1;                      ///< index of the pattern that is written now, -1 before the first
};

[[nodiscard]] Place place_of(const MemoryTestMode& mode);
void press(MemoryTestMode& mode, ControlState& state, Effect effect, int figure);
/// Patterns change by the clock.
void follow(MemoryTestMode& mode, ControlState& state);
void draw(const MemoryTestMode& mode, const ControlState& state, Monitor& monitor);
[[nodiscard]] std::string sentence_of(const MemoryTestMode& mode, const ControlState& state);
void stored(MemoryTestMode& mode, ControlState& state, const StoreRequest& request);

}  // namespace cnclab::panel
