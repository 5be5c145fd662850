#include "configuration_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "shared/screen.hpp"

namespace cnclab {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr char32_t kMalformed = U'\uFFFD';

bool is_ascii(char letter) { return static_cast<unsigned char>(letter) < 0x80; }

/// The text in quotes that `rest` begins with, its last quote included; the line's rest if it has none.
std::string_view quoted(std::string_view rest) {
  const char quote = rest.front();
  std::size_t at = 1;
  while (at < rest.size() && rest[at] != '\n' && rest[at] != quote)
    at += quote == '"' && rest[at] == '\\' && at + 1 < rest.size() && rest[at + 1] != '\n' ? 2 : 1;
  return rest.substr(0, at < rest.size() && rest[at] == quote ? at + 1 : at);
}

/// `quoted` in ASCII, or why it cannot be.
std::expected<std::string, std::string> escaped(std::string_view quoted) {
  if (std::ranges::all_of(quoted, is_ascii)) return std::string(quoted);
  if (quoted.front() == '\'') return std::unexpected("letters beyond a-z need double quotation marks (\")");
  std::string out;
  for (const char32_t code : from_utf8(quoted)) {
    if (code == kMalformed) return std::unexpected("this letter is no UTF-8; save the file as UTF-8");
    out += code < 0x80 ? std::string(1, static_cast<char>(code))
                       : fmt::format("\\U{:08X}", static_cast<std::uint32_t>(code));
  }
  return out;
}

}  // namespace

std::expected<std::string, UnfitText> ascii_configuration(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::string out;
  int line = 1;
  while (!text.empty()) {
    const char next = text.front();
    std::size_t length = 1;
    if (text.starts_with(R"(""")") || text.starts_with("'''"))
      return std::unexpected(UnfitText{line, "a text stands on one line, between two quotation marks"});
    if (next == '\0') return std::unexpected(UnfitText{line, "this is no text: it has NUL bytes"});
    if (!is_ascii(next))
      return std::unexpected(
          UnfitText{line, "letters beyond a-z stand only in comments and between straight quotation marks (\")"});
    if (next == '"' || next == '\'') {
      const std::string_view in_quotes = quoted(text);
      const auto ascii = escaped(in_quotes);
      if (!ascii) return std::unexpected(UnfitText{line, ascii.error()});
      out += *ascii;
      length = in_quotes.size();
    } else if (next == '#') {
      length = std::min(text.find('\n'), text.size());
    } else {
      out += next;
      line += next == '\n' ? 1 : 0;
    }
    text.remove_prefix(length);
  }
  return out;
}

}  // namespace cnclab
