// The slow path of TapeCursor: everything that stands between two characters that count.
#include "language/tape_cursor.hpp"

#include <algorithm>

namespace cnclab::language {

namespace {

constexpr std::size_t kSeparatorLength = 6;  // EXT-052

}  // namespace

TapeCursor::TapeCursor(std::string_view text, Reading reading, ErrorList& errors)
    : text_(text), reading_(reading), errors_(errors) {
  skip();
}

void TapeCursor::skip() {
  for (; position_ < text_.size(); ++position_) {
    const char c = text_[position_];
    const bool opens_comment = c == '(' && reading_ == Reading::file;
    if (c >= '!' && c <= '_' && !opens_comment) {
      current_ = c;
      return;
    }
    if (opens_comment) {
      skip_comment();
    } else if (c == '\n') {
      ++line_;
    } else if (c == '\0') {
      if (!is_separator()) continue;
      current_ = kSeparator;
      return;
    } else if (reading_ == Reading::file && c >= 'a' && c <= 'z') {
      note_lower_case();
      current_ = static_cast<char>(c - ('a' - 'A'));  // as it was meant, so that no other errors follow from it
      return;
    } else if (is_arrow()) {
      position_ += kArrow.size() - 1;
      current_ = '\\';
      return;
    }
  }
  position_ = text_.size();
  current_ = kEnd;
}

/// Moves to the last NUL of the run.
bool TapeCursor::is_separator() {
  const std::size_t after = std::min(text_.find_first_not_of('\0', position_), text_.size());
  const std::size_t length = after - position_;
  position_ = after - 1;
  return length >= kSeparatorLength;
}

bool TapeCursor::is_arrow() const {
  return reading_ == Reading::file && text_.substr(position_, kArrow.size()) == kArrow;
}

/// Moves to the closing parenthesis.
void TapeCursor::skip_comment() {
  const std::size_t close = text_.find(')', position_);
  if (close == std::string_view::npos)
    errors_.add({.code = ErrorCode::text_malformed, .word = '(', .expected = ")", .line = line_});
  const std::size_t end = std::min(close, text_.size());
  line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(position_),
                                       text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
  position_ = end;
}

void TapeCursor::note_lower_case() {
  if (lower_case_line_ == line_) return;
  lower_case_line_ = line_;
  errors_.add({.code = ErrorCode::lower_case, .detail = std::string(1, text_[position_]), .line = line_});
}

}  // namespace cnclab::language
