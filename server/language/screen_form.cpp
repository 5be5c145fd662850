// Block lines in the form of D-21: values with a point, empty words as dots, a text in parentheses in its place.
#include "language/screen_form.hpp"

#include "language/value_text.hpp"

namespace cnclab::language {

namespace {

constexpr std::string_view kEmptyLength = ".....,...";  // SCR-012
constexpr std::size_t kLengthWidth = 9;                 // sign, 4 places, point, 3 decimals

std::string length_text(std::int64_t value_um, char fill) {
  const std::string digits = millimetres_text(value_um < 0 ? -value_um : value_um);
  std::string text(value_um < 0 ? "-" : "+");
  if (digits.size() + 1 < kLengthWidth) text.append(kLengthWidth - 1 - digits.size(), fill);
  return text + digits;
}

/// "#04" at the right of the word's width (SCR-015, DEC-60).
std::string parameter_text(std::int64_t number, std::size_t width) {
  std::string reference = "#";
  append_digits(reference, number, 2);
  if (reference.size() < width) reference.insert(0, width - reference.size(), '.');
  return reference;
}

std::string number_text(const Block& block) {
  std::string text(block.function.kind == Function::Kind::tool ? "T" : "N");
  append_digits(text, block.number, 3);
  return text + (block.is_damaged ? '!' : ' ');  // SCR-052, D-119: in place of the blank
}

const Word* word_at(const Block& block, const BlockForm& form, std::size_t place) {
  if (form.words[place] != Address::operand) return block.find(form.words[place]);
  const bool is_there = place < block.words.size() && block.words[place].address == Address::operand;
  return is_there ? &block.words[place] : nullptr;
}

/// SCR-053: "↓01          #01 = #02 + #03", "↓10          #55 = COPY #64", "↓00          #54 = -...0.500".
std::string calculation_text(const Block& block, const BlockForm& form) {
  std::string text(10, ' ');
  const auto operand = [&](std::size_t place) { return word_text(form.words[place], word_at(block, form, place)); };
  text += operand(0) + " = ";
  if (form.words.size() == 3) return text + operand(1) + ' ' + std::string(form.german) + ' ' + operand(2);
  if (!form.german.empty()) text += std::string(form.german) + ' ';
  return text + operand(1);
}

std::string words_text(const Block& block, const BlockForm& form, Tongue tongue) {
  const std::string text = '(' + std::string(tongue == Tongue::german ? form.german : form.english) + ')';
  std::string line;
  const auto append = [&](const std::string& part) { line += line.empty() ? part : ' ' + part; };
  if (form.text_place == TextPlace::before_words) append(text);
  for (std::size_t place = 0; place < form.words.size(); ++place)
    append(word_text(form.words[place], word_at(block, form, place)));
  if (form.text_place == TextPlace::after_words) append(text);
  return line;
}

}  // namespace

std::string istwert_text(Micrometres value) { return length_text(value.value, '0'); }

std::string word_text(Address address, const Word* word) {
  const WordFormat& format = format_of(address);
  const bool is_length = format.kind == WordFormat::Kind::millimetres;
  const std::size_t width = is_length ? kLengthWidth : static_cast<std::size_t>(format.digits);
  std::string text;
  if (address != Address::value) text += letter(address);
  if (word == nullptr) return text + (is_length ? std::string(kEmptyLength) : std::string(width, '.'));
  if (word->is_parameter) return text + parameter_text(word->number, width);
  if (is_length) return text + length_text(word->number, '.');
  append_digits(text, word->number, format.digits);
  return text;
}

std::string block_line(const Block& block, Plane plane, Tongue tongue) {
  std::string line = number_text(block);
  const BlockForm* form = find_form(block.function, plane_of_words(block, plane), {});
  if (block.function.kind != Function::Kind::tool) {
    line += block.function.kind == Function::Kind::g ? "G" : "↓";
    append_digits(line, block.function.code, 2);
    line += ' ';
  }
  if (form == nullptr) {
    line.pop_back();
    return line;
  }
  const bool is_calculation = (addresses_of(*form) & bit_of(Address::operand)) != 0;
  if (!is_calculation) return line + words_text(block, *form, tongue);
  line.pop_back();
  return line + calculation_text(block, *form);
}

}  // namespace cnclab::language
