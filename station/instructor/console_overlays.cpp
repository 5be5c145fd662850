// Input while something lies over the table of seats: a question, a page, a command being typed, a station's screen.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "instructor/command_line.hpp"
#include "instructor/console_model.hpp"

namespace cnclab::instructor {
namespace {

constexpr std::size_t kLongestEntry = 200;

template <class What>
bool is(const Input& input, What what) {
  const auto* given = std::get_if<What>(&input);
  return given != nullptr && *given == what;
}

char32_t character_of(const Input& input) {
  const auto* typed = std::get_if<Typed>(&input);
  return typed == nullptr ? U'\0' : typed->character;
}

Reaction stay(ConsoleModel& model) { return {.model = std::move(model), .request = {}}; }

Reaction close(ConsoleModel& model) {
  model.overlay = Overlay::none;
  return stay(model);
}

Reaction begin_command(ConsoleModel& model) {
  model.overlay = Overlay::entry;
  model.entry.clear();
  model.message = {};
  return stay(model);
}

/// Cuts the last character off, whatever bytes it has.
void take_back(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
  if (!text.empty()) text.pop_back();
}

Reaction send_entry(ConsoleModel& model) {
  auto command = read_command(words_of(model.entry), model.language);
  if (!command) {
    model.message = {command.error(), true};
    return stay(model);
  }
  model.overlay = Overlay::none;
  if (model.link == Link::lost) {
    const station::Text text{"Keine Verbindung: nichts gesendet.", "No connection: nothing was sent."};
    model.message = {std::string(text.in(model.language)), true};
    return stay(model);
  }
  model.message = {};
  if (command->request.has_student_remove() && command->request.student_remove().erase()) {
    model.overlay = Overlay::ask_erase;
    model.asked_about = std::move(command->request);
    return stay(model);
  }
  Reaction reaction = stay(model);
  reaction.is_urgent = command->request.has_halt() || command->request.has_power_off();
  reaction.content_file = command->content_file;
  reaction.is_collection = command->is_collection;
  reaction.sent_file = command->sent_file;
  reaction.request = std::move(command->request);
  return reaction;
}

bool is_yes(const Input& input) {
  const char32_t answer = character_of(input);
  return answer != U'\0' && std::u32string_view(U"jJyY").contains(answer);
}

/// What is deleted for good cannot be restored: only a yes does it.
Reaction react_erase_question(ConsoleModel& model, const Input& input) {
  auto command = std::exchange(model.asked_about, std::nullopt);
  model.overlay = Overlay::none;
  if (is_yes(input) && model.link == Link::connected) {
    Reaction reaction = stay(model);
    reaction.request = std::move(command);
    return reaction;
  }
  const station::Text text{"Nichts gelöscht.", "Nothing deleted."};
  model.message = {.text = std::string(text.in(model.language))};
  return stay(model);
}

Reaction react_entry(ConsoleModel& model, const Input& input) {
  if (is(input, Special::escape)) return close(model);
  if (is(input, Special::enter)) return send_entry(model);
  if (is(input, Special::backspace)) take_back(model.entry);
  const char32_t character = character_of(input);
  if (character >= U' ' && model.entry.size() < kLongestEntry) model.entry += to_utf8(character);
  return stay(model);
}

bool is_key(const Input& input, station::Special key) {
  const auto* const station_key = std::get_if<StationKey>(&input);
  return station_key != nullptr && station_key->key == key;
}

/// The line that a key brings to the top of the page; nothing where it is no key for that.
std::optional<int> top_after(const Input& input, int top, int last) {
  using S = station::Special;
  if (is(input, Special::up)) return top - 1;
  if (is(input, Special::down)) return top + 1;
  if (character_of(input) == U' ' || is_key(input, S::page_down)) return top + kPageLines;
  if (is_key(input, S::page_up)) return top - kPageLines;
  if (is_key(input, S::home)) return 0;
  if (is_key(input, S::end)) return last;
  return std::nullopt;
}

// What is no key of the page does nothing: the rest of a word that somebody types blindly would command the lab.
Reaction react_page(ConsoleModel& model, const Input& input) {
  const int last = std::max(0, static_cast<int>(model.page.size()) - kPageLines);
  if (const auto top = top_after(input, model.page_top, last)) model.page_top = std::clamp(*top, 0, last);
  const bool closes = is(input, Special::escape) || is(input, Special::enter) || is(input, Special::backspace) ||
                      character_of(input) == U'q';
  return closes ? close(model) : stay(model);
}

/// The key of a station's keyboard that an input is.
std::optional<station::Input> station_input(const Input& input) {
  if (const auto* typed = std::get_if<Typed>(&input)) return typed->character;
  if (const auto* key = std::get_if<StationKey>(&input)) return key->key;
  const auto* special = std::get_if<Special>(&input);
  if (special == nullptr) return std::nullopt;
  switch (*special) {
    case Special::up:
      return station::Special::up;
    case Special::down:
      return station::Special::down;
    case Special::enter:
      return station::Special::enter;
    case Special::escape:
      return station::Special::escape;
    case Special::backspace:
      return station::Special::backspace;
    case Special::halt:
    case Special::give_back:
      return std::nullopt;
  }
  return std::nullopt;
}

/// Ends watching; a keyboard that was taken over goes back.
Reaction end_watching(ConsoleModel& model) {
  v1::InstructorRequest request;
  if (model.watched.is_typing)
    request.mutable_give()->set_station(static_cast<std::uint32_t>(model.watched.station));
  else
    request.mutable_watch()->set_station(0);
  model.overlay = Overlay::none;
  model.watched = {};
  Reaction reaction = stay(model);
  reaction.request = std::move(request);
  return reaction;
}

Reaction react_watching(ConsoleModel& model, const Input& input) {
  if (is(input, Special::give_back)) return end_watching(model);
  if (!model.watched.is_typing) {
    if (character_of(input) == U':') {
      Reaction reaction = end_watching(model);
      reaction.model = begin_command(reaction.model).model;
      return reaction;
    }
    if (character_of(input) != U't') return end_watching(model);
    Reaction reaction = stay(model);
    reaction.request.emplace();
    reaction.request->mutable_take()->set_station(static_cast<std::uint32_t>(reaction.model.watched.station));
    return reaction;
  }
  Reaction reaction = stay(model);
  const auto key = station_input(input);
  const station::Binding* binding = key ? station::binding_of(*key) : nullptr;
  if (binding == nullptr) return reaction;
  if (const auto* press = std::get_if<station::Press>(&binding->action)) reaction.keys = press->keys;
  return reaction;
}

}  // namespace

std::optional<Reaction> react_overlaid(ConsoleModel& model, const Input& input) {
  const bool is_watching = model.overlay == Overlay::watching;
  const bool takes_letters = model.overlay == Overlay::entry || (is_watching && model.watched.is_typing);
  const bool halts = is(input, Special::halt) || (!takes_letters && character_of(input) == U'h');
  if (halts) {  // a stop always works; what was typed or watched stays
    if (!takes_letters && !is_watching) model.overlay = Overlay::none;
    return std::nullopt;
  }
  const bool is_text = model.overlay == Overlay::help || model.overlay == Overlay::page;
  if (is_text && character_of(input) == U':') return begin_command(model);
  switch (model.overlay) {
    case Overlay::none:
      return std::nullopt;
    case Overlay::help:
      return close(model);
    case Overlay::ask_quit: {
      Reaction reaction = close(model);
      reaction.quits = is_yes(input);
      return reaction;
    }
    case Overlay::ask_erase:
      return react_erase_question(model, input);
    case Overlay::entry:
      return react_entry(model, input);
    case Overlay::page:
      return react_page(model, input);
    case Overlay::watching:
      return react_watching(model, input);
  }
  return std::nullopt;
}

}  // namespace cnclab::instructor
