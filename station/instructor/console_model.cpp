// What the console knows and what a key or a message does to it; no terminal, no network.
#include "instructor/console_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cnclab::instructor {
namespace {

using station::Text;
template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

Message say(const ConsoleModel& model, const Text& text, bool is_error = false) {
  return {std::string(text.in(model.language)), is_error};
}

std::uint32_t chosen_station(const ConsoleModel& model) { return static_cast<std::uint32_t>(model.chosen); }

void fill_select(v1::InstructorRequest& request, const ConsoleModel& model, bool force) {
  request.mutable_select()->set_station(chosen_station(model));
  request.mutable_select()->set_force(force);
}

void fill_power(v1::InstructorRequest& request, const ConsoleModel& model) {
  const bool is_off = model.status && model.status->machine().state() == "off";
  is_off ? request.mutable_power_on() : request.mutable_power_off();
}

void fill_lock(v1::InstructorRequest& request, const ConsoleModel& model) {
  const auto* seat = model.status ? seat_of(*model.status, model.chosen) : nullptr;
  const bool is_locked = seat != nullptr && seat->locked();
  (is_locked ? request.mutable_unlock() : request.mutable_lock())->set_station(chosen_station(model));
}

void fill_show(v1::InstructorRequest& request, const ConsoleModel& model) {
  const bool is_shown = model.status && model.status->shown() == chosen_station(model);
  request.mutable_show()->set_station(is_shown ? 0 : chosen_station(model));
}

/// What each letter asks the server to do.
struct Letter {
  char32_t character;
  void (*fill)(v1::InstructorRequest& request, const ConsoleModel& model);
};

constexpr Letter kLetters[] = {
    {U's', [](auto& request, const auto& model) { fill_select(request, model, false); }},
    {U'S', [](auto& request, const auto& model) { fill_select(request, model, true); }},
    {U'r', [](auto& request, const auto&) { request.mutable_release(); }},
    {U'R', [](auto& request, const auto&) { request.mutable_release()->set_force(true); }},
    {U'h', [](auto& request, const auto&) { request.mutable_halt(); }},
    {U'c', [](auto& request, const auto&) { request.mutable_clear_halt(); }},
    {U'p', fill_power},
    {U'l', fill_lock},
    {U'v', fill_show},
    {U'w', [](auto& request, const auto& model) { request.mutable_watch()->set_station(chosen_station(model)); }},
    {U't', [](auto& request, const auto& model) { request.mutable_take()->set_station(chosen_station(model)); }},
    {U'g', [](auto& request, const auto& model) { request.mutable_give()->set_station(chosen_station(model)); }},
};

std::optional<v1::InstructorRequest> request_for(char32_t character, const ConsoleModel& model) {
  const auto* const letter = std::ranges::find(kLetters, character, &Letter::character);
  if (letter == std::end(kLetters)) return std::nullopt;
  v1::InstructorRequest request;
  letter->fill(request, model);
  return request;
}

Reaction ask_server(ConsoleModel model, v1::InstructorRequest request) {
  if (model.link == Link::lost) {
    model.message = say(model, {"Keine Verbindung: nichts gesendet.", "No connection: nothing was sent."}, true);
    return {.model = std::move(model), .request = {}};
  }
  model.message = {};
  const bool is_urgent = request.has_halt() || request.has_power_off();
  return {.model = std::move(model), .request = std::move(request), .is_urgent = is_urgent};
}

Reaction ask_quit(ConsoleModel model) {
  const bool has_control = model.status && model.status->selected() != 0;
  if (!has_control) return {.model = std::move(model), .request = {}, .quits = true};
  model.overlay = Overlay::ask_quit;
  return {.model = std::move(model), .request = {}};
}

Reaction choose(ConsoleModel model, int seat) {
  model.chosen = std::clamp(seat, 1, kSeats);
  return {.model = std::move(model), .request = {}};
}

/// A command to be completed and sent with Enter.
Reaction begin_entry(ConsoleModel model, std::string text) {
  model.overlay = Overlay::entry;
  model.entry = std::move(text);
  model.message = {};
  return {.model = std::move(model), .request = {}};
}

/// Letters that begin a command line; nothing for other letters.
std::optional<std::string> entry_for(char32_t character, int seat) {
  switch (character) {
    case U':':
      return "";
    case U'm':
      return fmt::format("message {} ", seat);
    case U'M':
      return "message all ";
    case U'x':
      return fmt::format("expel {}", seat);
    default:
      return std::nullopt;
  }
}

Reaction react_typed(ConsoleModel model, char32_t character) {
  if (character >= U'1' && character <= U'9') return choose(std::move(model), static_cast<int>(character - U'0'));
  if (character == U'?') {
    model.overlay = Overlay::help;
    return {.model = std::move(model), .request = {}};
  }
  if (auto entry = entry_for(character, model.chosen)) return begin_entry(std::move(model), std::move(*entry));
  if (character == U'q') return ask_quit(std::move(model));
  auto request = request_for(character, model);
  if (request) return ask_server(std::move(model), std::move(*request));
  model.message = say(model, {"Diese Taste hat hier keine Wirkung; ? zeigt alle Tasten.",
                              "This key does nothing here; ? shows all keys."});
  return {.model = std::move(model), .request = {}};
}

Reaction react_special(ConsoleModel model, Special special) {
  const int chosen = model.chosen;
  switch (special) {
    case Special::up:
      return choose(std::move(model), chosen - 1);
    case Special::down:
      return choose(std::move(model), chosen + 1);
    case Special::enter:
      return react_typed(std::move(model), U's');
    case Special::halt:
      return react_typed(std::move(model), U'h');
    case Special::escape:
    case Special::backspace:
    case Special::give_back:
      break;
  }
  model.message = {};
  return {.model = std::move(model), .request = {}};
}

}  // namespace

