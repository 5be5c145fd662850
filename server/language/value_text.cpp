// Number text for tapes, screens and messages.
#include "language/value_text.hpp"

#include <array>
#include <charconv>

namespace cnclab::language {

void append_digits(std::string& text, std::int64_t value, int digits) {
  std::array<char, 24> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  const auto length = end - buffer.data();
  if (length < digits) text.append(static_cast<std::size_t>(digits - length), '0');
  text.append(buffer.data(), end);
}

std::string millimetres_text(std::int64_t value_um) {
  std::string text(value_um < 0 ? "-" : "");
  const std::int64_t size = value_um < 0 ? -value_um : value_um;
  append_digits(text, size / 1000, 1);
  text += '.';
  append_digits(text, size % 1000, 3);
  return text;
}

std::string value_text(const Word& word) {
  if (!word.is_parameter) return value_text(word.address, word.number);
  std::string text("#");
  append_digits(text, word.number, 2);
  return text;
}

std::string value_text(Address address, std::int64_t value) {
  const WordFormat& format = format_of(address);
  if (format.kind == WordFormat::Kind::millimetres) return millimetres_text(value);
  std::string text(value < 0 ? "-" : "");  // a parameter may give what no word can hold
  append_digits(text, value < 0 ? -value : value, format.digits);
  return text;
}

std::string range_text(const WordFormat& format) {
  if (format.kind == WordFormat::Kind::millimetres)
    return millimetres_text(format.least) + ".." + millimetres_text(format.most);
  std::string text;
  append_digits(text, format.least, format.digits);
  text += "..";
  append_digits(text, format.most, format.digits);
  return text;
}

}  // namespace cnclab::language
