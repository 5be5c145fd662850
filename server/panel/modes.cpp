// Hands each question to the mode that is active.
#include "panel/modes.hpp"

namespace cnclab::panel {

namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

}  // namespace

ActiveMode open_mode(Mode mode, ControlState& state) {
  switch (mode) {
    case Mode::menu:
      return MenuMode{};
    case Mode::automat:
      return open_automat(state);
    case Mode::editor:
      return open_editor(state);
    case Mode::hand:
    case Mode::hand_input:
    case Mode::teach_in:
    case Mode::external_data:
    case Mode::graphics:
    case Mode::erase_memory:
    case Mode::machine_data:
    case Mode::memory_test:
      return ComingMode{mode};
  }
  return MenuMode{};
}

void close_mode(ActiveMode& mode, ControlState& state) {
  if (auto* automat = std::get_if<AutomatMode>(&mode)) close(*automat, state);
}

Mode mode_of(const ActiveMode& mode) {
  return std::visit(
      Overloaded{[](const MenuMode&) { return Mode::menu; }, [](const EditorMode&) { return Mode::editor; },
                 [](const AutomatMode&) { return Mode::automat; },
                 [](const ComingMode& coming) { return coming.mode; }},
      mode);
}

Place place_of(const ActiveMode& mode, const ControlState& state) {
  return std::visit(
      Overloaded{[](const MenuMode&) { return Place::menu; }, [](const EditorMode& editor) { return place_of(editor); },
                 [&](const AutomatMode& automat) { return place_of(automat, state); },
                 [](const ComingMode& coming) { return place_of(coming); }},
      mode);
}

void press(ActiveMode& mode, ControlState& state, Effect effect, int figure) {
  if (auto* editor = std::get_if<EditorMode>(&mode)) return press(*editor, state, effect, figure);
  if (auto* automat = std::get_if<AutomatMode>(&mode)) return press(*automat, state, effect, figure);
}

void draw(const ActiveMode& mode, const ControlState& state, Monitor& monitor) {
  std::visit([&](const auto& active) { draw(active, state, monitor); }, mode);
}

std::string sentence_of(const ActiveMode& mode, const ControlState& state) {
  return std::visit(Overloaded{[&](const MenuMode&) { return std::string(text(Text::wait_menu, state.tongue())); },
                               [&](const auto& active) { return sentence_of(active, state); }},
                    mode);
}

}  // namespace cnclab::panel
