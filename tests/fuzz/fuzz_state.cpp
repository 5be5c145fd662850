// Feeds any text to the reader of a control's kept state: the control that comes of it works, and what it keeps itself
// is read back equal (SEAT-004).
#include <cstdint>
#include <cstdlib>
#include <string>

#include "panel/control.hpp"

namespace panel = cnclab::panel;
using cnclab::Key;

namespace {

const panel::Now kNow{.monotonic_ns = 1'000'000'000, .wall = {}};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  panel::Control control(panel::Settings{}, panel::Memory(16'384), cnclab::machine::MachineData{});
  control.restore_state(text);
  static_cast<void>(control.draw(kNow, {}));
  const std::string kept = control.save_state();
  panel::Control again(panel::Settings{}, panel::Memory(16'384), cnclab::machine::MachineData{});
  again.restore_state(kept);
  if (again.save_state() != kept) std::abort();
  for (const Key key :
       {Key::ENTER, Key::D1, Key::EINGABE, Key::DOWN, Key::MENU, Key::AUTOMAT, Key::ENTER, Key::ENTER}) {
    static_cast<void>(control.press(key, kNow));
    static_cast<void>(control.draw(kNow, {}));
  }
  return 0;
}
