// A state machine after ECMA-48: every sequence has an end that can be told without knowing what it means.
#include "station/key_decoder.hpp"

#include <langinfo.h>

#include <bit>
#include <cstdlib>
#include <cwchar>
#include <utility>

#include "shared/screen.hpp"

namespace cnclab::station {
namespace {

// The parts of a sequence come together, over a slow line nearly so; a key pressed later is one of its own.
constexpr std::chrono::milliseconds kLongestPause(500);

constexpr unsigned char kBell = 7, kEscape = 27, kControl8 = 0x9B, kSingleShift8 = 0x8F;

bool is_final(unsigned char byte) { return byte >= 0x40 && byte < 0x7F; }
bool is_parameter(unsigned char byte) { return byte >= 0x30 && byte < 0x40; }
bool begins_string(unsigned char byte) { return std::string_view("P]X^_").contains(static_cast<char>(byte)); }

std::optional<Input> control_key(char32_t code) {
  switch (code) {
    case U'\r':
    case U'\n':
      return Special::enter;
    case U'\t':
      return Special::tab;
    case 8:
    case 127:
      return Special::backspace;
    case 3:
      return Special::ctrl_c;
    case 12:
      return Special::ctrl_l;
    default:
      return std::nullopt;
  }
}

/// Bytes of the UTF-8 character that this one begins; 0 where it begins none.
std::size_t length_begun_by(unsigned char byte) {
  constexpr unsigned char kLeast = 0xC2, kMost = 0xF4;
  return byte < kLeast || byte > kMost ? 0 : static_cast<std::size_t>(std::countl_one(byte));
}

}  // namespace

Coding coding_of_locale() {
  const std::string_view name = ::nl_langinfo(CODESET);
  const bool is_ascii = name == "ANSI_X3.4-1968";
  return !is_ascii && MB_CUR_MAX == 1 ? Coding::single_byte : Coding::utf8;
}

bool KeyDecoder::is_stop(unsigned char byte) const { return stops_.contains(static_cast<char>(byte)); }

std::optional<TerminalEvent> KeyDecoder::take(unsigned char byte, Clock::time_point now) {
  if (now - last_ > kLongestPause) state_ = State::ground;
  last_ = now;
  if (byte == kEscape) {
    state_ = State::escape;
    begun_.clear();
    return std::nullopt;
  }
  switch (state_) {
    case State::ground:
      return take_ground(byte);
    case State::escape_was_key:
      return byte == '[' || byte == 'O' ? take_escape(byte) : take_ground(byte);
    case State::escape:
    case State::control:
    case State::function:
    case State::single_shift:
    case State::string:
      return take_in_sequence(byte);
  }
  return std::nullopt;
}

std::optional<TerminalEvent> KeyDecoder::take(Special key) {
  const bool is_part = state_ == State::escape || is_pasting_;
  state_ = State::ground;
  if (is_part && key != Special::f12) return std::nullopt;
  return Input(key);
}

std::optional<TerminalEvent> KeyDecoder::pause() {
  if (state_ != State::escape) return std::nullopt;
  state_ = State::escape_was_key;
  is_pasting_ = false;
  return Input(Special::escape);
}

std::optional<TerminalEvent> KeyDecoder::take_ground(unsigned char byte) {
  state_ = State::ground;
  if (byte >= 0x80) return take_high(byte);
  begun_.clear();
  is_with_alt_ = false;
  return character(byte);
}

std::optional<TerminalEvent> KeyDecoder::take_in_sequence(unsigned char byte) {
  if (is_stop(byte)) {
    state_ = State::ground;
    return Stray{byte};
  }
  switch (state_) {
    case State::escape:
      return take_escape(byte);
    case State::control:
      return take_control(byte);
    case State::single_shift:
      if (!is_parameter(byte)) state_ = State::ground;
      return std::nullopt;
    case State::function:
      state_ = State::ground;
      return std::nullopt;
    case State::string:
      if (byte == kBell) state_ = State::ground;
      return std::nullopt;
    case State::ground:
    case State::escape_was_key:
      break;
  }
  return take_ground(byte);
}

std::optional<TerminalEvent> KeyDecoder::take_escape(unsigned char byte) {
  parameters_.clear();
  state_ = byte == '['           ? State::control
           : byte == 'O'         ? State::single_shift
           : begins_string(byte) ? State::string
                                 : State::ground;
  if (byte < 0x80) return std::nullopt;
  is_with_alt_ = true;
  return take_high(byte);
}

std::optional<TerminalEvent> KeyDecoder::take_control(unsigned char byte) {
  constexpr std::size_t kMostParameters = 32;  // far more than any key has: what follows is text again
  if (byte == '[' && parameters_.empty()) {
    state_ = State::function;
    return std::nullopt;
  }
  if (is_final(byte)) return finish_control(static_cast<char>(byte));
  if (byte < 0x20 || byte >= 0x7F || parameters_.size() == kMostParameters) return take_ground(byte);
  parameters_ += static_cast<char>(byte);
  return std::nullopt;
}

std::optional<TerminalEvent> KeyDecoder::finish_control(char final) {
  state_ = State::ground;
  if (final != '~') return std::nullopt;
  if (parameters_ == "200") is_pasting_ = true;
  if (parameters_ == "201") is_pasting_ = false;
  if (parameters_ == "24") return Input(Special::f12);  // as nearly all terminals send it, whatever TERM says
  return std::nullopt;
}

std::optional<TerminalEvent> KeyDecoder::take_high(unsigned char byte) {
  if (coding_ == Coding::single_byte) {
    const std::wint_t wide = std::btowc(byte);
    return wide == WEOF ? std::nullopt : character(static_cast<char32_t>(wide));
  }
  if (length_begun_by(byte) != 0) {
    begun_.assign(1, static_cast<char>(byte));
    return std::nullopt;
  }
  if (begun_.empty() || (byte & 0xC0U) != 0x80U) {
    begun_.clear();
    if (byte == kControl8 || byte == kSingleShift8) return take_escape(byte == kControl8 ? '[' : 'O');
    return std::nullopt;
  }
  begun_ += static_cast<char>(byte);
  if (begun_.size() < length_begun_by(static_cast<unsigned char>(begun_.front()))) return std::nullopt;
  const std::u32string whole = from_utf8(begun_);
  begun_.clear();
  constexpr char32_t kReplacement = U'\uFFFD';
  if (whole.size() != 1 || whole.front() == kReplacement) return std::nullopt;
  return character(whole.front());
}

std::optional<TerminalEvent> KeyDecoder::character(char32_t code) {
  if (std::exchange(is_with_alt_, false)) return std::nullopt;
  const bool is_control = code < 0x20 || code == 0x7F;
  if (is_pasting_) return is_control ? std::nullopt : std::optional<TerminalEvent>(Stray{code});
  if (is_control) {
    const auto key = control_key(code);
    return key ? std::optional<TerminalEvent>(*key) : std::nullopt;
  }
  return Input(code);
}

}  // namespace cnclab::station
