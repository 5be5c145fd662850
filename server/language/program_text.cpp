// Looking for the marks of a listing.
#include "language/program_text.hpp"

#include <algorithm>
#include <string>

#include "language/listing.hpp"

namespace cnclab::language {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_blank(char c) { return c >= '\0' && c <= ' '; }

/// "N003", "t001".
bool begins_with_number(std::string_view line) {
  constexpr std::size_t kLength = 4;
  return line.size() >= kLength && std::string_view("NTnt").contains(line.front()) &&
         std::ranges::all_of(line.substr(1, kLength - 1), is_digit);
}

/// "+...5,000", "....", "......#04".
bool has_placeholders(std::string_view value) {
  return value.contains(',') || value.contains(".#") || std::ranges::count(value, '.') > 1;
}

/// "#01 = ": is the "=" at `equals` one behind an operand?
bool is_assignment(std::string_view line, std::size_t equals) {
  const std::size_t before = line.substr(0, equals).find_last_not_of("0123456789. ");
  return before != std::string_view::npos && line[before] == '#';
}

/// line   without comments
bool shows_listing(std::string_view line) {
  line.remove_prefix(static_cast<std::size_t>(std::ranges::find_if_not(line, is_blank) - line.begin()));
  if (!begins_with_number(line)) return false;
  if (line.substr(4).starts_with('!')) return true;
  for (std::size_t at = 4; at < line.size();) {
    if (line[at] == '=' && is_assignment(line, at)) return true;
    const std::size_t end = std::min(line.find_first_not_of("+-.,#0123456789", at), line.size());
    if (has_placeholders(line.substr(at, end - at))) return true;
    at = std::max(end, at + 1);
  }
  return false;
}

}  // namespace

TextForm form_of_text(std::string_view text) {
  // A tape as it is written has none of these, which the machine finds out faster than we walk over its lines.
  if (!text.contains('.') && !text.contains(',') && !text.contains('=') && !text.contains('!')) return TextForm::tape;
  std::string line;
  bool is_comment = false;
  for (const char c : text) {
    if (c == '\n') {
      if (shows_listing(line)) return TextForm::listing;
      line.clear();
    } else if (is_comment) {
      is_comment = c != ')';
    } else if (c == '(') {
      is_comment = true;
      line += ' ';
    } else {
      line += c;
    }
  }
  return shows_listing(line) ? TextForm::listing : TextForm::tape;
}

Tape read_programs_text(std::string_view text, Reading reading, Tongue tongue) {
  if (reading == Reading::file && form_of_text(text) == TextForm::listing) return read_listing(text, tongue);
  return read_tape(text, reading, tongue);
}

}  // namespace cnclab::language
