// Writing blocks and programs as tape text: always the same text for the same block, since it is also the stored form.
#include <fmt/format.h>

#include <boost/crc.hpp>

#include "language/tape.hpp"
#include "language/value_text.hpp"

namespace cnclab::language {

namespace {

void append_value(std::string& text, const Word& word) {
  const WordFormat& format = format_of(word.address);
  if (word.is_parameter) {
    text += '#';
    append_digits(text, word.number, 2);
  } else if (format.kind == WordFormat::Kind::millimetres) {
    text += word.number < 0 ? '-' : '+';
    append_digits(text, word.number < 0 ? -word.number : word.number, 1);
  } else {
    append_digits(text, word.number, format.digits);
  }
}

void append_block(std::string& text, const Block& block) {
  text += block.function.kind == Function::Kind::tool ? 'T' : 'N';
  append_digits(text, block.number, 3);
  if (block.function.kind != Function::Kind::tool) {
    text += block.function.kind == Function::Kind::g ? 'G' : '\\';
    append_digits(text, block.function.code, 2);
  }
  for (const Word& word : block.words) {
    if (word.address != Address::value) text += letter(word.address);
    append_value(text, word);
  }
}

}  // namespace

std::string write_block(const Block& block) {
  std::string text;
  append_block(text, block);
  return text;
}

std::string write_program(const Program& program) {
  std::string text = "P";
  append_digits(text, program.number, 4);
  text += '\n';
  for (const Block& block : program.blocks) {
    append_block(text, block);
    text += '\n';
  }
  return text;
}

std::string write_machine_data(std::span<const MachineDatum> data) {
  if (data.empty()) return {};
  std::string text = "MD\n";
  for (const MachineDatum& datum : data) {
    text += 'N';
    append_digits(text, datum.number, 2);
    text += '=';
    append_digits(text, datum.value, 1);
    text += '\n';
  }
  return text;
}

std::uint32_t check_code(std::uint16_t program, std::string_view stored_block) {
  std::string place = "P";
  append_digits(place, program, 4);
  boost::crc_32_type crc;  // IEEE 802.3
  crc.process_bytes(place.data(), place.size());
  crc.process_bytes(stored_block.data(), stored_block.size());
  return crc.checksum();
}

std::uint32_t datum_check_code(int number, std::int64_t value) {
  return check_code(kToolTable, fmt::format("{:02}={}", number, value));
}

}  // namespace cnclab::language
