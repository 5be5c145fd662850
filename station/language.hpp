// The two languages a station speaks, and which one before the server has named one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cnclab::station {

enum class Language : std::uint8_t { german, english };

/// One text in both languages.
struct Text {
  std::string_view german, english;
  [[nodiscard]] constexpr std::string_view in(Language language) const {
    return language == Language::german ? german : english;
  }
};

/// "en…" is English, everything else German, the lab's default.
[[nodiscard]] Language language_named(std::string_view code);
/// From LC_ALL, LC_MESSAGES, LANG, in this order.
[[nodiscard]] Language language_of_locale();
/// The one of the two that fits it: for what is said on the command line.
[[nodiscard]] std::string in_language_of_locale(std::string_view german, std::string_view english);

}  // namespace cnclab::station
