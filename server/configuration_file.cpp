// One table of keys: where each is kept, what it may be, what the comment says.
#include "configuration_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <vector>

#include "configuration_text.hpp"
#include "net/listen.hpp"

#define TOML_ENABLE_FORMATTERS 0
// The library asserts what its own error handling reports a line later ("[?": no key begins like that).
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

namespace cnclab {

namespace {

using lab::Configuration;

/// Two beats of 50 ms: with one, the beat itself would be silence (AUTH-007).
constexpr int kLeastManualSilence_ms = 100;

/// A key of lab.toml. `take` puts the value into the configuration and says what would be right if it may not.
struct ConfigKey {
  std::string_view section, name, comment;
  std::function<std::string(const toml::node&, Configuration&)> take;
  std::function<std::string(const Configuration&)> show;
};

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') result += '\\';
    if (byte < 0x20 || byte == 0x7F)
      result += fmt::format("\\u{:04X}", byte);
    else
      result += c;
  }
  return result + '"';
}

ConfigKey text_key(std::string_view section, std::string_view name, std::string Configuration::* member,
                   std::string_view comment, const std::vector<std::string>& allowed = {}) {
  return {section, name, comment,
          [member, allowed](const toml::node& node, Configuration& to) -> std::string {
            const auto value = node.value_exact<std::string>();
            if (!value) return "a text in quotes";
            if (!allowed.empty() && std::ranges::find(allowed, *value) == allowed.end())
              return fmt::format("one of {}", fmt::join(allowed, ", "));
            to.*member = *value;
            return {};
          },
          [member](const Configuration& from) { return in_quotes(from.*member); }};
}

ConfigKey address_key(std::string_view section, std::string_view name, std::string Configuration::* member,
                      std::string_view comment, bool may_be_empty) {
  return {section, name, comment,
          [=](const toml::node& node, Configuration& to) -> std::string {
            const auto value = node.value_exact<std::string>();
            const bool is_off = value && value->empty() && may_be_empty;
            if (!value || (!is_off && !net::endpoint_of(*value)))
              return fmt::format("an address and a port in quotes, such as \"127.0.0.1:3300\"{}",
                                 may_be_empty ? ", or empty" : "");
            to.*member = *value;
            return {};
          },
          [member](const Configuration& from) { return in_quotes(from.*member); }};
}

ConfigKey number_key(std::string_view section, std::string_view name, int Configuration::* member,
                     std::string_view comment, int least, int most) {
  return {section, name, comment,
          [=](const toml::node& node, Configuration& to) -> std::string {
            const auto value = node.value_exact<std::int64_t>();
            if (!value || *value < least || *value > most) return fmt::format("a number from {} to {}", least, most);
            to.*member = static_cast<int>(*value);
            return {};
          },
          [member](const Configuration& from) { return fmt::format("{}", from.*member); }};
}

ConfigKey switch_key(std::string_view section, std::string_view name, bool Configuration::* member,
                     std::string_view comment) {
  return {section, name, comment,
          [member](const toml::node& node, Configuration& to) -> std::string {
            const auto value = node.value_exact<bool>();
            if (!value) return "true or false";
            to.*member = *value;
            return {};
          },
          [member](const Configuration& from) { return from.*member ? "true" : "false"; }};
}

ConfigKey list_key(std::string_view section, std::string_view name, std::vector<int> Configuration::* member,
                   std::string_view comment, const std::vector<int>& allowed) {
  return {section, name, comment,
          [=](const toml::node& node, Configuration& to) -> std::string {
            const std::string right = fmt::format("a list of these numbers: {}", fmt::join(allowed, ", "));
            const toml::array* array = node.as_array();
            if (array == nullptr) return right;
            std::vector<int> values;
            for (const auto& item : *array) {
              const auto value = item.value_exact<std::int64_t>();
              if (!value || std::ranges::find(allowed, *value) == allowed.end()) return right;
              values.push_back(static_cast<int>(*value));
            }
            to.*member = values;
            return {};
          },
          [member](const Configuration& from) { return fmt::format("[{}]", fmt::join(from.*member, ", ")); }};
}

ConfigKey data_key() {
  return {"server", "data", "data folder: database, certificate",
          [](const toml::node& node, Configuration& to) -> std::string {
            const auto value = node.value_exact<std::string>();
            if (!value || value->empty()) return "a folder in quotes";
            to.data = *value;
            return {};
          },
          [](const Configuration& from) { return in_quotes(from.data.string()); }};
}

