#include "configuration_text.hpp"

namespace cnclab {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Where the text in quotes at `start` ends (behind its last quote), at the end of the line at the latest.
std::size_t end_of_quotes(std::string_view text, std::size_t start) {
  const char quote = text[start];
  std::size_t at = start + 1;
  while (at < text.size() && text[at] != '\n' && text[at] != quote)
    at += quote == '"' && text[at] == '\\' && at + 1 < text.size() && text[at + 1] != '\n' ? 2 : 1;
  return at < text.size() && text[at] == quote ? at + 1 : at;
}

}  // namespace

std::optional<UnfitText> unfit_text(std::string_view text) {
  if (text.contains('\0')) return UnfitText{1, "this is no text: it has NUL bytes"};
  int line = 1;
  std::size_t at = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  while (at < text.size()) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with(R"(""")") || rest.starts_with("'''"))
      return UnfitText{line, "a text stands on one line, between two quotation marks"};
    if (rest.front() == '"' || rest.front() == '\'') {
      at = end_of_quotes(text, at);
    } else if (rest.front() == '#') {
      at = text.find('\n', at);
    } else if (static_cast<unsigned char>(rest.front()) >= 0x80) {
      return UnfitText{line, "letters beyond a-z stand only in comments and between straight quotation marks (\")"};
    } else {
      if (rest.front() == '\n') ++line;
      ++at;
    }
  }
  return std::nullopt;
}

}  // namespace cnclab
