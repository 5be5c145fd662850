// What the lab says, in the language of whoever reads it.
#pragma once

#include <string>

#include "db/store.hpp"
#include "language/units.hpp"

namespace cnclab::lab {

[[nodiscard]] inline std::string say(language::Tongue tongue, const char* german, const char* english) {
  return tongue == language::Tongue::german ? german : english;
}

/// What the screen that wanted to store says (STO-009).
[[nodiscard]] inline std::string sentence_for(const db::StoreError& error, language::Tongue tongue) {
  return std::string(db::explain(error.kind, say(tongue, "de", "en")));
}

}  // namespace cnclab::lab
