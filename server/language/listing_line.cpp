// Placeholders, decimal commas and operators of listing lines.
#include "language/listing_line.hpp"

#include <algorithm>

#include "language/block_form.hpp"
#include "language/tape_cursor.hpp"

namespace cnclab::language {

namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kValueCharacters = "+-.,#0123456789";
constexpr std::string_view kLengthExample = "+...1.500";

/// "...." and ".....,...": a word without a value (SCR-012).
bool is_empty_word(std::string_view value) {
  return value.starts_with('.') && value.find_first_not_of(".,") == std::string_view::npos;
}

class LineScanner {
 public:
  explicit LineScanner(std::string_view text) : rest_(text) {}

  TapeLine scan() {
    take_head();
    if (rest_.empty()) return std::move(line_);
    if (is_tool_)
      take_words(addresses_in_any_plane({Function::Kind::tool, 0}));
    else
      take_function();
    return std::move(line_);
  }

 private:
  /// "N003", "N003!", "T001".
  void take_head() {
    is_tool_ = rest_.front() == 'T';
    take(1);
    take(count_of(kDigits));
    if (rest_.starts_with('!')) {
      line_.is_damaged = true;
      rest_.remove_prefix(1);
    }
    skip_blanks();
  }

  void take_function() {
    const auto kind = rest_.front() == 'G' ? Function::Kind::g : Function::Kind::parametric;
    take(1);  // if it is no function's, the block's reader says so
    const std::string_view digits = rest_.substr(0, count_of(kDigits));
    take(digits.size());
    if (digits.size() != 2) return;
    const Function function{kind, static_cast<std::uint8_t>((digits[0] - '0') * 10 + (digits[1] - '0'))};
    const BlockForm* form = find_form(function, Plane::xy, {});
    if (form == nullptr) return;
    if ((addresses_of(*form) & bit_of(Address::operand)) != 0)
      take_calculation(*form);
    else
      take_words(addresses_in_any_plane(function));
  }

  void take_words(AddressSet allowed) {
    for (skip_blanks(); !rest_.empty() && !line_.fault; skip_blanks()) {
      const char c = rest_.front();
      if (c < 'A' || c > 'Z') {
        fail(ErrorCode::text_malformed, 0, character_at(rest_, 0), {});
        return;
      }
      rest_.remove_prefix(1);
      const std::string_view value = rest_.substr(0, count_of(kValueCharacters));
      rest_.remove_prefix(value.size());
      const auto address = static_cast<Address>(c);
      if ((allowed & bit_of(address)) == 0) {
        line_.tape += c;  // the block's reader refuses it
        return;
      }
      if (is_empty_word(value)) continue;
      line_.tape += c;
      append_value(address, value);
    }
  }

  /// "+..25,000" becomes "+25.000", "......#04" becomes "#04", "F1000" stays.
  void append_value(Address address, std::string_view value) {
    const std::string_view whole = value;
    if (value.starts_with('+') || value.starts_with('-')) {
      line_.tape += value.front();
      value.remove_prefix(1);
    }
    value.remove_prefix(std::min(value.find_first_not_of('.'), value.size()));
    const bool is_length = format_of(address).kind == WordFormat::Kind::millimetres && !value.starts_with('#');
    if (is_length && !value.empty() && value.find_first_of(".,") == std::string_view::npos) {
      fail(ErrorCode::text_malformed, letter(address), std::string(whole), kLengthExample);
      return;
    }
    for (const char c : value) line_.tape += is_length && c == ',' ? '.' : c;
  }

  /// "#01 = #02 + #03", "#55 = COPY #64", "#54 = -...0.500"; blanks say nothing.
  void take_calculation(const BlockForm& form) {
    compact_ = rest_;
    std::erase(compact_, ' ');
    rest_ = compact_;
    const bool has_three_operands = form.words.size() == 3;
    if (!take_operand() || !expect("=")) return;
    if (form.words.back() == Address::value) {
      take_assigned_value();
    } else if (has_three_operands) {
      if (!take_operand() || !expect(form.german) || !take_operand()) return;
    } else if (!expect(form.german) || !take_operand()) {
      return;
    }
    if (!rest_.empty() && !line_.fault) fail(ErrorCode::text_malformed, 0, character_at(rest_, 0), {});
  }

  void take_assigned_value() {
    const std::string_view value = rest_.substr(0, count_of(kValueCharacters));
    rest_.remove_prefix(value.size());
    if (!is_empty_word(value)) append_value(Address::value, value);
  }

  /// "#04"; "#.." is missing.
  bool take_operand() {
    if (!rest_.starts_with('#')) return fail(ErrorCode::word_missing, '#', {}, {});
    rest_.remove_prefix(1);
    rest_.remove_prefix(std::min(rest_.find_first_not_of('.'), rest_.size()));
    const std::size_t digits = count_of(kDigits);
    if (digits == 0) return fail(ErrorCode::word_missing, '#', {}, {});
    line_.tape += '#';
    take(digits);
    return true;
  }

  bool expect(std::string_view text) {
    if (!rest_.starts_with(text))
      return fail(ErrorCode::text_malformed, 0, rest_.empty() ? std::string{} : character_at(rest_, 0), text);
    rest_.remove_prefix(text.size());
    return true;
  }

  [[nodiscard]] std::size_t count_of(std::string_view characters) const {
    return std::min(rest_.find_first_not_of(characters), rest_.size());
  }

  void take(std::size_t count) {
    line_.tape += rest_.substr(0, count);
    rest_.remove_prefix(count);
  }

  void skip_blanks() { rest_.remove_prefix(count_of(" ")); }

  bool fail(ErrorCode code, char word, std::string detail, std::string_view expected) {
    line_.fault = Error{.code = code, .word = word, .detail = std::move(detail), .expected = std::string(expected)};
    return false;
  }

  std::string_view rest_;
  std::string compact_;  ///< holds the rest of a calculation
  bool is_tool_ = false;
  TapeLine line_;
};

}  // namespace

BareLine bare_line(std::string_view line) {
  BareLine bare;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '(') {
      const std::size_t close = line.find(')', at);
      bare.has_open_comment = close == std::string_view::npos;
      if (bare.has_open_comment) break;
      bare.text += ' ';
      at = close;
    } else if (line.substr(at).starts_with(kArrow)) {
      bare.text += '\\';
      at += kArrow.size() - 1;
    } else if (c >= 'a' && c <= 'z') {
      if (bare.lower_case == 0) bare.lower_case = c;
      bare.text += static_cast<char>(c - ('a' - 'A'));  // as it was meant, so that no other errors follow from it
    } else {
      bare.text += c >= '\0' && c <= ' ' ? ' ' : c;
    }
  }
  const std::size_t end = bare.text.find_last_not_of(' ') + 1;
  bare.text.erase(end);
  bare.text.erase(0, bare.text.find_first_not_of(' '));
  return bare;
}

TapeLine tape_line(std::string_view text) { return LineScanner(text).scan(); }

std::string character_at(std::string_view text, std::size_t place) {
  std::size_t end = place + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
  return std::string(text.substr(place, end - place));
}

}  // namespace cnclab::language
