// cnclab-tool: check, run and draw programs without a server.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>

#include "tool/options.hpp"

namespace {

using namespace cnclab;
using tool::Options;

/// "P0001" or "1": a number behind an optional letter.
std::optional<std::uint16_t> number_behind(char letter, std::string text, int least, int most) {
  if (!text.empty() && text.front() == letter) text.erase(0, 1);
  if (text.empty() || text.size() > 4 || text.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  const int number = std::stoi(text);
  if (number < least || number > most) return std::nullopt;
  return static_cast<std::uint16_t>(number);
}

void add_number(CLI::App& command, const std::string& name, char letter, int least, int most,
                std::optional<std::uint16_t>& place, const std::string& help) {
  command.add_option_function<std::string>(
      name,
      [=, &place](const std::string& text) {
        place = number_behind(letter, text, least, most);
        if (!place)
          throw CLI::ValidationError(name, "'" + text + "' is none; expected " + letter + std::to_string(least) +
                                               " to " + letter + std::to_string(most));
      },
      help);
}

void add_source(CLI::App& command, Options& options, bool runs) {
  command.add_option("FILE", options.file, "tape text, '-' for standard input")->required();
  command.add_option("--dialect", options.dialect, "cnc3300, din66025 or codesys; default by content")
      ->check(CLI::IsMember({"cnc3300", "din66025", "codesys"}));
  command.add_flag("--strict", options.is_strict, "read as the control does: small letters are skipped");
  if (!runs) return;
  command.add_option("--tools", options.tools_file, "tape with the tool table P0000");
  command.add_option("--machine-data", options.machine_data_file, "file with lines NN = value");
  add_number(command, "--program", 'P', 1, 9999, options.program, "start program, e.g. P0001");
  add_number(command, "--block", 'N', 1, 999, options.block,
             "start block, e.g. N001; G, F, S and T are taken from the blocks before it");
}

/// CLI11's own check names its upper limit in 300 digits.
CLI::Validator above_zero() {
  const auto check = [](const std::string& text) {
    double number = 0;
    return CLI::detail::lexical_cast(text, number) && number > 0 ? std::string() : "'" + text + "' is not above 0";
  };
  return {check, "", "above zero"};
}

CLI::Option* add_most_blocks(CLI::App& command, Options& options) {
  return command.add_option("--max-blocks", options.most_blocks, "stop after so many blocks")
      ->check(above_zero())
      ->capture_default_str();
}

void add_run_options(CLI::App& command, Options& options) {
  add_most_blocks(command, options);
  command.add_option("--trace", options.trace_file, "write position, feed, spindle and block of every tick (CSV)");
  command.add_option("--steps", options.steps_file,
                     "write the steps of X Y Z U in every tick, four 32-bit integers each, lowest byte first");
  command.add_option("--tick-ms", options.tick_ms, "length of a tick")
      ->check(CLI::Range(0.1, 10.0))
      ->capture_default_str();
  command.add_option("--max-seconds", options.most_seconds, "stop after so much machine time")
      ->check(above_zero())
      ->capture_default_str();
}

language::Tongue tongue_of_environment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') continue;
    return std::string_view(value).starts_with("de") ? language::Tongue::german : language::Tongue::english;
  }
  return language::Tongue::english;
}

using Command = std::function<int(const Options&)>;

void add_commands(CLI::App& app, Options& options, Command& chosen) {
  const auto add = [&](const std::string& name, const std::string& help, Command command) {
    CLI::App* added = app.add_subcommand(name, help);
    added->callback([&chosen, command = std::move(command)] { chosen = command; });
    return added;
  };
  CLI::App* check = add("check", "print every error of the programs", tool::check);
  add_source(*check, options, true);
  CLI::App* path = add("path", "print the tool path as JSON Lines", tool::path);
  add_source(*path, options, true);
  add_most_blocks(*path, options);
  CLI::App* run = add("run", "run on the simulated machine in virtual time", tool::run);
  add_source(*run, options, true);
  add_run_options(*run, options);
  CLI::App* plot = add("plot", "draw tool path and workpiece as SVG", tool::plot);
  add_source(*plot, options, true);
  add_most_blocks(*plot, options);
  plot->add_option("--out", options.out_file, "SVG file to write")->required();
  plot->add_option("--view", options.view, "xy, xz, yz or iso")
      ->check(CLI::IsMember({"xy", "xz", "yz", "iso"}))
      ->capture_default_str();
  CLI::App* convert = add("convert", "print the programs in another form", tool::convert);
  add_source(*convert, options, false);
  convert->add_option("--to", options.target, "cnc3300, listing or din66025")
      ->check(CLI::IsMember({"cnc3300", "listing", "din66025"}))
      ->required();
  CLI::App* verify = add("verify", "check a lab's database and every block stored in it", tool::verify);
  verify->add_option("DB", options.file, "the database, e.g. var/cnclab.db, or a backup of it")->required();
}

/// Of a word that is no command the parser says only that one is required.
int tell_usage(const CLI::App& app, const CLI::ParseError& error) {
  const auto words = app.remaining(true);
  if (!app.get_subcommands().empty() || words.empty() || words.front().starts_with('-'))
    return app.exit(error) == 0 ? 0 : tool::kExitUsage;
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) names += (names.empty() ? "" : ", ") + command->get_name();
  std::fprintf(stderr, "cnclab-tool: there is no command '%s'; commands: %s. See cnclab-tool --help\n",
               words.front().c_str(), names.c_str());
  return tool::kExitUsage;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.tongue = tongue_of_environment();
  Command chosen;
  CLI::App app("Checks, runs and draws programs of the CNC 3300 without a server.", "cnclab-tool");
  app.set_version_flag("--version", "cnclab-tool " CNCLAB_VERSION);
  app.require_subcommand(1);
  app.add_option_function<std::string>(
         "--language",
         [&options](const std::string& language) {
           options.tongue = language == "de" ? language::Tongue::german : language::Tongue::english;
           options.listing_tongue = options.tongue;
         },
         "de or en; default from LANG, listings in German")
      ->check(CLI::IsMember({"de", "en"}));
  add_commands(app, options, chosen);
  app.fallthrough();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return tell_usage(app, error);
  }
  try {
    return chosen(options);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "cnclab-tool: %s\n", failure.what());
    return tool::kExitError;
  }
}
