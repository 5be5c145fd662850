// Feeds any lines to the reader of headless commands: a sentence, or a command within its limits.
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <type_traits>

#include "station/headless_command.hpp"

namespace station = cnclab::station;

namespace {

void require(bool is_right) {
  if (!is_right) std::abort();
}

bool is_chord(const station::Chord& chord) { return !chord.empty() && chord.size() <= station::kLargestChord; }

void check(const station::HeadlessCommand& command) {
  if (const auto* press = std::get_if<station::PressCommand>(&command)) {
    require(!press->chords.empty());
    for (const auto& chord : press->chords) require(is_chord(chord));
  }
  if (const auto* hold = std::get_if<station::HoldCommand>(&command))
    require(is_chord(hold->chord) && hold->duration.count() >= 0 && hold->duration.count() <= 600'000);
  if (const auto* pot = std::get_if<station::PotCommand>(&command)) require(pot->percent <= 100);
  if (const auto* wait = std::get_if<station::WaitCommand>(&command)) require(!wait->text.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    for (const auto language : {station::Language::german, station::Language::english}) {
      const auto command = station::parse_headless(line, language);
      if (command)
        check(*command);
      else
        require(!command.error().empty());
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return 0;
}