ConfigKey tongue_key() {
  return {"lab", "language", "screens and messages: de or en",
          [](const toml::node& node, Configuration& to) -> std::string {
            const auto value = node.value_exact<std::string>();
            if (!value || (*value != "de" && *value != "en")) return "\"de\" or \"en\"";
            to.tongue = *value == "de" ? language::Tongue::german : language::Tongue::english;
            return {};
          },
          [](const Configuration& from) { return in_quotes(from.tongue == language::Tongue::german ? "de" : "en"); }};
}

ConfigKey model_key() {
  return {
      "control", "model", "3300 or 3250",
      [](const toml::node& node, Configuration& to) -> std::string {
        const auto text = node.value<std::string>();  // also written as a number
        if (text != "3300" && text != "3250" && node.value<int>() != 3300 && node.value<int>() != 3250)
          return "\"3300\" or \"3250\"";
        const bool small = text == "3250" || node.value<int>() == 3250;
        to.model = small ? language::Model::cnc3250 : language::Model::cnc3300;
        return {};
      },
      [](const Configuration& from) { return in_quotes(from.model == language::Model::cnc3300 ? "3300" : "3250"); }};
}

ConfigKey size_key() {
  return {"workpiece", "size_mm", "size of the simulated workpiece: X, Y, Z",
          [](const toml::node& node, Configuration& to) -> std::string {
            constexpr const char* kRight = "three lengths from 1 to 1000 mm";
            const toml::array* array = node.as_array();
            if (array == nullptr || array->size() != 3) return kRight;
            std::vector<double> size;
            for (const auto& item : *array) {
              const auto value = item.value<double>();
              if (!value || !(*value >= 1) || *value > 1000) return kRight;
              size.push_back(*value);
            }
            to.size_mm = size;
            return {};
          },
          [](const Configuration& from) { return fmt::format("[{}]", fmt::join(from.size_mm, ", ")); }};
}

ConfigKey cell_key() {
  return {"workpiece", "cell_mm", "resolution of the simulated workpiece",
          [](const toml::node& node, Configuration& to) -> std::string {
            const auto value = node.value<double>();
            if (!value || *value < 0.05 || *value > 5) return "a length from 0.05 to 5 mm";
            to.cell_mm = *value;
            return {};
          },
          [](const Configuration& from) { return fmt::format("{}", from.cell_mm); }};
}

