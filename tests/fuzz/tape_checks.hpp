// What must hold of everything that a reader of programs has read. A fuzzer tells a fault by ending the process.
#pragma once

#include <cstdlib>

#include "language/tape.hpp"

namespace cnclab::fuzz {

inline void require(bool is_right) {
  if (!is_right) std::abort();
}

/// Not too many, and each can be said.
inline void check_errors(const language::Tape& tape) {
  require(tape.errors.size() <= 1000);
  for (const language::Error& error : tape.errors) {
    require(!language::explain(error, language::Tongue::german).empty());
    require(!language::explain(error, language::Tongue::english).empty());
  }
}

/// `read_again` has no errors and the programs of `tape`.
inline void require_same_programs(const language::Tape& tape, const language::Tape& read_again) {
  require(read_again.errors.empty() && tape.programs.size() == read_again.programs.size());
  for (std::size_t i = 0; i < tape.programs.size(); ++i)
    require(tape.programs[i].program == read_again.programs[i].program);
}

}  // namespace cnclab::fuzz
