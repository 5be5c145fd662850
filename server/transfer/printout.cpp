// Breaking lists into lines and pages.
#include "transfer/printout.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cnclab::transfer {

namespace {

constexpr std::size_t kHeaderLines = 2;

/// Bytes of the character that begins at `at`; 0 where it is no valid UTF-8 (overlong and surrogate forms are).
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xC0U) != 0x80) return 0;
  const unsigned second = length > 1 ? byte(at + 1) : 0;
  const bool is_odd = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                      (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return is_odd ? 0 : length;
}

/// The characters of a text, one after another, each fit to be printed.
std::vector<std::string> characters_of(std::string_view text) {
  std::vector<std::string> characters;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text, at);
    const bool is_control = static_cast<unsigned char>(text[at]) < ' ' || text[at] == '\x7F';
    characters.push_back(length == 0 ? "?" : is_control ? " " : std::string(text.substr(at, length)));
    at += std::max<std::size_t>(length, 1);
  }
  return characters;
}

/// Exactly `width` columns.
std::string fitted(std::string_view text, std::size_t width) {
  std::string field;
  std::size_t columns = 0;
  for (const std::string& character : characters_of(text)) {
    if (columns++ == width) return field;
    field += character;
  }
  return field + std::string(width - std::min(columns, width), ' ');
}

/// Lines of the page's width.
void append_line(std::string_view line, std::vector<std::string>& lines) {
  std::size_t columns = 0;
  std::string part;
  for (const std::string& character : characters_of(line)) {
    if (columns++ == kPageColumns) {
      lines.push_back(std::move(part));
      part.clear();
      columns = 1;
    }
    part += character;
  }
  lines.push_back(std::move(part));
}

std::string header_line(const PrintHeader& header, std::size_t page, std::size_t pages) {
  const std::string number =
      fmt::format("{} {}/{}", header.tongue == language::Tongue::german ? "Seite" : "page", page, pages);
  const std::string right = fmt::format("{}  {}", fitted(header.date, 17), number);
  const std::size_t left = kPageColumns - std::min(kPageColumns, right.size() + 2);
  const std::size_t what = left / 2;
  return fitted(header.what, what) + ' ' + fitted(header.student, left - what) + ' ' + right;
}

std::string rule() {
  std::string line;
  for (std::size_t column = 0; column < kPageColumns; ++column) line += "─";
  return line;
}

}  // namespace

std::vector<PrintPage> set_pages(std::string_view text, const PrintHeader& header) {
  std::vector<PrintPage> pages(1);
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\n\f");
    std::string_view line = text.substr(0, end);
    const bool breaks_page = end != std::string_view::npos && text[end] == '\f';
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    std::vector<std::string> lines;
    if (!line.empty() || !breaks_page) append_line(line, lines);
    for (std::string& part : lines) {
      if (pages.back().size() == kPageLines - kHeaderLines) pages.emplace_back();
      pages.back().push_back(std::move(part));
    }
    if (breaks_page) pages.emplace_back();
  }
  for (std::size_t page = 0; page < pages.size(); ++page)
    pages[page].insert(pages[page].begin(), {header_line(header, page + 1, pages.size()), rule()});
  return pages;
}

std::string print_text(const std::vector<PrintPage>& pages) {
  std::string text;
  for (const PrintPage& page : pages) {
    if (!text.empty()) text += '\f';
    for (const std::string& line : page) {
      const std::size_t last = line.find_last_not_of(' ');
      text += last == std::string::npos ? std::string_view{} : std::string_view(line).substr(0, last + 1);
      text += '\n';
    }
  }
  return text;
}

}  // namespace cnclab::transfer
