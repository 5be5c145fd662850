// Faults of a command explained from what the parser knows of it.
#include "station/command_fault.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace cnclab::station {
namespace {

/// The innermost command that was begun; `app` itself where there was none.
const CLI::App& begun(const CLI::App& app) {
  const CLI::App* innermost = &app;
  while (!innermost->get_subcommands().empty()) innermost = innermost->get_subcommands().front();
  return *innermost;
}

/// What an option takes, without what its checks add behind a colon.
std::string type_of(const CLI::Option& option) {
  constexpr std::string_view kAddress = "HOST:PORT";
  const std::string type = option.get_type_name();
  if (type.starts_with(kAddress)) return std::string(kAddress);
  return type.substr(0, type.find(':'));
}

std::string usage_of(const CLI::Option& option) {
  const bool is_flag = option.get_items_expected_max() == 0;
  std::string text = option.get_positional() ? type_of(option) : option.get_name();
  if (!option.get_positional() && !is_flag) text += " " + type_of(option);
  if (option.get_positional() && option.get_items_expected_max() >= CLI::detail::expected_max_vector_size) text += "…";
  return option.get_required() ? text : "[" + text + "]";
}

/// The option that a message of the parser is about: "--station: …", "--server is required", "… --x = abc".
const CLI::Option* option_in(const CLI::App& command, const std::string& message) {
  const auto options = command.get_options();
  const auto found = std::ranges::find_if(options, [&](const CLI::Option* option) {
    const std::string name = option->get_name();
    return message.starts_with(name + ":") || message.starts_with(name + " is required") ||
           message.contains(": " + name + " = ");
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
  if (type == "FILE") return form({"Die Datei „{}“ gibt es nicht.", "There is no file \"{}\"."}, language, value);
  if (type == "FOLDER") return form({"Den Ordner „{}“ gibt es nicht.", "There is no folder \"{}\"."}, language, value);
  return form({"„{}“ passt nicht zu {}.", "\"{}\" does not fit {}."}, language, value, type);
}

/// "--look-on excludes --take-over"; nothing for other faults.
std::optional<std::string> exclusion(const CLI::ParseError& error, Language language) {
  constexpr std::string_view kExcludes = " excludes ";
  const std::string message = error.what();
  const auto place = message.find(kExcludes);
  if (dynamic_cast<const CLI::ExcludesError*>(&error) == nullptr || place == std::string::npos) return std::nullopt;
  return form({"{} und {} schließen einander aus.", "{} and {} exclude each other."}, language,
              message.substr(0, place), message.substr(place + kExcludes.size()));
}

/// A fault of an option that belongs to no command.
std::string option_fault(const CLI::Option& option, Language language) {
  if (!option.results().empty()) return option.get_name() + ": " + refused_value(option, language);
  return form({"{} fehlt, oder sein Wert: {}.", "{} is missing, or its value: {}."}, language, option.get_name(),
              usage_of(option));
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
  const CLI::Option* const option = option_in(command, message);
  const CLI::Option* const before =
      option_in(app, message);  // before the command, where one of that name may stand too
  const bool is_before = before != nullptr && (&command == &app || option == nullptr ||
                                               (option->results().empty() && !before->results().empty()));
  if (is_before) return option_fault(*before, language);
  const bool is_extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  const auto extra = is_extra ? app.remaining(true) : std::vector<std::string>{};
  const bool is_command_unknown = &command == &app && !app.get_subcommands({}).empty();
  if (!extra.empty() && is_command_unknown && !extra.front().starts_with('-'))
    return form({"Den Befehl „{}“ gibt es nicht.", "There is no command \"{}\"."}, language, extra.front());
  std::string fault;
  if (!extra.empty()) {
    fault = form({"„{}“ ist zu viel.", "\"{}\" is too much."}, language, extra.front());
  } else if (option != nullptr && !option->results().empty()) {
    fault = (option->get_positional() ? "" : option->get_name() + ": ") + refused_value(*option, language);
  } else {
    fault = exclusion(error, language)
                .value_or(form({"Unvollständig oder widersprüchlich.", "Incomplete or contradictory."}, language));
  }
  return &command == &app ? fault : fault + " " + form({"So: {}", "Usage: {}"}, language, usage_of(command));
}

}  // namespace cnclab::station
