// Walks over tape text from one character that counts to the next: blanks, line breaks, comments and runs of NUL are
// dealt with here, so that the readers behind see the bare language. Private to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "language/error_list.hpp"
#include "language/tape.hpp"

namespace cnclab::language {

inline constexpr std::string_view kArrow = "\xE2\x86\x93";  ///< ↓ in UTF-8: a word by parameter in a file (DEC-31)

/// Invariant: `current` is a character 21H..5FH that counts, or kEnd or kSeparator (both below 21H, so never text).
class TapeCursor {
 public:
  static constexpr char kEnd = '\0';
  static constexpr char kSeparator = '\1';  ///< at least six NUL (EXT-052)

  TapeCursor(std::string_view text, Reading reading, ErrorList& errors);

  [[nodiscard]] char current() const { return current_; }
  [[nodiscard]] bool is_digit() const { return current_ >= '0' && current_ <= '9'; }
  [[nodiscard]] int line() const { return line_; }
  /// Small letters were found in a file, which is refused as a whole (DEC-30).
  [[nodiscard]] bool has_lower_case() const { return lower_case_line_ != 0; }

  void advance() {
    ++position_;
    if (position_ < text_.size() && is_plain(text_[position_]))
      current_ = text_[position_];
    else
      skip();
  }

  /// Reads exactly `count` digits, at most 4; nothing where there are fewer.
  [[nodiscard]] std::optional<std::uint16_t> read_digits(int count) {
    std::uint16_t value = 0;
    for (; count > 0 && is_digit(); --count) {
      value = static_cast<std::uint16_t>(value * 10 + (current_ - '0'));
      advance();
    }
    if (count > 0) return std::nullopt;
    return value;
  }

 private:
  /// 21H..5FH without "(", which opens a comment in files.
  [[nodiscard]] static constexpr bool is_plain(char c) { return c >= '!' && c <= '_' && c != '('; }
  void skip();
  [[nodiscard]] bool is_separator();
  [[nodiscard]] bool is_arrow() const;
  void skip_comment();
  void note_lower_case();

  std::string_view text_;
  Reading reading_;
  ErrorList& errors_;
  std::size_t position_ = 0;
  int line_ = 1;
  int lower_case_line_ = 0;  ///< the last line reported
  char current_ = kEnd;
};

}  // namespace cnclab::language