const std::vector<ConfigKey>& keys() {
  using C = Configuration;
  static const std::vector<ConfigKey> kAll{
      address_key("server", "listen", &C::listen, "address and port for stations and consoles", false),
      data_key(),
      address_key("server", "metrics", &C::metrics, "loopback ADDR:PORT for Prometheus text, empty = off", true),
      tongue_key(),
      switch_key("lab", "accept", &C::accept, "a selected station accepts with START"),
      number_key("lab", "keep_minutes", &C::keep_minutes, "how long a control waits for a broken line", 1, 240),
      number_key("lab", "memory_bytes", &C::memory_bytes, "program memory of each student", 4096, 100'093),
      switch_key("lab", "hints", &C::hints, "row 18 says why a key was ignored"),
      number_key("lab", "silence_manual_ms", &C::silence_manual_ms, "silence that stops manual motion",
                 kLeastManualSilence_ms, 300),
      number_key("lab", "silence_lease_ms", &C::silence_lease_ms, "silence that ends control", 100, 1000),
      number_key("lab", "journal_days", &C::journal_days, "how long the journal is kept", 1, 3650),
      number_key("lab", "undo_days", &C::undo_days, "how long removed people can come back (student restore)", 1, 3650),
      model_key(),
      switch_key("control", "planned_functions", &C::planned_functions, "functions that the manual marks as planned"),
      text_key("control", "rests", &C::rests, "rests below one step: exact or original", {"exact", "original"}),
      text_key("control", "clock", &C::clock, "clock on the screen: host or original", {"host", "original"}),
      text_key("control", "start_in_middle", &C::start_in_middle, "AUTOMAT at a later block: rebuilt or original",
               {"rebuilt", "original"}),
      switch_key("control", "remote", &C::remote, "the REMOTE switch at the back"),
      switch_key("control", "keys_19inch", &C::keys_19inch, "memory test with 1+4+7 instead of 3+6+9"),
      list_key("control", "io_cards", &C::io_cards, "I/O cards fitted", {1, 2, 3}),
      text_key("machine", "kind", &C::kind, "the lab's machine", {"simulated"}),
      switch_key("machine", "require_reference", &C::require_reference, "unreferenced only HAND and REFERENZ"),
      switch_key("machine", "tool_list", &C::tool_list, "tools must agree with the instructor's list"),
      list_key("machine", "outputs_off_at_power_off", &C::outputs_off_at_power_off,
               "outputs (11-18, 21-28) that power-off resets",
               {11, 12, 13, 14, 15, 16, 17, 18, 21, 22, 23, 24, 25, 26, 27, 28}),
      size_key(),
      cell_key(),
      address_key("dnc", "listen", &C::dnc_listen, "TCP address of the serial line, empty = off", true),
      text_key("dnc", "device", &C::dnc_device, "serial device, empty = off"),
      number_key("dnc", "station", &C::dnc_station, "station that the device belongs to, 0 = none", 0, 15),
      switch_key("dnc", "pacing", &C::dnc_pacing, "keep to the baud rate"),
      switch_key("dnc", "training_start", &C::dnc_training_start, "a remote start may start training machines"),
      text_key("printer", "queue", &C::printer_queue, "CUPS queue, empty = off"),
  };
  return kAll;
}

std::string place(const std::filesystem::path& file, const toml::source_region& source) {
  return fmt::format("{}:{}", file.string(), source.begin.line);
}

std::expected<lab::Configuration, std::string> configuration_of(const toml::table& document,
                                                                const std::filesystem::path& file) {
  Configuration configuration;
  for (const auto& [section, content] : document) {
    const toml::table* table = content.as_table();
    if (table == nullptr)
      return std::unexpected(fmt::format("{}: '{}' must stand in a section such as [server]",
                                         place(file, content.source()), section.str()));
    for (const auto& [name, value] : *table) {
      const auto known = std::ranges::find_if(
          keys(), [&](const ConfigKey& key) { return key.section == section.str() && key.name == name.str(); });
      if (known == keys().end())
        return std::unexpected(fmt::format("{}: unknown key '{}' in [{}]; --print-config shows all keys",
                                           place(file, value.source()), name.str(), section.str()));
      if (const std::string right = known->take(value, configuration); !right.empty())
        return std::unexpected(fmt::format("{}: '{}' must be {}", place(file, value.source()), name.str(), right));
    }
  }
  if (!configuration.dnc_device.empty() && configuration.dnc_station == 0)
    return std::unexpected(fmt::format("{}: 'device' needs 'station', 1 to 15, in [dnc]",
                                       place(file, document["dnc"]["device"].node()->source())));
  return configuration;
}

template <class Parse>
std::expected<lab::Configuration, std::string> parsed(const std::filesystem::path& file, Parse parse) {
  try {
    return configuration_of(parse(), file);
  } catch (const toml::parse_error& error) {
    if (error.source().begin.line == 0)
      return std::unexpected(fmt::format("{}: {}", file.string(), error.description()));
    return std::unexpected(fmt::format("{}: {}", place(file, error.source()), error.description()));
  }
}

}  // namespace

std::expected<lab::Configuration, std::string> read_configuration(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in)
    return std::unexpected(
        fmt::format("{}: the file cannot be read. Is the path of --config right, may this user read "
                    "it? A file with every key: cnclab-server --print-config > lab.toml",
                    file.string()));
  return parse_configuration(text, file);
}

std::expected<lab::Configuration, std::string> parse_configuration(std::string_view text,
                                                                   const std::filesystem::path& file) {
  const auto ascii = ascii_configuration(text);
  if (!ascii) return std::unexpected(fmt::format("{}:{}: {}", file.string(), ascii.error().line, ascii.error().reason));
  return parsed(file, [&] { return toml::parse(*ascii, file.string()); });
}

std::string print_configuration(const Configuration& configuration) {
  std::string out;
  std::string_view section;
  for (const ConfigKey& key : keys()) {
    if (key.section != section) {
      out += fmt::format("{}[{}]\n", out.empty() ? "" : "\n", key.section);
      section = key.section;
    }
    out += fmt::format("{} = {}  # {}\n", key.name, key.show(configuration), key.comment);
  }
  return out;
}

}  // namespace cnclab
