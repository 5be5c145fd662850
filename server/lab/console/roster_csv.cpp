// A roster's lines cut into fields, and the fields judged.
#include "lab/console/roster_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <expected>
#include <set>
#include <span>

#include "lab/passwords.hpp"
#include "shared/credential_limits.hpp"

namespace cnclab::lab {

namespace {

constexpr std::size_t kMostFields = 3;
constexpr std::string_view kHeading = "name,password,language";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // what spreadsheets put in front

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

/// The next field, taken off the line with the comma behind it. Nothing where a quotation mark is not closed, or text
/// stands behind one that is.
std::expected<std::string, bool> take_field(std::string_view& line) {
  line = trimmed(line);
  if (!line.starts_with('"')) {
    const auto comma = std::min(line.find(','), line.size());
    std::string field(trimmed(line.substr(0, comma)));
    line.remove_prefix(std::min(comma + 1, line.size()));
    return field;
  }
  std::string field;
  std::size_t at = 1;
  for (;; ++at) {
    if (at >= line.size()) return std::unexpected(false);
    if (line[at] != '"') {
      field += line[at];
    } else if (line.substr(at).starts_with("\"\"")) {
      field += line[at++];
    } else {
      break;
    }
  }
  std::string_view rest = trimmed(line.substr(at + 1));
  if (!rest.empty() && !rest.starts_with(',')) return std::unexpected(false);
  line = rest.empty() ? rest : rest.substr(1);
  return field;
}

std::expected<std::vector<std::string>, bool> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  do {
    const bool ends_with_comma = line.ends_with(',');
    auto field = take_field(line);
    if (!field) return std::unexpected(false);
    fields.push_back(std::move(*field));
    if (line.empty() && ends_with_comma && fields.size() < kMostFields) fields.emplace_back();
  } while (!line.empty());
  return fields;
}

/// The columns' names, in any case, in German too, and as many as the file has: never an account `name` with the
/// password `password`.
bool is_heading(const std::vector<std::string>& fields) {
  static const std::array<std::array<std::string_view, 2>, kMostFields> kColumns{
      {{"name", "name"}, {"password", "passwort"}, {"language", "sprache"}}};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    std::string word = fields[i];
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (i >= kColumns.size() || std::ranges::find(kColumns[i], word) == kColumns[i].end()) return false;
  }
  return true;
}

struct Judge {
  language::Tongue tongue;
  std::set<std::string> names;

  [[nodiscard]] std::string say(std::string_view german, std::string_view english) const {
    return std::string(tongue == language::Tongue::german ? german : english);
  }

  /// What is wrong with an entry, empty if nothing.
  std::string fault_of(const RosterEntry& entry) {
    if (!is_name(entry.name))
      return say("kein gültiger Name (Buchstaben, Ziffern, . - _, höchstens 32 Bytes, ein Umlaut hat zwei)",
                 "not a valid name (letters, digits, . - _, at most 32 bytes, an umlaut has two)");
    if (!names.insert(entry.name).second)
      return say("der Name steht schon weiter oben", "the name stands above already");
    if (!entry.password.empty() &&
        (entry.password.size() < kShortestPassword || entry.password.size() > kLongestPassword))
      return say("ein Passwort hat 8 bis 256 Zeichen", "a password has 8 to 256 characters");
    if (!entry.language.empty() && entry.language != "de" && entry.language != "en")
      return say("die Sprache ist de oder en", "the language is de or en");
    return {};
  }
};

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\n\r\t ") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

}  // namespace

bool is_name(std::string_view name) {
  const auto allowed = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '-' || c == '_' || c >= 0x80;
  };
  // Names become folders where programs are collected.
  return !name.empty() && name != "." && name != ".." && name.size() <= kLongestName &&
         std::ranges::all_of(name, allowed);
}

std::string line_prefix(int line, language::Tongue tongue) {
  return fmt::format("{} {}: ", tongue == language::Tongue::german ? "Zeile" : "line", line);
}

Roster read_roster(std::string_view csv, language::Tongue tongue) {
  Roster roster;
  Judge judge{tongue, {}};
  if (csv.starts_with(kByteOrderMark)) csv.remove_prefix(kByteOrderMark.size());
  for (int number = 1; !csv.empty(); ++number) {
    const auto end = std::min(csv.find('\n'), csv.size());
    const std::string_view line = trimmed(csv.substr(0, end));
    csv.remove_prefix(std::min(end + 1, csv.size()));
    if (line.empty()) continue;
    const auto fields = fields_of(line);
    if (number == 1 && fields && is_heading(*fields)) continue;
    if (!fields || fields->size() > kMostFields) {
      roster.errors[number] =
          line_prefix(number, tongue) + judge.say("name,password,language erwartet", "name,password,language expected");
      continue;
    }
    RosterEntry entry{fields->at(0), fields->size() > 1 ? fields->at(1) : "", fields->size() > 2 ? fields->at(2) : "",
                      number};
    if (const std::string fault = judge.fault_of(entry); !fault.empty())
      roster.errors[number] = line_prefix(number, tongue) + fault;
    else
      roster.entries.push_back(std::move(entry));
  }
  return roster;
}

std::string write_roster(const std::vector<RosterEntry>& entries) {
  std::string csv = std::string(kHeading) + "\n";
  for (const RosterEntry& entry : entries)
    csv += quoted(entry.name) + "," + quoted(entry.password) + "," + entry.language + "\n";
  return csv;
}

}  // namespace cnclab::lab
