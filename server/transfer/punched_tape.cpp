// Punching and reading tapes.
#include "transfer/punched_tape.hpp"

#include <algorithm>

#include "language/tape.hpp"
#include "transfer/iso_code.hpp"

namespace cnclab::transfer {

namespace {

constexpr std::size_t kLeader = 100;  // rows, 10 per inch: enough to thread the tape in

void append_lines(std::string& text, std::string_view lines) {
  for (const char c : lines) {
    if (c == '\n') text += '\r';
    text += c;
  }
}

}  // namespace

std::string with_even_parity(std::string_view text) {
  std::string bytes(text);
  for (char& byte : bytes) byte = with_even_parity(byte);
  return bytes;
}

std::string without_parity(std::string_view bytes) {
  std::string text(bytes);
  for (char& c : text) c = without_parity(c);
  return text;
}

std::string line_text(std::span<const language::Program> programs) {
  std::string text;
  for (const language::Program& program : programs) {
    if (!text.empty()) text.append(kSeparatorLength, kNul);
    append_lines(text, language::write_program(program));
  }
  return text + kTransmissionEnd;
}

std::string disk_text(std::span<const language::Program> programs, std::string_view machine_data) {
  std::string text;
  for (const language::Program& program : programs) text += language::write_program(program);
  text += machine_data;
  return text + "%\n";
}

std::string punch(std::string_view text) {
  std::string rows(kLeader, kNul);
  for (const char c : text)
    if ((static_cast<unsigned char>(c) & 0x80U) == 0) rows += with_even_parity(c);
  rows.append(kLeader, kNul);
  return rows;
}

std::string read_punched(std::string_view rows) {
  const std::string text = without_parity(rows.substr(0, kLargestFile));
  const std::size_t first = text.find_first_not_of(kNul);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kNul) + 1 - first);
}

std::string twin_text(std::string_view rows) {
  std::string twin;
  bool is_in_gap = false;
  for (const char c : read_punched(rows)) {
    if (c == kNul && !is_in_gap) twin += '\n';
    is_in_gap = c == kNul;
    if (c == '\n' || (c >= ' ' && c <= '~')) twin += c;
  }
  if (!twin.ends_with('\n')) twin += '\n';
  return twin;
}

}  // namespace cnclab::transfer
