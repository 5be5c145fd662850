// Faults of a command explained from what the parser knows of it.
#include "instructor/command_fault.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace cnclab::instructor {
namespace {

using station::Language;
using station::Text;

/// The innermost command that was begun; `app` itself where there was none.
const CLI::App& begun(const CLI::App& app) {
  const CLI::App* innermost = &app;
  while (!innermost->get_subcommands().empty()) innermost = innermost->get_subcommands().front();
  return *innermost;
}

/// What an option takes, without what its checks add.
std::string type_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

std::string usage_of(const CLI::Option& option) {
  const bool is_flag = option.get_items_expected_max() == 0;
  std::string text = option.get_positional() ? type_of(option) : option.get_name();
  if (!option.get_positional() && !is_flag) text += " " + type_of(option);
  if (option.get_positional() && option.get_items_expected_max() >= CLI::detail::expected_max_vector_size) text += "…";
  return option.get_required() ? text : "[" + text + "]";
}

/// The option whose name begins a message as the parser forms it: "station: …" or "station is required".
const CLI::Option* option_in(const CLI::App& command, const std::string& message) {
  const auto options = command.get_options();
  const auto found = std::ranges::find_if(options, [&](const CLI::Option* option) {
    const std::string name = option->get_name();
    return message.starts_with(name + ":") || message.starts_with(name + " is required");
  });
  return found == options.end() ? nullptr : *found;
}

std::string form(const Text& text, Language language, const auto&... values) {
  return fmt::format(fmt::runtime(text.in(language)), values...);
}

/// An option's value that its check has refused.
std::string refused_value(const CLI::Option& option, Language language) {
  const std::string value = fmt::format("{}", fmt::join(option.results(), " "));
  const std::string type = type_of(option);
  if (type == "FILE" || type == "FOLDER")
    return form({"„{}“ gibt es nicht.", "\"{}\" does not exist."}, language, value);
  return form({"„{}“ passt nicht zu {}.", "\"{}\" does not fit {}."}, language, value, type);
}

}  // namespace

std::string usage_of(const CLI::App& command) {
  std::string text = command.get_name();
  const auto* parent = command.get_parent();
  if (parent != nullptr && parent->get_parent() != nullptr) text = parent->get_name() + " " + text;
  for (const bool positional : {true, false})
    for (const auto* option : command.get_options())
      if (option->get_positional() == positional && option->get_name() != "--help") text += " " + usage_of(*option);
  const auto below = command.get_subcommands([](const CLI::App* sub) { return !sub->get_name().empty(); });
  for (std::size_t i = 0; i < below.size(); ++i) text += (i == 0 ? " " : "|") + below[i]->get_name();
  return text;
}

std::string fault_text(const CLI::App& app, const CLI::ParseError& error, Language language) {
  std::string message = error.what();
  if (const auto* unfit = dynamic_cast<const UnfitFile*>(&error))
    return message + ": " + std::string(unfit->why().in(language));
  const CLI::App& command = begun(app);
  const CLI::Option* option = option_in(command, message);
  if (option == nullptr) option = option_in(app, message);
  const bool is_extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  const auto extra = is_extra ? app.remaining(true) : std::vector<std::string>{};
  std::string fault;
  if (&command == &app) {
    if (!extra.empty())
      return form({"Den Befehl „{}“ gibt es nicht.", "There is no command \"{}\"."}, language, extra.front());
    if (option == nullptr) return message;
    return option->get_name() + ": " + refused_value(*option, language);
  }
  if (!extra.empty()) {
    fault = form({"„{}“ ist zu viel.", "\"{}\" is too much."}, language, extra.front());
  } else if (option != nullptr && !option->results().empty()) {
    fault = refused_value(*option, language);
  } else {
    fault = form({"Unvollständig oder widersprüchlich.", "Incomplete or contradictory."}, language);
  }
  return fault + " " + form({"So: {}", "Usage: {}"}, language, usage_of(command));
}

}  // namespace cnclab::instructor