const v1::StationStatus* seat_of(const v1::Status& status, int seat) {
  const auto found = std::ranges::find_if(
      status.stations(), [&](const auto& entry) { return entry.station() == static_cast<std::uint32_t>(seat); });
  return found == status.stations().end() ? nullptr : &*found;
}

bool stops(const ConsoleModel& model, const Input& input) {
  const auto* const special = std::get_if<Special>(&input);
  if (special != nullptr) return *special == Special::halt;
  const auto* const typed = std::get_if<Typed>(&input);
  const auto* const pasted = std::get_if<Pasted>(&input);
  if (typed == nullptr && pasted == nullptr) return false;
  const char32_t character = typed != nullptr ? typed->character : pasted->character;
  if (model.overlay == Overlay::entry) return false;
  const bool is_typing = model.overlay == Overlay::watching && model.watched.is_typing;
  return is_typing ? station::is_stop(station::Input(character)) : character == U'h';
}

Reaction react(ConsoleModel model, const Input& pressed) {
  if (model.is_too_small && !stops(model, pressed)) return {.model = std::move(model), .request = {}};
  Input input = pressed;
  if (const auto* const pasted = std::get_if<Pasted>(&pressed)) {
    if (model.overlay != Overlay::entry && !stops(model, pressed)) return {.model = std::move(model), .request = {}};
    input = Typed{pasted->character};
  }
  if (auto reaction = react_overlaid(model, input)) return std::move(*reaction);
  return std::visit(Overloaded{[&](const Typed& typed) { return react_typed(std::move(model), typed.character); },
                               [&](Special special) { return react_special(std::move(model), special); },
                               [&](const StationKey&) { return Reaction{.model = std::move(model), .request = {}}; },
                               [&](const Pasted&) { return Reaction{.model = std::move(model), .request = {}}; },
                               [&](const Clicked& clicked) {
                                 const int seat = clicked.row - kFirstSeatRow + 1;
                                 const bool is_seat = seat >= 1 && seat <= kSeats;
                                 const int chosen = is_seat ? seat : model.chosen;
                                 return choose(std::move(model), chosen);
                               }},
                    input);
}

ConsoleModel with_status(ConsoleModel model, const v1::Status& status) {
  model.status = status;
  if (model.message.is_of_halt && status.halted_by().empty()) model.message = {};
  const auto* const seat = seat_of(status, model.watched.station);
  if (model.watched.is_typing && (seat == nullptr || seat->taken_by() != model.user)) {
    model.watched.is_typing = false;
    model.message = say(model, {"Die Tastatur ist zurückgegeben.", "The keyboard is given back."});
  }
  return model;
}

ConsoleModel with_screen(ConsoleModel model, const Screen& screen) {
  model.watched.screen = screen;
  return model;
}

ConsoleModel with_line(ConsoleModel model, Link link) {
  model.link = link;
  model.message = {};  // of what was sent over the line before
  if (model.overlay == Overlay::watching) model.overlay = Overlay::none;
  model.watched = {};
  return model;
}

}  // namespace cnclab::instructor
