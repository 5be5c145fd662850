// How digits, point, sign and C shape one word (D-14, DEC-12, D-52, DEC-60).
#include <algorithm>

#include "language/screen_form.hpp"
#include "panel/modes/entry_line.hpp"

namespace cnclab::panel {

namespace {

constexpr int kWholeMillimetreFigures = 4;
constexpr int kDecimals = 3;
constexpr int kParameterFigures = 2;
constexpr std::int64_t kUmPerMm = 1000;

bool is_millimetres(const language::WordFormat& format) {
  return format.kind == language::WordFormat::Kind::millimetres;
}

std::int64_t unit_of_decimal(int decimals) { return decimals == 0 ? 100 : decimals == 1 ? 10 : 1; }

}  // namespace

void DigitField::digit(int figure) {
  if (typed == 0) value = 0;
  if (typed == places) return;
  value = *value * 10 + figure;
  ++typed;
}

std::string DigitField::text() const {
  if (!value) return std::string(static_cast<std::size_t>(places), '.');
  const std::string digits = std::to_string(*value);
  const auto wanted = static_cast<std::size_t>(places);
  return std::string(wanted - std::min(wanted, digits.size()), '0').append(digits);
}

WordEntry WordEntry::of(language::Address address, const language::Word* word) {
  WordEntry entry;
  entry.address = address;
  if (word == nullptr) return entry;
  entry.is_parameter = word->is_parameter;
  entry.has_value = true;
  entry.is_negative = word->number < 0;
  entry.magnitude = word->number < 0 ? -word->number : word->number;
  return entry;
}

void WordEntry::begin() {
  if (is_begun) return;
  is_begun = true;
  magnitude = 0;
  if (!is_signed) is_negative = false;
}

void WordEntry::digit(int figure) {
  const language::WordFormat& format = language::format_of(address);
  const bool in_millimetres = !is_parameter && is_millimetres(format);
  const int most = is_parameter ? kParameterFigures : in_millimetres ? kWholeMillimetreFigures : format.digits;
  begin();
  if (decimals) {
    if (*decimals < kDecimals) magnitude += figure * unit_of_decimal((*decimals)++);
  } else if (figures < most) {
    magnitude = magnitude * 10 + figure * (in_millimetres ? kUmPerMm : 1);
    ++figures;
  }
  has_value = true;
}

void WordEntry::point() {
  if (!takes_point_and_sign() || decimals) return;
  begin();
  decimals = 0;
  has_value = true;
}

void WordEntry::sign() {
  if (!takes_point_and_sign()) return;
  is_negative = !is_negative;
  is_signed = true;
}

void WordEntry::clear() { *this = WordEntry::of(address, nullptr); }

bool WordEntry::takes_point_and_sign() const { return !is_parameter && is_millimetres(language::format_of(address)); }

bool WordEntry::takes_parameter() const { return language::format_of(address).takes_parameter; }

bool WordEntry::to_parameter() {
  if (!takes_parameter()) return false;
  clear();
  is_parameter = true;
  return true;
}

std::optional<language::Word> WordEntry::word() const {
  if (!has_value) return std::nullopt;
  const auto number = static_cast<std::int32_t>(magnitude);
  return language::Word{address, is_parameter, is_negative && !is_parameter ? -number : number};
}

std::string WordEntry::text() const {
  const std::optional<language::Word> value = word();
  std::string shown = language::word_text(address, value ? &*value : nullptr);
  if (is_half()) {
    constexpr std::size_t kHalfColumns = 3;
    const std::size_t dots = shown.size() > kHalfColumns + 1 ? shown.size() - kHalfColumns - 1 : 0;
    return shown.substr(0, 1).append(dots, '.').append("↓..");
  }
  if (!is_negative || is_parameter) return shown;
  // A sign that has no number yet, or that stands before a zero, is typed but no part of a value.
  const std::size_t sign_place = address == language::Address::value ? 0 : 1;
  if (!value || value->number == 0) shown[sign_place] = '-';
  return shown;
}

}  // namespace cnclab::panel
