// Fuzzer of screen updates: whatever a server sends, a terminal gets 24 rows of 80 harmless cells or none (SEC-006).
#include <cnclab/v1/screen.pb.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "shared/screen_wire.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cnclab::v1::ScreenUpdate update;
  if (!update.ParseFromArray(data, static_cast<int>(size))) return 0;
  const cnclab::Screen blank;
  const auto applied = cnclab::apply_rows(blank, update);
  if (!applied) {
    if (applied.error().empty()) std::abort();
    return 0;
  }
  for (int row = 0; row < cnclab::Screen::kRows; ++row) {
    if (cnclab::from_utf8(applied->text(row)).size() != cnclab::Screen::kColumns) std::abort();
    for (const cnclab::Cell& cell : applied->row(row)) {
      if (cell.code < 0x20 || (cell.code >= 0x7F && cell.code < 0xA0)) std::abort();
    }
  }
  // The way back: the difference to a blank screen, applied, is the same screen.
  cnclab::v1::ScreenUpdate again;
  cnclab::write_rows(blank, *applied, again);
  const auto twice = cnclab::apply_rows(blank, again);
  if (!twice || !(*twice == *applied)) std::abort();
  return 0;
}
