// Machine-data files: one `NN = value` per line.
#include <fmt/core.h>

#include <charconv>
#include <optional>
#include <vector>

#include "machine/machine_data.hpp"

namespace cnclab::machine {

namespace {

struct Entry {
  int line = 0, number = 0;
  std::int64_t value = 0;
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

template <class Number>
std::optional<Number> whole_number(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::expected<std::optional<Entry>, DataFileFault> read_line(std::string_view text, int line) {
  const std::string_view content = trimmed(text.substr(0, text.find('#')));
  if (content.empty()) return std::nullopt;
  const auto equals = content.find('=');
  if (equals == std::string_view::npos) return std::unexpected(DataFileFault{line, "expected `NN = value`"});
  const auto number = whole_number<int>(trimmed(content.substr(0, equals)));
  const auto value = whole_number<std::int64_t>(trimmed(content.substr(equals + 1)));
  if (!number || !value) return std::unexpected(DataFileFault{line, "number and value must be whole numbers"});
  return Entry{line, *number, *value};
}

}  // namespace

std::expected<MachineData, DataFileFault> read_machine_data(std::string_view text) {
  std::vector<Entry> entries;
  for (int line = 1; !text.empty(); ++line) {
    const auto end = text.find('\n');
    const auto entry = read_line(text.substr(0, end), line);
    if (!entry) return std::unexpected(entry.error());
    if (*entry) entries.push_back(**entry);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  // F MAX and F START/STOP bound each other: what is refused may be right once the other one is in.
  MachineData data;
  while (!entries.empty()) {
    std::vector<Entry> refused;
    DataFileFault first;
    for (const Entry& entry : entries) {
      const auto done = data.set(entry.number, entry.value);
      if (done) continue;
      if (refused.empty()) first = {entry.line, fmt::format("MD {:02}: {}", entry.number, done.error())};
      refused.push_back(entry);
    }
    if (refused.size() == entries.size()) return std::unexpected(first);
    entries = std::move(refused);
  }
  return data;
}

}  // namespace cnclab::machine
