// Words of a command line to a command value.
#include "station/headless_command.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <optional>

namespace cnclab::station {
namespace {

constexpr std::int64_t kLongest_ms = 600'000;
using Parsed = std::expected<HeadlessCommand, std::string>;

// What is left of the line behind the words already taken.
class Words {
 public:
  Words(std::string_view text, Language language) : text_(text), language_(language) {}

  std::string_view next() {
    skip_blanks();
    const std::size_t end = std::min(text_.find(' '), text_.size());
    const std::string_view word = text_.substr(0, end);
    text_.remove_prefix(end);
    return word;
  }
  // Everything behind one blank.
  std::string_view rest() {
    if (text_.starts_with(' ')) text_.remove_prefix(1);
    return text_;
  }
  std::optional<std::int64_t> number(std::int64_t largest) {
    const std::string_view word = next();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || value < 0 || value > largest) return std::nullopt;
    return value;
  }
  bool is_empty() {
    skip_blanks();
    return text_.empty();
  }
  [[nodiscard]] std::unexpected<std::string> wrong(std::string_view german, std::string_view english,
                                                   std::string_view value = {}) const {
    return std::unexpected(fmt::format(fmt::runtime(Text{german, english}.in(language_)), value));
  }

 private:
  void skip_blanks() {
    while (text_.starts_with(' ')) text_.remove_prefix(1);
  }
  std::string_view text_;
  Language language_;
};

std::unexpected<std::string> no_chord(const Words& words, std::string_view name) {
  return keys_of(name).empty()
             ? words.wrong("unbekannte Taste {}", "unknown key {}", name)
             : words.wrong("höchstens drei Tasten zugleich, nicht {}", "at most three keys at once, not {}", name);
}

Parsed parse_key(Words& words) {
  PressCommand command;
  while (!words.is_empty()) {
    const std::string_view name = words.next();
    command.chords.push_back(chord_of(name));
    if (command.chords.back().empty()) return no_chord(words, name);
  }
  if (command.chords.empty()) return words.wrong("key NAME [NAME…]", "key NAME [NAME…]");
  return command;
}

Parsed parse_hold(Words& words) {
  const auto duration_ms = words.number(kLongest_ms);
  if (!duration_ms || words.is_empty())
    return words.wrong("hold MS NAME[+NAME…], MS von 0 bis 600000", "hold MS NAME[+NAME…], MS 0 to 600000");
  const std::string_view name = words.next();
  const Chord chord = chord_of(name);
  if (chord.empty()) return no_chord(words, name);
  if (!words.is_empty()) return words.wrong("hold MS NAME[+NAME…]", "hold MS NAME[+NAME…]");
  return HoldCommand{std::chrono::milliseconds(*duration_ms), chord};
}

Parsed parse_type(Words& words) {
  PressCommand command;
  for (const char character : words.rest()) {
    if (character >= '0' && character <= '9') {
      command.chords.push_back({static_cast<Key>(static_cast<int>(Key::D0) + (character - '0'))});
    } else if (character == '.' || character == '-') {
      command.chords.push_back({character == '.' ? Key::POINT : Key::SIGN});
    } else {
      return words.wrong("type nimmt nur Ziffern, . und -", "type takes digits, . and - only");
    }
  }
  if (command.chords.empty()) return words.wrong("type TEXT", "type TEXT");
  return command;
}

Parsed parse_pot(Words& words) {
  const auto percent = words.number(100);
  if (!percent || !words.is_empty()) return words.wrong("pot PERCENT, von 0 bis 100", "pot PERCENT, 0 to 100");
  return PotCommand{static_cast<std::uint32_t>(*percent)};
}

Parsed parse_wait(Words& words, bool until_present) {
  const auto limit_ms = words.number(kLongest_ms);
  const std::string_view text = words.rest();
  if (!limit_ms || text.empty()) {
    return until_present ? words.wrong("wait MS TEXT, MS von 0 bis 600000", "wait MS TEXT, MS 0 to 600000")
                         : words.wrong("gone MS TEXT, MS von 0 bis 600000", "gone MS TEXT, MS 0 to 600000");
  }
  return WaitCommand{std::chrono::milliseconds(*limit_ms), std::string(text), until_present};
}

}  // namespace

Chord chord_of(std::string_view name) {
  Chord chord = keys_of(name);
  if (chord.size() > kLargestChord) chord.clear();
  return chord;
}

Parsed parse_headless(std::string_view line, Language language) {
  Words words(line, language);
  const std::string_view verb = words.next();
  if (verb == "key") return parse_key(words);
  if (verb == "hold") return parse_hold(words);
  if (verb == "type") return parse_type(words);
  if (verb == "pot") return parse_pot(words);
  if (verb == "wait") return parse_wait(words, true);
  if (verb == "gone") return parse_wait(words, false);
  if (verb == "screen" && words.is_empty()) return ScreenCommand{};
  if (verb == "marks" && words.is_empty()) return MarksCommand{};
  if (verb == "quit" && words.is_empty()) return QuitCommand{};
  return words.wrong("unbekannter Befehl; es gibt key, hold, type, pot, screen, marks, wait, gone, quit",
                     "unknown command; there are key, hold, type, pot, screen, marks, wait, gone, quit");
}

}  // namespace cnclab::station
