// What the files of commands are written with. Private to this folder.
#pragma once

#include <CLI/CLI.hpp>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include "instructor/command_line.hpp"
#include "station/command_fault.hpp"
#include "station/utf8.hpp"

namespace cnclab::instructor {

/// Fills the request of one command when the whole line has been understood.
using Fill = std::function<void(Command&)>;

/// The subcommands below one app. An argument's value lives in the command's `Fill`, which shares it.
class CommandTable {
 public:
  CommandTable(CLI::App& app, std::optional<Command>& command) : app_(app), command_(command) {}

  CLI::App& add(const std::string& name, const std::string& description, Fill fill) {
    CLI::App* sub = app_.add_subcommand(name, description);
    sub->fallthrough();
    sub->callback([&command = command_, fill = std::move(fill)] { fill(command.emplace()); });
    return *sub;
  }

  CommandTable group(const std::string& name, const std::string& description) {
    CLI::App* sub = app_.add_subcommand(name, description);
    sub->fallthrough();
    sub->require_subcommand(1);
    return {*sub, command_};
  }

 private:
  CLI::App& app_;
  std::optional<Command>& command_;
};

template <class T>
std::shared_ptr<T> value(T initial = {}) {
  return std::make_shared<T>(std::move(initial));
}

/// A word that the command needs. `kind` stands for it in the usage: a range, a choice, or an example.
template <class T>
CLI::Option* needed(CLI::App& sub, const std::string& name, const std::shared_ptr<T>& into, const std::string& what,
                    const std::string& kind) {
  return sub.add_option(name, *into, what)->required()->type_name(kind);
}

/// A text that can be sent. throws station::UnfitFile
inline std::string content_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (const auto line = station::line_not_utf8(text))
    throw station::UnfitFile(file + ":" + std::to_string(*line), station::kNotUtf8);
  return text;
}

/// The password in the first line. throws station::UnfitFile also where there is none
inline std::string password_of(const std::string& file) {
  const std::string text = content_of(file);
  std::string line = text.substr(0, text.find('\n'));
  if (line.ends_with('\r')) line.pop_back();
  if (line.empty())
    throw station::UnfitFile(file, {"kein Passwort in der ersten Zeile", "no password in the first line of the file"});
  return line;
}

// Each adds the commands of one part of interfaces.md section 4.
void add_machine_commands(CommandTable& table);
void add_roster_commands(CommandTable& table);
void add_program_commands(CommandTable& table);

}  // namespace cnclab::instructor
