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

/// What each letter asks the server to do; nothing for other letters.
std::optional<v1::InstructorRequest> request_for(char32_t character, const ConsoleModel& model) {
  v1::InstructorRequest request;
  switch (character) {
    case U's':
      request.mutable_select()->set_station(chosen_station(model));
      break;
    case U'S':
      request.mutable_select()->set_station(chosen_station(model));
      request.mutable_select()->set_force(true);
      break;
    case U'r':
      request.mutable_release();
      break;
    case U'R':
      request.mutable_release()->set_force(true);
      break;
    case U'h':
      request.mutable_halt();
      break;
    case U'c':
      request.mutable_clear_halt();
      break;
    case U'p':
      if (model.status && model.status->machine().state() == "off") {
        request.mutable_power_on();
      } else {
        request.mutable_power_off();
      }
      break;
    default:
      return std::nullopt;
  }
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

/// A question or the help page takes the next key; a stop always works.
std::optional<Reaction> react_overlaid(ConsoleModel& model, const Input& input) {
  if (model.overlay == Overlay::none) return std::nullopt;
  const auto* typed = std::get_if<Typed>(&input);
  const auto* special = std::get_if<Special>(&input);
  const bool stops = (typed && typed->character == U'h') || (special && *special == Special::halt);
  const bool agrees = typed && std::u32string_view(U"jJyY").contains(typed->character);
  const bool quits = model.overlay == Overlay::ask_quit && agrees;
  model.overlay = Overlay::none;
  if (stops) return std::nullopt;
  return Reaction{.model = std::move(model), .request = {}, .quits = quits};
}

Reaction react_typed(ConsoleModel model, char32_t character) {
  if (character >= U'1' && character <= U'9') return choose(std::move(model), static_cast<int>(character - U'0'));
  if (character == U'?') {
    model.overlay = Overlay::help;
    return {.model = std::move(model), .request = {}};
  }
  if (character == U'q') return ask_quit(std::move(model));
  auto request = request_for(character, model);
  if (request) return ask_server(std::move(model), std::move(*request));
  model.message = say(model, {"Diese Taste hat hier keine Wirkung; ? zeigt alle Tasten.",
                              "This key does nothing here; ? shows all keys."});
  return {.model = std::move(model), .request = {}};
}

Reaction react_special(ConsoleModel model, Special special) {
  switch (special) {
    case Special::up:
      return choose(std::move(model), model.chosen - 1);
    case Special::down:
      return choose(std::move(model), model.chosen + 1);
    case Special::enter:
      return react_typed(std::move(model), U's');
    case Special::halt:
      return react_typed(std::move(model), U'h');
    case Special::escape:
      break;
  }
  model.message = {};
  return {.model = std::move(model), .request = {}};
}

Message done_message(const ConsoleModel& model, const v1::InstructorRequest& request) {
  if (request.has_select()) {
    const auto form = Text{"Platz {}: Steuerung angeboten; der Platz nimmt mit START an.",
                           "Seat {}: control offered; the seat accepts with START."};
    return {fmt::format(fmt::runtime(form.in(model.language)), request.select().station()), false};
  }
  if (request.has_release()) return say(model, {"Niemand hat die Steuerung.", "Nobody has control."});
  if (request.has_halt()) return say(model, {"MASCHINE HALT. c hebt ihn auf.", "MACHINE HALT. c clears it."});
  if (request.has_clear_halt()) return say(model, {"Halt aufgehoben.", "Halt cleared."});
  if (request.has_power_off()) return say(model, {"Antriebe stromlos. p schaltet ein.", "Drives off. p switches on."});
  if (request.has_power_on()) return say(model, {"Antriebe eingeschaltet.", "Drives on."});
  return {};
}

}  // namespace

const v1::StationStatus* seat_of(const v1::Status& status, int seat) {
  const auto found = std::ranges::find_if(
      status.stations(), [&](const auto& entry) { return entry.station() == static_cast<std::uint32_t>(seat); });
  return found == status.stations().end() ? nullptr : &*found;
}

Reaction react(ConsoleModel model, const Input& input) {
  if (auto reaction = react_overlaid(model, input)) return std::move(*reaction);
  return std::visit(Overloaded{[&](const Typed& typed) { return react_typed(std::move(model), typed.character); },
                               [&](Special special) { return react_special(std::move(model), special); },
                               [&](const Clicked& clicked) {
                                 const int seat = clicked.row - kFirstSeatRow + 1;
                                 const bool is_seat = seat >= 1 && seat <= kSeats;
                                 return choose(std::move(model), is_seat ? seat : model.chosen);
                               }},
                    input);
}

ConsoleModel with_answer(ConsoleModel model, const v1::InstructorRequest& request, const v1::InstructorAnswer& answer) {
  if (!answer.error().empty()) {
    model.message = {answer.error(), true};
    return model;
  }
  const bool has_detail =
      !answer.items().empty() && answer.items(0).has_done() && !answer.items(0).done().detail().empty();
  model.message = has_detail ? Message{answer.items(0).done().detail(), false} : done_message(model, request);
  return model;
}

}  // namespace cnclab::instructor
