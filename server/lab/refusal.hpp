// A refusal in the user's words.
#pragma once

#include <string>

#include "language/units.hpp"

namespace cnclab::lab {

/// Thrown inside a store job to end it without effect; nothing may have been changed before.
struct Refusal {
  std::string german, english;
  [[nodiscard]] const std::string& in(language::Tongue tongue) const {
    return tongue == language::Tongue::german ? german : english;
  }
};

}  // namespace cnclab::lab
