// Hands each question to the mode that is active.
#include "panel/modes/modes.hpp"

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
    case Mode::hand:
      return open_hand(state);
    case Mode::hand_input:
      return open_hand_input(state);
    case Mode::teach_in:
      return open_teach_in(state);
    case Mode::automat:
      return open_automat(state);
    case Mode::erase_memory:
      return EraseMemoryMode{};
    case Mode::editor:
      return open_editor(state);
    case Mode::graphics:
      return open_graphics(state);
    case Mode::external_data:
      return open_external_data(state);
    case Mode::machine_data:
      return open_machine_data(state);
    case Mode::memory_test:
      return MemoryTestMode{};
  }
  return MenuMode{};
}

void close_mode(ActiveMode& mode, ControlState& state) {
  std::visit(Overloaded{[&](auto& active)
                          requires requires { close(active, state); }
                        { close(active, state); },
                        [](const auto&) {}},
                        mode);
}

Mode mode_of(const ActiveMode& mode) {
  return std::visit(
      Overloaded{
          [](const MenuMode&) { return Mode::menu; }, [](const HandMode&) { return Mode::hand; },
          [](const HandInputMode&) { return Mode::hand_input; }, [](const TeachInMode&) { return Mode::teach_in; },
          [](const EraseMemoryMode&) { return Mode::erase_memory; }, [](const GraphicsMode&) { return Mode::graphics; },
          [](const ExternalDataMode&) { return Mode::external_data; },
          [](const MachineDataMode&) { return Mode::machine_data; },
          [](const MemoryTestMode&) { return Mode::memory_test; }, [](const AutomatMode&) { return Mode::automat; },
          [](const EditorMode&) { return Mode::editor; }},
      mode);
}

Place place_of(const ActiveMode& mode, const ControlState& state) {
  return std::visit(Overloaded{[](const MenuMode&) { return Place::menu; },
                               [&](const HandInputMode& input) { return place_of(input, state); },
                               [&](const AutomatMode& automat) { return place_of(automat, state); },
                               [&](const ExternalDataMode& external) { return place_of(external, state); },
                               [](const auto& active) { return place_of(active); }},
                    mode);
}

void disarm(ActiveMode& mode, Effect effect) {
  std::visit(Overloaded{[&](auto& active)
                          requires requires { disarm(active, effect); }
                        { disarm(active, effect); },
                        [](const auto&) {}},
                        mode);
}

void press(ActiveMode& mode, ControlState& state, Effect effect, int figure) {
  std::visit(Overloaded{[&](auto& active)
                          requires requires { press(active, state, effect, figure); }
                        { press(active, state, effect, figure); },
                        [](const auto&) {}},
                        mode);
}

void follow(ActiveMode& mode, ControlState& state) {
  std::visit(Overloaded{[&](auto& active)
                          requires requires { follow(active, state); }
                        { follow(active, state); },
                        [](const auto&) {}},
                        mode);
}

void stored(ActiveMode& mode, ControlState& state, const StoreRequest& request) {
  std::visit(Overloaded{[&](auto& active)
                          requires requires { stored(active, state, request); }
                        { stored(active, state, request); },
                        [](const auto&) {}},
                        mode);
}

bool acts(const ActiveMode& mode, Effect effect) {
  return std::visit(Overloaded{[&](const auto& active)
                                 requires requires { active.line.acts(effect); }
                               { return active.line.acts(effect); },
                               [](const auto&) { return true; }},
                               mode);
}

bool is_of_use(const ActiveMode& mode, const ControlState& state, Effect effect, Key key) {
  const auto* external = std::get_if<ExternalDataMode>(&mode);
  if (external != nullptr && effect == Effect::digit) return is_of_use(*external, state, digit_of(key).value_or(0));
  const auto* editor = std::get_if<EditorMode>(&mode);
  const bool is_rom = editor != nullptr && editor->is_open && language::is_reserved_for_cycles(editor->number());
  const bool is_change = effect == Effect::store || effect == Effect::erase_block;
  if (effect == Effect::erase_block && editor != nullptr && !editor->line.is_loaded()) return false;
  return acts(mode, effect) && !(is_rom && is_change);
}

void draw(const ActiveMode& mode, const ControlState& state, Monitor& monitor) {
  std::visit([&](const auto& active) { draw(active, state, monitor); }, mode);
}

std::optional<geometry::SourceBlock> damaged_block(const ActiveMode& mode, const ControlState& state) {
  return std::visit(Overloaded{[&](const EditorMode& editor) { return damaged_block(editor, state); },
                               [&](const AutomatMode& automat) { return damaged_block(automat, state); },
                               [](const auto&) { return std::optional<geometry::SourceBlock>{}; }},
                    mode);
}

std::string sentence_of(const ActiveMode& mode, const ControlState& state) {
  return std::visit(Overloaded{[&](const MenuMode&) { return std::string(text(Text::wait_menu, state.tongue())); },
                               [&](const auto& active) { return sentence_of(active, state); }},
                    mode);
}

}  // namespace cnclab::panel
