// What a reader has made of a tape, as text and as programs, to be compared.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language/tape.hpp"

namespace cnclab::language {

inline std::vector<Program> programs_in(const Tape& tape) {
  std::vector<Program> programs;
  for (const ReadProgram& read : tape.programs) programs.push_back(read.program);
  return programs;
}

/// In tape form, `between` between them.
inline std::string programs_of(const Tape& tape, std::string_view between = "") {
  std::string text;
  for (const Program& program : programs_in(tape)) {
    if (!text.empty()) text += between;
    text += write_program(program);
  }
  return text;
}

/// Every error with its line, in German.
inline std::string messages_of(const Tape& tape) {
  std::string text;
  for (const Error& error : tape.errors)
    text += std::to_string(error.line) + ' ' + explain(error, Tongue::german) + '\n';
  return text;
}

}  // namespace cnclab::language
