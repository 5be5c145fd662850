// The character rules of the serial line.
#include "transfer/line_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "transfer/iso_code.hpp"

namespace cnclab::transfer {

namespace {

constexpr std::size_t kHeadLength = 9;  // EXT-051
constexpr std::size_t kContinuationLength = 4;
constexpr char kStart = '*', kErase = '#', kStatus = '!';

bool is_digit(char c) { return c >= '0' && c <= '9'; }

int number_in(std::string_view digits) {
  int number = 0;
  for (const char c : digits) number = number * 10 + (c - '0');
  return number;
}

/// Does `text` fit the pattern as far as both go? "0" stands for any digit.
bool fits(std::string_view text, std::string_view pattern) {
  const std::size_t length = std::min(text.size(), pattern.size());
  return std::ranges::equal(text.substr(0, length), pattern.substr(0, length),
                            [](char c, char p) { return p == '0' ? is_digit(c) : c == p; });
}

}  // namespace

Received LineInput::take(char byte) {
  const char c = without_parity(byte);
  if (c == kNul || c == kTransmissionEnd) return take_end(c);
  if (c < '!' || c > '_') return {};
  return take_character(c);
}

Received LineInput::take_character(char c) {
  if (is_remote_ && buffer_.empty() && c == kErase) return EraseReceived{};
  if (is_remote_ && buffer_.empty() && c == kStatus) return StatusQuery{};
  if (is_remote_ && c == kStart && buffer_.size() == kHeadLength && buffer_[0] == 'P' && buffer_[5] == 'N') {
    const std::string head = std::exchange(buffer_, {});
    program_ = number_in(std::string_view(head).substr(1, 4));
    return StartReceived{.program = static_cast<std::uint16_t>(program_),
                         .block = static_cast<std::uint16_t>(number_in(std::string_view(head).substr(6)))};
  }
  if (buffer_.size() == kLineBuffer) {
    buffer_.clear();
    return LineFault::overflow;
  }
  buffer_ += c;
  if (buffer_.size() > kHeadLength || begins_well()) return {};
  buffer_.clear();
  return LineFault::beginning_wrong;
}

/// The tool table has rows T001 instead of blocks; "MDN" begins machine data, which are free of the rule (DEC-62).
bool LineInput::begins_well() const {
  return fits(buffer_, "P0000N000") || (buffer_.starts_with("P0000") && fits(buffer_, "P0000T000")) ||
         fits(buffer_, "MDN") || (program_ >= 0 && fits(buffer_, program_ == 0 ? "T000" : "N000"));
}

Received LineInput::take_end(char c) {
  if (buffer_.empty() && c == kNul) return {};
  std::string text = std::exchange(buffer_, {});
  const bool begins_program = text.starts_with('P');
  const bool is_continuation = text.starts_with('N') || text.starts_with('T');
  if (begins_program && text.size() < kHeadLength) return LineFault::beginning_wrong;
  if (is_continuation && text.size() < kContinuationLength) return LineFault::beginning_wrong;
  if (begins_program) program_ = number_in(std::string_view(text).substr(1, 4));
  const auto program = static_cast<std::uint16_t>(std::max(program_, 0));
  if (is_continuation) text.insert(0, fmt::format("P{:04}", program));
  return TextReceived{.program = program,
                      .is_continuation = is_continuation,
                      .is_last = c == kTransmissionEnd,
                      .text = std::move(text)};
}

}  // namespace cnclab::transfer
