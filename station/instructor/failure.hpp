// Why a command or a login failed, with the exit code that tells scripts so.
#pragma once

#include <string>

#include "station/language.hpp"

namespace cnclab::instructor {

inline constexpr int kRefused = 1;  ///< the server refused the command, or its answer could not be kept

/// exit_code   of the console: 1 for a refused command, else as the station's (interfaces.md section 3); one-shot
///             commands end with 1 whatever it is
/// text        what happened, where, what to do; for stderr behind "error: "
struct Failure {
  int exit_code = kRefused;
  std::string text;
};

/// A sentence of this program's own, in the language of the locale: nobody may have logged in.
[[nodiscard]] inline std::string own_words(const station::Text& text) {
  return std::string(text.in(station::language_of_locale()));
}

}  // namespace cnclab::instructor
