// Choosing the language by code and by locale.
#include "station/language.hpp"

#include <cstdlib>

namespace cnclab::station {

Language language_named(std::string_view code) { return code.starts_with("en") ? Language::english : Language::german; }

Language language_of_locale() {
  for (const char* const name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* const value = std::getenv(name);
    if (value != nullptr && *value != '\0') return language_named(value);
  }
  return Language::german;
}

std::string in_language_of_locale(std::string_view german, std::string_view english) {
  return std::string(Text{german, english}.in(language_of_locale()));
}

}  // namespace cnclab::station
