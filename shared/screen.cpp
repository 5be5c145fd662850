// The screen's grid with rows shared between copies, and UTF-8 both ways.
#include "shared/screen.hpp"

namespace cnclab {
namespace {

constexpr char32_t kReplacement = U'\uFFFD';

bool is_inside(int row, int column) {
  return row >= 0 && row < Screen::kRows && column >= 0 && column < Screen::kColumns;
}

bool is_scalar(char32_t code) { return code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF); }

struct Decoded {
  char32_t code;
  std::size_t length;  // bytes taken, at least 1
};

// One code point from the start of `bytes` (not empty). A malformed sequence takes its valid beginning, as the Unicode
// standard recommends, so that a text behind it stays readable.
Decoded decode(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 && lead <= 0xF4  ? 4
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                                                           : 0;
  if (length == 0) return {kReplacement, 1};
  // The second byte's range excludes overlong forms, surrogates and numbers above U+10FFFF.
  const unsigned low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const unsigned high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  char32_t code = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned next = i < bytes.size() ? byte(i) : 0;
    if (next < (i == 1 ? low : 0x80U) || next > (i == 1 ? high : 0xBFU)) return {kReplacement, i};
    code = (code << 6) | (next & 0x3FU);
  }
  return {code, length};
}

}  // namespace

Screen::Screen() {
  static const auto kBlank = std::make_shared<const Row>();
  rows_.fill(kBlank);
}

const Cell& Screen::at(int row, int column) const {
  static constexpr Cell kOutside{};
  return is_inside(row, column) ? this->row(row)[static_cast<std::size_t>(column)] : kOutside;
}

void Screen::put(int row, int column, Cell cell) {
  if (!is_inside(row, column) || at(row, column) == cell) return;
  Row changed = this->row(row);
  changed[static_cast<std::size_t>(column)] = cell;
  rows_[static_cast<std::size_t>(row)] = std::make_shared<const Row>(changed);
}

void Screen::write(int row, int column, std::string_view utf8, Attribute attribute, int width) {
  if (row < 0 || row >= kRows) return;
  Row changed = this->row(row);
  for (int written = 0; !utf8.empty() && written < width && column < kColumns; ++written, ++column) {
    const Decoded next = decode(utf8);
    utf8.remove_prefix(next.length);
    if (column >= 0) changed[static_cast<std::size_t>(column)] = {next.code, attribute};
  }
  set_row(row, changed);
}

void Screen::set_row(int index, const Row& row) {
  if (index < 0 || index >= kRows || this->row(index) == row) return;
  rows_[static_cast<std::size_t>(index)] = std::make_shared<const Row>(row);
}

std::string Screen::text(int row) const {
  std::string utf8;
  for (const Cell& cell : this->row(row)) utf8 += to_utf8(cell.code);
  return utf8;
}

std::vector<int> Screen::changed_rows(const Screen& newer) const {
  std::vector<int> changed;
  for (int row = 0; row < kRows; ++row) {
    const auto& mine = rows_[static_cast<std::size_t>(row)];
    const auto& theirs = newer.rows_[static_cast<std::size_t>(row)];
    if (mine != theirs && *mine != *theirs) changed.push_back(row);
  }
  return changed;
}

bool operator==(const Screen& a, const Screen& b) { return a.changed_rows(b).empty(); }

std::string to_utf8(char32_t code) {
  if (!is_scalar(code)) code = kReplacement;
  const auto tail = [&](int shift) { return static_cast<char>(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0U | (code >> 6)), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0U | (code >> 12)), tail(6), tail(0)};
  return {static_cast<char>(0xF0U | (code >> 18)), tail(12), tail(6), tail(0)};
}

std::string to_utf8(std::u32string_view text) {
  std::string utf8;
  for (const char32_t code : text) utf8 += to_utf8(code);
  return utf8;
}

std::string shortened(std::string_view utf8, std::size_t columns) {
  const std::u32string text = from_utf8(utf8);
  if (text.size() <= columns) return std::string(utf8);
  const std::size_t end = (columns - 1) / 2, begin = columns - 1 - end;
  return to_utf8(text.substr(0, begin) + U'…' + text.substr(text.size() - end));
}

std::u32string from_utf8(std::string_view utf8) {
  std::u32string codes;
  while (!utf8.empty()) {
    const Decoded next = decode(utf8);
    codes.push_back(next.code);
    utf8.remove_prefix(next.length);
  }
  return codes;
}

}  // namespace cnclab
